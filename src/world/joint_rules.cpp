#include "world/joint_rules.h"

#include "world/validate.h"

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

constexpr float pi = 3.14159265358979f;

// Adds constraint rows to the rules of one joint.
class Builder {
  public:
    JointRules rules;

    JointAxisRule& add(AxisKind kind, int column_a = 0, int column_b = 0) {
        JointAxisRule& rule = rules.axes[rules.locks.axis_count++];
        rule = {};
        rule.kind = kind;
        rule.column_a = std::uint8_t(column_a);
        rule.column_b = std::uint8_t(column_b);
        return rule;
    }
    void hold_point() { rules.locks.point = JointLock::full; }
    void hold_point_across(int column) {
        rules.locks.point = JointLock::across;
        rules.locks.point_column = std::uint8_t(column);
    }
    void hold_turn() { rules.locks.turn = JointLock::full; }
    void hold_turn_across(int column) {
        rules.locks.turn = JointLock::across;
        rules.locks.turn_column = std::uint8_t(column);
    }
    void lock(AxisKind kind, int column_a, int column_b, float at = 0) {
        JointAxisRule& rule = add(kind, column_a, column_b);
        set_range(rule, {at, at, {}});
        rule.is_lock = 1;
    }

    static void set_range(JointAxisRule& rule, const JointRange& range) {
        rule.has_limits = 1;
        rule.lower = std::max(range.lower, -unlimited);
        rule.upper = std::min(range.upper, unlimited);
        rule.is_equation = rule.lower == rule.upper;
        if (!range.spring) return;
        rule.rigid_limit = 0;
        rule.limit_stiffness = range.spring->stiffness;
        rule.limit_damping = range.spring->damping;
        rule.limit_relative = range.spring->is_acceleration;
    }
    static void set_spring(JointAxisRule& rule, const JointSpring& spring, float max_force) {
        rule.has_drive = 1;
        rule.max_drive = std::min(max_force, unlimited);
        rule.drive_stiffness = spring.stiffness;
        rule.drive_damping = spring.damping;
        rule.drive_relative = spring.is_acceleration;
    }
    static void set_motor(JointAxisRule& rule, const JointMotor& motor) {
        rule.has_drive = 1;
        rule.max_drive = std::min(motor.max_force, unlimited);
        rule.target_velocity = motor.velocity;
        rule.target_position = motor.position;
        rule.rigid_drive = !motor.spring;
        if (motor.spring) set_spring(rule, *motor.spring, motor.max_force);
    }
    void control(AxisKind kind, int column_a, int column_b, const JointControl& control) {
        JointAxisRule& rule = add(kind, column_a, column_b);
        if (control.limits) set_range(rule, *control.limits);
        if (control.motor) set_motor(rule, *control.motor);
        rule.friction = control.friction;
    }
};

