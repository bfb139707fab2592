"""The C++ part of the package."""
from typing import Any, Iterable, Sequence

import numpy as np

from ._arrays import BodyArray
from ._types import *
from ._types._vector import Vector

class _Handle:
    """Names one object of one world. Once that object is destroyed, the handle is stale for good."""
    def __init__(self, bits: int = 0) -> None: ...
    @property
    def bits(self) -> int:
        """The handle as a 64-bit number; 0: the null handle."""
    @property
    def index(self) -> int:
        """Index of the slot in which the world stores the object."""
    @property
    def generation(self) -> int: ...
    @property
    def world(self) -> int: ...
    def __bool__(self) -> bool: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object) -> bool: ...
    def __lt__(self, other: Any) -> bool: ...

class BodyId(_Handle):
    """Names a body."""

class ShapeId(_Handle):
    """Names a shape on a body."""

class JointId(_Handle):
    """Names a joint."""

class ForceFieldId(_Handle):
    """Names a force field."""

class Hull:
    """A convex polyhedron. Its vertices never change, so that copies share their data."""
    def __init__(self, points: Any, rounding: float = 0.0) -> None:
        """The convex hull of `points` (n x 3), meters, in the shape's frame. Raises InvalidValueError when a coordinate is
        not finite or exceeds 1e6, when there are fewer than 4 points, or when all of them coincide, lie on one line or lie
        in one plane (within 1e-5 of their extent)."""
    rounding: float
    """Meters, >= 0: radius of the ball that is added to the sharp polyhedron."""
    @property
    def vertices(self) -> np.ndarray:
        """Vertices (n x 3), meters; points inside the hull or on its faces are omitted."""
    @property
    def faces(self) -> list[list[int]]:
        """Indices of the vertices of each face, counterclockwise as seen from outside."""
    @property
    def volume(self) -> float:
        """Volume, m^3, without rounding."""

class Mesh:
    """A triangle mesh, for static and kinematic bodies. The solid side of a triangle is the one from which its vertices
    appear clockwise. A mesh never changes, so that copies share their data."""
    def __init__(self, vertices: Any, indices: Any, materials: Iterable[Material] = (), material_numbers: Any = None) -> None:
        """`vertices` (n x 3): meters, in the shape's frame. `indices` (m x 3): the vertices of each triangle,
        counterclockwise as seen from outside. Vertices at the same place are merged; triangles without area are omitted.
        `materials`: at most 65,535 materials in addition to that of the shape. `material_numbers` (m): the material of
        each triangle, 0 for the material of the shape, k for materials[k - 1]; None: all have the material of the shape.
        Raises InvalidValueError when a coordinate is not finite or exceeds 1e6, when an index is out of range, when no
        triangle is left, when a material is invalid, or when a material number is out of range."""
    @property
    def materials(self) -> list[Material]: ...
    @property
    def material_numbers(self) -> np.ndarray:
        """The material of each triangle of `indices`; empty: all have the material of the shape."""
    @property
    def vertices(self) -> np.ndarray: ...
    @property
    def indices(self) -> np.ndarray: ...
    @property
    def dropped_triangles(self) -> int:
        """How many triangles were omitted because they have no area."""

class HeightField:
    """A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies. It never changes, so
    that copies share their data."""
    def __init__(
        self, heights: Any, spacing: Vector, materials: Iterable[Material] = (), material_numbers: Any = None
    ) -> None:
        """`heights` (rows x columns): meters along y. The height of row r and column c is at x = (c - (columns - 1) / 2) *
        spacing[0], z = (r - (rows - 1) / 2) * spacing[1]; `spacing` is in meters, > 0. Triangles that have a vertex with
        the height +infinity are holes. `materials`: at most 65,535 materials in addition to that of the shape.
        `material_numbers` (rows - 1 x columns - 1): the material of each cell, 0 for the material of the shape, k for
        materials[k - 1]; None: all have the material of the shape. Raises InvalidValueError for fewer than 2 columns or
        rows, more than 2^28 heights, a spacing that is not finite and > 0, a height that is NaN or exceeds 1e6 and is not
        +infinity, a field that consists of holes only, an invalid material, or a material number out of range."""
    @property
    def materials(self) -> list[Material]: ...
    @property
    def material_numbers(self) -> np.ndarray:
        """The material of each cell (rows - 1 x columns - 1); empty: all have the material of the shape."""
    @property
    def indices(self) -> np.ndarray:
        """The triangles that are not holes (n x 3): indices of `vertices`, counterclockwise as seen from above."""
    @property
    def vertices(self) -> np.ndarray:
        """The points of the grid with their heights (n x 3), row by row, meters; y of a hole is +infinity."""
    @property
    def heights(self) -> np.ndarray: ...
    @property
    def spacing(self) -> np.ndarray:
        """Distance of neighboring points of the grid along x and z, meters."""

