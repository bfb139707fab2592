# Made by tools/api.py from api/: change those, and run it.
"""Structs and enums of the API: those of include/cairn/joint.h."""
from __future__ import annotations

import enum
import math
from dataclasses import dataclass, field
from typing import Sequence, Union

from .._cairn import BodyId, _spring_from_frequency
from .math import Transform
from ._members import lists_members
from ._vector import Vector


class JointAxis(enum.Enum):
    """What a limit or drive of a general joint is about."""

    linear = 0
    """A distance along axes."""
    angular = 1
    """An angle about axes."""


class JointSolver(enum.Enum):
    """How a joint is solved. Both give the same motion; they differ in cost and stiffness."""

    automatic = 0
    """Direct in chains, machines, robots whose angles servos hold, and under high mass ratios as long as it pays, and
    where it hangs together with joints that are asked to be direct; else iterative.
    """
    iterative = 1
    """8 joints at a time, one after the other, with the contacts. For nets and heaps of many joints."""
    direct = 2
    """All direct joints that hang together at once. With their motors, springs, friction and limits. For chains,
    machines, robots, and what must not give at all. Gears, racks and pulleys stay iterative; so do all of a net of
    thousands of joints, whose factorization would not end.
    """


@lists_members
@dataclass(slots=True, eq=False)
class JointSpring:
    """A damped spring. It is stepped implicitly: any stiffness is stable."""

    stiffness: float = 0.0
    """N/m or N m/rad, >= 0."""
    damping: float = 0.0
    """N s/m or N m s/rad, >= 0."""
    is_acceleration: bool = False
    """True: both are per unit of the mass (or moment of inertia) that the joint moves along that axis, so that the
    motion, not the force, is given.
    """

    @staticmethod
    def from_frequency(hertz: float, damping_ratio: float) -> "JointSpring":
        """The spring with which what the joint moves swings at `hertz` (> 0) with that ratio to critical damping (>=
        0).
        """
        return JointSpring(*_spring_from_frequency(hertz, damping_ratio), True)


@lists_members
@dataclass(slots=True, eq=False)
class JointRange:
    """The range of a position, m or rad. `lower` = `upper` holds it at one value."""

    lower: float = 0.0
    """lower <= upper; -infinity and +infinity for no bound. (m or rad)"""
    upper: float = 0.0
    """lower <= upper; -infinity and +infinity for no bound. (m or rad)"""
    spring: JointSpring | None = None
    """Pushes back from beyond a bound; None: rigid."""


@lists_members
@dataclass(slots=True, eq=False)
class JointMotor:
    """What drives an axis: with a spring, towards `position` and `velocity`; without one, it holds the velocity."""

    velocity: float = 0.0
    """m/s or rad/s."""
    position: float = 0.0
    """m or rad; only with a spring."""
    spring: JointSpring | None = None
    """None: the motor holds its velocity."""
    max_force: float = math.inf
    """N or N m, >= 0."""


@lists_members
@dataclass(slots=True, eq=False)
class JointControl:
    """All that can act along one axis of a joint."""

    limits: JointRange | None = None
    """None: no limits."""
    motor: JointMotor | None = None
    """None: no motor."""
    friction: float = 0.0
    """N or N m, >= 0: dry friction, which holds until it is overcome."""


@lists_members
@dataclass(slots=True, eq=False)
class FixedJoint:
    """B keeps its place and rotation against A."""


@lists_members
@dataclass(slots=True, eq=False)
class BallJoint:
    """The origins of the frames coincide; B turns freely."""

    cone_angle: float | None = None
    """rad, 0 to pi: greatest angle between the x axes of the two frames."""
    twist: JointRange | None = None
    """Of the angle about the x axis, -pi to pi."""
    friction: float = 0.0
    """N m about each axis, >= 0."""


@lists_members
@dataclass(slots=True, eq=False)
class HingeJoint:
    """B turns about the x axis of A. Its angle is counted on beyond a full turn while a limit, motor or friction acts
    on it; without any it is between -pi and pi.
    """

    angle: JointControl = field(default_factory=JointControl)
    """About the x axis of A."""


