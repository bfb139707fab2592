// Properties of joints and of their axes.
#include "sweep/properties.h"

#include <array>
#include <cmath>
#include <vector>

namespace cairn::sweep {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct NamedAxis {
    std::string_view name;
    JointControl* control;
};

// Returns the axes in the order of `JointState::positions`.
std::vector<NamedAxis> axes_of(Joint& joint) {
    if (auto* j = std::get_if<HingeJoint>(&joint)) return {{"angle", &j->angle}};
    if (auto* j = std::get_if<SliderJoint>(&joint)) return {{"translation", &j->translation}};
    if (auto* j = std::get_if<DistanceJoint>(&joint)) return {{"distance", &j->distance}};
    if (auto* j = std::get_if<CylindricalJoint>(&joint)) {
        return {{"translation", &j->translation}, {"angle", &j->angle}};
    }
    if (auto* j = std::get_if<UniversalJoint>(&joint)) return {{"first", &j->first}, {"second", &j->second}};
    if (auto* j = std::get_if<WheelJoint>(&joint)) {
        std::vector<NamedAxis> axes{{"suspension", &j->suspension}};
        if (j->steering) axes.push_back({"steering", &*j->steering});
        axes.push_back({"spin", &j->spin});
        return axes;
    }
    return {};
}

JointControl& require_control(Joint& joint, std::size_t axis) {
    if (JointControl* control = control_of(joint, axis)) return *control;
    throw Error(
        ErrorCode::invalid_value, "joint", {},
        "must be a hinge, slider, cylindrical, universal, distance or wheel joint, which have limits and motors "
        "by name");
}

JointMotor& motor_of(Joint& joint, std::size_t axis) {
    JointControl& control = require_control(joint, axis);
    if (!control.motor) control.motor.emplace();
    return *control.motor;
}
JointRange& limits_of(Joint& joint, std::size_t axis) {
    JointControl& control = require_control(joint, axis);
    constexpr float infinite = std::numeric_limits<float>::infinity();
    if (!control.limits) control.limits = JointRange{-infinite, infinite, {}};
    return *control.limits;
}
JointSpring& spring_of(Joint& joint, std::size_t axis) {
    JointMotor& motor = motor_of(joint, axis);
    if (!motor.spring) motor.spring.emplace();
    return *motor.spring;
}

// A float of a joint's axis. It is read from a copy of the joint, in which absent parts get their defaults.
template <float& (*member)(Joint&, std::size_t)> constexpr Property of_axis(std::string_view name) {
    return {name, "",
            [](const Trial& t, const Subject& s, double* out) {
                if (!t.world.is_valid(s.joint)) {
                    *out = nothing;
                    return;
                }
                Joint joint = t.world.joint_def(s.joint).joint;
                *out = static_cast<double>(member(joint, s.axis));
            },
            [](Changes& c, const Subject& s, const double* v) {
                member(c.joint_of(s.joint), s.axis) = static_cast<float>(*v);
            }};
}

float& lower(Joint& j, std::size_t axis) { return limits_of(j, axis).lower; }
float& upper(Joint& j, std::size_t axis) { return limits_of(j, axis).upper; }
float& motor_velocity(Joint& j, std::size_t axis) { return motor_of(j, axis).velocity; }
float& motor_position(Joint& j, std::size_t axis) { return motor_of(j, axis).position; }
float& motor_max_force(Joint& j, std::size_t axis) { return motor_of(j, axis).max_force; }
float& motor_stiffness(Joint& j, std::size_t axis) { return spring_of(j, axis).stiffness; }
float& motor_damping(Joint& j, std::size_t axis) { return spring_of(j, axis).damping; }
float& joint_friction(Joint& j, std::size_t axis) {
    if (auto* ball = std::get_if<BallJoint>(&j)) return ball->friction;
    return require_control(j, axis).friction;
}

template <float JointDef::*member, bool is_force> constexpr Property strength(std::string_view name) {
    return {name, "",
            [](const Trial& t, const Subject& s, double* out) {
                *out = t.world.is_valid(s.joint) ? static_cast<double>(t.world.joint_def(s.joint).*member) : nothing;
            },
            [](Changes& c, const Subject& s, const double* v) {
                const JointDef& def = c.trial.world.joint_def(s.joint);
                const float value = static_cast<float>(*v);
                c.trial.world.set_joint_strength(s.joint, is_force ? value : def.break_force,
                                                 is_force ? def.break_torque : value);
            }};
}

// Returns NaN for a broken joint.
template <Vec3 JointState::*member> void read_load(const Trial& trial, const Subject& subject, double* out) {
    out[0] = out[1] = out[2] = nothing;
    if (!trial.world.is_valid(subject.joint)) return;
    const Vec3 v = trial.world.joint_state(subject.joint).*member;
    out[0] = static_cast<double>(v.x), out[1] = static_cast<double>(v.y), out[2] = static_cast<double>(v.z);
}
template <Vec3 JointState::*member> void read_size(const Trial& trial, const Subject& subject, double* out) {
    double v[3];
    read_load<member>(trial, subject, v);
    *out = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

constexpr std::array of_joint{
    of_axis<lower>("lower"),
    of_axis<upper>("upper"),
    of_axis<motor_velocity>("motor_velocity"),
    of_axis<motor_position>("motor_position"),
    of_axis<motor_max_force>("motor_max_force"),
    of_axis<motor_stiffness>("motor_stiffness"),
    of_axis<motor_damping>("motor_damping"),
    of_axis<joint_friction>("friction"),
    strength<&JointDef::break_force, true>("break_force"),
    strength<&JointDef::break_torque, false>("break_torque"),
    Property{"enabled", "",
             [](const Trial& t, const Subject& s, double* out) {
                 *out = t.world.is_valid(s.joint) ? static_cast<double>(t.world.joint_def(s.joint).enabled) : nothing;
             },
             [](Changes& c, const Subject& s, const double* v) {
                 if (*v != 0.0 && *v != 1.0)
                     throw Error(ErrorCode::invalid_value, "enabled", std::to_string(*v), "must be 0 or 1");
                 c.trial.world.set_joint_enabled(s.joint, *v != 0.0);
             }},
    Property{"position", "",
             [](const Trial& t, const Subject& s, double* out) {
                 *out = nothing;
                 if (t.world.is_valid(s.joint)) {
                     *out = static_cast<double>(t.world.joint_state(s.joint).positions[s.axis]);
                 }
             }},
    Property{"force", "xyz", read_load<&JointState::force>},
    Property{"torque", "xyz", read_load<&JointState::torque>},
    Property{"load", "", read_size<&JointState::force>},
    Property{"torque_load", "", read_size<&JointState::torque>},
    Property{"linear_error", "",
             [](const Trial& t, const Subject& s, double* out) {
                 *out = nothing;
                 if (t.world.is_valid(s.joint)) *out = static_cast<double>(t.world.joint_state(s.joint).linear_error);
             }},
    Property{"broken", "",
             [](const Trial& t, const Subject& s, double* out) { *out = t.world.is_valid(s.joint) ? 0.0 : 1.0; }},
};

} // namespace

Joint& Changes::joint_of(JointId id) {
    if (id != id_) {
        finish();
        joint_ = trial.world.joint_def(id).joint;
        id_ = id;
    }
    return joint_;
}

void Changes::finish() {
    if (!id_.is_null()) trial.world.set_joint(id_, joint_);
    id_ = {};
}

std::span<const Property> joint_properties() { return of_joint; }

JointControl* control_of(Joint& joint, std::size_t axis) {
    const std::vector<NamedAxis> axes = axes_of(joint);
    return axis < axes.size() ? axes[axis].control : nullptr;
}

std::optional<std::size_t> axis_of(const Joint& joint, std::string_view name) {
    Joint copy = joint;
    const std::vector<NamedAxis> axes = axes_of(copy);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (axes[i].name == name) return i;
    }
    return std::nullopt;
}

} // namespace cairn::sweep