void build(Builder& b, const FixedJoint&, float) {
    b.hold_point();
    b.hold_turn();
}
void build(Builder& b, const BallJoint& j, float) {
    b.hold_point();
    if (j.cone_angle) Builder::set_range(b.add(AxisKind::swing), {-unlimited, *j.cone_angle, {}});
    if (j.twist) Builder::set_range(b.add(AxisKind::twist), *j.twist);
    if (!(j.friction > 0)) return;
    for (int i = 0; i < 3; ++i) {
        JointAxisRule& rule = b.add(AxisKind::rotation, i, i);
        rule.friction = j.friction;
        rule.is_lock = 1;
    }
}
void build(Builder& b, const HingeJoint& j, float) {
    b.hold_point();
    b.hold_turn_across(0);
    b.control(AxisKind::twist, 0, 0, j.angle);
}
void build(Builder& b, const SliderJoint& j, float) {
    b.hold_point_across(0);
    b.hold_turn();
    b.control(AxisKind::linear, 0, 0, j.translation);
}
void build(Builder& b, const CylindricalJoint& j, float) {
    b.hold_point_across(0);
    b.hold_turn_across(0);
    b.control(AxisKind::linear, 0, 0, j.translation);
    b.control(AxisKind::twist, 0, 0, j.angle);
}
void build(Builder& b, const UniversalJoint& j, float) {
    b.hold_point();
    b.lock(AxisKind::perpendicular, 0, 1);
    b.control(AxisKind::cross_a, 0, 1, j.first);
    b.control(AxisKind::cross_b, 0, 1, j.second);
}
void build(Builder& b, const DistanceJoint& j, float) { b.control(AxisKind::distance, 0, 0, j.distance); }
void build(Builder& b, const WheelJoint& j, float) {
    b.hold_point_across(0);
    b.control(AxisKind::linear, 0, 0, j.suspension);
    if (j.steering) {
        b.lock(AxisKind::perpendicular, 0, 1);
        b.control(AxisKind::cross_a, 0, 1, *j.steering);
        b.control(AxisKind::cross_b, 0, 1, j.spin);
    } else {
        b.hold_turn_across(1);
        b.control(AxisKind::twist, 1, 1, j.spin);
    }
}
void build(Builder& b, const ServoJoint& j, float) {
    // The target pose is folded into frame A (fill_frames in joints.cpp).
    for (int i = 0; i < 3; ++i) Builder::set_spring(b.add(AxisKind::linear, i, i), j.linear, j.max_force);
    for (int i = 0; i < 3; ++i) Builder::set_spring(b.add(AxisKind::rotation, i, i), j.angular, j.max_torque);
}
void build(Builder& b, const GearJoint& j, float) {
    b.lock(AxisKind::gear, 0, 0);
    b.rules.axes[0].ratio_b = j.ratio;
}
void build(Builder& b, const RackJoint& j, float) {
    b.lock(AxisKind::rack, 0, 0);
    b.rules.axes[0].ratio_a = j.radius;
    b.rules.axes[0].ratio_b = -1;
}
void build(Builder& b, const PulleyJoint& j, float length) {
    JointAxisRule& rule = b.add(AxisKind::pulley);
    rule.ratio_b = j.ratio;
    Builder::set_range(rule, {-unlimited, j.length.value_or(length), {}});
}

int count_of(const std::array<bool, 3>& axes) { return int(axes[0]) + int(axes[1]) + int(axes[2]); }
int first_of(const std::array<bool, 3>& axes) { return axes[0] ? 0 : axes[1] ? 1 : 2; }
int missing_of(const std::array<bool, 3>& axes) { return !axes[0] ? 0 : !axes[1] ? 1 : 2; }

// Whether the limit locks its axes at zero, where the frames coincide.
bool is_plain_lock(const JointLimit& limit) {
    return !limit.stiffness && limit.min && limit.max && *limit.min == 0 && *limit.max == 0;
}

struct Locks {
    std::array<bool, 3> linear{}, angular{};
};
Locks plain_locks(const GeneralJoint& j) {
    Locks locks;
    for (const JointLimit& limit : j.limits)
        if (is_plain_lock(limit))
            for (std::size_t i = 0; i < 3; ++i)
                if (limit.axes[i]) (limit.kind == JointAxis::linear ? locks.linear : locks.angular)[i] = true;
    return locks;
}

AxisKind kind_of(const JointLimit& limit) {
    constexpr AxisKind linear[] = {AxisKind::linear, AxisKind::radial, AxisKind::distance};
    constexpr AxisKind angular[] = {AxisKind::twist, AxisKind::swing, AxisKind::turn};
    const int n = count_of(limit.axes) - 1;
    return limit.kind == JointAxis::linear ? linear[n] : angular[n];
}
int column_of(const JointLimit& limit) {
    return count_of(limit.axes) == 2 ? missing_of(limit.axes) : first_of(limit.axes);
}

JointAxisRule& row_for(Builder& b, AxisKind kind, int column) {
    for (int i = 0; i < b.rules.locks.axis_count; ++i) {
        JointAxisRule& rule = b.rules.axes[i];
        if (rule.kind == kind && rule.column_a == column && !rule.is_lock && !rule.has_drive) return rule;
    }
    return b.add(kind, column, column);
}

void hold_locks(Builder& b, const Locks& locks) {
    switch (count_of(locks.linear)) {
    case 3:
        b.hold_point();
        break;
    case 2:
        b.hold_point_across(missing_of(locks.linear));
        break;
    case 1:
        b.lock(AxisKind::linear, first_of(locks.linear), first_of(locks.linear));
        break;
    }
    switch (count_of(locks.angular)) {
    case 3:
        b.hold_turn();
        break;
    case 2:
        b.hold_turn_across(missing_of(locks.angular));
        break;
    case 1:
        b.lock(AxisKind::twist, first_of(locks.angular), first_of(locks.angular));
        break;
    }
}

