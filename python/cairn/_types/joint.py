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
    """Whether a limit or drive of a general joint acts on a distance or on an angle."""

    linear = 0
    """A distance along axes."""
    angular = 1
    """An angle about axes."""


class JointSolver(enum.Enum):
    """How a joint is solved. Both solvers give the same motion; they differ in cost and stiffness."""

    automatic = 0
    """The engine chooses. It solves directly: chains, machines, robots with servo-driven angles, and joints under high
    mass ratios, as long as this is not too expensive; and all joints that connect to joints with `direct`. All others
    are iterative.
    """
    iterative = 1
    """Joints are solved in turn (eight at a time, in SIMD lanes), together with the contacts. For nets, and heaps of
    many joints.
    """
    direct = 2
    """All direct joints that connect bodies are solved as one system of equations, including their motors, springs,
    friction and limits. For chains, machines, robots, and joints that must not yield. Gears, racks and pulleys remain
    iterative, and so do all joints of a net of thousands, whose factorization would take far too long.
    """


@lists_members
@dataclass(slots=True, eq=False)
class JointSpring:
    """A damped spring. It is integrated implicitly, so that any stiffness is stable."""

    stiffness: float = 0.0
    """N/m or N m/rad, >= 0."""
    damping: float = 0.0
    """N s/m or N m s/rad, >= 0."""
    is_acceleration: bool = False
    """True: stiffness (1/s^2) and damping (1/s) are per unit of the mass (or moment of inertia) that the joint moves
    along that axis: they set the motion, whatever the mass. False: they set the force.
    """

    @staticmethod
    def from_frequency(hertz: float, damping_ratio: float) -> "JointSpring":
        """The spring with which the bodies oscillate at a natural frequency of `hertz` (Hz, > 0), with that damping
        ratio (>= 0; 1: critical damping).
        """
        return JointSpring(*_spring_from_frequency(hertz, damping_ratio), True)


@lists_members
@dataclass(slots=True, eq=False)
class JointRange:
    """Limits of a position, m or rad. `lower` = `upper` holds it at one value."""

    lower: float = 0.0
    """m or rad, lower <= upper; -infinity: no bound on that side."""
    upper: float = 0.0
    """m or rad, lower <= upper; +infinity: no bound on that side."""
    spring: JointSpring | None = None
    """Pulls back a position that is beyond a bound; None: the limit is rigid."""


@lists_members
@dataclass(slots=True, eq=False)
class JointMotor:
    """Drives an axis. With a spring it pulls towards `position` and `velocity`; without one it keeps the velocity, as
    far as `max_force` allows.
    """

    velocity: float = 0.0
    """m/s or rad/s: target velocity."""
    position: float = 0.0
    """m or rad: target position; used only with a spring."""
    spring: JointSpring | None = None
    """None: the motor keeps its velocity."""
    max_force: float = math.inf
    """N or N m, >= 0: greatest force or torque of the motor."""


@lists_members
@dataclass(slots=True, eq=False)
class JointControl:
    """Limits, motor and friction of one axis of a joint. By default the axis is free."""

    limits: JointRange | None = None
    """None: no limits."""
    motor: JointMotor | None = None
    """None: no motor."""
    friction: float = 0.0
    """N or N m, >= 0: dry friction. The axis moves only under a greater force or torque."""


@lists_members
@dataclass(slots=True, eq=False)
class FixedJoint:
    """B keeps its position and rotation relative to A."""


@lists_members
@dataclass(slots=True, eq=False)
class BallJoint:
    """The origins of the two frames coincide; B rotates freely about that point, within the limits."""

    cone_angle: float | None = None
    """rad, 0 to pi: greatest angle between the x axes of the two frames (swing limit); None: none."""
    twist: JointRange | None = None
    """rad, -pi to pi: limits of the angle about the x axis; None: none."""
    friction: float = 0.0
    """N m, >= 0: friction torque about each axis."""


@lists_members
@dataclass(slots=True, eq=False)
class HingeJoint:
    """B rotates about the x axis of A. While a limit, motor or friction acts on the angle, it counts full turns;
    otherwise it is between -pi and pi.
    """

    angle: JointControl = field(default_factory=JointControl)
    """Angle about the x axis of A."""


