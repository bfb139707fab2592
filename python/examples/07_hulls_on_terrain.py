"""Stones, random convex hulls, roll down hills, a height field."""
import numpy as np

import cairn

random = np.random.default_rng(3)
world = cairn.World()
size = 41
x, z = np.meshgrid(np.linspace(-10, 10, size), np.linspace(-10, 10, size))
heights = 0.4 * np.sin(x) * np.cos(z) - 0.15 * x  # rows along z
terrain = world.create_body(type="static")
world.add_shape(terrain, cairn.HeightField(heights, (20 / (size - 1), 20 / (size - 1))))
stones = []
for i in range(60):
    stone = world.create_body(position=(*random.uniform(-6, 0, 1), 4 + 0.2 * i, *random.uniform(-6, 6, 1)))
    world.add_shape(stone, cairn.Hull(random.normal(0, 0.25, (20, 3)), rounding=0.02), density=2500)
    stones.append(stone)
print(f"the first stone has {len(world.shape(world.body(stones[0]).shapes[0]).faces)} faces, "
      f"{world.body(stones[0]).mass:.1f} kg")
before = world.positions[1:].mean(axis=0)
world.step(n=600)
after = world.positions[1:].mean(axis=0)
print(f"their mean position moved from x = {before[0]:.2f}, y = {before[1]:.2f} m to x = {after[0]:.2f}, y = {after[1]:.2f} m")
assert after[1] < before[1]
inside = (np.abs(world.positions[1:, ::2]) < 9).all(axis=1)
ground = -0.15 * world.positions[1:, 0] - 0.5
assert (world.positions[1:, 1] > ground)[inside].all(), "a stone fell through"