void build(Builder& b, const GeneralJoint& j, float) {
    const Locks locks = plain_locks(j);
    hold_locks(b, locks);
    for (const JointLimit& limit : j.limits) {
        if (is_plain_lock(limit)) continue;
        const float infinite = std::numeric_limits<float>::infinity();
        JointRange range{limit.min.value_or(-infinite), limit.max.value_or(infinite), {}};
        if (limit.stiffness) range.spring = JointSpring{*limit.stiffness, limit.damping, false};
        const int column = column_of(limit);
        Builder::set_range(b.add(kind_of(limit), column, column), range);
    }
    // The angle about a single free axis is counted beyond full turns; among several free axes it is a component of the
    // rotation vector.
    const AxisKind angular = count_of(locks.angular) == 2 ? AxisKind::twist : AxisKind::rotation;
    for (const JointDrive& drive : j.drives) {
        JointAxisRule& rule = row_for(b, drive.kind == JointAxis::linear ? AxisKind::linear : angular, drive.axis);
        Builder::set_spring(rule, {drive.stiffness, drive.damping, drive.is_acceleration},
                            drive.max_force.value_or(std::numeric_limits<float>::infinity()));
        rule.target_position = drive.position_target;
        rule.target_velocity = drive.velocity_target;
    }
}

// --- Checks.

using Field = const std::string&;

void check(Field field, const JointSpring& spring) {
    require_at_least(field + ".stiffness", spring.stiffness, 0);
    require_at_least(field + ".damping", spring.damping, 0);
}
void require_cap(Field field, float value) {
    if (!(value >= 0)) refuse(field, to_text(double(value)), "must be >= 0, or infinite");
}
std::string range_text(const JointRange& range) {
    std::string text = to_text(double(range.lower));
    return text.append(" to ").append(to_text(double(range.upper)));
}
void check(Field field, const JointRange& range, float least, float most) {
    if (!(range.lower <= range.upper)) refuse(field, range_text(range), "must have lower <= upper");
    const bool bounded = range.lower >= least && range.upper <= most;
    if (!bounded || range.lower == std::numeric_limits<float>::infinity() ||
        range.upper == -std::numeric_limits<float>::infinity())
        refuse(field, range_text(range), std::string("must be from ").append(range_text(JointRange{least, most, {}})));
    if (range.spring) check(field + ".spring", *range.spring);
}
constexpr float unbounded = std::numeric_limits<float>::infinity();

void check(Field field, const JointControl& control, float least = -unbounded) {
    if (control.limits) check(field + ".limits", *control.limits, least, unbounded);
    if (control.motor) {
        const JointMotor& motor = *control.motor;
        require_finite(field + ".motor.velocity", double(motor.velocity));
        require_finite(field + ".motor.position", double(motor.position));
        require_cap(field + ".motor.max_force", motor.max_force);
        if (motor.spring) check(field + ".motor.spring", *motor.spring);
    }
    require_at_least(field + ".friction", double(control.friction), 0);
}
void require_not_zero(Field field, float value) {
    require_finite(field, double(value));
    if (value == 0) refuse(field, "0", "must not be 0");
}

void check(const FixedJoint&) {}
void check(const BallJoint& j) {
    if (j.cone_angle && !(*j.cone_angle >= 0 && *j.cone_angle <= pi))
        refuse("BallJoint.cone_angle", to_text(double(*j.cone_angle)), "must be an angle from 0 to pi");
    if (j.twist) check("BallJoint.twist", *j.twist, -unbounded, unbounded);
    require_at_least("BallJoint.friction", double(j.friction), 0);
}
void check(const HingeJoint& j) { check("HingeJoint.angle", j.angle); }
void check(const SliderJoint& j) { check("SliderJoint.translation", j.translation); }
void check(const CylindricalJoint& j) {
    check("CylindricalJoint.translation", j.translation);
    check("CylindricalJoint.angle", j.angle);
}
void check(const UniversalJoint& j) {
    check("UniversalJoint.first", j.first);
    check("UniversalJoint.second", j.second);
}
void check(const DistanceJoint& j) {
    check("DistanceJoint.distance", j.distance);
    if (j.distance.limits && !(j.distance.limits->upper >= 0))
        refuse("DistanceJoint.distance.limits.upper", to_text(double(j.distance.limits->upper)), "must be >= 0");
}
void check(const WheelJoint& j) {
    check("WheelJoint.suspension", j.suspension);
    if (j.steering) check("WheelJoint.steering", *j.steering);
    check("WheelJoint.spin", j.spin);
}
void check(const ServoJoint& j) {
    require_finite("ServoJoint.position", j.position);
    checked_rotation("ServoJoint.rotation", j.rotation);
    check("ServoJoint.linear", j.linear);
    check("ServoJoint.angular", j.angular);
    require_cap("ServoJoint.max_force", j.max_force);
    require_cap("ServoJoint.max_torque", j.max_torque);
}
void check(const GearJoint& j) { require_not_zero("GearJoint.ratio", j.ratio); }
void check(const RackJoint& j) { require_not_zero("RackJoint.radius", j.radius); }
void check(const PulleyJoint& j) {
    require_position("PulleyJoint.ground_a", j.ground_a);
    require_position("PulleyJoint.ground_b", j.ground_b);
    require_above("PulleyJoint.ratio", double(j.ratio), 0);
    if (j.length) require_above("PulleyJoint.length", double(*j.length), 0);
}
std::string element(const char* list, std::size_t i) {
    return std::string(list).append("[").append(std::to_string(i)).append("]");
}

