# Made by tools/api.py from api/: change those, and run it.
"""Structs and enums of the API: those of include/cairn/world.h."""
from __future__ import annotations

import enum
from dataclasses import dataclass, field

from .events import Contact
from ._members import lists_members
from ._vector import Vector


class Integrator(enum.Enum):
    """How free motion is integrated over a substep of length h. Contacts work with all of them."""

    semi_implicit_euler = 0
    """v += h a, then x += h v. Bounded energy error; the default."""
    explicit_euler = 1
    """x += h v, then v += h a. Gains energy; kept for teaching."""
    rk4 = 2
    """Classic fourth-order Runge-Kutta."""


class ForceFieldKind(enum.Enum):
    """The kind of a force field."""

    uniform = 0
    """`direction` at every place."""
    radial = 1
    """`strength` x distance^`exponent`, towards `center`."""
    fluid = 2
    """A fluid with a level surface through `center`, which flows with the velocity `direction`."""


@lists_members
@dataclass(slots=True, eq=False)
class WorldDef:
    """Settings of a world. All may be changed later with `World.set_settings`."""

    gravity: Vector = (0.0, -9.81, 0.0)
    """Acceleration of gravity, m/s^2, finite."""
    substeps: int = 0
    """Number of solver substeps in a step, 0 to 256. 0: as many as are needed for substeps of at most 1/360 s (6 at 60
    Hz, 2 at 240 Hz).
    """
    adaptive_substeps: bool = True
    """True: more substeps for islands that need them: with joints (substeps of at most 1/660 s), high mass ratios, tall
    stacks, or bodies less than 10 cm wide.
    """
    integrator: Integrator | str = Integrator.semi_implicit_euler
    """How free motion is integrated."""
    enable_sleep: bool = True
    """True: islands at rest fall asleep, and then cost no time."""
    sleep_speed: float = 0.05
    """m/s, >= 0: a body is at rest if no point of its surface is faster."""
    sleep_time: float = 0.5
    """s, >= 0: time at rest before an island falls asleep, unless its speed grows steadily."""
    restitution_speed: float = 0.02
    """m/s, >= 0: slower impacts do not bounce."""
    hit_speed: float = 1.0
    """m/s, >= 0: least approach speed for a hit event."""
    recovery_speed: float = 3.0
    """m/s, > 0: greatest speed at which overlapping shapes are pushed apart."""
    max_linear_speed: float = 2000.0
    """m/s, > 0, at most 1e15: higher speeds are reduced to this, and counted (`Statistics.clamped_speeds`)."""
    max_angular_speed: float = 1000.0
    """rad/s, > 0: higher angular speeds are reduced to this, and counted."""


@lists_members
@dataclass(slots=True, eq=False)
class ForceField:
    """A field that acts on all dynamic bodies: an acceleration or a force, evaluated at the center of mass of each
    body, or a fluid. A fluid (water, oil, air) fills a box below its surface, which is the plane through `center`
    perpendicular to the world's gravity. Buoyancy equals the weight of the displaced fluid in the world's gravity
    (Archimedes). Drag is computed over the surface of a body: a surface element that moves into the fluid with the
    normal speed s is pushed back with a pressure of drag x density x s^2 / 2, and one that moves along the fluid with
    the tangential speed t with a shear stress of skin_friction x density x t^2 / 2. A part of the fluid moves along
    with a body (`added_mass`). There are no waves, but a body that bobs loses energy as if it made waves
    (`wave_damping`). A fluid acts on solid shapes, not on triggers. At the sides of the box it acts on the part of a
    shape that is inside the box; at its bottom, on shapes whose middle is above the bottom. Where fluids overlap, both
    act.
    """

    kind: ForceFieldKind | str = ForceFieldKind.uniform
    """The kind of the field."""
    direction: Vector = (0.0, 0.0, 0.0)
    """m/s^2 or N or m/s. Uniform: acceleration, or force if `is_force`. Fluid: velocity of its flow."""
    center: Vector = (0.0, 0.0, 0.0)
    """Radial: the center of attraction, meters. Fluid: the middle of its surface, meters."""
    strength: float = 0.0
    """Radial: acceleration or force (m/s^2 or N) at a distance of 1 m; negative: repulsion."""
    exponent: float = 0.0
    """Radial: -2, -1, 0 or 1. -2 is point gravity, 0 is constant, 1 is a spring."""
    is_force: bool = False
    """Uniform, radial: False: an acceleration, the same for all masses; True: a force."""
    half_extents: Vector = (0.0, 0.0, 0.0)
    """Fluid: half extents of its box along the world axes, from `center`, meters, > 0; may be infinite. Along the axis
    closest to the direction of gravity it is the depth.
    """
    density: float = 1000.0
    """Fluid: kg/m^3, >= 0. The default is the density of water."""
    drag: float = 1.0
    """Fluid: coefficient of pressure drag, >= 0. A plate has this drag coefficient, a ball half of it."""
    skin_friction: float = 0.01
    """Fluid: coefficient of skin friction, >= 0."""
    added_mass: float = 0.5
    """Fluid: mass of fluid that moves along with a body, as a fraction of the displaced mass, >= 0; for a ball it is
    0.5.
    """
    wave_damping: float = 0.2
    """Fluid: damping of bobbing by waves, as a fraction of critical damping, >= 0."""


