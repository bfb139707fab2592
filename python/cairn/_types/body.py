# Made by tools/api.py from api/: change those, and run it.
"""Structs and enums of the API: those of include/cairn/body.h."""
from __future__ import annotations

import enum
from dataclasses import dataclass

from ._members import lists_members
from ._vector import Vector


class BodyType(enum.Enum):
    """How a body moves."""

    static = 0
    """Never moves by itself."""
    kinematic = 1
    """Moves with the velocity it is given; nothing pushes it."""
    dynamic = 2
    """Moves by forces and contacts."""


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
