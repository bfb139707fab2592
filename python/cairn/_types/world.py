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
    """What a force field does."""

    uniform = 0
    """The same everywhere, along `direction`."""
    radial = 1
    """Towards `center`, `strength` x distance^`exponent`."""
    fluid = 2
    """A fluid with a level surface through `center`, which flows with the velocity `direction`."""


@lists_members
@dataclass(slots=True, eq=False)
class WorldDef:
    """Settings of a world. All may be changed later through `World.set_settings`."""

    gravity: Vector = (0.0, -9.81, 0.0)
    """m/s^2, finite."""
    substeps: int = 0
    """Solver substeps of one step, 1 to 256; or 0: as many as make them no longer than 1/360 s (6 at 60 Hz, 2 at 240
    Hz). (0 to 256)
    """
    adaptive_substeps: bool = True
    """Take more in islands that ask for it: with joints (no longer than 1/660 s), high mass ratios, tall stacks, bodies
    less than 10 cm wide.
    """
    integrator: Integrator | str = Integrator.semi_implicit_euler
    """How free motion is integrated."""
    enable_sleep: bool = True
    """Islands at rest stop costing time."""
    sleep_speed: float = 0.05
    """m/s; a body slower than this at its surface may sleep. >= 0."""
    sleep_time: float = 0.5
    """s at rest before an island sleeps, unless it gains speed steadily. >= 0."""
    restitution_speed: float = 0.02
    """m/s; slower impacts do not bounce. >= 0."""
    hit_speed: float = 1.0
    """m/s; least approach speed for a hit event. >= 0."""
    recovery_speed: float = 3.0
    """m/s; overlaps are pushed apart no faster than this. > 0."""
    max_linear_speed: float = 2000.0
    """m/s; faster bodies are slowed to this, and counted. > 0, at most 1e15."""
    max_angular_speed: float = 1000.0
    """rad/s; likewise. (> 0)"""


@lists_members
@dataclass(slots=True, eq=False)
class ForceField:
    """A field that acts on every dynamic body: an acceleration or a force, evaluated at its center of mass, or a fluid,
    which fills a box below its level surface, lifts what is in it by the weight of what that displaces, and resists
    motion against it.
    """

    kind: ForceFieldKind | str = ForceFieldKind.uniform
    """What it does."""
    direction: Vector = (0.0, 0.0, 0.0)
    """Uniform: acceleration in m/s^2 (or force in N, see `is_force`). Fluid: m/s. (m/s^2 or N or m/s)"""
    center: Vector = (0.0, 0.0, 0.0)
    """Radial: the point that attracts, meters. Fluid: the middle of its surface."""
    strength: float = 0.0
    """Radial: m/s^2 (or N) at a distance of one meter; negative repels. (m/s^2 or N)"""
    exponent: float = 0.0
    """Radial: 0 constant, 1 spring, -1, -2 gravity of a point. One of -2,-1,0,1. (-2, -1, 0 or 1)"""
    is_force: bool = False
    """False: an acceleration, equal for all masses; True: a force."""
    half_extents: Vector = (0.0, 0.0, 0.0)
    """Fluid: how far it reaches from `center` along the axes of the world, meters, > 0; may be infinite. Along the axis
    nearest to gravity it is the depth.
    """
    density: float = 1000.0
    """Fluid: kg/m^3, >= 0. The default is that of water."""
    drag: float = 1.0
    """Fluid: coefficient of what is pushed ahead, >= 0. That of a plate; a ball has half of it."""
    skin_friction: float = 0.01
    """Fluid: coefficient of what is dragged along, >= 0."""
    added_mass: float = 0.5
    """Fluid: how much of it moves along, >= 0, of what a body displaces; a ball: 0.5."""
    wave_damping: float = 0.2
    """Fluid: how fast bobbing is lost to waves, >= 0, of critical damping."""


@lists_members
@dataclass(slots=True, eq=False)
class StageTimes:
    """Wall-clock time of the stages of the last step, in milliseconds."""

    broad_phase: float = 0.0
    """Pairs of bounds. (ms)"""
    narrow_phase: float = 0.0
    """Contact points. (ms)"""
    islands: float = 0.0
    """What is solved together. (ms)"""
    prepare: float = 0.0
    """Rows of the solver. (ms)"""
    solve: float = 0.0
    """Substeps. (ms)"""
    finalize: float = 0.0
    """New places, events, sleep. (ms)"""
    total: float = 0.0
    """The whole step. (ms)"""


@lists_members
@dataclass(slots=True, eq=False)
class Statistics:
    """Counts and times of the last step."""

    steps: int = 0
    """Steps since the world was made."""
    time: float = 0.0
    """Simulated seconds since then."""
    bodies: int = 0
    """All of them."""
    dynamic_bodies: int = 0
    """Those that forces move."""
    awake_bodies: int = 0
    """Those that are not asleep."""
    shapes: int = 0
    """All of them."""
    candidate_pairs: int = 0
    """Pairs whose bounds overlap."""
    tested_pairs: int = 0
    """Of those, how many the last step has tested. The others were well apart or asleep, or their bodies have moved by
    a few millimeters at most since they were.
    """
    contacts: int = 0
    """Touching pairs of shapes, asleep ones included."""
    contact_points: int = 0
    """Their points."""
    islands: int = 0
    """Awake islands."""
    sleeping_islands: int = 0
    """Islands that are asleep."""
    colors: int = 0
    """Colors of contacts, which are solved one after the other."""
    overflow_contacts: int = 0
    """Contacts that found no free color, solved one by one."""
    clamped_speeds: int = 0
    """Since the world was made: velocities cut to the maximum."""
    max_substeps: int = 0
    """Most substeps that any island took."""
    max_penetration: float = 0.0
    """Deepest overlap, meters, >= 0."""
    swept_pairs: int = 0
    """In the last step: pairs looked at along their ways, as one moved far."""
    impacts: int = 0
    """In the last step: impacts of bodies in flight, several of one body included."""
    stopped_bodies: int = 0
    """In the last step: bodies held where they met what the solver did not know."""
    times: StageTimes = field(default_factory=StageTimes)
    """Of the last step."""


@lists_members
@dataclass(slots=True, eq=False)
class SnapshotSizes:
    """What the bytes of a snapshot are for."""

    bodies: int = 0
    """The dynamic state of the bodies and their shapes: place, rotation, velocities, where they came to rest, island,
    time to sleep, forces. (bytes)
    """
    contacts: int = 0
    """Pairs of shapes: points, and the impulses that the next step starts from. (bytes)"""
    joints: int = 0
    """Impulses that the next step starts from, and positions. (bytes)"""
    broad_phase: int = 0
    """Boxes, their tree, and the list of pairs. (bytes)"""
    other: int = 0
    """Header, counters, events that the next step will report. (bytes)"""
    definitions: int = 0
    """Once for all snapshots that share them. (bytes)"""
