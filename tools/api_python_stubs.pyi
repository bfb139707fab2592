"""The part of the package that is written in C++."""
from typing import Any, Iterable, Sequence

import numpy as np

from ._arrays import BodyArray
from ._types import *
from ._types._vector import Vector

class _Handle:
    """Names one object of one world. Once that is gone the handle is stale for ever."""
    def __init__(self, bits: int = 0) -> None: ...
    @property
    def bits(self) -> int:
        """All of it; 0: none."""
    @property
    def index(self) -> int:
        """The slot that the object is in."""
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
    """A convex polyhedron. Its corners never change, so that copies share their data."""
    def __init__(self, points: Any, rounding: float = 0.0) -> None:
        """The convex hull of any points (n x 3), meters, in the shape's frame. Raises InvalidValueError when a coordinate is
        not finite or exceeds 1e6, when there are fewer than 4 points, or when they all lie in one point, on one line or in one
        plane."""
    rounding: float
    """Meters, >= 0: radius of the ball that is added to the sharp polyhedron."""
    @property
    def vertices(self) -> np.ndarray:
        """Corners (n x 3), meters; points inside and on faces are left out."""
    @property
    def faces(self) -> list[list[int]]:
        """Indices of the corners of each face, counterclockwise as seen from outside."""
    @property
    def volume(self) -> float:
        """m^3."""

class Mesh:
    """A surface of triangles, for static and kinematic bodies. Solid is the side that sees the corners clockwise."""
    def __init__(self, vertices: Any, indices: Any, materials: Iterable[Material] = (), material_numbers: Any = None) -> None:
        """Vertices (n x 3), meters; triangles (m x 3), counterclockwise as seen from outside. Triangles without area are left
        out. `materials`: those that parts of it have beside that of the shape; `material_numbers` (m): which one each triangle
        has, 0 for that of the shape, k for materials[k - 1]; None: all have that of the shape. Raises InvalidValueError when a
        coordinate is not finite or exceeds 1e6, when an index is out of range, when no triangle is left, or when a material or
        a number is none."""
    @property
    def materials(self) -> list[Material]: ...
    @property
    def material_numbers(self) -> np.ndarray:
        """One for each row of `indices`; empty: all have that of the shape."""
    @property
    def vertices(self) -> np.ndarray: ...
    @property
    def indices(self) -> np.ndarray: ...
    @property
    def dropped_triangles(self) -> int:
        """How many had no area."""

class HeightField:
    """A surface over a grid in the shape's xz plane, solid below, for static and kinematic bodies."""
    def __init__(
        self, heights: Any, spacing: Vector, materials: Iterable[Material] = (), material_numbers: Any = None
    ) -> None:
        """Heights (rows x columns), meters along y: that of row r and column c stands at x = (c - (columns - 1) / 2) *
        spacing[0], z = (r - (rows - 1) / 2) * spacing[1]. Triangles of which a corner has the height +infinity are holes.
        `materials`: those that parts of it have beside that of the shape; `material_numbers` (rows - 1 x columns - 1): which one
        each cell has, 0 for that of the shape, k for materials[k - 1]; None: all have that of the shape. Raises
        InvalidValueError for fewer than 2 columns or rows, a spacing that is no size, a height that is no number or exceeds 1e6
        and is not +infinity, holes alone, or a material or a number that is none."""
    @property
    def materials(self) -> list[Material]: ...
    @property
    def material_numbers(self) -> np.ndarray:
        """Of each cell (rows - 1 x columns - 1); empty: all have that of the shape."""
    @property
    def indices(self) -> np.ndarray:
        """Its triangles that are no holes (n x 3): indices of its vertices, counterclockwise as seen from above."""
    @property
    def vertices(self) -> np.ndarray:
        """Where the heights stand, row after row (n x 3), meters; y of a hole is +infinity."""
    @property
    def heights(self) -> np.ndarray: ...
    @property
    def spacing(self) -> np.ndarray:
        """Meters along x and z."""

class Snapshot:
    """The whole state of a world at one moment. A world restored from it goes on bit for bit."""
    @property
    def nbytes(self) -> int:
        """Its size, without what it shares with other snapshots of the same world."""

