/// \file joint.h
/// Joints: what holds two bodies together, and moves them against each other.
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

/// A damped spring. It is stepped implicitly: any stiffness is stable.
struct JointSpring {
    float stiffness = 0.0f; ///< N/m or N m/rad, >= 0.
    float damping = 0.0f;   ///< N s/m or N m s/rad, >= 0.
    /// true: both are per unit of the mass (or moment of inertia) that the joint moves along that axis, so that the
    /// motion, not the force, is given.
    bool is_acceleration = false;

    /// The spring with which what the joint moves swings at `hertz` (> 0) with that ratio to critical damping (>= 0).
    static constexpr JointSpring from_frequency(float hertz, float damping_ratio) {
        const float omega = 6.28318531f * hertz;
        return {omega * omega, 2.0f * damping_ratio * omega, true};
    }
};

/// The range of a position, m or rad. `lower` = `upper` holds it at one value.
struct JointRange {
    float lower = 0.0f, upper = 0.0f;    ///< lower <= upper; -infinity and +infinity for no bound.
    std::optional<JointSpring> spring{}; ///< Pushes back from beyond a bound; absent: rigid.
};

/// What drives an axis: with a spring, towards `position` and `velocity`; without one, it holds the velocity.
struct JointMotor {
    float velocity = 0.0f; ///< m/s or rad/s.
    float position = 0.0f; ///< m or rad; only with a spring.
    std::optional<JointSpring> spring{};
    float max_force = std::numeric_limits<float>::infinity(); ///< N or N m, >= 0.
};

/// All that can act along one axis of a joint.
struct JointControl {
    std::optional<JointRange> limits{};
    std::optional<JointMotor> motor{};
    float friction = 0.0f; ///< N or N m, >= 0: dry friction, which holds until it is overcome.
};

/// B keeps its place and rotation against A.
struct FixedJoint {};

/// The origins of the frames coincide; B turns freely.
struct BallJoint {
    std::optional<float> cone_angle{}; ///< rad, 0 to pi: greatest angle between the x axes of the two frames.
    std::optional<JointRange> twist{}; ///< Of the angle about the x axis, -pi to pi.
    float friction = 0.0f;             ///< N m about each axis, >= 0.
};

/// B turns about the x axis of A. Its angle is counted on beyond a full turn while a limit, motor or friction acts on
/// it; without any it is between -pi and pi.
struct HingeJoint {
    JointControl angle{};
};

/// B moves along the x axis of A without turning.
struct SliderJoint {
    JointControl translation{};
};

/// B moves along the x axis of A and turns about it.
struct CylindricalJoint {
    JointControl translation{}, angle{};
};

/// A cross of two axes at a right angle: A turns about its x axis, B about its y axis (a Cardan joint).
struct UniversalJoint {
    JointControl first{}, second{}; ///< About the x axis of A, and about the y axis of B.
};

/// The distance between the origins of the frames. A rod has lower = upper, a rope lower = 0, a spring a motor with a
/// spring at its length at rest.
struct DistanceJoint {
    JointControl distance{};
};

/// A wheel B under a car A. The wheel moves along the x axis of A (the suspension), turns about it (the steering) and
/// spins about its own y axis.
struct WheelJoint {
    JointControl suspension{};
    /// Absent: the wheel does not steer.
    std::optional<JointControl> steering{};
    JointControl spin{};
};

/// A servo that moves B to a place and rotation in the frame of A.
struct ServoJoint {
    Vec3 position{0.0f, 0.0f, 0.0f};       ///< Of the origin of frame B in frame A, meters.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< Of frame B in frame A; normalized.
    JointSpring linear = JointSpring::from_frequency(5.0f, 1.0f);
    JointSpring angular = JointSpring::from_frequency(5.0f, 1.0f);
    float max_force = std::numeric_limits<float>::infinity();  ///< N along each axis, >= 0.
    float max_torque = std::numeric_limits<float>::infinity(); ///< N m about each axis, >= 0.
};

/// Two turning bodies in mesh: (rate of A about its frame's x axis) + ratio x (rate of B about its own) = 0. With teeth
/// in mesh on the outside of both, about parallel axes, ratio = teeth of B / teeth of A. Rates are those against the
/// world: the bodies that carry the axles must not turn about them.
struct GearJoint {
    float ratio = 1.0f; ///< Not 0.
};

/// A pinion A on a rack B: (translation of B along its frame's x axis) = radius x (angle of A about its frame's x
/// axis), as against the world.
struct RackJoint {
    float radius = 0.1f; ///< m, not 0; negative for the other sense.
};