@lists_members
@dataclass(slots=True, eq=False)
class StageTimes:
    """Wall-clock time of the stages of the last step, in milliseconds. Not part of snapshots: 0 after a world is
    restored.
    """

    broad_phase: float = 0.0
    """Broad phase: pairs of shapes whose bounds overlap, ms."""
    narrow_phase: float = 0.0
    """Narrow phase: contact points, ms."""
    islands: float = 0.0
    """Islands: bodies that are solved together, ms."""
    prepare: float = 0.0
    """Preparation of constraint rows, ms."""
    solve: float = 0.0
    """Substeps of the solver, ms."""
    finalize: float = 0.0
    """New poses of bodies, events, sleeping, ms."""
    total: float = 0.0
    """The whole step, ms."""


@lists_members
@dataclass(slots=True, eq=False)
class Statistics:
    """Counts and times of the last step."""

    steps: int = 0
    """Steps since the world was created."""
    time: float = 0.0
    """Simulated time since then, s."""
    bodies: int = 0
    """Number of bodies."""
    dynamic_bodies: int = 0
    """Number of dynamic bodies."""
    awake_bodies: int = 0
    """Number of bodies that are awake."""
    shapes: int = 0
    """Number of shapes."""
    candidate_pairs: int = 0
    """Pairs of shapes whose bounds overlap."""
    tested_pairs: int = 0
    """How many of these pairs the narrow phase tested in the last step. The others were well separated or asleep, or
    their bodies have moved by at most a few millimeters since their last test.
    """
    contacts: int = 0
    """Touching pairs of shapes, including sleeping ones."""
    contact_points: int = 0
    """Contact points of these pairs."""
    islands: int = 0
    """Awake islands."""
    sleeping_islands: int = 0
    """Islands that are asleep."""
    colors: int = 0
    """Colors of the constraint graph; contacts of different colors are solved in turn."""
    overflow_contacts: int = 0
    """Contacts for which no color of the constraint graph was free; they are solved one by one."""
    clamped_speeds: int = 0
    """How many times since the world was created a speed was reduced to the maximum."""
    max_substeps: int = 0
    """Greatest number of substeps of any awake island."""
    max_penetration: float = 0.0
    """Deepest overlap, meters, >= 0."""
    swept_pairs: int = 0
    """Pairs tested along their paths in the last step, because one of the bodies moved far."""
    impacts: int = 0
    """Impacts of bodies in free flight in the last step; one body may have several."""
    stopped_bodies: int = 0
    """Bodies that were stopped in the last step where they met a shape with which the solver had no contact."""
    times: StageTimes = field(default_factory=StageTimes)
    """Times of the stages of the last step."""


@lists_members
@dataclass(slots=True, eq=False)
class SnapshotSizes:
    """How the size of a snapshot, in bytes, is made up."""

    bodies: int = 0
    """Dynamic state of the bodies and their shapes: position, rotation, velocities, the pose at which they came to
    rest, island, time at rest, forces. (bytes)
    """
    contacts: int = 0
    """Pairs of shapes: contact points, and the impulses for warm starting the next step. (bytes)"""
    joints: int = 0
    """Impulses for warm starting the next step, and positions. (bytes)"""
    broad_phase: int = 0
    """Bounding boxes, their trees, and the list of pairs. (bytes)"""
    other: int = 0
    """Header, counters, and events that the next step will report. (bytes)"""
    definitions: int = 0
    """The definitions, which many snapshots may share. (bytes)"""