class Body:
    """An accessor to one body of a world. It stays usable as long as the body lives; after that every use raises
    InvalidHandleError. Setting a property wakes the body. Vectors are in world axes, points in world space."""
    @property
    def id(self) -> BodyId: ...
    @property
    def world(self) -> World: ...
    # Body: from the table

class World:
    """A world of rigid bodies. It must not be used by two threads at a time: what comes while another thread is in `step`
    raises WrongStateError."""
    def __init__(self, definition: WorldDef | None = None, **members: Any) -> None:
        """`World(gravity=(0, -1.6, 0))` is `World(WorldDef(gravity=(0, -1.6, 0)))`."""
    time_step: float
    """s, 0.0001 to 1: what `step` takes unless it is told otherwise. 1/60, or what its scene is meant for."""
    title: str
    """Of its scene."""
    hint: str
    """One line of its scene on what to watch or try."""
    @property
    def warnings(self) -> list[str]:
        """What the file asks for that was done another way, or left out."""
    def body(self, body: BodyId | Body) -> Body:
        """The accessor to a body. Raises InvalidHandleError."""
    def create_body(self, definition: BodyDef | None = None, **members: Any) -> BodyId:
        """Makes a body without shapes: of a definition, or of its members by name."""
    def destroy_body(self, body: BodyId | Body) -> None:
        """With its shapes and joints; wakes what rested on it. Arrays of bodies are retired."""
    def is_valid(self, handle: BodyId | ShapeId | JointId | ForceFieldId) -> bool:
        """Whether it names something of this world that exists."""
    def step(self, dt: float | None = None, n: int = 1) -> None:
        """Advances by `n` steps of `dt` seconds (> 0; None: `time_step`). Other threads of Python run meanwhile. Events are
        those of the last step. Raises InvalidValueError, WrongStateError."""
    @property
    def positions(self) -> BodyArray:
        """The origins of the bodies' frames, meters (n x 3, float64), in the order of `bodies`. Read-only; it follows the
        world until bodies come or go."""
    @property
    def rotations(self) -> BodyArray:
        """The rotations of the bodies as unit quaternions x, y, z, w (n x 4, float32); otherwise as `positions`."""
    @property
    def velocities(self) -> BodyArray:
        """The velocities of the centers of mass, m/s (n x 3, float32); otherwise as `positions`."""
    @property
    def angular_velocities(self) -> BodyArray:
        """rad/s, world axes (n x 3, float32); otherwise as `positions`."""
    def save(self) -> Snapshot:
        """The whole state, to go back to."""
    def restore(self, snapshot: Snapshot) -> None:
        """Makes this world the one that was saved. Handles from then are valid again; arrays of bodies are retired."""
    def close(self) -> None:
        """Gives its memory back. Every use after that raises WrongStateError."""
    @property
    def closed(self) -> bool: ...
    def __enter__(self) -> World: ...
    def __exit__(self, *exception: Any) -> None: ...
    # World: from the table

def load(path: Any, fixed_base: bool = False) -> World:
    """Reads a scene file (.gltf, .glb) or a model (URDF, MJCF, SDF, USD). `fixed_base`: the base of a robot does not move. Raises
    InvalidFileError, FileError, UnsupportedError."""

def save(world: World, path: Any) -> None:
    """Writes the world as it stands now: a binary .glb if the name ends so, else .gltf. Raises FileError."""

def find_scene(name: str) -> str:
    """The file of a scene that comes with Cairn, by its name or number; or the path itself if it is one."""

def instruction_set() -> str:
    """"avx512", "avx2", "sse2", "neon", "simd128" or "scalar". Results do not depend on it."""

def hardware_threads() -> int:
    """The number of threads that this machine runs at a time."""

def _spring_from_frequency(hertz: float, damping_ratio: float) -> tuple[float, float]: ...
def _rollout(world: World, parameters: list[tuple[Any, str, np.ndarray]], worlds: int, steps: int, dt: float,
             record: list[str], every: int, threads: int) -> dict[str, np.ndarray]: ...

__version__: str