@lists_members
@dataclass(slots=True, eq=False)
class SliderJoint:
    """B moves along the x axis of A without turning."""

    translation: JointControl = field(default_factory=JointControl)
    """Along the x axis of A."""


@lists_members
@dataclass(slots=True, eq=False)
class CylindricalJoint:
    """B moves along the x axis of A and turns about it."""

    translation: JointControl = field(default_factory=JointControl)
    """Along the x axis of A."""
    angle: JointControl = field(default_factory=JointControl)
    """About the x axis of A."""


@lists_members
@dataclass(slots=True, eq=False)
class UniversalJoint:
    """A cross of two axes at a right angle: A turns about its x axis, B about its y axis (a Cardan joint)."""

    first: JointControl = field(default_factory=JointControl)
    """About the x axis of A."""
    second: JointControl = field(default_factory=JointControl)
    """About the y axis of B."""


@lists_members
@dataclass(slots=True, eq=False)
class DistanceJoint:
    """The distance between the origins of the frames. A rod has lower = upper, a rope lower = 0, a spring a motor with
    a spring at its length at rest.
    """

    distance: JointControl = field(default_factory=JointControl)
    """Between the origins of the frames."""


@lists_members
@dataclass(slots=True, eq=False)
class WheelJoint:
    """A wheel B under a car A. The wheel moves along the x axis of A (the suspension), turns about it (the steering)
    and spins about its own y axis.
    """

    suspension: JointControl = field(default_factory=JointControl)
    """Along the x axis of A."""
    steering: JointControl | None = None
    """None: the wheel does not steer."""
    spin: JointControl = field(default_factory=JointControl)
    """About the y axis of the wheel."""


@lists_members
@dataclass(slots=True, eq=False)
class ServoJoint:
    """A servo that moves B to a place and rotation in the frame of A."""

    position: Vector = (0.0, 0.0, 0.0)
    """Of the origin of frame B in frame A, meters."""
    rotation: Vector = (0.0, 0.0, 0.0, 1.0)
    """Of frame B in frame A; normalized."""
    linear: JointSpring = field(default_factory=lambda: JointSpring.from_frequency(5.0, 1.0))
    """The spring that pulls B to its place."""
    angular: JointSpring = field(default_factory=lambda: JointSpring.from_frequency(5.0, 1.0))
    """The spring that turns B to its rotation."""
    max_force: float = math.inf
    """N along each axis, >= 0."""
    max_torque: float = math.inf
    """N m about each axis, >= 0."""


@lists_members
@dataclass(slots=True, eq=False)
class GearJoint:
    """Two turning bodies in mesh: (rate of A about its frame's x axis) + ratio x (rate of B about its own) = 0. With
    teeth in mesh on the outside of both, about parallel axes, ratio = teeth of B / teeth of A. Rates are those against
    the world: the bodies that carry the axles must not turn about them.
    """

    ratio: float = 1.0
    """Not 0."""


@lists_members
@dataclass(slots=True, eq=False)
class RackJoint:
    """A pinion A on a rack B: (translation of B along its frame's x axis) = radius x (angle of A about its frame's x
    axis), as against the world.
    """

    radius: float = 0.1
    """m, not 0; negative for the other sense."""


@lists_members
@dataclass(slots=True, eq=False)
class PulleyJoint:
    """A rope over two fixed pulleys: length at A + ratio x length at B <= length."""

    ground_a: Vector = (0.0, 0.0, 0.0)
    """World points from which the bodies hang."""
    ground_b: Vector = (0.0, 0.0, 0.0)
    """World points from which the bodies hang."""
    ratio: float = 1.0
    """> 0: of a block and tackle."""
    length: float | None = None
    """m, > 0; None: what it is when the joint is made, which `World.joint_def` then has."""


