"""A rollout as the inner loop of an optimizer: 256 rockets start their engines at different heights, and the one with the
softest landing is determined. The forces are given for each step of each world."""
import numpy as np

import cairn

world = cairn.World(hit_speed=0)
ground = world.create_body(type="static")
world.add_shape(ground, cairn.Plane())
rocket = world.create_body(position=(0, 51, 0), mass=100, allow_sleep=False)
world.add_shape(rocket, cairn.Cylinder(half_height=1, radius=0.3))

dt, steps, thrust = 1 / 60, 360, 2500.0
heights = np.linspace(5, 40, 256)  # height above the ground at which the engine starts, m
# Each rocket falls freely until `starts` seconds; then its engine burns for `burns` seconds, until the velocity is zero.
starts = np.sqrt(2 * (50 - heights) / 9.81)
burns = 9.81 * starts / (thrust / 100 - 9.81)
time = np.arange(steps) * dt
forces = np.zeros((256, steps, 3))
forces[:, :, 1] = np.where((time >= starts[:, None]) & (time < (starts + burns)[:, None]), thrust, 0)

run = cairn.rollout(world, {(rocket, "force"): forces}, steps, dt=dt, record=["positions", "velocities"])
height = run["positions"][:, :, 1, 1] - 1
speed = -run["velocities"][:, :, 1, 1]
landed = np.argmax(height < 0.05, axis=1)
impact = np.array([speed[i, max(0, frame - 2)] if frame else np.inf for i, frame in enumerate(landed)])
best = impact.argmin()
print(f"the best rocket starts its engine at {heights[best]:.1f} m, and lands with {impact[best]:.2f} m/s after "
      f"{landed[best] * dt:.2f} s")
# The ideal height h, from which the velocity becomes zero at the ground after a fall from H = 50 m: m g H = thrust h.
ideal = 50 * 9.81 * 100 / thrust
print(f"closed form: {ideal:.1f} m")
assert impact[best] < 3 and abs(heights[best] - ideal) < 2
