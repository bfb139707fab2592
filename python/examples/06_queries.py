"""Queries: a lidar that casts 360 rays in a room with pillars, a shape cast, an overlap query and a closest point."""
import numpy as np

import cairn

world = cairn.World()
room = world.create_body(type="static")
for x, z, width, depth in ((-5, 0, 0.1, 5), (5, 0, 0.1, 5), (0, -5, 5, 0.1), (0, 5, 5, 0.1)):
    world.add_shape(room, cairn.Box((width, 1, depth)), position=(x, 1, z))
pillars = [(2, 2), (-3, 1), (0, -3)]
for x, z in pillars:
    pillar = world.create_body(type="static", name="pillar", position=(x, 1, z))
    world.add_shape(pillar, cairn.Cylinder(half_height=1, radius=0.4))

angles = np.radians(np.arange(360))
seen, distances = set(), np.full(360, np.inf)
for i, angle in enumerate(angles):
    hit = world.cast_ray((0, 1, 0), (np.cos(angle), 0, np.sin(angle)), 20)
    if hit:
        distances[i] = hit.distance
        seen.add(world.body(hit.body).name)
print(f"distances {distances.min():.3f} to {distances.max():.3f} m, to bodies with the names {sorted(seen)}")
assert seen == {"", "pillar"} and np.isfinite(distances).all()
assert abs(distances.min() - (np.hypot(2, 2) - 0.4)) < 0.01

ball = cairn.Sphere(0.3)
way = world.cast_shape(ball, cairn.Transform((0, 1, 0)), (10, 0, 0))
print(f"a ball with a radius of 0.3 m can move {10 * way.fraction:.3f} m")
assert abs(10 * way.fraction - 4.6) < 1e-3
near = world.overlap(cairn.Box((1, 1, 1)), cairn.Transform((2, 1, 2)))
print(f"the box around the first pillar overlaps {len(near)} shape")
assert len(near) == 1
closest = world.closest_point((0, 1, 0), 10)
assert world.body(closest.body).name == "pillar"
