/// \file joint.h
/// Joints: they constrain the motion of two bodies relative to each other, and may drive it.
///
/// A joint has a frame on each of its two bodies. Its x axis is the joint's main axis: the axis of a hinge, the line
/// of a slider, the twist axis of a ball joint. Positions are those of frame B as seen from frame A: a hinge's angle is
/// 0 where the two frames coincide.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cairn {

/// A damped spring. It is integrated implicitly, so that any stiffness is stable.
struct JointSpring {
    float stiffness = 0.0f; ///< N/m or N m/rad, >= 0.
    float damping = 0.0f;   ///< N s/m or N m s/rad, >= 0.
    /// true: stiffness (1/s^2) and damping (1/s) are per unit of the mass (or moment of inertia) that the joint moves
    /// along that axis: they set the motion, whatever the mass. false: they set the force.
    bool is_acceleration = false;

    /// The spring with which the bodies oscillate at a natural frequency of `hertz` (Hz, > 0), with that damping ratio
    /// (>= 0; 1: critical damping).
    static constexpr JointSpring from_frequency(float hertz, float damping_ratio) {
        const float omega = 6.28318531f * hertz;
        return {omega * omega, 2.0f * damping_ratio * omega, true};
    }
};

/// Limits of a position, m or rad. `lower` = `upper` holds it at one value.
struct JointRange {
    float lower = 0.0f, upper = 0.0f;    ///< lower <= upper; -infinity or +infinity: no bound on that side.
    std::optional<JointSpring> spring{}; ///< Pulls back a position that is beyond a bound; absent: the limit is rigid.
};

/// Drives an axis. With a spring it pulls towards `position` and `velocity`; without one it keeps the velocity, as far
/// as `max_force` allows.
struct JointMotor {
    float velocity = 0.0f; ///< m/s or rad/s: target velocity.
    float position = 0.0f; ///< m or rad: target position; used only with a spring.
    std::optional<JointSpring> spring{};
    /// N or N m, >= 0: greatest force or torque of the motor.
    float max_force = std::numeric_limits<float>::infinity();
};

/// Limits, motor and friction of one axis of a joint. By default the axis is free.
struct JointControl {
    std::optional<JointRange> limits{};
    std::optional<JointMotor> motor{};
    float friction = 0.0f; ///< N or N m, >= 0: dry friction. The axis moves only under a greater force or torque.
};

/// B keeps its position and rotation relative to A.
struct FixedJoint {};

/// The origins of the two frames coincide; B rotates freely about that point, within the limits.
struct BallJoint {
    /// rad, 0 to pi: greatest angle between the x axes of the two frames (swing limit); absent: none.
    std::optional<float> cone_angle{};
    std::optional<JointRange> twist{}; ///< rad, -pi to pi: limits of the angle about the x axis; absent: none.
    float friction = 0.0f;             ///< N m, >= 0: friction torque about each axis.
};

/// B rotates about the x axis of A. While a limit, motor or friction acts on the angle, it counts full turns; otherwise
/// it is between -pi and pi.
struct HingeJoint {
    JointControl angle{};
};

/// B moves along the x axis of A and does not rotate relative to A.
struct SliderJoint {
    JointControl translation{};
};

/// B moves along the x axis of A and rotates about it.
struct CylindricalJoint {
    JointControl translation{}, angle{};
};

/// A universal (Cardan) joint: a cross with two axes at a right angle, the x axis of A and the y axis of B, about which
/// the bodies rotate.
struct UniversalJoint {
    JointControl first{}, second{}; ///< Rotation about the x axis of A, and about the y axis of B.
};

/// Controls the distance (m) between the origins of the two frames. For a rod, set limits with lower = upper; for a
/// rope, lower = 0; for a spring, a motor with a spring and `position` = its rest length.
struct DistanceJoint {
    JointControl distance{};
};

/// A wheel B under a car A. The wheel moves along the x axis of A (suspension), rotates about it (steering), and spins
/// about its own y axis.
struct WheelJoint {
    JointControl suspension{};
    /// Absent: the wheel does not steer.
    std::optional<JointControl> steering{};
    JointControl spin{};
};

/// A servo that pulls B to a target position and rotation in the frame of A.
struct ServoJoint {
    Vec3 position{0.0f, 0.0f, 0.0f};       ///< Target of the origin of frame B, in frame A, meters.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< Target of frame B in frame A; normalized.
    JointSpring linear = JointSpring::from_frequency(5.0f, 1.0f);
    JointSpring angular = JointSpring::from_frequency(5.0f, 1.0f);
    float max_force = std::numeric_limits<float>::infinity();  ///< N, >= 0: greatest force along each axis.
    float max_torque = std::numeric_limits<float>::infinity(); ///< N m, >= 0: greatest torque about each axis.
};

/// Two meshing gears: (angular speed of A about the x axis of its frame) + ratio x (angular speed of B about that of
/// its frame) = 0. For external gears on parallel axes, ratio = teeth of B / teeth of A. Angular speeds are relative to
/// the world, so the bodies that carry the axles must not rotate about them.
struct GearJoint {
    float ratio = 1.0f; ///< Not 0; negative: both rotate in the same sense.
};