@lists_members
@dataclass(slots=True, eq=False)
class SliderJoint:
    """B moves along the x axis of A and does not rotate relative to A."""

    translation: JointControl = field(default_factory=JointControl)
    """Translation along the x axis of A."""


@lists_members
@dataclass(slots=True, eq=False)
class CylindricalJoint:
    """B moves along the x axis of A and rotates about it."""

    translation: JointControl = field(default_factory=JointControl)
    """Translation along the x axis of A."""
    angle: JointControl = field(default_factory=JointControl)
    """Angle about the x axis of A."""


@lists_members
@dataclass(slots=True, eq=False)
class UniversalJoint:
    """A universal (Cardan) joint: a cross with two axes at a right angle, the x axis of A and the y axis of B, about
    which the bodies rotate.
    """

    first: JointControl = field(default_factory=JointControl)
    """Rotation about the x axis of A."""
    second: JointControl = field(default_factory=JointControl)
    """Rotation about the y axis of B."""


@lists_members
@dataclass(slots=True, eq=False)
class DistanceJoint:
    """Controls the distance (m) between the origins of the two frames. For a rod, set limits with lower = upper; for a
    rope, lower = 0; for a spring, a motor with a spring and `position` = its rest length.
    """

    distance: JointControl = field(default_factory=JointControl)
    """Distance between the origins of the two frames."""


@lists_members
@dataclass(slots=True, eq=False)
class WheelJoint:
    """A wheel B under a car A. The wheel moves along the x axis of A (suspension), rotates about it (steering), and
    spins about its own y axis.
    """

    suspension: JointControl = field(default_factory=JointControl)
    """Translation along the x axis of A."""
    steering: JointControl | None = None
    """Angle about the x axis of A. None: the wheel does not steer."""
    spin: JointControl = field(default_factory=JointControl)
    """Rotation about the y axis of the wheel."""


@lists_members
@dataclass(slots=True, eq=False)
class ServoJoint:
    """A servo that pulls B to a target position and rotation in the frame of A."""

    position: Vector = (0.0, 0.0, 0.0)
    """Target of the origin of frame B, in frame A, meters."""
    rotation: Vector = (0.0, 0.0, 0.0, 1.0)
    """Target of the rotation of frame B in frame A; normalized."""
    linear: JointSpring = field(default_factory=lambda: JointSpring.from_frequency(5.0, 1.0))
    """Spring that pulls B to the target position."""
    angular: JointSpring = field(default_factory=lambda: JointSpring.from_frequency(5.0, 1.0))
    """Spring that rotates B to the target rotation."""
    max_force: float = math.inf
    """N, >= 0: greatest force along each axis."""
    max_torque: float = math.inf
    """N m, >= 0: greatest torque about each axis."""


@lists_members
@dataclass(slots=True, eq=False)
class GearJoint:
    """Two meshing gears: (angular speed of A about the x axis of its frame) + ratio x (angular speed of B about that of
    its frame) = 0. For external gears on parallel axes, ratio = teeth of B / teeth of A. Angular speeds are relative to
    the world, so the bodies that carry the axles must not rotate about them.
    """

    ratio: float = 1.0
    """Not 0; negative: both rotate in the same sense."""


@lists_members
@dataclass(slots=True, eq=False)
class RackJoint:
    """A pinion A on a rack B: (translation of B along the x axis of its frame) = radius x (angle of A about the x axis
    of its frame), both relative to the world.
    """

    radius: float = 0.1
    """m, not 0; negative: the rack moves in the opposite sense."""


@lists_members
@dataclass(slots=True, eq=False)
class PulleyJoint:
    """A rope over two fixed pulleys: length at A + ratio x length at B <= length."""

    ground_a: Vector = (0.0, 0.0, 0.0)
    """The pulley on the side of A, meters, world space."""
    ground_b: Vector = (0.0, 0.0, 0.0)
    """The pulley on the side of B, meters, world space."""
    ratio: float = 1.0
    """> 0: ratio of the block and tackle on the side of B."""
    length: float | None = None
    """m, > 0; None: the length when the joint is created, which `World.joint_def` then returns."""


