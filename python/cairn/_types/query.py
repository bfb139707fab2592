# Made by tools/api.py from api/: change those, and run it.
"""Structs and enums of the API: those of include/cairn/query.h."""
from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import Sequence

from .._cairn import BodyId, ShapeId
from .math import Bounds
from .shape import CollisionFilter
from ._members import lists_members
from ._vector import Vector


class BroadPhaseTree(enum.Enum):
    """The trees of the broad phase. Planes are in none."""

    fixed = 0
    """Of what is fixed."""
    awake = 1
    """Of what is awake."""
    large = 2
    """Of what is awake and large beside the others."""
    sleeping = 3
    """Of what sleeps, with a tree for each island below that of all islands."""


@lists_members
@dataclass(slots=True, eq=False)
class RayHit:
    """The nearest thing that a ray met."""

    shape: ShapeId = ShapeId()
    body: BodyId = BodyId()
    point: Vector = (0.0, 0.0, 0.0)
    """On the surface, meters."""
    normal: Vector = (0.0, 0.0, 0.0)
    """Unit outward normal of the surface there."""
    distance: float = 0.0
    """From the ray's origin, meters."""
    triangle: int = -1
    """Of a mesh: the one of its triangles that the ray met, in the order of its indices; of a height field: twice the
    number of its cell, row after row, and 1 more for the half on the side of greatest x. Of other shapes -1.
    """


@lists_members
@dataclass(slots=True, eq=False)
class ShapeCastHit:
    """The first thing that a moving shape met."""

    shape: ShapeId = ShapeId()
    body: BodyId = BodyId()
    fraction: float = 0.0
    """Of the translation, 0 to 1; 0 if they overlapped from the start."""
    point: Vector = (0.0, 0.0, 0.0)
    """Where they meet, meters."""
    normal: Vector = (0.0, 0.0, 0.0)
    """Unit, out of the shape that was met."""
    triangle: int = -1
    """That was met; as in RayHit."""


@lists_members
@dataclass(slots=True, eq=False)
class ClosestPoint:
    """The surface point nearest to a given one."""

    shape: ShapeId = ShapeId()
    body: BodyId = BodyId()
    point: Vector = (0.0, 0.0, 0.0)
    """On the surface, meters; the given point itself if that lies inside."""
    distance: float = 0.0
    """Meters; 0 inside."""
    triangle: int = -1
    """That it is on; as in RayHit."""


@lists_members
@dataclass(slots=True, eq=False)
class BroadPhaseNode:
    """A box of a tree of the broad phase. It holds the boxes below it, up to eight; those of nodes side by side may
    overlap.
    """

    bounds: Bounds = field(default_factory=Bounds)
    """Meters; of a shape, somewhat larger than the shape."""
    tree: BroadPhaseTree | str = BroadPhaseTree.fixed
    """The one that it is in."""
    depth: int = 0
    """0: the root of the tree."""
    parent: int = 0
    """Its place in the list; -1: it is a root."""
    is_leaf: bool = False
    """It is the box of one shape."""
    shape: ShapeId = ShapeId()
    """Of a leaf; else null."""


@lists_members
@dataclass(slots=True, eq=False)
class SolverContact:
    """How the solver works on a touching pair of shapes, as it stood after the last step; for pictures and
    measurements.
    """

    shape_a: ShapeId = ShapeId()
    shape_b: ShapeId = ShapeId()
    body_a: BodyId = BodyId()
    body_b: BodyId = BodyId()
    color: int = 0
    """Contacts of one color share no body that moves by forces, so they are solved side by side; colors take turns, the
    lowest first, and those with what does not move by forces come last. -1: no color was free; solved one by one,
    before all others.
    """
    substeps: int = 0
    """Of its island in the last step in which that was awake; 0: not solved yet."""


@lists_members
@dataclass(slots=True, eq=False)
class DebugLinesDef:
    """What debug lines show."""

    shapes: bool = True
    """Edges of shapes; of infinite planes a grid of 20 m. Bodies that are static, kinematic, awake and asleep, and
    triggers, have colors of their own.
    """
    bounds: bool = False
    """Boxes around shapes, along the axes of the world."""
    centers: bool = False
    """The axes of inertia at the centers of mass of dynamic bodies: x red, y green, z blue."""
    velocities: bool = False
    """From each center of mass of what moves to where it is in a tenth of a second."""
    contacts: bool = True
    """At each point that touches, the normal."""
    joints: bool = True
    """From both centers of mass to the anchors, and the axes of the joint there."""
    size: float = 0.2
    """The length of axes, and of normals. (> 0)"""
    impulse_scale: float = 0.0
    """Not 0: a normal is as long as this times the impulse at its point. (m/(N s), >= 0)"""


@lists_members
@dataclass(slots=True, eq=False)
class DebugLine:
    """A straight line."""

    begin: Vector = (0.0, 0.0, 0.0)
    """In world space. (m)"""
    end: Vector = (0.0, 0.0, 0.0)
    """In world space. (m)"""
    color: Vector = (0.0, 0.0, 0.0)
    """Red, green and blue, 0 to 1."""


@lists_members
@dataclass(slots=True, eq=False)
class QueryFilter:
    """Which shapes a query sees: those that pass all of it."""

    layers: int = 2**64 - 1
    """Those that are in any of these layers (`CollisionFilter.layers`)."""
    own_layers: int = 2**64 - 1
    """Those that collide with any of these, in which the query itself is."""
    static_bodies: bool = True
    """Those of static bodies."""
    kinematic_bodies: bool = True
    """Those of kinematic bodies."""
    dynamic_bodies: bool = True
    """Those of dynamic bodies."""
    triggers: bool = False
    """Triggers as well; they are seen like any other shape then."""
    any: bool = False
    """Any one is enough: the first that is found, rather than the nearest, and of overlaps a single one. Faster, where
    only the question is whether there is any.
    """
    ignored_bodies: Sequence[BodyId] = field(default_factory=list)
    """Shapes of these are not seen. Each must exist."""
