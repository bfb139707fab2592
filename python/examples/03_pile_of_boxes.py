"""A thousand boxes fall and form a pile. Prints contacts, awake bodies and kinetic energy. The state hash does not depend
on the number of threads."""
import numpy as np

import cairn


def heap(threads):
    world = cairn.World()
    world.threads = threads
    ground = world.create_body(type="static")
    world.add_shape(ground, cairn.Plane())
    random = np.random.default_rng(1)
    for i in range(1000):
        place = (i % 10 - 4.5, 1 + i // 100, i // 10 % 10 - 4.5) + random.uniform(-0.2, 0.2, 3)
        box = world.create_body(position=place)
        world.add_shape(box, cairn.Box((0.3, 0.3, 0.3)))
    return world


world, other = heap(1), heap(2)
for second in range(1, 5):
    world.step(n=60)
    s = world.statistics
    print(f"{second} s: {s.contacts} contacts, {s.awake_bodies} awake, {world.kinetic_energy:.1f} J, "
          f"deepest overlap {1000 * s.max_penetration:.2f} mm, {s.times.total:.2f} ms a step")
other.step(n=240)
print(f"state hash {world.state_hash:016x} on 1 thread, {other.state_hash:016x} on 2")
assert world.state_hash == other.state_hash
assert world.positions[1:, 1].min() > 0.2  # the first body is the ground
