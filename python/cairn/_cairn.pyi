# Made by tools/api.py from api/: change those, and run it.
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
    @property
    def type(self) -> BodyType:
        """How the body moves. Setting: Makes the body static, kinematic or dynamic."""
    @type.setter
    def type(self, value: BodyType | str) -> None: ...
    @property
    def name(self) -> str:
        """The name of the body, as in `BodyDef.name`. Setting: Sets the name, for display and `World.find_body`; it
        need not be unique.
        """
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def user_data(self) -> int:
        """The number that the application stored in `BodyDef.user_data`."""
    @property
    def position(self) -> np.ndarray:
        """Origin of the body's frame, meters. Setting: Teleports the origin of the body's frame: velocities stay, and
        contacts are detected afresh in the next step.
        """
    @position.setter
    def position(self, value: Vector) -> None: ...
    @property
    def rotation(self) -> np.ndarray:
        """Rotation of the body's frame, of unit length. Setting: Rotates the body about its origin at once: velocities
        stay, and contacts are detected afresh in the next step. Normalized on entry; must not be zero.
        """
    @rotation.setter
    def rotation(self, value: Vector) -> None: ...
    @property
    def transform(self) -> Transform:
        """Position and rotation of the body's frame."""
    @property
    def center_of_mass(self) -> np.ndarray:
        """Center of mass in world space, meters. For a kinematic body: its origin, unless `BodyDef.mass_properties`
        gave a center of mass.
        """
    @property
    def linear_velocity(self) -> np.ndarray:
        """Velocity of the center of mass, m/s. Setting: Sets the velocity of the center of mass, m/s. Refused
        (wrong_state) for static bodies.
        """
    @linear_velocity.setter
    def linear_velocity(self, value: Vector) -> None: ...
    @property
    def angular_velocity(self) -> np.ndarray:
        """Angular velocity in world axes, rad/s. Setting: Sets the angular velocity, rad/s, world axes. Refused
        (wrong_state) for static bodies.
        """
    @angular_velocity.setter
    def angular_velocity(self, value: Vector) -> None: ...
    def velocity_at(self, point: Vector) -> np.ndarray:
        """Velocity of the body's material at a point in world space, m/s. Raises: invalid_handle, invalid_value,
        wrong_state.
        """
    @property
    def mass(self) -> float:
        """Mass, kg; +infinity for static and kinematic bodies."""
    @property
    def mass_properties(self) -> MassProperties:
        """Mass, center of mass and inertia, as set or computed from the shapes. Setting: Sets the mass properties,
        which then do not follow the shapes. Dynamic bodies only; refused (wrong_state) for others.
        """
    @mass_properties.setter
    def mass_properties(self, value: MassProperties) -> None: ...
    @property
    def world_inertia(self) -> np.ndarray:
        """Inertia tensor about the center of mass, world axes, kg m^2."""
    @property
    def angular_momentum(self) -> np.ndarray:
        """Angular momentum about the center of mass, kg m^2/s."""
    @property
    def kinetic_energy(self) -> float:
        """Linear and rotational kinetic energy, J; 0 for static and kinematic bodies."""
    @property
    def gravity_scale(self) -> float:
        """The factor by which gravity is multiplied for this body. Setting: Sets the factor by which gravity is
        multiplied for this body; any finite value.
        """
    @gravity_scale.setter
    def gravity_scale(self, value: float) -> None: ...
    @property
    def linear_damping(self) -> float:
        """Damping of the linear velocity, 1/s."""
    @property
    def angular_damping(self) -> float:
        """Damping of the angular velocity, 1/s."""
    @property
    def is_awake(self) -> bool:
        """Whether the body is awake. A static or disabled body never is; a kinematic body is while one of its
        velocities is not zero.
        """
    @property
    def allow_sleep(self) -> bool:
        """Whether the body may fall asleep. Setting: False: the body and its island never fall asleep."""
    @allow_sleep.setter
    def allow_sleep(self, value: bool) -> None: ...
    @property
    def enabled(self) -> bool:
        """Whether the body takes part in the simulation. Setting: Takes the body out of the simulation (false) or puts
        it back (true), and keeps its shapes, joints and handles. This suits bodies that are reused often, or that are
        needed only later. A disabled body does not move but keeps its velocities; it has no contacts, queries do not
        find it, its joints do not act, and energies and momenta of the world exclude it. Its properties may be changed,
        but forces and impulses are refused (wrong_state). When it is disabled, its contacts end with a ContactEnd, and
        the bodies that it touched wake. If it overlaps others when it is enabled, it is pushed out of them like a newly
        created body.
        """
    @enabled.setter
    def enabled(self, value: bool) -> None: ...
    @property
    def shapes(self) -> list[ShapeId]:
        """The shapes of the body, oldest first."""
    def set_transform(self, position: Vector, rotation: Vector) -> None:
        """Teleports the body: its velocities stay, and its contacts are detected afresh in the next step. Raises:
        invalid_handle, invalid_value, wrong_state.
        """
    def move_to(self, target: Transform, seconds: float) -> None:
        """Sets the velocities of a kinematic body such that it reaches `target` after `seconds` (> 0). It keeps these
        velocities afterwards. Refused (wrong_state) for bodies of other types. Raises: invalid_handle, invalid_value,
        wrong_state.
        """
    def set_damping(self, linear: float, angular: float) -> None:
        """Sets the damping of the linear and angular velocity, 1/s, >= 0: velocities decay as v' = -damping v. Raises:
        invalid_handle, invalid_value, wrong_state.
        """
    def set_mass_from_shapes(self, mass: float | None = None) -> None:
        """Makes the mass properties follow the densities of the shapes again, scaled to a total of `mass` (kg, > 0) if
        it is given. Dynamic bodies only; refused (wrong_state) for others. Raises: invalid_handle, invalid_value,
        wrong_state.
        """
    def wake(self) -> None:
        """Wakes the body and its island. Raises: invalid_handle, wrong_state."""
    def sleep(self) -> None:
        """Sets the velocities of a dynamic body to zero and puts it to sleep at the beginning of the next step, at its
        present place, even in the air. This requires that `sleep` was called for all bodies of its island, that is,
        also for those that it touches or is joined to, and that all of them may sleep. A level that is created asleep
        costs no time until something wakes it; then it settles like newly created bodies. Calls that move or push the
        body before that step wake it as usual. No effect on other types of bodies, and where `WorldDef.enable_sleep` is
        false. Raises: invalid_handle, wrong_state.
        """
    def add_force(self, force: Vector) -> None:
        """Adds a force, N, at the center of mass; it acts during the next step only. Raises: invalid_handle,
        invalid_value, wrong_state.
        """
    def add_force_at(self, force: Vector, point: Vector) -> None:
        """Adds a force, N, at a point in world space; it acts during the next step only. Raises: invalid_handle,
        invalid_value, wrong_state.
        """
    def add_torque(self, torque: Vector) -> None:
        """Adds a torque, N m; it acts during the next step only. Raises: invalid_handle, invalid_value, wrong_state."""
    def apply_impulse(self, impulse: Vector) -> None:
        """Applies an impulse, N s, at the center of mass; it changes the velocity at once. Raises: invalid_handle,
        invalid_value, wrong_state.
        """
    def apply_impulse_at(self, impulse: Vector, point: Vector) -> None:
        """Applies an impulse, N s, at a point in world space; it changes the velocities at once. Raises:
        invalid_handle, invalid_value, wrong_state.
        """
    def apply_angular_impulse(self, impulse: Vector) -> None:
        """Applies an angular impulse, N m s; it changes the angular velocity at once. Raises: invalid_handle,
        invalid_value, wrong_state.
        """
    @property
    def is_character(self) -> bool:
        """Whether the body is a character."""
    @property
    def character(self) -> CharacterDef:
        """The definition of the character. Refused (wrong_state) if the body is no character. Setting: Makes a
        kinematic body a character, or changes the definition of a character. From then on each step sets the velocities
        of the body to those with which it moves the character. Setting its linear velocity then throws the character:
        with an upward velocity, it leaves the ground.
        """
    @character.setter
    def character(self, value: CharacterDef) -> None: ...
    def remove_character(self) -> None:
        """Makes the character an ordinary kinematic body again, at rest. Raises: invalid_handle, wrong_state."""
    @property
    def walk_velocity(self) -> np.ndarray:
        """The velocity with which the character tries to move, m/s, relative to the ground. Refused (wrong_state) if
        the body is no character. Setting: Sets the velocity with which a character tries to move, m/s, relative to the
        ground; it holds until the next call. The character moves along the ground with this speed, in this direction as
        seen from above. The component along `CharacterDef.up` is used only if the character flies
        (`CharacterDef.flies`).
        """
    @walk_velocity.setter
    def walk_velocity(self, value: Vector) -> None: ...
    def jump(self, speed: float) -> None:
        """A character that stands on the ground leaves it in the next step with this upward speed, m/s, > 0. No effect
        on a character that does not stand then. Raises: invalid_handle, invalid_value, wrong_state.
        """
    @property
    def character_state(self) -> CharacterState:
        """The motion and support of the character after the last step. Refused (wrong_state) if the body is no
        character.
        """
    @property
    def joints(self) -> list[JointId]:
        """The joints of one body, oldest first."""
    @property
    def contacts(self) -> list[Contact]:
        """The contact manifolds of one body."""

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
    def add_shape(self, body: BodyId | Body, shape: Shape, definition: ShapeDef | None = None, **members: Any) -> ShapeId:
        """Adds a shape to a body and, unless its mass properties were given, updates these. A dynamic body whose shapes
        have no mass has its given mass, or 1 kg, at a point, and does not rotate. Planes, meshes and height fields are
        refused on dynamic bodies (wrong_state). Raises: invalid_handle, invalid_value, wrong_state.
        """
    def remove_shape(self, shape: ShapeId) -> None:
        """Removes a shape from its body and, unless the mass properties of the body were given, updates these. Raises:
        invalid_handle, wrong_state.
        """
    def set_shape(self, shape: ShapeId, geometry: Shape) -> None:
        """Replaces the geometry of a shape; its handle and its definition stay. The mass of the body is updated as when
        a shape is added. If the new geometry is of the same type, contacts with shapes that it still touches continue
        without events; otherwise its contacts end and begin anew. Shapes that overlap the new geometry are pushed out
        with at most `WorldDef.recovery_speed`. Rising ground therefore carries the bodies on it if it rises more slowly
        than that, and in one call by less than the height of the body. Wakes the body of the shape, and bodies around
        the old and the new geometry. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def set_shape_def(self, shape: ShapeId, definition: ShapeDef | None = None, **members: Any) -> None:
        """Replaces the definition of a shape in the same way as its geometry: its pose on the body, density, material,
        filter, and so on. To change only a part of it, begin with the present definition. Its contacts end and begin
        anew if `is_trigger` or `filter` changes. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def body_of(self, shape: ShapeId) -> BodyId:
        """The body to which a shape belongs. Raises: invalid_handle, wrong_state."""
    def shape(self, shape: ShapeId) -> Shape:
        """The geometry of a shape. Raises: invalid_handle, wrong_state."""
    def shape_def(self, shape: ShapeId) -> ShapeDef:
        """The present definition of a shape. Raises: invalid_handle, wrong_state."""
    def shape_transform(self, shape: ShapeId) -> Transform:
        """The pose of a shape in world space. Raises: invalid_handle, wrong_state."""
    def shape_bounds(self, shape: ShapeId) -> Bounds:
        """Tight axis-aligned bounds of a shape, meters; infinite for infinite planes. Raises: invalid_handle,
        wrong_state.
        """
    def set_material(self, shape: ShapeId, material: Material) -> None:
        """Replaces the material of a shape. Raises: invalid_handle, invalid_value, wrong_state."""
    def set_filter(self, shape: ShapeId, filter: CollisionFilter) -> None:
        """Replaces the collision filter of a shape. Raises: invalid_handle, invalid_value, wrong_state."""
    def set_surface_velocity(self, shape: ShapeId, velocity: Vector) -> None:
        """Sets `ShapeDef.surface_velocity`, m/s. Refused (wrong_state) for a shape of a dynamic body. Raises:
        invalid_handle, invalid_value, wrong_state.
        """
    @property
    def bodies(self) -> list[BodyId]:
        """All bodies, in order of slot index."""
    def find_body(self, name: str) -> BodyId | None:
        """The first body with that name. Raises: wrong_state."""
    def create_joint(self, definition: JointDef | None = None, **members: Any) -> JointId:
        """Joins two bodies, or a body and the world, and wakes them. Raises: invalid_value, wrong_state."""
    def joint_at(self, body_a: BodyId | Body, body_b: BodyId | Body, anchor: Vector, axis: Vector, joint: Joint) -> JointDef:
        """Returns the definition of a joint whose two frames coincide, for the present poses of the bodies: with their
        origin at `anchor` (world space, meters) and x along `axis` (world space, any non-zero vector). The y and z axes
        result from the shortest rotation that takes the world's x axis to `axis`: for an `axis` along +y, they are -x
        and z. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def destroy_joint(self, joint: JointId) -> None:
        """Destroys a joint and wakes its bodies. Raises: invalid_handle, wrong_state."""
    def joint_def(self, joint: JointId) -> JointDef:
        """The present definition of a joint. Raises: invalid_handle, wrong_state."""
    def set_joint(self, id: JointId, joint: Joint) -> None:
        """Replaces the type-specific part of a joint: limits, motors, springs, or its type. Wakes its bodies. Raises:
        invalid_handle, invalid_value, wrong_state.
        """
    def set_joint_strength(self, joint: JointId, break_force: float, break_torque: float) -> None:
        """Sets the force (N) and torque (N m) at which a joint breaks, > 0; may be infinite. Raises: invalid_handle,
        invalid_value, wrong_state.
        """
    def set_joint_enabled(self, joint: JointId, enabled: bool) -> None:
        """Disables or enables a joint. A disabled joint keeps its definition and its handle but does not act: its
        bodies move and collide as if it had been destroyed. When it is enabled, it starts with zero impulses, and pulls
        its bodies together if they have moved apart. Both wake its bodies. Raises: invalid_handle, wrong_state.
        """
    def joint_state(self, joint: JointId) -> JointState:
        """Forces, positions and errors of a joint in the last step. Raises: invalid_handle, wrong_state."""
    @property
    def joints(self) -> list[JointId]:
        """All joints, in order of slot index."""
    def find_joint(self, name: str) -> JointId | None:
        """The first joint with that name. Raises: wrong_state."""
    def cast_ray(self, origin: Vector, direction: Vector, max_distance: float, filter: QueryFilter | None = None, **members: Any) -> RayHit | None:
        """The nearest intersection of a ray with a shape within `max_distance` (meters). `direction` need not have unit
        length. A ray that starts inside a shape does not hit that shape; only one that starts below an infinite plane
        hits it, at distance 0. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def cast_ray_all(self, origin: Vector, direction: Vector, max_distance: float, filter: QueryFilter | None = None, **members: Any) -> list[RayHit]:
        """The intersections of the ray with all shapes within `max_distance` (meters), nearest first. Raises:
        invalid_handle, invalid_value, wrong_state.
        """
    def cast_shape(self, shape: Shape, start: Transform, translation: Vector, filter: QueryFilter | None = None, **members: Any) -> ShapeCastHit | None:
        """The first shape that the given convex shape hits when it moves by `translation` (meters) from `start` without
        rotation. The accuracy is a millionth of the size of the smaller shape. If they overlap at the start, the
        fraction is 0, and point and normal are those of the smallest separating translation; if several shapes overlap,
        the one with the lowest slot index is returned. Planes, meshes and height fields are hit from outside only, and
        cannot be cast (invalid_value). Raises: invalid_handle, invalid_value, wrong_state.
        """
    def closest_point(self, point: Vector, max_distance: float, filter: QueryFilter | None = None, **members: Any) -> ClosestPoint | None:
        """The shape nearest to a point, at most `max_distance` (meters, >= 0) away. Points below a plane are inside it;
        meshes and height fields have no inside. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def overlap(self, shape: Shape, pose: Transform, filter: QueryFilter | None = None, **members: Any) -> list[ShapeId]:
        """All shapes that have a point in common with the given shape at `pose` (touching counts), in order of slot
        index. A plane is solid below. Rectangles, strips, double-sided planes, meshes and height fields are surfaces
        without thickness: a shape that touches or crosses them from any side overlaps them; a shape entirely below does
        not. Two surfaces never overlap. Raises: invalid_handle, invalid_value, wrong_state.
        """
    def overlap_bounds(self, bounds: Bounds, filter: QueryFilter | None = None, **members: Any) -> list[ShapeId]:
        """Shapes whose tight bounds overlap the box, in order of slot index. Raises: invalid_handle, invalid_value,
        wrong_state.
        """
    def broad_phase_nodes(self, max_depth: int, max_count: int) -> list[BroadPhaseNode]:
        """The present nodes of the broad phase down to `max_depth` (>= 0), in order of depth, at most `max_count` (>=
        0): for visualization, and to find out why a scene is slow. Raises: invalid_value, wrong_state.
        """
    @property
    def solver_contacts(self) -> list[SolverContact]:
        """How each touching pair of shapes is solved, in the order of `world_get_contacts`."""
    def debug_lines(self, what: DebugLinesDef | None = None, **members: Any) -> list[DebugLine]:
        """The contents of the world as lines, for programs with their own renderer: bodies in order of slot index, then
        contacts, then joints. There is a line for each edge, which takes time for large meshes and height fields.
        Raises: invalid_value, wrong_state.
        """
    @property
    def contact_begins(self) -> list[ContactBegin]:
        """Pairs of shapes that began to touch in the last step."""
    @property
    def contact_ends(self) -> list[ContactEnd]:
        """Pairs of shapes that ceased to touch in the last step."""
    @property
    def contact_hits(self) -> list[ContactHit]:
        """Pairs of shapes that hit each other in the last step with an approach speed of at least `WorldDef.hit_speed`.
        """
    @property
    def trigger_events(self) -> list[TriggerEvent]:
        """Shapes that entered or left triggers in the last step."""
    @property
    def joint_events(self) -> list[JointEvent]:
        """Joints that broke, or of which a body was destroyed, in the last step or since then."""
    @property
    def sleep_events(self) -> list[SleepEvent]:
        """Bodies that fell asleep or woke up in the last step."""
    @property
    def contacts(self) -> list[Contact]:
        """The contact manifolds of all touching pairs of shapes."""
    @property
    def settings(self) -> WorldDef:
        """The present settings of the world. Setting: Replaces the settings. Wakes all bodies if gravity changes."""
    @settings.setter
    def settings(self, value: WorldDef) -> None: ...
    def usual_substeps(self, dt: float) -> int:
        """The number of substeps in a step of `dt` seconds for islands that need no more: `WorldDef.substeps`, or, if
        that is 0, the number for which it stands. Refused (invalid_value) unless `dt` is finite and > 0. Raises:
        invalid_value, wrong_state.
        """
    @property
    def threads(self) -> int:
        """The number of threads that a step may use. Setting: Sets the number of threads that a step may use, 1 to 256:
        the caller's, and `count` - 1 that the world keeps. Default: 1. Results do not depend on it, and it is not part
        of snapshots. Refused (invalid_value) outside that range, and (unsupported) if the system cannot create the
        threads.
        """
    @threads.setter
    def threads(self, value: int) -> None: ...
    def add_force_field(self, field: ForceField | None = None, **members: Any) -> ForceFieldId:
        """Adds a force field, which acts on all dynamic bodies from the next step on. Raises: invalid_value,
        wrong_state.
        """
    def set_force_field(self, id: ForceFieldId, field: ForceField | None = None, **members: Any) -> None:
        """Replaces a force field by another. Raises: invalid_handle, invalid_value, wrong_state."""
    def remove_force_field(self, id: ForceFieldId) -> None:
        """Removes a force field from the world. Raises: invalid_handle, wrong_state."""
    def force_field(self, id: ForceFieldId) -> ForceField:
        """The present definition of a force field. Raises: invalid_handle, wrong_state."""
    @property
    def force_fields(self) -> list[ForceFieldId]:
        """All force fields, in order of slot index."""
    @property
    def step_count(self) -> int:
        """Number of steps since the world was created."""
    @property
    def time(self) -> float:
        """Simulated time since the world was created, seconds."""
    @property
    def kinetic_energy(self) -> float:
        """Kinetic energy of all dynamic bodies, J."""
    @property
    def potential_energy(self) -> float:
        """Potential energy in the world's gravity, relative to the origin, J."""
    @property
    def linear_momentum(self) -> np.ndarray:
        """Linear momentum of all dynamic bodies, kg m/s."""
    @property
    def angular_momentum(self) -> np.ndarray:
        """Angular momentum of all dynamic bodies about the origin, kg m^2/s."""
    @property
    def state_hash(self) -> int:
        """A hash of the bits of all positions, rotations and velocities."""
    @property
    def statistics(self) -> Statistics:
        """Counts and times of the last step."""

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