/// A pinion A on a rack B: (translation of B along the x axis of its frame) = radius x (angle of A about the x axis of
/// its frame), both relative to the world.
struct RackJoint {
    float radius = 0.1f; ///< m, not 0; negative: the rack moves in the opposite sense.
};

/// A rope over two fixed pulleys: length at A + ratio x length at B <= length.
struct PulleyJoint {
    Position ground_a{0.0, 0.0, 0.0}, ground_b{0.0, 0.0, 0.0}; ///< The two pulleys, meters, world space.
    float ratio = 1.0f;                                        ///< > 0: ratio of the block and tackle on the side of B.
    /// m, > 0; absent: the length when the joint is created, which `World::joint_def` then returns.
    std::optional<float> length{};
};

enum class JointAxis : std::uint8_t { linear, angular };

/// Limits a distance (m) or an angle (rad) between the two frames. With one axis it is the position along, or the angle
/// about, that axis. With two axes it is the distance from the line of the third axis, or the angle between the third
/// axes of both frames (a cone). With three axes it is the distance of the two origins, or the angle of the whole
/// rotation.
struct JointLimit {
    JointAxis kind = JointAxis::linear;
    std::array<bool, 3> axes{};     ///< Which of the axes x, y and z of frame A; one to three of them.
    std::optional<float> min, max;  ///< m or rad, min <= max; absent: no bound on that side.
    std::optional<float> stiffness; ///< N/m or N m/rad, >= 0; absent: rigid.
    float damping = 0.0f;           ///< N s/m or N m s/rad, >= 0; used only with a stiffness.
};

/// A damped spring or motor along or about one axis. Its force (or torque) is stiffness x (position_target - position)
/// + damping x (velocity_target - velocity).
struct JointDrive {
    JointAxis kind = JointAxis::linear;
    bool is_acceleration = false;   ///< true: the formula gives an acceleration; false: a force or torque.
    int axis = 0;                   ///< 0, 1 or 2: x, y or z of frame A.
    std::optional<float> max_force; ///< N or N m, >= 0: greatest force or torque; absent: no bound.
    float position_target = 0.0f, velocity_target = 0.0f, stiffness = 0.0f, damping = 0.0f;
};

/// The joint of the glTF draft KHR_physics_rigid_bodies: six degrees of freedom, any of which may have limits and
/// drives. It may have at most eight limits and drives, not counting limits that just lock axes.
struct GeneralJoint {
    std::vector<JointLimit> limits{};
    std::vector<JointDrive> drives{};
};

/// Any joint.
using Joint = std::variant<FixedJoint, BallJoint, HingeJoint, SliderJoint, CylindricalJoint, UniversalJoint,
                           DistanceJoint, WheelJoint, ServoJoint, GearJoint, RackJoint, PulleyJoint, GeneralJoint>;

/// How a joint is solved. Both solvers give the same motion; they differ in cost and stiffness.
enum class JointSolver : std::uint8_t {
    /// The engine chooses. It solves directly: chains, machines, robots with servo-driven angles, and joints under high
    /// mass ratios, as long as this is not too expensive; and all joints that connect to joints with `direct`. All
    /// others are iterative.
    automatic,
    /// Joints are solved in turn (eight at a time, in SIMD lanes), together with the contacts. For nets, and heaps of
    /// many joints.
    iterative,
    /// All direct joints that connect bodies are solved as one system of equations, including their motors, springs,
    /// friction and limits. For chains, machines, robots, and joints that must not yield. Gears, racks and pulleys
    /// remain iterative, and so do all joints of a net of thousands, whose factorization would take far too long.
    direct,
};

/// Everything that is needed to create a joint (`World::create_joint`).
struct JointDef {
    BodyId body_a{}, body_b{}; ///< Null: the world. They must differ, and at least one must be dynamic.
    /// Pose of the joint's frame relative to the frame of each body, or relative to the world.
    Transform frame_a{}, frame_b{};
    Joint joint = FixedJoint{};
    bool enable_collision = false; ///< true: the two bodies collide with each other.
    /// N, > 0: the joint breaks if its mean force in a step exceeds this.
    float break_force = std::numeric_limits<float>::infinity();
    float break_torque = std::numeric_limits<float>::infinity(); ///< N m, > 0: likewise for its mean torque.
    JointSolver solver = JointSolver::automatic;
    std::string name{};          ///< For display and `World::find_joint`; need not be unique.
    std::uint64_t user_data = 0; ///< Stored for the application; the engine does not use it.
    bool enabled = true;         ///< false: the joint does not act until `World::set_joint_enabled`.
};

/// Forces, positions and errors of a joint in the last step.
struct JointState {
    Vec3 force{0.0f, 0.0f, 0.0f};  ///< N: mean force on B, world axes.
    Vec3 torque{0.0f, 0.0f, 0.0f}; ///< N m: mean torque on B about the origin of its frame, world axes.
    /// Positions of its axes (m or rad), in the order of the members of its type: for a hinge its angle; for a
    /// cylindrical joint translation and angle; for a general joint one for each of its limits and drives, except
    /// limits that just lock axes.
    std::array<float, 8> positions{};
    int position_count = 0;
    float linear_error = 0.0f;  ///< m: distance between the points that the joint holds together.
    float angular_error = 0.0f; ///< rad: rotation of B about the axes that the joint locks.
};

} // namespace cairn
