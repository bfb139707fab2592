"""A hinge with a motor turns a wheel. A slider with a spring lifts a weight, and its reaction force is printed."""
import numpy as np

import cairn

world = cairn.World()
frame = world.create_body(type="static")

wheel = world.create_body(position=(0, 2, 0))
world.add_shape(wheel, cairn.Cylinder(half_height=0.1, radius=0.5), rotation=(np.sqrt(0.5), 0, 0, np.sqrt(0.5)))
motor = cairn.JointMotor(velocity=2 * np.pi, max_force=200)
hinge = world.create_joint(world.joint_at(frame, wheel, (0, 2, 0), (0, 0, 1),
                                          cairn.HingeJoint(angle=cairn.JointControl(motor=motor))))

weight = world.create_body(position=(3, 1, 0), mass=10, allow_sleep=False)
world.add_shape(weight, cairn.Box((0.2, 0.2, 0.2)))
spring = cairn.JointSpring.from_frequency(2, 1)
lift = cairn.SliderJoint(translation=cairn.JointControl(motor=cairn.JointMotor(position=0.5, spring=spring)))
slider = world.create_joint(world.joint_at(frame, weight, (3, 1, 0), (0, 1, 0), lift))

world.step(n=300)
spin = world.body(wheel).angular_velocity[2]
height = world.body(weight).position[1]
force = world.joint_state(slider).force
print(f"the wheel turns at {spin:.3f} rad/s, its angle is {world.joint_state(hinge).positions[0]:.2f} rad")
print(f"the weight hangs at {height:.3f} m, and the force of the slider is {force[1]:.1f} N")
assert abs(spin - 2 * np.pi) < 0.01
assert abs(force[1] - 10 * 9.81) < 1
sag = 9.81 / (2 * np.pi * 2) ** 2  # static deflection g / (2 pi f)^2 of a spring with f = 2 Hz
assert abs(height - (1.5 - sag)) < 0.005