void check(const GeneralJoint& j) {
    for (std::size_t i = 0; i < j.limits.size(); ++i) {
        const JointLimit& limit = j.limits[i];
        const std::string field = element("GeneralJoint.limits", i);
        if (limit.kind > JointAxis::angular)
            refuse(field + ".kind", std::to_string(int(limit.kind)), "must be one of the enumerators");
        if (count_of(limit.axes) == 0) refuse(field + ".axes", "none", "must be 1 to 3 axes");
        check(field, JointRange{limit.min.value_or(-unbounded), limit.max.value_or(unbounded), {}}, -unbounded,
              unbounded);
        if (limit.stiffness) require_at_least(field + ".stiffness", double(*limit.stiffness), 0);
        require_at_least(field + ".damping", double(limit.damping), 0);
    }
    for (std::size_t i = 0; i < j.drives.size(); ++i) {
        const JointDrive& drive = j.drives[i];
        const std::string field = element("GeneralJoint.drives", i);
        if (drive.kind > JointAxis::angular)
            refuse(field + ".kind", std::to_string(int(drive.kind)), "must be one of the enumerators");
        if (drive.axis < 0 || drive.axis > 2) refuse(field + ".axis", std::to_string(drive.axis), "must be 0, 1 or 2");
        if (drive.max_force) require_cap(field + ".max_force", *drive.max_force);
        require_finite(field + ".position_target", double(drive.position_target));
        require_finite(field + ".velocity_target", double(drive.velocity_target));
        require_at_least(field + ".stiffness", double(drive.stiffness), 0);
        require_at_least(field + ".damping", double(drive.damping), 0);
    }
    const Locks locks = plain_locks(j);
    std::size_t rows = j.drives.size() + (count_of(locks.linear) == 1) + (count_of(locks.angular) == 1);
    for (const JointLimit& limit : j.limits) rows += !is_plain_lock(limit);
    if (rows > std::size_t(max_joint_axes))
        refuse("GeneralJoint", std::to_string(rows), "must have at most 8 limits and drives that are not plain locks");
}

} // namespace

void validate(const Joint& joint) {
    std::visit([](const auto& j) { check(j); }, joint);
}

void validate(const JointDef& def) {
    require_position("JointDef.frame_a.position", def.frame_a.position);
    require_position("JointDef.frame_b.position", def.frame_b.position);
    checked_rotation("JointDef.frame_a.rotation", def.frame_a.rotation);
    checked_rotation("JointDef.frame_b.rotation", def.frame_b.rotation);
    if (!(def.break_force > 0)) refuse("JointDef.break_force", to_text(double(def.break_force)), "must be > 0");
    if (!(def.break_torque > 0)) refuse("JointDef.break_torque", to_text(double(def.break_torque)), "must be > 0");
    if (def.solver > JointSolver::direct)
        refuse("JointDef.solver", std::to_string(int(def.solver)), "must be one of the enumerators");
    validate(def.joint);
}

JointRules make_rules(const Joint& joint, float pulley_length) {
    Builder builder;
    std::visit([&](const auto& j) { build(builder, j, pulley_length); }, joint);
    return builder.rules;
}

} // namespace cairn
