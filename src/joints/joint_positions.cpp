// Positions of a joint's axes, computed outside of a step.
#include "joints/joint_positions.h"

#include "joints/joint_placement.h"
#include "math/rotation.h"

namespace cairn {

using math::DQuat;
using math::DVec3;

namespace {

// The angle of (x, y), -pi to pi.
double angle_of(double y, double x) {
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0)) return 0;
    // Twice the angle of (x + length, y); where that vector vanishes, the angle is pi.
    if (x < 0 && std::fabs(y) < 1e-12 * length) return 3.14159265358979323846;
    return math::to_rotation_vector(math::normalized(DQuat{y, 0, 0, x + length})).x;
}

// Adds whole turns to an angle, so that it is nearest to the last known one.
double counted_angle(double angle, double last) {
    constexpr double whole = 2 * 3.14159265358979323846;
    return angle + whole * std::floor((last - angle) / whole + 0.5);
}

double turning_position(const JointAxisRule& rule, const DQuat& turn, DVec3 a, DVec3 b, double last) {
    const DVec3 rotation = math::to_rotation_vector(turn);
    switch (rule.kind) {
    case AxisKind::twist:
        return counted_angle(2 * angle_of(math::dot(turn.vector(), a), turn.w), last);
    case AxisKind::cross_a: {
        const DVec3 u = math::rotate_back(turn, b);
        return counted_angle(angle_of(math::dot(a, math::cross(u, b)), math::dot(u, b)), last);
    }
    case AxisKind::cross_b: {
        const DVec3 u = math::rotate(turn, a);
        return counted_angle(angle_of(math::dot(b, math::cross(a, u)), math::dot(a, u)), last);
    }
    case AxisKind::swing:
        return angle_of(math::length(math::cross(a, b)), math::dot(a, b));
    case AxisKind::turn:
        return math::length(rotation);
    case AxisKind::rotation:
        return math::dot(rotation, a);
    case AxisKind::perpendicular:
        return math::dot(a, b);
    default:
        return last; // for gears and racks, accumulated from step to step
    }
}

double axis_position(const Bodies& bodies, const Joints& joints, std::uint32_t index, int i, const JointPlacement& p) {
    const JointInfo& joint = joints.info[index];
    const JointAxisRule& rule = joints.axes[index].rules[i];
    const DVec3 a = math::to_double(frame_axis(p.frame_a, rule.column_a)),
                b = math::to_double(frame_axis(p.frame_b, rule.column_b));
    switch (rule.kind) {
    case AxisKind::linear:
        return math::dot(a, p.gap);
    case AxisKind::radial:
        return math::length(p.gap - math::dot(a, p.gap) * a);
    case AxisKind::distance:
        return math::length(p.gap);
    case AxisKind::pulley: {
        const double length_a = math::length(math::to_double(pulley_reach(bodies, joint, 0, p)));
        const double length_b = math::length(math::to_double(pulley_reach(bodies, joint, 1, p)));
        return double(rule.ratio_a) * length_a + double(rule.ratio_b) * length_b;
    }
    default:
        return turning_position(rule, turn_of(p), a, b, double(joints.axes[index].states[i].position));
    }
}

} // namespace

JointPlacement place_joint(const Bodies& bodies, const JointInfo& joint) {
    JointPlacement p{place_anchors(bodies, joint), {}, {}};
    auto turned = [&](std::int32_t body, const DQuat& frame) {
        return body == none ? frame : bodies.motion[body].q * frame;
    };
    p.frame_a = turned(joint.body_a, joint.frame_a);
    p.frame_b = turned(joint.body_b, joint.frame_b);
    return p;
}

math::Vec3 pulley_reach(const Bodies& bodies, const JointInfo& joint, int side, const JointPlacement& p) {
    const std::int32_t body = side == 0 ? joint.body_a : joint.body_b;
    const DVec3 ground = side == 0 ? joint.ground_a : joint.ground_b;
    if (body == none) return math::to_float((side == 0 ? joint.anchor_a : joint.anchor_b) - ground);
    return math::to_float((bodies.motion[body].x - ground) + (side == 0 ? p.arm_a : p.arm_b));
}

JointPositions joint_positions(const Bodies& bodies, const Joints& joints, std::uint32_t index) {
    const JointInfo& joint = joints.info[index];
    const JointPlacement p = place_joint(bodies, joint);
    JointPositions r{};
    for (int i = 0; i < joint.rules.axis_count; ++i) r.axes[i] = float(axis_position(bodies, joints, index, i, p));
    if (joint.rules.point != JointLock::none) {
        const DVec3 a = math::to_double(frame_axis(p.frame_a, joint.rules.point_column));
        r.gap = math::to_float(joint.rules.point == JointLock::full ? p.gap : p.gap - math::dot(a, p.gap) * a);
    }
    const int column = joint.rules.turn_column;
    if (joint.rules.turn == JointLock::full) r.turn = math::to_float(math::to_rotation_vector(turn_of(p)));
    if (joint.rules.turn == JointLock::across)
        r.turn = math::cross(frame_axis(p.frame_a, column), frame_axis(p.frame_b, column));
    return r;
}

} // namespace cairn
