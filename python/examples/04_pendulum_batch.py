"""A thousand pendulums are released at angles up to 170 degrees. Their periods are compared with the elliptic integral.
The argument `plot.png` writes a plot with matplotlib."""
import sys

import numpy as np

import cairn

length, gravity = 1.0, 9.81
angles = np.linspace(5, 170, 1000) * np.pi / 180

world = cairn.World(substeps=8, adaptive_substeps=False)
pivot = world.create_body(type="static")
mass = cairn.MassProperties(mass=1.0, inertia_diagonal=(1e-6, 1e-6, 1e-6))
bob = world.create_body(position=(0, -length, 0), mass_properties=mass, allow_sleep=False)
world.create_joint(world.joint_at(pivot, bob, (0, 0, 0), (0, 0, 1), cairn.HingeJoint()))

# One world for each angle, at which the bob starts, with the rotation of the pendulum.
positions = length * np.stack([np.sin(angles), -np.cos(angles), 0 * angles], axis=1)
rotations = np.stack([0 * angles, 0 * angles, np.sin(angles / 2), np.cos(angles / 2)], axis=1)
dt, steps = 1 / 240, 2000
run = cairn.rollout(world, {(bob, "position"): positions, (bob, "rotation"): rotations}, steps, dt=dt, record=["positions"])
bobs = run["positions"][:, :, 1]  # worlds x frames x 3; body 0 is the pivot
x = bobs[:, :, 0]

# The time between the first two sign changes of x, which are interpolated, is half a period.
periods = np.empty(len(angles))
for i, way in enumerate(x):
    at = np.nonzero(np.sign(way[:-1]) != np.sign(way[1:]))[0][:2]
    times = (at + 1 + way[at] / (way[at] - way[at + 1])) * dt
    periods[i] = 2 * (times[1] - times[0])


def arithmetic_geometric_mean(a, b):
    for _ in range(40):
        a, b = (a + b) / 2, np.sqrt(a * b)
    return a


expected = 2 * np.pi * np.sqrt(length / gravity) / arithmetic_geometric_mean(1, np.cos(angles / 2))
error = np.abs(periods / expected - 1)
print(f"{len(angles)} pendulums, {steps} steps: periods {periods.min():.3f} to {periods.max():.3f} s, "
      f"relative error at most {100 * error.max():.3f} %")
if len(sys.argv) > 1:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plot

    figure, axes = plot.subplots()
    axes.plot(np.degrees(angles), expected, label="elliptic integral")
    axes.plot(np.degrees(angles)[::25], periods[::25], "o", label="Cairn")
    axes.set_xlabel("angle of release, degrees")
    axes.set_ylabel("period, s")
    axes.legend()
    figure.savefig(sys.argv[1])
assert error.max() < 0.01
