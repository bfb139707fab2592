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
    """Two shapes no longer touch, or one of them was removed (its handles are stale then)."""

    shape_a: ShapeId = ShapeId()
    shape_b: ShapeId = ShapeId()
    body_a: BodyId = BodyId()
    body_b: BodyId = BodyId()


@lists_members
@dataclass(slots=True, eq=False)
class ContactHit:
    """Two shapes began to touch with an approach speed of at least WorldDef.hit_speed."""

    shape_a: ShapeId = ShapeId()
    shape_b: ShapeId = ShapeId()
    body_a: BodyId = BodyId()
    body_b: BodyId = BodyId()
    point: Vector = (0.0, 0.0, 0.0)
    """Meters, world space."""
    normal: Vector = (0.0, 0.0, 0.0)
    """Unit, from A to B."""
    approach_speed: float = 0.0
    """m/s, > 0."""
    time: float = 0.0
    """When they met: seconds after the beginning of the last step, 0 to its length (but for rounding). Of what bounces
    or passes far in a step, the moment of the impact, on a straight way through the step: with gravity at 60 Hz that is
    within 0.4 mm of the true way. Of what comes to rest on something, and of bodies that touch others already or hang
    on joints: when the gap would close at the approach speed with which the step (or the pass of it, where something
    spins) began, without what forces and other contacts do until then; at the end of it at the latest, as the solver
    may stop it a substep early, and at its beginning if they overlapped by then. Hits are not listed in its order. (0
    to the step)
    """
    surface_material: int = 0
    """Of a mesh or height field, where it was hit: the number of its material there (0: that of the shape). Of other
    shapes 0.
    """


@lists_members
@dataclass(slots=True, eq=False)
class TriggerEvent:
    """A shape began or ceased to overlap a trigger (ShapeDef.is_trigger). Triggers see what is on dynamic and kinematic
    bodies, characters too; those on dynamic and kinematic bodies see static ones as well. They do not see each other.
    It is seen at the beginning of each step: what comes in is told after the next one. What passes through within a
    step has both events in that one, behind those of the beginning, in the order of their times. Handles of what was
    removed are stale.
    """

    trigger: ShapeId = ShapeId()
    other: ShapeId = ShapeId()
    trigger_body: BodyId = BodyId()
    other_body: BodyId = BodyId()
    inside: bool = False
    """True: it came in; False: it left, or one of the two was removed."""
    time: float = 0.0
    """Seconds after the beginning of the last step, 0 to its length: 0 for what is seen there; of what passes within
    it, when it came in and when it left, on the way that it took. (0 to the step)
    """


@lists_members
@dataclass(slots=True, eq=False)
class JointEvent:
    """A joint is gone: it broke under its load, or one of its bodies was destroyed. Its handle is stale."""

    joint: JointId = JointId()
    body_a: BodyId = BodyId()
    """Null: the world."""
    body_b: BodyId = BodyId()
    """Null: the world."""
    broke: bool = False
    """False: a body was destroyed."""
    force: float = 0.0
    """N: at which it broke."""
    torque: float = 0.0
    """N m: likewise."""
    user_data: int = 0
    """Of its definition."""


@lists_members
@dataclass(slots=True, eq=False)
class SleepEvent:
    """A body fell asleep or woke up."""

    body: BodyId = BodyId()
    asleep: bool = False
    """False: it woke up."""


@lists_members
@dataclass(slots=True, eq=False)
class ContactPoint:
    """One point of a contact."""

    point: Vector = (0.0, 0.0, 0.0)
    """Midway between the two surfaces, meters."""
    separation: float = 0.0
    """Meters; negative when the shapes overlap."""
    normal_impulse: float = 0.0
    """N s during the last step, >= 0. Divide by the step for the mean force."""


@lists_members
@dataclass(slots=True, eq=False)
class Contact:
    """A touching pair of shapes as it stood after the last step. A shape may touch a mesh or height field, and the
    surfaces of several of its faces, in several of these, one for each normal and material.
    """

    shape_a: ShapeId = ShapeId()
    shape_b: ShapeId = ShapeId()
    body_a: BodyId = BodyId()
    body_b: BodyId = BodyId()
    normal: Vector = (0.0, 0.0, 0.0)
    """Unit, from A to B."""
    friction_impulse: Vector = (0.0, 0.0, 0.0)
    """N s on B during the last step, world axes."""
    point_count: int = 0
    """1 to 4."""
    points: Sequence[ContactPoint] = ()
    """The first `point_count` of them."""
    surface_material: int = 0
    """Of a mesh or height field there: the number of its material (0: that of the shape). Of other shapes 0."""
