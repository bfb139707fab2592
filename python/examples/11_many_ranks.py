"""A rollout on several MPI ranks: rank r of n computes the worlds r, r + n, r + 2 n, ... The results have the same bits for
any number of ranks.

    mpirun -n 4 python3 python/examples/11_many_ranks.py    # Debian: python3-mpi4py, openmpi-bin

Without mpirun or mpi4py, a single process computes all worlds."""
import hashlib

import numpy as np

import cairn

try:
    from mpi4py import MPI

    ranks = MPI.COMM_WORLD
    rank, size = ranks.Get_rank(), ranks.Get_size()
except ImportError:
    ranks, rank, size = None, 0, 1

# A ball is thrown over rough ground at different angles; the distance at which it comes to rest is measured.
world = cairn.World()
ground = world.create_body(type="static")
soil = cairn.Material(static_friction=0.5, dynamic_friction=0.5, restitution=0.5)
world.add_shape(ground, cairn.Plane(), material=soil)
ball = world.create_body(position=(0, 0.1, 0), angular_damping=5)
world.add_shape(ball, cairn.Sphere(0.1), material=soil)

throws = 400
angles = np.linspace(0.1, 1.5, throws)
velocities = 8 * np.stack([np.cos(angles), np.sin(angles), np.zeros(throws)], axis=1)

mine = np.arange(rank, throws, size)
run = cairn.rollout(world, {(ball, "linear_velocity"): velocities[mine]}, 240, every=240, threads=1)
ways = np.zeros(throws)
ways[mine] = run["positions"][:, -1, 1, 0]
if ranks is not None:
    ranks.Allreduce(MPI.IN_PLACE, ways)  # each element is set by one rank, and zero in all others

if rank == 0:
    best = ways.argmax()
    print(f"{size} processes: greatest distance at {np.degrees(angles[best]):.1f} degrees, {ways[best]:.2f} m; "
          f"hash of all distances {hashlib.sha256(ways.tobytes()).hexdigest()[:16]}")
    # The ball continues to bounce and roll after it lands, so that the best angle is below 45 degrees.
    assert 15 < np.degrees(angles[best]) < 45 and ways[best] > 8**2 / 9.81