@lists_members
@dataclass(slots=True, eq=False)
class JointLimit:
    """Limits a distance (m) or an angle (rad) between the two frames. With one axis it is the position along, or the
    angle about, that axis. With two axes it is the distance from the line of the third axis, or the angle between the
    third axes of both frames (a cone). With three axes it is the distance of the two origins, or the angle of the whole
    rotation.
    """

    kind: JointAxis | str = JointAxis.linear
    """Whether it limits a distance or an angle."""
    axes: Sequence[bool] = (False, False, False)
    """Which of the axes x, y and z of frame A; one to three of them."""
    min: float | None = None
    """m or rad, min <= max; None: no bound on that side."""
    max: float | None = None
    """m or rad, min <= max; None: no bound on that side."""
    stiffness: float | None = None
    """N/m or N m/rad, >= 0; None: rigid."""
    damping: float = 0.0
    """N s/m or N m s/rad, >= 0; used only with a stiffness."""


@lists_members
@dataclass(slots=True, eq=False)
class JointDrive:
    """A damped spring or motor along or about one axis. Its force (or torque) is stiffness x (position_target -
    position) + damping x (velocity_target - velocity).
    """

    kind: JointAxis | str = JointAxis.linear
    """Whether it drives a distance or an angle."""
    is_acceleration: bool = False
    """True: the formula gives an acceleration; False: a force or torque."""
    axis: int = 0
    """0, 1 or 2: x, y or z of frame A."""
    max_force: float | None = None
    """N or N m, >= 0: greatest force or torque; None: no bound."""
    position_target: float = 0.0
    """m or rad: target position of the spring."""
    velocity_target: float = 0.0
    """m/s or rad/s: target velocity of the damping."""
    stiffness: float = 0.0
    """N/m or N m/rad, >= 0: stiffness of the spring."""
    damping: float = 0.0
    """N s/m or N m s/rad, >= 0: damping of the spring."""


@lists_members
@dataclass(slots=True, eq=False)
class GeneralJoint:
    """The joint of the glTF draft KHR_physics_rigid_bodies: six degrees of freedom, any of which may have limits and
    drives. It may have at most eight limits and drives, not counting limits that just lock axes.
    """

    limits: Sequence[JointLimit] = field(default_factory=list)
    """Limits of distances and angles."""
    drives: Sequence[JointDrive] = field(default_factory=list)
    """Drives of distances and angles."""


@lists_members
@dataclass(slots=True, eq=False)
class JointDef:
    """Everything that is needed to create a joint."""

    body_a: BodyId = BodyId()
    """Null: the world. The two bodies must differ, and at least one must be dynamic."""
    body_b: BodyId = BodyId()
    """Null: the world. The two bodies must differ, and at least one must be dynamic."""
    frame_a: Transform = field(default_factory=Transform)
    """Pose of the joint's frame relative to the frame of body A, or relative to the world."""
    frame_b: Transform = field(default_factory=Transform)
    """Pose of the joint's frame relative to the frame of body B, or relative to the world."""
    joint: Joint = field(default_factory=FixedJoint)
    """The type of joint, with its limits, motors and springs."""
    enable_collision: bool = False
    """True: the two bodies collide with each other."""
    break_force: float = math.inf
    """N, > 0: the joint breaks if its mean force in a step exceeds this."""
    break_torque: float = math.inf
    """N m, > 0: the joint breaks if its mean torque in a step exceeds this."""
    solver: JointSolver | str = JointSolver.automatic
    """How the joint is solved."""
    name: str = ""
    """For display and `World.find_joint`; need not be unique."""
    user_data: int = 0
    """Stored for the application; the engine does not use it."""
    enabled: bool = True
    """False: the joint does not act until `World.set_joint_enabled`."""


@lists_members
@dataclass(slots=True, eq=False)
class JointState:
    """Forces, positions and errors of a joint in the last step."""

    force: Vector = (0.0, 0.0, 0.0)
    """N: mean force on B, world axes."""
    torque: Vector = (0.0, 0.0, 0.0)
    """N m: mean torque on B about the origin of its frame, world axes."""
    positions: Sequence[float] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    """Positions of its axes (m or rad), in the order of the members of its type: for a hinge its angle; for a
    cylindrical joint translation and angle; for a general joint one for each of its limits and drives, except limits
    that just lock axes.
    """
    position_count: int = 0
    """Number of valid elements of `positions`."""
    linear_error: float = 0.0
    """m: distance between the points that the joint holds together."""
    angular_error: float = 0.0
    """rad: rotation of B about the axes that the joint locks."""


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
