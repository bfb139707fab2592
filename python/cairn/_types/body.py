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
    """Moves with the velocities that it is given, rotating about its origin. Forces and contacts do not change them."""
    dynamic = 2
    """Moves by forces and contacts."""


class CharacterSupport(enum.Enum):
    """What supports a character."""

    none = 0
    """The character is in the air, or flies."""
    steep = 1
    """It slides down a slope steeper than `CharacterDef.max_slope`."""
    ground = 2
    """It stands on the ground."""


@lists_members
@dataclass(slots=True, eq=False)
class MassProperties:
    """Mass, center of mass and inertia of a body. With a `mass` of +infinity forces do not translate the body; a zero
    entry of `inertia_diagonal` keeps torques from rotating it about that principal axis.
    """

    mass: float = 1.0
    """kg, > 0; may be infinite."""
    center_of_mass: Vector = (0.0, 0.0, 0.0)
    """Center of mass in the body's frame, meters."""
    inertia_diagonal: Vector = (1.0, 1.0, 1.0)
    """Principal moments about the center of mass, kg m^2."""
    inertia_orientation: Vector = (0.0, 0.0, 0.0, 1.0)
    """Rotation from principal axes to the body's frame."""


@lists_members
@dataclass(slots=True, eq=False)
class BodyDef:
    """Everything that is needed to create a body."""

    type: BodyType | str = BodyType.dynamic
    """How it moves."""
    position: Vector = (0.0, 0.0, 0.0)
    """Origin of the body's frame (not its center of mass), meters."""
    rotation: Vector = (0.0, 0.0, 0.0, 1.0)
    """Rotation of the body's frame. Normalized on entry; must not be zero."""
    linear_velocity: Vector = (0.0, 0.0, 0.0)
    """Velocity of the center of mass, m/s."""
    angular_velocity: Vector = (0.0, 0.0, 0.0)
    """Angular velocity in world axes, rad/s."""
    linear_damping: float = 0.0
    """1/s, >= 0: velocity decays as v' = -damping v."""
    angular_damping: float = 0.0
    """1/s, >= 0: the same for the angular velocity."""
    gravity_scale: float = 1.0
    """Multiplies the world's gravity for this body; any finite value."""
    allow_sleep: bool = True
    """False: the body and its island never fall asleep."""
    mass: float | None = None
    """Total mass in kg, > 0 (+infinity: immovable), to which the mass properties of the shapes are scaled. None: the
    mass follows from the densities of the shapes.
    """
    mass_properties: MassProperties | None = None
    """Used in place of `mass` and of the shapes' densities."""
    name: str = ""
    """For display and `World.find_body`; need not be unique."""
    user_data: int = 0
    """Stored for the application; the engine does not use it."""
    enabled: bool = True
    """False: the body does not take part in the simulation until it is enabled."""


@lists_members
@dataclass(slots=True, eq=False)
class CharacterDef:
    """How a character moves. A character is a kinematic body that is moved at the beginning of each step: it slides
    along walls, climbs steps, stands on slopes, falls, is carried by the body on which it stands, and never passes
    through anything that its shapes collide with. Only its convex shapes count; a capsule along `up` is usual. It
    rotates with the body on which it stands (about `up`), and otherwise only if the application rotates it.
    """

    up: Vector = (0.0, 1.0, 0.0)
    """Direction away from the ground: any non-zero vector; it is normalized."""
    max_slope: float = 0.87
    """rad, 0 to 1.57: greatest slope on which the character stands. It slides down steeper slopes and does not walk up
    them.
    """
    step_height: float = 0.3
    """m, >= 0: greatest height of a step that it climbs; 0: it climbs none."""
    stick_distance: float = 0.3
    """m, >= 0: it stays on the ground where this drops by up to this distance within a time step, as on stairs
    downwards.
    """
    skin: float = 0.02
    """m, 1e-4 to 1: the distance that it keeps from all other shapes."""
    mass: float = 70.0
    """kg, >= 0: the mass with which it acts on dynamic bodies on which it stands or lands, or from which it jumps."""
    max_push_force: float = 500.0
    """N, >= 0: greatest force with which it pushes dynamic bodies that are in its way."""
    air_acceleration: float = 10.0
    """m/s^2, >= 0: greatest acceleration towards the walk velocity while it is in the air."""
    flies: bool = False
    """True: it moves with the walk velocity in all three directions, and gravity, ground and steps do not act on it:
    for swimming, ladders, flying.
    """


@lists_members
@dataclass(slots=True, eq=False)
class CharacterState:
    """The motion and support of a character after the last step."""

    support: CharacterSupport | str = CharacterSupport.none
    """What supports the character."""
    velocity: Vector = (0.0, 0.0, 0.0)
    """m/s, in world axes, including the velocity of the ground. It differs from the velocity of the body, which is the
    displacement in the last step divided by its duration: it excludes the height of stairs that were climbed, and in
    the air it is the velocity at the end of the step.
    """
    ground_shape: ShapeId = ShapeId()
    """The shape on which it stands or slides; null in the air, and if that shape was removed."""
    ground_body: BodyId = BodyId()
    """The body of that shape."""
    ground_point: Vector = (0.0, 0.0, 0.0)
    """Where the character touches that shape, m, world space; valid unless `support` is none."""
    ground_normal: Vector = (0.0, 1.0, 0.0)
    """Unit normal there, out of the ground; valid unless `support` is none."""
    ground_velocity: Vector = (0.0, 0.0, 0.0)
    """m/s: velocity of the ground's material there; valid unless `support` is none."""
