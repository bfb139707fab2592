# Made by tools/api.py from api/: change those, and run it.
"""Structs and enums of the API: those of include/cairn/shape.h."""
from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import Union

from .._cairn import HeightField, Hull, Mesh
from ._members import lists_members
from ._vector import Vector


class CombineRule(enum.Enum):
    """How the coefficients of two touching materials become one. Where the two materials disagree on the rule, the
    stronger one counts, in the order average > minimum > maximum > multiply (KHR_physics_rigid_bodies).
    """

    average = 0
    """The mean of both."""
    minimum = 1
    """The smaller one."""
    maximum = 2
    """The greater one."""
    multiply = 3
    """The product of both."""


@lists_members
@dataclass(slots=True, eq=False)
class Sphere:
    """A ball around the shape's origin. `radius` in meters, > 0."""

    radius: float = 0.5
    """Meters, > 0."""


@lists_members
@dataclass(slots=True, eq=False)
class Box:
    """A box around the shape's origin. `half_extents` in meters, each > 0. A Box, a Cylinder or a Hull with `rounding`
    r > 0 is that solid plus a ball of radius r: all that is within r of the sharp solid (its Minkowski sum with the
    ball). It is larger by r on every side, its faces stay flat, and its edges and corners are round with radius r. To
    keep the outer size, take r off the half extents.
    """

    half_extents: Vector = (0.5, 0.5, 0.5)
    """Meters, each > 0, of the sharp box: the rounding comes on top."""
    rounding: float = 0.0
    """Meters, >= 0: radius of the ball that is added to the sharp box."""


@lists_members
@dataclass(slots=True, eq=False)
class Plane:
    """A plane through the shape's origin; solid is the side away from `normal`. Without `half_extents` it is an
    infinite half-space. With them it is a rectangle, `half_extents[0]` along the shape's `tangent` and
    `half_extents[1]` along normal x tangent; the rectangle is one-sided, and pushes along its normal whatever is above
    it or has sunk in so that a part of it is still above. Where one half extent is infinite, it is a strip: without
    ends along that axis. Double-sided, it is a sheet without thickness that holds things on both sides: an infinite one
    pushes a body to the side where its center of mass is, a rectangle or strip pushes a shape to the side where the
    shape's middle is. Rays and casts meet a sheet from either side, and nothing is inside of it. Planes have no mass:
    they may only be added to static and kinematic bodies.
    """

    normal: Vector = (0.0, 1.0, 0.0)
    """Any non-zero finite vector; it is normalized."""
    tangent: Vector = (1.0, 0.0, 0.0)
    """Only for the rectangle; made orthogonal to `normal`."""
    half_extents: Vector | None = None
    """Meters, each > 0, one may be infinite; absent for an infinite plane."""
    double_sided: bool = False
    """A sheet that holds things on both sides."""


@lists_members
@dataclass(slots=True, eq=False)
class Capsule:
    """The convex hull of two balls on the shape's y axis, their centers at -half_height and +half_height. Meters, all >
    0 (`radius_top` >= 0).
    """

    half_height: float = 0.5
    """Meters, > 0, along the y axis."""
    radius: float = 0.25
    """Of both balls, or of the lower one if `radius_top` is given. (m, > 0)"""
    radius_top: float | None = None
    """Of the upper ball: a tapered capsule. (m, >= 0)"""


@lists_members
@dataclass(slots=True, eq=False)
class Cylinder:
    """A solid cylinder around the shape's y axis, from -half_height to +half_height. Meters, all > 0 (`radius_top` >=
    0); without its rounding.
    """

    half_height: float = 0.5
    """Meters, > 0, along the y axis."""
    radius: float = 0.5
    """At both ends, or at the lower end if `radius_top` is given. (m, > 0)"""
    radius_top: float | None = None
    """At the upper end: a tapered cylinder, or with 0 a cone. (m, >= 0)"""
    rounding: float = 0.0
    """Meters, >= 0: radius of the ball that is added to the sharp cylinder."""


@lists_members
@dataclass(slots=True, eq=False)
class Material:
    """Surface properties of a shape."""

    static_friction: float = 0.6
    """Coulomb coefficient while the contact sticks, >= 0."""
    dynamic_friction: float = 0.6
    """Coulomb coefficient while it slides, >= 0."""
    restitution: float = 0.0
    """Ratio of rebound to approach speed, 0 (no bounce) to 1 (elastic). (0 to 1)"""
    rolling_friction: float = 0.0
    """Lever arm of the rolling resistance torque in meters, >= 0."""
    torsional_friction: float = 0.001
    """Radius of the contact patch in meters, >= 0: a spinning one-point contact feels a torque of at most friction x
    normal force x this radius. Without any, a ball that spins upright never comes to rest.
    """
    friction_combine: CombineRule | str = CombineRule.average
    """How its friction and the other material's become one."""
    restitution_combine: CombineRule | str = CombineRule.average
    """How its restitution and the other material's become one."""


@lists_members
@dataclass(slots=True, eq=False)
class CollisionFilter:
    """Which shapes meet: two do if each is in a layer that the other collides with."""

    layers: int = 1
    """The layers that the shape is in, one bit each."""
    collides_with: int = 2**64 - 1
    """The layers that it collides with."""


@lists_members
@dataclass(slots=True, eq=False)
class ShapeDef:
    """How a shape is attached to its body."""

    position: Vector = (0.0, 0.0, 0.0)
    """Origin of the shape in the body's frame, meters; within 1e15."""
    rotation: Vector = (0.0, 0.0, 0.0, 1.0)
    """Orientation in the body's frame; normalized, must not be zero."""
    density: float = 1000.0
    """kg/m^3, >= 0; 0 adds no mass. Ignored by planes."""
    material: Material = field(default_factory=Material)
    """Of its surface."""
    filter: CollisionFilter = field(default_factory=CollisionFilter)
    """What it meets."""
    is_trigger: bool = False
    """A trigger touches nothing: it only reports what overlaps it (trigger events)."""
    surface_velocity: Vector = (0.0, 0.0, 0.0)
    """m/s, in the shape's frame: the surface moves with it like a conveyor belt, beside the motion of the body. Only
    its part along the surface counts. Static and kinematic bodies only.
    """
    user_data: int = 0
    """Not touched by the engine."""
    one_way: Vector = (0.0, 0.0, 0.0)
    """A direction in the shape's frame, of any length. Not zero: the shape holds only what came from there. What is not
    wholly beyond it in that direction when the two meet goes through it, until it is: onto such a platform one jumps
    from below. Static and kinematic bodies only; infinite planes, meshes and height fields have none. Rays, casts and
    other queries meet it from all sides.
    """


Shape = Union[
    Sphere,
    Box,
    Plane,
    Capsule,
    Cylinder,
    Hull,
    Mesh,
    HeightField,
]