class Snapshot:
    """The complete state of a world at one time. A world restored from it continues bit for bit as the original would
    have."""
    @property
    def nbytes(self) -> int:
        """Its size in bytes, without the definitions that it shares with other snapshots of the same world."""

class Body:
    """An accessor to one body of a world. It can be used as long as the body exists; after that, every use raises
    InvalidHandleError. Setting a property wakes the body. Vectors are in world axes and points in world space."""
    @property
    def id(self) -> BodyId: ...
    @property
    def world(self) -> World: ...
    # Body: from the table

class World:
    """A world of rigid bodies. It must not be used by two threads at the same time: calls while another thread runs
    `step` raise WrongStateError."""
    def __init__(self, definition: WorldDef | None = None, **members: Any) -> None:
        """Creates an empty world. `World(gravity=(0, -1.6, 0))` is `World(WorldDef(gravity=(0, -1.6, 0)))`."""
    time_step: float
    """s, 0.0001 to 1: the default time step of `step`. 1/60, or the time step for which the scene is intended."""
    title: str
    """Title of the scene."""
    hint: str
    """One line about what to watch or try in the scene."""
    @property
    def warnings(self) -> list[str]:
        """Features of the scene file that were approximated or left out."""
    def body(self, body: BodyId | Body) -> Body:
        """Returns an accessor to a body. Raises InvalidHandleError."""
    def create_body(self, definition: BodyDef | None = None, **members: Any) -> BodyId:
        """Creates a body without shapes, from a definition or from members of one as keyword arguments. Makes arrays
        of bodies invalid."""
    def destroy_body(self, body: BodyId | Body) -> None:
        """Destroys the body with its shapes and joints, and wakes bodies that rested on it. Makes arrays of bodies invalid."""
    def is_valid(self, handle: BodyId | ShapeId | JointId | ForceFieldId) -> bool:
        """Whether the handle names an object of this world that exists."""
    def step(self, dt: float | None = None, n: int = 1) -> None:
        """Advances the simulation by `n` steps of `dt` seconds (> 0; None: `time_step`). Other Python threads can run
        meanwhile. The events are those of the last step. Raises InvalidValueError, WrongStateError."""
    @property
    def positions(self) -> BodyArray:
        """The origins of the bodies' frames, meters (n x 3, float64), in the order of `bodies`. Read-only; the array
        follows the world until bodies are created or destroyed."""
    @property
    def rotations(self) -> BodyArray:
        """The rotations of the bodies as unit quaternions x, y, z, w (n x 4, float32); otherwise like `positions`."""
    @property
    def velocities(self) -> BodyArray:
        """The velocities of the centers of mass, m/s (n x 3, float32); otherwise like `positions`."""
    @property
    def angular_velocities(self) -> BodyArray:
        """The angular velocities, rad/s, world axes (n x 3, float32); otherwise like `positions`."""
    def save(self) -> Snapshot:
        """Saves the complete state of the world, to which it can be restored."""
    def restore(self, snapshot: Snapshot) -> None:
        """Restores the state that was saved. Handles of that time are valid again. Makes arrays of bodies invalid."""
    def close(self) -> None:
        """Frees the memory of the world. Every use after that raises WrongStateError."""
    @property
    def closed(self) -> bool: ...
    def __enter__(self) -> World: ...
    def __exit__(self, *exception: Any) -> None: ...
    # World: from the table

def load(path: Any, fixed_base: bool = False) -> World:
    """Reads a scene file (.gltf, .glb) or a model (URDF, MJCF, SDF, USD). `fixed_base`: the base of a robot
    (URDF, MJCF, SDF) does not move. Raises InvalidFileError, FileError, and UnsupportedError for `fixed_base` with other
    files."""

def save(world: World, path: Any) -> None:
    """Writes the present state of the world to a file: binary .glb if the name ends so, otherwise .gltf. Raises FileError."""

def find_scene(name: str) -> str:
    """Returns the file of a scene that comes with Cairn, given its name or number; or the path `name` itself if that file
    exists. Raises FileError if there is none, and InvalidValueError if the name is ambiguous."""

def instruction_set() -> str:
    """The instruction set that the kernels of this process use: "avx512", "avx2", "sse2", "neon", "simd128" or "scalar".
    Results do not depend on it."""

def hardware_threads() -> int:
    """The number of hardware threads of this machine, 1 to 256: a good value for `World.threads`."""

def _spring_from_frequency(hertz: float, damping_ratio: float) -> tuple[float, float]: ...
def _rollout(world: World, parameters: list[tuple[Any, str, np.ndarray]], worlds: int, steps: int, dt: float,
             record: list[str], every: int, threads: int) -> dict[str, np.ndarray]: ...

__version__: str
