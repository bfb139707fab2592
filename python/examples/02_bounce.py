"""Balls with different restitution bounce. Each should rise to its drop height times the square of its restitution."""
import numpy as np

import cairn

world = cairn.World()
ground = world.create_body(type="static")
world.add_shape(ground, cairn.Plane(), material=cairn.Material(restitution=1, restitution_combine="multiply"))
restitutions = np.array([0.2, 0.4, 0.6, 0.8, 1.0])
balls = []
for i, restitution in enumerate(restitutions):
    ball = world.create_body(position=(2 * i, 2.5, 0), allow_sleep=False)
    material = cairn.Material(restitution=restitution, restitution_combine="multiply")
    world.add_shape(ball, cairn.Sphere(0.5), material=material)
    balls.append(ball)
row = {body: i for i, body in enumerate(world.bodies)}
heights = world.positions[:, 1]  # a view of the state of the world, which steps update
fell, highest = np.zeros(5, bool), np.zeros(5)
for _ in range(600):
    world.step(1 / 240)
    hit = {event.body_b for event in world.contact_begins} | {event.body_a for event in world.contact_begins}
    for i, ball in enumerate(balls):
        if fell[i] and ball in hit:
            fell[i] = False  # the second bounce
            balls[i] = None
        elif balls[i] is not None and ball in hit:
            fell[i] = True
        if fell[i]:
            highest[i] = max(highest[i], heights[row[ball]] - 0.5)
for restitution, height in zip(restitutions, highest):
    print(f"restitution {restitution:.1f}: rises to {height:.3f} m; expected {2 * restitution**2:.3f}")
assert np.allclose(highest, 2 * restitutions**2, atol=0.05)
