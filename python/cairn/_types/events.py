# Made by tools/api.py from api/: change those, and run it.
"""Structs and enums of the API: those of include/cairn/events.h."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Sequence

from .._cairn import BodyId, JointId, ShapeId
from .shape import ShapeDef
from ._members import lists_members
from ._vector import Vector


@lists_members
@dataclass(slots=True, eq=False)
class ContactBegin:
    """Two shapes began to touch."""

    shape_a: ShapeId = ShapeId()
    shape_b: ShapeId = ShapeId()
    body_a: BodyId = BodyId()
    body_b: BodyId = BodyId()


@lists_members
@dataclass(slots=True, eq=False)
class ContactEnd:
    """Two shapes ceased to touch, or one of them was removed (its handle is then stale)."""

    shape_a: ShapeId = ShapeId()
    shape_b: ShapeId = ShapeId()
    body_a: BodyId = BodyId()
    body_b: BodyId = BodyId()


@lists_members
@dataclass(slots=True, eq=False)
class ContactHit:
    """Two shapes began to touch with an approach speed of at least `WorldDef.hit_speed`."""

    shape_a: ShapeId = ShapeId()
    shape_b: ShapeId = ShapeId()
    body_a: BodyId = BodyId()
    body_b: BodyId = BodyId()
    point: Vector = (0.0, 0.0, 0.0)
    """Point of contact, meters, world space."""
    normal: Vector = (0.0, 0.0, 0.0)
    """Unit normal, from A to B."""
    approach_speed: float = 0.0
    """Approach speed, m/s, > 0."""
    time: float = 0.0
    """Time of the hit: seconds after the beginning of the last step, 0 to the step's length (except for rounding). Hits
    are not sorted by it. For bodies that bounce, or that move far within the step, it is the time of impact on a
    straight path through the step; at 60 Hz under gravity this path is within 0.4 mm of the true one. For bodies that
    come to rest, that already touch others, or that have joints, it is the time at which the gap would close at the
    approach speed at the beginning of the step (of the current pass through the step where a body spins), ignoring
    forces and other contacts until then. It is then limited to the end of the step, because the solver may stop the
    approach a substep early, and is 0 if the shapes overlapped at the beginning.
    """
    surface_material: int = 0
    """Number of the material of the mesh or height field where it was hit (0: the material of the shape); 0 for other
    shapes.
    """


@lists_members
@dataclass(slots=True, eq=False)
class TriggerEvent:
    """A shape began or ceased to overlap a trigger (`ShapeDef.is_trigger`). Every trigger detects shapes of dynamic and
    kinematic bodies, including characters; triggers on dynamic and kinematic bodies detect shapes of static bodies as
    well. Triggers do not detect each other. Overlaps are tested at the beginning of each step, so that a shape that
    enters in one step is reported by the next. A shape that enters and leaves within one step has both events in that
    step; these are listed after those found at its beginning, sorted by time. Handles of removed shapes are stale.
    """

    trigger: ShapeId = ShapeId()
    other: ShapeId = ShapeId()
    trigger_body: BodyId = BodyId()
    other_body: BodyId = BodyId()
    inside: bool = False
    """True: the shape entered; False: it left, or one of the two shapes was removed."""
    time: float = 0.0
    """Seconds after the beginning of the last step, 0 to the step's length. It is 0 for overlaps found at the
    beginning; for a shape that passes through within the step, it is the time at which the shape, on its path, entered
    or left.
    """


@lists_members
@dataclass(slots=True, eq=False)
class JointEvent:
    """A joint was removed by the engine: it broke under its load, or one of its bodies was destroyed. Its handle is
    stale.
    """

    joint: JointId = JointId()
    body_a: BodyId = BodyId()
    """Null stands for the world."""
    body_b: BodyId = BodyId()
    """Null stands for the world."""
    broke: bool = False
    """True: it exceeded its break force or torque; False: one of its bodies was destroyed."""
    force: float = 0.0
    """N: force at which it broke."""
    torque: float = 0.0
    """N m: torque at which it broke."""
    user_data: int = 0
    """The `user_data` from the definition of the joint."""


@lists_members
@dataclass(slots=True, eq=False)
class SleepEvent:
    """A body fell asleep or woke up."""

    body: BodyId = BodyId()
    asleep: bool = False
    """True: it fell asleep; False: it woke up."""


@lists_members
@dataclass(slots=True, eq=False)
class ContactPoint:
    """One contact point of a contact manifold."""

    point: Vector = (0.0, 0.0, 0.0)
    """Midway between the two surfaces, meters, world space."""
    separation: float = 0.0
    """Meters; negative when the shapes overlap."""
    normal_impulse: float = 0.0
    """N s: normal impulse during the last step, >= 0. Divided by the length of the step it is the mean force."""


@lists_members
@dataclass(slots=True, eq=False)
class Contact:
    """A contact manifold of a touching pair of shapes, after the last step. A shape that touches a mesh or height field
    may have several manifolds with it, one for each normal and material.
    """

    shape_a: ShapeId = ShapeId()
    shape_b: ShapeId = ShapeId()
    body_a: BodyId = BodyId()
    body_b: BodyId = BodyId()
    normal: Vector = (0.0, 0.0, 0.0)
    """Unit normal, from A to B."""
    friction_impulse: Vector = (0.0, 0.0, 0.0)
    """N s: friction impulse on B during the last step, world axes."""
    point_count: int = 0
    """Number of contact points, 1 to 4."""
    points: Sequence[ContactPoint] = ()
    """The contact points; only the first `point_count` elements are valid."""
    surface_material: int = 0
    """Number of the material of the mesh or height field at the contact (0: the material of the shape); 0 for other
    shapes.
    """
