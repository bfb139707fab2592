# Made by tools/api.py from api/: change those, and run it.
"""Structs and enums of the API: those of include/cairn/body.h."""
from __future__ import annotations

import enum
from dataclasses import dataclass

from .._cairn import BodyId, ShapeId
from ._members import lists_members
from ._vector import Vector


class BodyType(enum.Enum):
    """How a body moves."""

    static = 0
    """Never moves by itself."""
    kinematic = 1
    """Moves with the velocity it is given, and turns about its origin; nothing pushes it."""
    dynamic = 2
    """Moves by forces and contacts."""


class CharacterSupport(enum.Enum):
    """What a character is on."""

    none = 0
    """It is in the air, or flies."""
    steep = 1
    """It slides down something steeper than `CharacterDef.max_slope`."""
    ground = 2
    """It stands."""


@lists_members
@dataclass(slots=True, eq=False)
class MassProperties:
    """Mass, center of mass and inertia of a body. A `mass` of +infinity, and zero entries of `inertia_diagonal`, stand
    for what cannot be moved or turned.
    """

    mass: float = 1.0
    """kg, > 0; may be infinite."""
    center_of_mass: Vector = (0.0, 0.0, 0.0)
    """In the body's frame, meters."""
    inertia_diagonal: Vector = (1.0, 1.0, 1.0)
    """Principal moments about the center of mass, kg m^2."""
    inertia_orientation: Vector = (0.0, 0.0, 0.0, 1.0)
    """Rotation from principal axes to the body's frame."""


@lists_members
@dataclass(slots=True, eq=False)
class BodyDef:
    """Everything needed to make a body."""

    type: BodyType | str = BodyType.dynamic
    """How it moves."""
    position: Vector = (0.0, 0.0, 0.0)
    """Origin of the body's frame (not its center of mass), meters."""
    rotation: Vector = (0.0, 0.0, 0.0, 1.0)
    """Normalized on entry; must not be zero."""
    linear_velocity: Vector = (0.0, 0.0, 0.0)
    """Of the center of mass, m/s."""
    angular_velocity: Vector = (0.0, 0.0, 0.0)
    """In world axes, rad/s."""
    linear_damping: float = 0.0
    """1/s, >= 0: velocity decays as v' = -damping v."""
    angular_damping: float = 0.0
    """1/s, >= 0."""
    gravity_scale: float = 1.0
    """Multiplies the world's gravity for this body; any finite value."""
    allow_sleep: bool = True
    """False: the body and its island never fall asleep."""
    mass: float | None = None
    """kg, > 0 (+infinity: immovable). None: from the shapes' densities."""
    mass_properties: MassProperties | None = None
    """Overrides mass and shapes altogether."""
    name: str = ""
    """For people; need not be unique."""
    user_data: int = 0
    """Not touched by the engine."""
    enabled: bool = True
    """False: it takes no part in the world until it is enabled."""


@lists_members
@dataclass(slots=True, eq=False)
class CharacterDef:
    """How a character moves. A character is a kinematic body that is moved at the beginning of each step: it slides
    along walls, climbs steps, stands on slopes, falls, is carried by what it stands on, and never passes through
    anything that its shapes collide with. Its shapes must be convex to count; a capsule along `up` is usual. It does
    not turn by itself, but for what it stands on.
    """

    up: Vector = (0.0, 1.0, 0.0)
    """Away from the ground; any non-zero vector, it is normalized."""
    max_slope: float = 0.87
    """rad, 0 to 1.57: it slides down what is steeper, and does not walk up there."""
    step_height: float = 0.3
    """m, >= 0: it climbs steps up to this height; 0: none."""
    stick_distance: float = 0.3
    """m, >= 0: it stays on ground that falls away by up to this in a step."""
    skin: float = 0.02
    """m, 1e-4 to 1: the distance that it keeps from everything."""
    mass: float = 70.0
    """kg, >= 0: what dynamic bodies feel that it stands on, lands on or jumps off."""
    max_push_force: float = 500.0
    """N, >= 0: it pushes dynamic bodies out of its way with no more than this."""
    air_acceleration: float = 10.0
    """m/s^2, >= 0: how fast its velocity follows the wanted one in the air."""
    flies: bool = False
    """It moves with the wanted velocity in all directions, without gravity, ground and steps: for swimming, ladders,
    flying.
    """


@lists_members
@dataclass(slots=True, eq=False)
class CharacterState:
    """How a character moves, as it stood after the last step."""

    support: CharacterSupport | str = CharacterSupport.none
    """What it is on."""
    velocity: Vector = (0.0, 0.0, 0.0)
    """m/s, in world axes, that of the ground included. Unlike the velocity of its body, which is by how much the last
    step moved it, it is without steps that were climbed, and in the air it is that at the end of the step.
    """
    ground_shape: ShapeId = ShapeId()
    """What it is on; null in the air, and when that was removed."""
    ground_body: BodyId = BodyId()
    """Its body."""
    ground_point: Vector = (0.0, 0.0, 0.0)
    """Where it touches that, m; valid unless `support` is none."""
    ground_normal: Vector = (0.0, 1.0, 0.0)
    """Unit, out of it; likewise."""
    ground_velocity: Vector = (0.0, 0.0, 0.0)
    """m/s, of its material there; likewise."""
