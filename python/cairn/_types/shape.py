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
    """How the coefficients of two materials in contact are combined into one. If their rules differ, the one with
    precedence applies, in the order average > minimum > maximum > multiply (KHR_physics_rigid_bodies).
    """

    average = 0
    """The mean of both coefficients."""
    minimum = 1
    """The smaller coefficient."""
    maximum = 2
    """The greater coefficient."""
    multiply = 3
    """The product of both coefficients."""


@lists_members
@dataclass(slots=True, eq=False)
class Sphere:
    """A ball around the shape's origin. `radius` in meters, > 0."""

    radius: float = 0.5
    """Radius in meters, > 0."""


@lists_members
@dataclass(slots=True, eq=False)
class Box:
    """A box around the shape's origin. `half_extents` in meters, each > 0. A Box, Cylinder or Hull with `rounding` r >
    0 is the Minkowski sum of the sharp solid and a ball of radius r: all points within a distance r of the sharp solid.
    It is larger by r on every side; its faces stay flat, and its edges and corners are rounded with radius r. To keep
    the outer size, subtract r from the half extents.
    """

    half_extents: Vector = (0.5, 0.5, 0.5)
    """Half extents of the sharp box, meters, each > 0; the rounding adds to them."""
    rounding: float = 0.0
    """Meters, >= 0: radius of the ball that is added to the sharp box."""


@lists_members
@dataclass(slots=True, eq=False)
class Plane:
    """A plane through the shape's origin, solid on the side opposite to `normal`. Without `half_extents` it is an
    infinite half-space. With them it is a rectangle: `half_extents[0]` along `tangent`, `half_extents[1]` along normal
    x tangent. A rectangle is one-sided: it pushes shapes along its normal that are above it, or that have sunk into it
    and are still partly above. With one infinite half extent it is a strip, without ends along that axis. A
    double-sided plane is a sheet without thickness that collides on both sides: an infinite one pushes a body to the
    side on which its center of mass is; a rectangle or strip pushes a shape to the side on which the middle of that
    shape is. Rays and casts hit a sheet from both sides, and no point is inside of it. Planes have no mass, and may
    only be added to static and kinematic bodies.
    """

    normal: Vector = (0.0, 1.0, 0.0)
    """Any non-zero finite vector; it is normalized."""
    tangent: Vector = (1.0, 0.0, 0.0)
    """Direction of `half_extents[0]`; it is made orthogonal to `normal`. Used only by rectangles and strips."""
    half_extents: Vector | None = None
    """Meters, each > 0; one may be infinite. None: an infinite plane."""
    double_sided: bool = False
    """True: the plane is a sheet that collides on both sides."""


@lists_members
@dataclass(slots=True, eq=False)
class Capsule:
    """The convex hull of two balls on the shape's y axis, their centers at -half_height and +half_height. Meters, all >
    0 (`radius_top` >= 0).
    """

    half_height: float = 0.5
    """Half the distance between the centers of the balls, meters, > 0."""
    radius: float = 0.25
    """Radius of both balls, or of the lower one if `radius_top` is given, meters, > 0."""
    radius_top: float | None = None
    """Radius of the upper ball, meters, >= 0, for a tapered capsule; None: `radius`."""


@lists_members
@dataclass(slots=True, eq=False)
class Cylinder:
    """A solid cylinder around the shape's y axis, from -half_height to +half_height. Meters, all > 0 (`radius_top` >=
    0); the rounding adds to these sizes.
    """

    half_height: float = 0.5
    """Half the length along the y axis, meters, > 0."""
    radius: float = 0.5
    """Radius at both ends, or at the lower end if `radius_top` is given, meters, > 0."""
    radius_top: float | None = None
    """Radius at the upper end, meters, >= 0, for a tapered cylinder, or a cone if it is 0; None: `radius`."""
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
    """Ratio of rebound to approach speed, 0 to 1; 0: no bounce, 1: elastic."""
    rolling_friction: float = 0.0
    """Lever arm of the rolling resistance torque in meters, >= 0."""
    torsional_friction: float = 0.001
    """Radius of the contact patch in meters, >= 0: a spinning one-point contact feels a torque of at most friction x
    normal force x this radius. With 0, a ball that spins about the contact normal never comes to rest.
    """
    friction_combine: CombineRule | str = CombineRule.average
    """How its friction coefficients are combined with those of the other material."""
    restitution_combine: CombineRule | str = CombineRule.average
    """How its restitution is combined with that of the other material."""


@lists_members
@dataclass(slots=True, eq=False)
class CollisionFilter:
    """Decides which shapes collide: two shapes do if each is in a layer with which the other collides."""

    layers: int = 1
    """Layers to which the shape belongs, one bit for each."""
    collides_with: int = 2**64 - 1
    """Layers with which the shape collides."""


@lists_members
@dataclass(slots=True, eq=False)
class ShapeDef:
    """How a shape is attached to its body."""

    position: Vector = (0.0, 0.0, 0.0)
    """Origin of the shape in the body's frame, meters; within 1e15."""
    rotation: Vector = (0.0, 0.0, 0.0, 1.0)
    """Orientation in the body's frame; normalized, must not be zero."""
    density: float = 1000.0
    """kg/m^3, >= 0; with 0 the shape adds no mass. Not used for planes."""
    material: Material = field(default_factory=Material)
    """Friction and restitution of its surface."""
    filter: CollisionFilter = field(default_factory=CollisionFilter)
    """Decides with which shapes it collides."""
    is_trigger: bool = False
    """True: the shape is a trigger. It has no contacts, and only reports shapes that overlap it
    (`World.trigger_events`).
    """
    surface_velocity: Vector = (0.0, 0.0, 0.0)
    """m/s, in the shape's frame: velocity of the surface relative to the body, as of a conveyor belt. Only its
    component along the surface counts. Static and kinematic bodies only.
    """
    user_data: int = 0
    """Stored for the application; the engine does not use it."""
    one_way: Vector = (0.0, 0.0, 0.0)
    """A direction in the shape's frame, of any length; zero: none. Otherwise the shape is a one-way platform: it
    collides only with shapes that come from that side. A shape that is not entirely on that side when the two meet
    passes through until it is, so that one can jump onto the platform from below. Static and kinematic bodies only;
    infinite planes, meshes and height fields cannot be one-way. Rays, casts and other queries find the shape from all
    sides.
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
