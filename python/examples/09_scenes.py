"""Scene files: load a scene that comes with Cairn, run it, save its state to a file, and load that file."""
import pathlib
import tempfile

import cairn

world = cairn.load(cairn.find_scene("pyramid"))
print(f"{world.title}: {len(world.bodies)} bodies, steps of {world.time_step:.4f} s")
world.step(n=60)
print(f"after {world.time:.2f} s: {world.statistics.contacts} contacts, hash {world.state_hash:016x}")
again = cairn.load(cairn.find_scene("pyramid"))
again.step(n=60)
assert again.state_hash == world.state_hash

with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "now.glb"
    cairn.save(world, path)
    print(f"saved {path.stat().st_size} bytes")
    loaded = cairn.load(path)
assert len(loaded.bodies) == len(world.bodies)
difference = abs(loaded.positions[:] - world.positions[:]).max()
assert difference < 1e-6, difference
try:
    cairn.load("no_such_scene.gltf")
except cairn.FileError as error:
    print(f"error: {error}")
