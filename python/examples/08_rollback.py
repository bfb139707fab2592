"""Rollback networking of multiplayer games: one world receives inputs eight frames late, restores the snapshot of that
frame, and simulates the frames again. It reaches the same state as a world that received the inputs in time."""
import cairn


def ring(world):
    ground = world.create_body(type="static")
    world.add_shape(ground, cairn.Plane())
    bodies = []
    for i in range(8):
        body = world.create_body(position=(i - 4, 0.5, 0), name=f"player {i}")
        world.add_shape(body, cairn.Box((0.4, 0.5, 0.4)))
        bodies.append(body)
    return bodies


inputs = {frame: (frame % 8, (20 * (-1) ** frame, 60, 5)) for frame in range(0, 120, 7)}


def advance(world, bodies, frame, known):
    if frame in known:
        player, impulse = known[frame]
        world.body(bodies[player]).apply_impulse(tuple(10 * i for i in impulse))
    world.step()


here = cairn.World()
here_bodies = ring(here)
for frame in range(120):
    advance(here, here_bodies, frame, inputs)

there, delay = cairn.World(), 8
there_bodies = ring(there)
saved, rolled_back = {}, 0
for frame in range(120 + delay):
    late = frame - delay
    if late in inputs:  # an input of frame `late` arrives now
        there.restore(saved[late])
        rolled_back += 1
        known = {f: i for f, i in inputs.items() if f <= late}
        for again in range(late, min(frame, 120)):
            saved[again] = there.save()
            advance(there, there_bodies, again, known)
    if frame < 120:
        saved[frame] = there.save()
        advance(there, there_bodies, frame, {f: i for f, i in inputs.items() if f <= late})
print(f"{rolled_back} rollbacks by {delay} frames: state hashes {here.state_hash:016x} and {there.state_hash:016x}")
assert here.state_hash == there.state_hash
