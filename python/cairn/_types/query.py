# Made by tools/api.py from api/: change those, and run it.
"""Structs and enums of the API: those of include/cairn/query.h."""
from __future__ import annotations

from dataclasses import dataclass

from .._cairn import BodyId, ShapeId
from ._members import lists_members
from ._vector import Vector


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
