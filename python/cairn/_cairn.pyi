# Made by tools/api.py from api/: change those, and run it.
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
    @property
    def type(self) -> BodyType:
        """How the body moves. Setting: Makes the body static, kinematic or dynamic."""
    @type.setter
    def type(self, value: BodyType | str) -> None: ...
    @property
    def name(self) -> str:
        """The name of its definition. Setting: For people; need not be unique."""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def user_data(self) -> int:
        """The number of its definition."""
    @property
    def position(self) -> np.ndarray:
        """Origin of the body's frame, meters. Setting: Teleports the origin of the body's frame: velocities stay,
        contacts are found anew.
        """
    @position.setter
    def position(self, value: Vector) -> None: ...
    @property
    def rotation(self) -> np.ndarray:
        """Rotation of the body's frame, of unit length. Setting: Turns the body in place: velocities stay, contacts are
        found anew. Normalized on entry; must not be zero.
        """
    @rotation.setter
    def rotation(self, value: Vector) -> None: ...
    @property
    def transform(self) -> Transform:
        """Place and rotation of the body's frame."""
    @property
    def center_of_mass(self) -> np.ndarray:
        """In world space, meters; of kinematic bodies, their origin, if not given."""
    @property
    def linear_velocity(self) -> np.ndarray:
        """Of the center of mass, m/s. Setting: Sets the velocity of the center of mass, m/s. Not of static bodies."""
    @linear_velocity.setter
    def linear_velocity(self, value: Vector) -> None: ...
    @property
    def angular_velocity(self) -> np.ndarray:
        """rad/s. Setting: Sets the angular velocity, rad/s, world axes. Not of static bodies."""
    @angular_velocity.setter
    def angular_velocity(self, value: Vector) -> None: ...
    def velocity_at(self, point: Vector) -> np.ndarray:
        """Of the body's material at a world point, m/s. Raises: invalid_handle, invalid_value, wrong_state."""
    @property
    def mass(self) -> float:
        """kg; +infinity for static and kinematic bodies."""
    @property
    def mass_properties(self) -> MassProperties:
        """Mass, center of mass and inertia, as set or computed from the shapes. Setting: Replaces the mass properties;
        they no longer follow the shapes. Dynamic bodies only.
        """
    @mass_properties.setter
    def mass_properties(self, value: MassProperties) -> None: ...
    @property
    def world_inertia(self) -> np.ndarray:
        """About the center of mass, world axes, kg m^2."""
    @property
    def angular_momentum(self) -> np.ndarray:
        """About the center of mass, kg m^2/s."""
    @property
    def kinetic_energy(self) -> float:
        """Linear and rotational, J; 0 for static and kinematic bodies."""
    @property
    def gravity_scale(self) -> float:
        """What gravity is multiplied with for this body. Setting: Multiplies gravity for this body; any finite value.
        """
    @gravity_scale.setter
    def gravity_scale(self, value: float) -> None: ...
    @property
    def linear_damping(self) -> float:
        """1/s."""
    @property
    def angular_damping(self) -> float:
        """1/s."""
    @property
    def is_awake(self) -> bool:
        """Static bodies never are; kinematic ones are while they move."""
    @property
    def allow_sleep(self) -> bool:
        """Whether it may fall asleep. Setting: False: the body and its island never fall asleep."""
    @allow_sleep.setter
    def allow_sleep(self, value: bool) -> None: ...
    @property
    def enabled(self) -> bool:
        """Whether it takes part in the world. Setting: Takes a body out of the world and puts it back, with its shapes,
        joints and handles as they are: for what is used again and again, or not yet. What is disabled does not move and
        keeps its velocities; nothing touches it, queries do not see it, its joints do not act, and energies and momenta
        are without it. All of it may be changed, but nothing can push it: forces and impulses are refused
        (wrong_state). What it touched ends with a ContactEnd, and wakes; where it is put back into something, it is
        pushed out as what is made there.
        """
    @enabled.setter
    def enabled(self, value: bool) -> None: ...
    @property
    def shapes(self) -> list[ShapeId]:
        """Its shapes, oldest first."""
    def set_transform(self, position: Vector, rotation: Vector) -> None:
        """Teleports the body: velocities stay, contacts are found anew. Raises: invalid_handle, invalid_value,
        wrong_state.
        """
    def move_to(self, target: Transform, seconds: float) -> None:
        """Kinematic bodies: sets the velocities that bring the body to `target` in `seconds` (> 0). Raises:
        invalid_handle, invalid_value, wrong_state.
        """
    def set_damping(self, linear: float, angular: float) -> None:
        """1/s, >= 0: the velocities decay as v' = -damping v. Raises: invalid_handle, invalid_value, wrong_state."""
    def set_mass_from_shapes(self, mass: float | None = None) -> None:
        """Mass properties follow the shapes' densities again, scaled to `mass` if given. Raises: invalid_handle,
        invalid_value, wrong_state.
        """
    def wake(self) -> None:
        """Wakes the body and its island. Raises: invalid_handle, wrong_state."""
    def sleep(self) -> None:
        """Brings a dynamic body to rest and lets it sleep from the next step on, as it is, even in the air: before
        anything moves, provided that all that touches it or is joined to it was told so, too, and may sleep. A level
        that is made asleep costs nothing until something comes; then it settles like anything that is made. What moves
        or pushes the body in between wakes it, as ever. Raises: invalid_handle, wrong_state.
        """
    def add_force(self, force: Vector) -> None:
        """N, at the center of mass; acts during the next step only. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def add_force_at(self, force: Vector, point: Vector) -> None:
        """N, at a world point; next step only. Raises: invalid_handle, invalid_value, wrong_state."""
    def add_torque(self, torque: Vector) -> None:
        """N m; next step only. Raises: invalid_handle, invalid_value, wrong_state."""
    def apply_impulse(self, impulse: Vector) -> None:
        """N s, at the center of mass; changes the velocity at once. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def apply_impulse_at(self, impulse: Vector, point: Vector) -> None:
        """N s, at a world point. Raises: invalid_handle, invalid_value, wrong_state."""
    def apply_angular_impulse(self, impulse: Vector) -> None:
        """N m s. Raises: invalid_handle, invalid_value, wrong_state."""
    @property
    def is_character(self) -> bool:
        """Whether the body is a character."""
    @property
    def character(self) -> CharacterDef:
        """How the character moves (wrong_state unless it is one). Setting: Makes a kinematic body a character, or
        changes how one moves. From then on its velocities are those with which each step moves it, and setting its
        linear velocity throws it: upwards, it leaves the ground.
        """
    @character.setter
    def character(self, value: CharacterDef) -> None: ...
    def remove_character(self) -> None:
        """It is an ordinary kinematic body again, at rest. Raises: invalid_handle, wrong_state."""
    @property
    def walk_velocity(self) -> np.ndarray:
        """Where the character wants to go, m/s. Setting: Where a character wants to go, m/s, until it is set anew: over
        the ground, with this speed and, seen from above, in this direction, beside the motion of the ground itself.
        What of it leads up or down counts for those alone that fly.
        """
    @walk_velocity.setter
    def walk_velocity(self, value: Vector) -> None: ...
    def jump(self, speed: float) -> None:
        """In the next step, a character that stands on the ground leaves it with this speed, m/s, > 0; others do not.
        Raises: invalid_handle, invalid_value, wrong_state.
        """
    @property
    def character_state(self) -> CharacterState:
        """How the character moves and what it is on, as it stood after the last step."""
    @property
    def joints(self) -> list[JointId]:
        """Those of one body, oldest first."""
    @property
    def contacts(self) -> list[Contact]:
        """Those of one body."""

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
    def add_shape(self, body: BodyId | Body, shape: Shape, definition: ShapeDef | None = None, **members: Any) -> ShapeId:
        """Adds a shape to a body and, unless its mass properties were given, updates them. A dynamic body whose shapes
        have no mass at all is a point of its given mass, or of 1 kg, that does not turn. Planes are refused on dynamic
        bodies. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def remove_shape(self, shape: ShapeId) -> None:
        """Takes a shape off its body, whose mass properties follow unless they were given. Raises: invalid_handle,
        wrong_state.
        """
    def set_shape(self, shape: ShapeId, geometry: Shape) -> None:
        """Gives a shape another geometry, in place: its handle and all that its definition says stay. The mass of the
        body follows as when a shape is added. What it touches then goes on touching it, without events, as long as it
        is of the same type; else its contacts end and begin anew. What overlaps it then is pushed out, no faster than
        `WorldDef.recovery_speed`: ground that rises carries what is on it if it rises more slowly than that, and by
        less than the height of that in one call. Wakes its body and what is around the shape, before and after. Raises:
        invalid_handle, invalid_value, wrong_state.
        """
    def set_shape_def(self, shape: ShapeId, definition: ShapeDef | None = None, **members: Any) -> None:
        """Gives a shape another definition, in place: place on its body, density, material, filter, and what else that
        says; to change a part of it, begin with the one that it has. Its contacts end and begin anew where `is_trigger`
        or `filter` is not what it was; else as when its geometry is set. Raises: invalid_handle, invalid_value,
        wrong_state.
        """
    def body_of(self, shape: ShapeId) -> BodyId:
        """The body that a shape is on. Raises: invalid_handle, wrong_state."""
    def shape(self, shape: ShapeId) -> Shape:
        """What was added. Raises: invalid_handle, wrong_state."""
    def shape_def(self, shape: ShapeId) -> ShapeDef:
        """How it is attached to its body, as it is now. Raises: invalid_handle, wrong_state."""
    def shape_transform(self, shape: ShapeId) -> Transform:
        """In world space. Raises: invalid_handle, wrong_state."""
    def shape_bounds(self, shape: ShapeId) -> Bounds:
        """Tight; infinite for infinite planes. Raises: invalid_handle, wrong_state."""
    def set_material(self, shape: ShapeId, material: Material) -> None:
        """Replaces the material. Raises: invalid_handle, invalid_value, wrong_state."""
    def set_filter(self, shape: ShapeId, filter: CollisionFilter) -> None:
        """Replaces the collision filter. Raises: invalid_handle, invalid_value, wrong_state."""
    def set_surface_velocity(self, shape: ShapeId, velocity: Vector) -> None:
        """See `ShapeDef.surface_velocity`. Refused (wrong_state) for a shape of a dynamic body. Raises: invalid_handle,
        invalid_value, wrong_state.
        """
    @property
    def bodies(self) -> list[BodyId]:
        """All, in order of slot index."""
    def find_body(self, name: str) -> BodyId | None:
        """The first of that name. Raises: wrong_state."""
    def create_joint(self, definition: JointDef | None = None, **members: Any) -> JointId:
        """Joins two bodies, or a body and the world. Wakes them. Raises: invalid_value, wrong_state."""
    def joint_at(self, body_a: BodyId | Body, body_b: BodyId | Body, anchor: Vector, axis: Vector, joint: Joint) -> JointDef:
        """The definition of a joint whose frames both lie at `anchor`, with x along `axis` (any non-zero vector; world
        space), and y and z as the shortest turn from those of the world has them: -x and z if `axis` points up. As the
        bodies stand now. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def destroy_joint(self, joint: JointId) -> None:
        """Takes a joint out of the world and wakes its bodies. Raises: invalid_handle, wrong_state."""
    def joint_def(self, joint: JointId) -> JointDef:
        """The definition of a joint, as it is now. Raises: invalid_handle, wrong_state."""
    def set_joint(self, id: JointId, joint: Joint) -> None:
        """Changes limits, motors, springs, or the kind of the joint. Wakes its bodies. Raises: invalid_handle,
        invalid_value, wrong_state.
        """
    def set_joint_strength(self, joint: JointId, break_force: float, break_torque: float) -> None:
        """N and N m, > 0; may be infinite. Raises: invalid_handle, invalid_value, wrong_state."""
    def set_joint_enabled(self, joint: JointId, enabled: bool) -> None:
        """A joint that is disabled keeps its definition and its handle, and acts on nothing: its bodies move, and
        collide, as if it had been destroyed. Enabled again it begins without impulses, and brings its bodies together
        where they have parted. Both wake them. Raises: invalid_handle, wrong_state.
        """
    def joint_state(self, joint: JointId) -> JointState:
        """What a joint did in the last step. Raises: invalid_handle, wrong_state."""
    @property
    def joints(self) -> list[JointId]:
        """All, in order of slot index."""
    def find_joint(self, name: str) -> JointId | None:
        """The first of that name. Raises: wrong_state."""
    def cast_ray(self, origin: Vector, direction: Vector, max_distance: float, filter: QueryFilter | None = None, **members: Any) -> RayHit | None:
        """The nearest shape that the ray meets within `max_distance`. `direction` need not be unit length. A ray that
        starts inside a shape does not meet that shape's surface from within, except planes' solid side. Raises:
        invalid_handle, invalid_value, wrong_state.
        """
    def cast_ray_all(self, origin: Vector, direction: Vector, max_distance: float, filter: QueryFilter | None = None, **members: Any) -> list[RayHit]:
        """Every shape that the ray meets, nearest first. Raises: invalid_handle, invalid_value, wrong_state."""
    def cast_shape(self, shape: Shape, start: Transform, translation: Vector, filter: QueryFilter | None = None, **members: Any) -> ShapeCastHit | None:
        """The first shape that the given convex one meets when it moves by `translation` (meters) from `start` without
        turning. Planes, meshes and height fields are met from outside only, and cannot be cast themselves
        (invalid_value). Raises: invalid_handle, invalid_value, wrong_state.
        """
    def closest_point(self, point: Vector, max_distance: float, filter: QueryFilter | None = None, **members: Any) -> ClosestPoint | None:
        """The shape nearest to a point, up to `max_distance` (meters, >= 0) away. What is below a plane is inside it;
        meshes and height fields have no inside. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def overlap(self, shape: Shape, pose: Transform, filter: QueryFilter | None = None, **members: Any) -> list[ShapeId]:
        """Shapes that overlap the given shape posed in the world, in order of slot index. Raises: invalid_handle,
        invalid_value, wrong_state.
        """
    def overlap_bounds(self, bounds: Bounds, filter: QueryFilter | None = None, **members: Any) -> list[ShapeId]:
        """Shapes whose tight bounds overlap the box, in order of slot index. Raises: invalid_handle, invalid_value,
        wrong_state.
        """
    def broad_phase_nodes(self, max_depth: int, max_count: int) -> list[BroadPhaseNode]:
        """The boxes of the broad phase as they stand, down to that depth, for pictures and for who wants to know why a
        scene is slow: those of least depth first, and no more than `max_count`. Both >= 0. Raises: invalid_value,
        wrong_state.
        """
    @property
    def solver_contacts(self) -> list[SolverContact]:
        """How each touching pair of shapes is solved, in the order of `world_get_contacts`."""
    def debug_lines(self, what: DebugLinesDef | None = None, **members: Any) -> list[DebugLine]:
        """What the world consists of as lines, for programs that draw it themselves: bodies in order of slot index,
        then contacts, then joints. As many as there are edges: of large meshes and height fields that takes its time.
        Raises: invalid_value, wrong_state.
        """
    @property
    def contact_begins(self) -> list[ContactBegin]:
        """Shapes that began to touch in the last step."""
    @property
    def contact_ends(self) -> list[ContactEnd]:
        """Shapes that ceased to touch in the last step."""
    @property
    def contact_hits(self) -> list[ContactHit]:
        """Shapes that hit each other in the last step, at `WorldDef.hit_speed` or more."""
    @property
    def trigger_events(self) -> list[TriggerEvent]:
        """What came into triggers and left them in the last step."""
    @property
    def joint_events(self) -> list[JointEvent]:
        """Joints that broke or lost a body in the last step, or since."""
    @property
    def sleep_events(self) -> list[SleepEvent]:
        """Bodies that fell asleep or woke up in the last step."""
    @property
    def contacts(self) -> list[Contact]:
        """All touching pairs."""
    @property
    def settings(self) -> WorldDef:
        """What the world was made with, or was last set to. Setting: Replaces the settings. Wakes everything if gravity
        changes.
        """
    @settings.setter
    def settings(self, value: WorldDef) -> None: ...
    def usual_substeps(self, dt: float) -> int:
        """The substeps of a step of `dt` seconds, finite and > 0, where no island asks for more: `WorldDef.substeps`,
        or what its 0 stands for. Raises: invalid_value, wrong_state.
        """
    @property
    def threads(self) -> int:
        """The number of threads that a step may use. Setting: The number of threads that a step may use: that of the
        caller, and `count` - 1 more that the world keeps. 1 to 256; default 1. Results do not depend on it. Snapshots
        do not hold it. Raises outside that range, or when the system has no more threads.
        """
    @threads.setter
    def threads(self, value: int) -> None: ...
    def add_force_field(self, field: ForceField | None = None, **members: Any) -> ForceFieldId:
        """Adds a field that acts on every dynamic body from the next step on. Raises: invalid_value, wrong_state."""
    def set_force_field(self, id: ForceFieldId, field: ForceField | None = None, **members: Any) -> None:
        """Replaces a field by another one. Raises: invalid_handle, invalid_value, wrong_state."""
    def remove_force_field(self, id: ForceFieldId) -> None:
        """Takes a field out of the world. Raises: invalid_handle, wrong_state."""
    def force_field(self, id: ForceFieldId) -> ForceField:
        """A field, as it is now. Raises: invalid_handle, wrong_state."""
    @property
    def force_fields(self) -> list[ForceFieldId]:
        """All, in order of slot index."""
    @property
    def step_count(self) -> int:
        """Steps since the world was made."""
    @property
    def time(self) -> float:
        """Simulated seconds."""
    @property
    def kinetic_energy(self) -> float:
        """J, of all dynamic bodies."""
    @property
    def potential_energy(self) -> float:
        """J in the world's gravity, relative to the origin."""
    @property
    def linear_momentum(self) -> np.ndarray:
        """kg m/s, of all dynamic bodies."""
    @property
    def angular_momentum(self) -> np.ndarray:
        """kg m^2/s about the origin, of all dynamic bodies."""
    @property
    def state_hash(self) -> int:
        """Of positions, rotations and velocities, by bits."""
    @property
    def statistics(self) -> Statistics:
        """Counts and times of the last step."""

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