@lists_members
@dataclass(slots=True, eq=False)
class JointLimit:
    """Keeps a distance (m) or an angle (rad) between the two frames in a range. With one axis: along or about it; with
    two: from the line of the remaining axis, or of the cone about it; with three: of points, or any turn.
    """

    kind: JointAxis | str = JointAxis.linear
    """Whether it is about distances or angles."""
    axes: Sequence[bool] = (False, False, False)
    """x, y and z of frame A; one to three of them."""
    min: float | None = None
    """None: no bound on that side. min <= max."""
    max: float | None = None
    """None: no bound on that side. min <= max."""
    stiffness: float | None = None
    """N/m or N m/rad, >= 0; None: rigid."""
    damping: float = 0.0
    """N s/m or N m s/rad, >= 0; with a stiffness only."""


@lists_members
@dataclass(slots=True, eq=False)
class JointDrive:
    """A damped spring or motor along or about one axis: pushes with stiffness x (position_target - position) + damping
    x (velocity_target - velocity).
    """

    kind: JointAxis | str = JointAxis.linear
    """Whether it is about distances or angles."""
    is_acceleration: bool = False
    """True: the above is an acceleration; False: a force or torque."""
    axis: int = 0
    """0, 1 or 2, of frame A."""
    max_force: float | None = None
    """N or N m, >= 0; None: no bound."""
    position_target: float = 0.0
    """Where the spring pulls to. (m or rad)"""
    velocity_target: float = 0.0
    """What the damping aims at. (m/s or rad/s)"""
    stiffness: float = 0.0
    """Of the spring, >= 0. (N/m or N m/rad)"""
    damping: float = 0.0
    """Of the spring, >= 0. (N s/m or N m s/rad)"""


@lists_members
@dataclass(slots=True, eq=False)
class GeneralJoint:
    """The joint of the glTF draft KHR_physics_rigid_bodies: six degrees of freedom, and any of them limited or driven.
    At most eight limits and drives that are not plain locks.
    """

    limits: Sequence[JointLimit] = field(default_factory=list)
    """What is kept in a range."""
    drives: Sequence[JointDrive] = field(default_factory=list)
    """What is driven."""


@lists_members
@dataclass(slots=True, eq=False)
class JointDef:
    """Everything needed to make a joint."""

    body_a: BodyId = BodyId()
    """Null: the world. At least one must be dynamic; not the same body."""
    body_b: BodyId = BodyId()
    """Null: the world. At least one must be dynamic; not the same body."""
    frame_a: Transform = field(default_factory=Transform)
    """In the frames of the bodies; of the world, in its own."""
    frame_b: Transform = field(default_factory=Transform)
    """In the frames of the bodies; of the world, in its own."""
    joint: Joint = field(default_factory=FixedJoint)
    """What kind of joint, and how it is limited and driven."""
    enable_collision: bool = False
    """Whether the two bodies collide with each other."""
    break_force: float = math.inf
    """N, > 0: the joint breaks beyond it."""
    break_torque: float = math.inf
    """N m, > 0."""
    solver: JointSolver | str = JointSolver.automatic
    """How it is solved."""
    name: str = ""
    """For people; need not be unique."""
    user_data: int = 0
    """Not touched by the engine."""
    enabled: bool = True
    """False: it acts on nothing, as if it were not there."""


@lists_members
@dataclass(slots=True, eq=False)
class JointState:
    """What a joint did in the last step."""

    force: Vector = (0.0, 0.0, 0.0)
    """N: mean force on B, world axes."""
    torque: Vector = (0.0, 0.0, 0.0)
    """N m: mean torque on B about the origin of its frame, world axes."""
    positions: Sequence[float] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    """The positions of its axes (m or rad), in the order of the fields of its type: of a hinge the angle, of a
    cylindrical joint translation and angle, of a general joint those of its limits and drives that are not plain locks.
    """
    position_count: int = 0
    """How many of `positions` there are."""
    linear_error: float = 0.0
    """m: how far the points that it holds together are apart."""
    angular_error: float = 0.0
    """rad: how far B has turned about the axes that it locks."""


Joint = Union[
    FixedJoint,
    BallJoint,
    HingeJoint,
    SliderJoint,
    CylindricalJoint,
    UniversalJoint,
    DistanceJoint,
    WheelJoint,
    ServoJoint,
    GearJoint,
    RackJoint,
    PulleyJoint,
    GeneralJoint,
]
