// Jacobians and errors of directly solved rows at the present poses, in double.
#include "joints/direct_sets.h"
#include "joints/direct_view.h"
#include "math/rotation.h"
#include "state/joint_state.h"

namespace cairn {

using math::DVec3;

namespace {

// The arm of a row for velocities and impulses. A body under tension has that of the middle of the substep: with the
// arm at its start, the tension acts half a substep late, and what rotates in that time gains energy. So has a body
// that does not move by forces, whose rotation is known. For other bodies the arm at the start of the substep conserves
// energy, and that of the middle would lose some of it.
DVec3 arm_at_work(const DirectBody& body, DVec3 arm, double h) {
    const bool is_at_start = body.by_forces && !body.is_tense();
    return is_at_start ? arm : math::rotate(math::from_rotation_vector(0.5 * h * body.w), arm);
}

void refresh_point(const JointLocks& rules, DVec3 axis, DVec3 gap, DirectRow& r) {
    r.linear = math::identity_block();
    r.is_plain = rules.point == JointLock::full;
    r.error = gap;
    if (rules.point == JointLock::across) {
        const DVec3 along = math::dot(axis, gap) * axis;
        r.arm_a += along;
        r.error = gap - along;
        r.linear = math::across_block(axis);
        r.impulse = r.linear * r.impulse;
        r.angular[0] = r.linear * math::cross_block(r.arm_a);
        r.angular[1] = -(r.linear * math::cross_block(r.arm_b));
        return;
    }
    r.angular[0] = math::cross_block(r.arm_a);
    r.angular[1] = -math::cross_block(r.arm_b);
}

void refresh_turn(const JointLocks& rules, DVec3 axis_a, DVec3 axis_b, const math::DQuat& turn, DirectRow& r) {
    r.linear = {};
    r.angular[1] = math::identity_block();
    if (rules.turn == JointLock::across) {
        r.angular[1] = math::across_block(axis_a); // for a driven turn see aim_driven_turn
        r.error = math::cross(axis_a, axis_b);
        r.impulse = r.angular[1] * r.impulse;
    } else {
        r.error = (turn.w < 0 ? -2.0 : 2.0) * turn.vector();
    }
    r.angular[0] = -r.angular[1];
}

void refresh_axis(const JointAxisRule& rule, DVec3 axis_a, DVec3 axis_b, DVec3 gap, DirectRow& r) {
    DVec3 u = axis_a;
    double position = 0;
    if (rule.kind == AxisKind::perpendicular) {
        const DVec3 turning = math::cross(axis_b, axis_a);
        r.linear = {};
        r.angular[0] = math::row_block(-turning);
        r.angular[1] = math::row_block(turning);
        r.error = {math::dot(axis_a, axis_b) - r.at, 0, 0};
        return;
    }
    if (rule.kind == AxisKind::distance) {
        position = math::length(gap);
        u = position > 0 ? (1 / position) * gap : DVec3{1, 0, 0};
    } else {
        position = math::dot(axis_a, gap);
        r.arm_a += gap;
    }
    r.linear = math::row_block(u);
    r.angular[0] = math::row_block(-math::cross(r.arm_a, u));
    r.angular[1] = math::row_block(math::cross(r.arm_b, u));
    r.error = {position - r.at, 0, 0};
}

} // namespace

void refresh_row(const Joints& joints, const SetView& v, std::size_t i, double h) {
    const DirectNode& node = v.set.nodes[i];
    DirectRow& r = v.rows[i];
    const JointLocks& rules = joints.info[node.joint].rules;
    const DirectBody &a = v.bodies[node.body[0]], &b = v.bodies[node.body[1]];
    r.arm_a = math::rotate(a.turn, r.arm_a0), r.arm_b = math::rotate(b.turn, r.arm_b0);
    const DVec3 gap = r.gap0 + ((b.center - a.center) + ((r.arm_b - r.arm_b0) - (r.arm_a - r.arm_a0)));
    r.arm_a = arm_at_work(a, r.arm_a, h), r.arm_b = arm_at_work(b, r.arm_b, h);
    const DVec3 axis_a = math::rotate(a.turn, r.axis_a0), axis_b = math::rotate(b.turn, r.axis_b0);
    if (node.rows == DirectRows::point)
        refresh_point(rules, axis_a, gap, r);
    else if (node.rows == DirectRows::turn)
        refresh_turn(rules, axis_a, axis_b, b.turn * r.turn0 * math::conjugate(a.turn), r);
    else if (node.rows == DirectRows::axis && has_direct_lane(joints.axes[node.joint].rules[node.axis].kind))
        r.error = {refresh_from_lane(v, i) - r.at, 0, 0};
    else if (node.rows == DirectRows::axis)
        refresh_axis(joints.axes[node.joint].rules[node.axis], axis_a, axis_b, gap, r);
    if (has_drive(node)) refresh_drive(v, i, h);
    if (node.is_driven) {
        r.axis = axis_a;
        aim_driven_turn(r);
    }
}

} // namespace cairn
