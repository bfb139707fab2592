# Made by tools/api.py from api/: change those, and run it.
"""Structs and enums of the API: those of include/cairn/math.h."""
from __future__ import annotations

from dataclasses import dataclass

from ._members import lists_members
from ._vector import Vector


@lists_members
@dataclass(slots=True, eq=False)
class Transform:
    """A pose: rotate by `rotation`, then translate by `position` (meters)."""

    position: Vector = (0.0, 0.0, 0.0)
    """Meters."""
    rotation: Vector = (0.0, 0.0, 0.0, 1.0)
    """A unit quaternion."""


@lists_members
@dataclass(slots=True, eq=False)
class Bounds:
    """An axis-aligned box in world space, in meters. Empty when any `min` exceeds its `max`."""

    min: Vector = (0.0, 0.0, 0.0)
    """Least coordinates, meters."""
    max: Vector = (0.0, 0.0, 0.0)
    """Greatest coordinates, meters."""