/// A rope over two fixed pulleys: length at A + ratio x length at B <= length.
struct PulleyJoint {
    Position ground_a{0.0, 0.0, 0.0}, ground_b{0.0, 0.0, 0.0}; ///< World points from which the bodies hang.
    float ratio = 1.0f;                                        ///< > 0: of a block and tackle.
    /// m, > 0; absent: what it is when the joint is made, which `World::joint_def` then has.
    std::optional<float> length{};
};

enum class JointAxis : std::uint8_t { linear, angular };

/// Keeps a distance (m) or an angle (rad) between the two frames in a range. With one axis: along or about it; with
/// two: from the line of the remaining axis, or of the cone about it; with three: of points, or any turn.
struct JointLimit {
    JointAxis kind = JointAxis::linear;
    std::array<bool, 3> axes{};     ///< x, y and z of frame A; one to three of them.
    std::optional<float> min, max;  ///< Absent: no bound on that side. min <= max.
    std::optional<float> stiffness; ///< N/m or N m/rad, >= 0; absent: rigid.
    float damping = 0.0f;           ///< N s/m or N m s/rad, >= 0; with a stiffness only.
};

/// A damped spring or motor along or about one axis: pushes with stiffness x (position_target - position) + damping x
/// (velocity_target - velocity).
struct JointDrive {
    JointAxis kind = JointAxis::linear;
    bool is_acceleration = false;   ///< true: the above is an acceleration; false: a force or torque.
    int axis = 0;                   ///< 0, 1 or 2, of frame A.
    std::optional<float> max_force; ///< N or N m, >= 0; absent: no bound.
    float position_target = 0.0f, velocity_target = 0.0f, stiffness = 0.0f, damping = 0.0f;
};

/// The joint of the glTF draft KHR_physics_rigid_bodies: six degrees of freedom, and any of them limited or driven. At
/// most eight limits and drives that are not plain locks.
struct GeneralJoint {
    std::vector<JointLimit> limits{};
    std::vector<JointDrive> drives{};
};

/// Any joint.
using Joint = std::variant<FixedJoint, BallJoint, HingeJoint, SliderJoint, CylindricalJoint, UniversalJoint,
                           DistanceJoint, WheelJoint, ServoJoint, GearJoint, RackJoint, PulleyJoint, GeneralJoint>;

/// How a joint is solved. Both give the same motion; they differ in cost and stiffness.
enum class JointSolver : std::uint8_t {
    /// Direct in chains, machines, robots whose angles servos hold, and under high mass ratios as long as it pays, and
    /// where it hangs together with joints that are asked to be direct; else iterative.
    automatic,
    iterative, ///< 8 joints at a time, one after the other, with the contacts. For nets and heaps of many joints.
    /// All direct joints that hang together at once, with their motors, springs, friction and limits. For chains,
    /// machines, robots, and what must not give at all. Gears, racks and pulleys stay iterative; so do all of a net of
    /// thousands of joints, whose factorization would not end.
    direct,
};

/// Everything needed to make a joint.
struct JointDef {
    BodyId body_a{}, body_b{};      ///< Null: the world. At least one must be dynamic; not the same body.
    Transform frame_a{}, frame_b{}; ///< In the frames of the bodies; of the world, in its own.
    Joint joint = FixedJoint{};
    bool enable_collision = false;                               ///< Whether the two bodies collide with each other.
    float break_force = std::numeric_limits<float>::infinity();  ///< N, > 0: the joint breaks beyond it.
    float break_torque = std::numeric_limits<float>::infinity(); ///< N m, > 0.
    JointSolver solver = JointSolver::automatic;
    std::string name{};          ///< For people; need not be unique.
    std::uint64_t user_data = 0; ///< Not touched by the engine.
    bool enabled = true;         ///< false: it acts on nothing, as if it were not there.
};

/// What a joint did in the last step.
struct JointState {
    Vec3 force{0.0f, 0.0f, 0.0f};  ///< N: mean force on B, world axes.
    Vec3 torque{0.0f, 0.0f, 0.0f}; ///< N m: mean torque on B about the origin of its frame, world axes.
    /// The positions of its axes (m or rad), in the order of the fields of its type: of a hinge the angle, of a
    /// cylindrical joint translation and angle, of a general joint those of its limits and drives that are not plain
    /// locks.
    std::array<float, 8> positions{};
    int position_count = 0;
    float linear_error = 0.0f;  ///< m: how far the points that it holds together are apart.
    float angular_error = 0.0f; ///< rad: how far B has turned about the axes that it locks.
};

} // namespace cairn
