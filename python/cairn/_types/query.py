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
    """The trees of the broad phase. Infinite planes are in none."""

    fixed = 0
    """Shapes of static bodies."""
    awake = 1
    """Awake shapes."""
    large = 2
    """Awake shapes that are large compared to the others."""
    sleeping = 3
    """Sleeping shapes: a tree of all sleeping islands, below which each island has a tree of its own."""


@lists_members
@dataclass(slots=True, eq=False)
class RayHit:
    """An intersection of a ray with a shape."""

    shape: ShapeId = ShapeId()
    body: BodyId = BodyId()
    point: Vector = (0.0, 0.0, 0.0)
    """On the surface, meters, world space."""
    normal: Vector = (0.0, 0.0, 0.0)
    """Unit outward normal of the surface there."""
    distance: float = 0.0
    """Distance from the ray's origin, meters."""
    triangle: int = -1
    """For a mesh: index of the triangle that was hit, in the order of the mesh's indices. For a height field: 2 x
    (index of the cell, row by row), plus 1 for the triangle on the side of greater x. For other shapes: -1.
    """


@lists_members
@dataclass(slots=True, eq=False)
class ShapeCastHit:
    """The first contact of a shape that is moved along a line."""

    shape: ShapeId = ShapeId()
    body: BodyId = BodyId()
    fraction: float = 0.0
    """Fraction of the translation before the contact, 0 to 1; 0 if the shapes overlap at the start."""
    point: Vector = (0.0, 0.0, 0.0)
    """Where the two shapes touch, meters, world space."""
    normal: Vector = (0.0, 0.0, 0.0)
    """Unit normal, out of the shape that was hit."""
    triangle: int = -1
    """The triangle that was hit; as in RayHit."""


@lists_members
@dataclass(slots=True, eq=False)
class ClosestPoint:
    """The point of the nearest shape that is closest to a given point."""

    shape: ShapeId = ShapeId()
    body: BodyId = BodyId()
    point: Vector = (0.0, 0.0, 0.0)
    """On the surface, meters, world space; the given point itself if it is inside the shape."""
    distance: float = 0.0
    """Meters; 0 if the given point is inside the shape."""
    triangle: int = -1
    """The triangle on which the point lies; as in RayHit."""


@lists_members
@dataclass(slots=True, eq=False)
class BroadPhaseNode:
    """A node of a tree of the broad phase. Its box encloses those of its children, of which there are at most eight;
    the boxes of siblings may overlap.
    """

    bounds: Bounds = field(default_factory=Bounds)
    """Meters, world space; the box of a leaf is somewhat larger than its shape."""
    tree: BroadPhaseTree | str = BroadPhaseTree.fixed
    """The tree to which the node belongs."""
    depth: int = 0
    """Levels below the root of the tree; 0: the root."""
    parent: int = 0
    """Index of the parent in the list of nodes; -1: the node is a root."""
    is_leaf: bool = False
    """True: the node is the box of a single shape."""
    shape: ShapeId = ShapeId()
    """The shape of a leaf; null for other nodes."""


@lists_members
@dataclass(slots=True, eq=False)
class SolverContact:
    """How the solver treats a touching pair of shapes, after the last step; for visualization and measurements."""

    shape_a: ShapeId = ShapeId()
    shape_b: ShapeId = ShapeId()
    body_a: BodyId = BodyId()
    body_b: BodyId = BodyId()
    color: int = 0
    """Color in the constraint graph. Contacts of one color share no dynamic body, so that they are solved in parallel.
    Colors are solved in turn, lowest first; those of contacts with static and kinematic bodies come last. -1: no color
    was free, and the contact is solved on its own, before all others.
    """
    substeps: int = 0
    """Substeps of its island in the last step in which the island was awake; 0: it has not been solved yet."""


@lists_members
@dataclass(slots=True, eq=False)
class DebugLinesDef:
    """What `World.debug_lines` shows."""

    shapes: bool = True
    """Edges of shapes; an infinite plane is shown as a grid of 20 m. The color tells whether a body is static,
    kinematic, awake or asleep; triggers have a color of their own.
    """
    bounds: bool = False
    """Axis-aligned bounding boxes of shapes; infinite planes have none."""
    centers: bool = False
    """Principal axes of inertia at the centers of mass of dynamic bodies: x red, y green, z blue."""
    velocities: bool = False
    """Lines from the center of mass of each moving body to where its velocity brings it in 0.1 s."""
    contacts: bool = True
    """The normal at each contact point."""
    joints: bool = True
    """Lines from the centers of mass of both bodies to their anchors, and the axes of the joint at the anchor of A."""
    size: float = 0.2
    """m, > 0: length of axes and normals."""
    impulse_scale: float = 0.0
    """m/(N s), >= 0. If > 0, the length of a normal is this times the normal impulse of its contact point in the last
    step.
    """


@lists_members
@dataclass(slots=True, eq=False)
class DebugLine:
    """A straight line."""

    begin: Vector = (0.0, 0.0, 0.0)
    """m, in world space."""
    end: Vector = (0.0, 0.0, 0.0)
    """m, in world space."""
    color: Vector = (0.0, 0.0, 0.0)
    """Red, green and blue, 0 to 1."""


@lists_members
@dataclass(slots=True, eq=False)
class QueryFilter:
    """Selects the shapes that a query can find. A shape must meet all conditions."""

    layers: int = 2**64 - 1
    """The shape must be in one of these layers (`CollisionFilter.layers`)."""
    own_layers: int = 2**64 - 1
    """The layers of the query itself: the shape must collide with one of them (`CollisionFilter.collides_with`)."""
    static_bodies: bool = True
    """True: shapes of static bodies are included."""
    kinematic_bodies: bool = True
    """True: shapes of kinematic bodies are included."""
    dynamic_bodies: bool = True
    """True: shapes of dynamic bodies are included."""
    triggers: bool = False
    """True: triggers are included, and found like other shapes."""
    any: bool = False
    """True: the query may return any one result: the first that it finds instead of the nearest, and a single shape for
    overlaps. Faster if it only matters whether there is any.
    """
    ignored_bodies: Sequence[BodyId] = field(default_factory=list)
    """Shapes of these bodies are excluded. Each body must exist."""
