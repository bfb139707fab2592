// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"

#include <string>

namespace cairn::c_api {

JointAxis to_joint_axis(cairn_joint_axis value, const char* field) {
    if (value < 0 || value > 1)
        throw Error(ErrorCode::invalid_value, field, std::to_string(value), "must be 0 to 1 (linear, angular)");
    return JointAxis(value);
}

JointSolver to_joint_solver(cairn_joint_solver value, const char* field) {
    if (value < 0 || value > 2)
        throw Error(ErrorCode::invalid_value, field, std::to_string(value),
            "must be 0 to 2 (automatic, iterative, direct)");
    return JointSolver(value);
}

JointSpring to_cpp(const cairn_joint_spring& c) {
    JointSpring x;
    x.stiffness = c.stiffness;
    x.damping = c.damping;
    x.is_acceleration = c.is_acceleration;
    return x;
}
cairn_joint_spring to_c(const JointSpring& x) {
    cairn_joint_spring c{};
    c.stiffness = x.stiffness;
    c.damping = x.damping;
    c.is_acceleration = x.is_acceleration;
    return c;
}

JointRange to_cpp(const cairn_joint_range& c) {
    JointRange x;
    x.lower = c.lower;
    x.upper = c.upper;
    if (c.has_spring) x.spring = to_cpp(c.spring);
    return x;
}
cairn_joint_range to_c(const JointRange& x) {
    cairn_joint_range c{};
    c.lower = x.lower;
    c.upper = x.upper;
    c.has_spring = x.spring.has_value();
    if (x.spring) c.spring = to_c(*x.spring);
    return c;
}

JointMotor to_cpp(const cairn_joint_motor& c) {
    JointMotor x;
    x.velocity = c.velocity;
    x.position = c.position;
    if (c.has_spring) x.spring = to_cpp(c.spring);
    x.max_force = c.max_force;
    return x;
}
cairn_joint_motor to_c(const JointMotor& x) {
    cairn_joint_motor c{};
    c.velocity = x.velocity;
    c.position = x.position;
    c.has_spring = x.spring.has_value();
    if (x.spring) c.spring = to_c(*x.spring);
    c.max_force = x.max_force;
    return c;
}

JointControl to_cpp(const cairn_joint_control& c) {
    JointControl x;
    if (c.has_limits) x.limits = to_cpp(c.limits);
    if (c.has_motor) x.motor = to_cpp(c.motor);
    x.friction = c.friction;
    return x;
}
cairn_joint_control to_c(const JointControl& x) {
    cairn_joint_control c{};
    c.has_limits = x.limits.has_value();
    if (x.limits) c.limits = to_c(*x.limits);
    c.has_motor = x.motor.has_value();
    if (x.motor) c.motor = to_c(*x.motor);
    c.friction = x.friction;
    return c;
}

FixedJoint to_cpp([[maybe_unused]] const cairn_fixed_joint& c) {
    FixedJoint x;
    return x;
}
cairn_fixed_joint to_c([[maybe_unused]] const FixedJoint& x) {
    cairn_fixed_joint c{};
    return c;
}

BallJoint to_cpp(const cairn_ball_joint& c) {
    BallJoint x;
    if (c.has_cone_angle) x.cone_angle = c.cone_angle;
    if (c.has_twist) x.twist = to_cpp(c.twist);
    x.friction = c.friction;
    return x;
}
cairn_ball_joint to_c(const BallJoint& x) {
    cairn_ball_joint c{};
    c.has_cone_angle = x.cone_angle.has_value();
    if (x.cone_angle) c.cone_angle = *x.cone_angle;
    c.has_twist = x.twist.has_value();
    if (x.twist) c.twist = to_c(*x.twist);
    c.friction = x.friction;
    return c;
}

HingeJoint to_cpp(const cairn_hinge_joint& c) {
    HingeJoint x;
    x.angle = to_cpp(c.angle);
    return x;
}
cairn_hinge_joint to_c(const HingeJoint& x) {
    cairn_hinge_joint c{};
    c.angle = to_c(x.angle);
    return c;
}

SliderJoint to_cpp(const cairn_slider_joint& c) {
    SliderJoint x;
    x.translation = to_cpp(c.translation);
    return x;
}
cairn_slider_joint to_c(const SliderJoint& x) {
    cairn_slider_joint c{};
    c.translation = to_c(x.translation);
    return c;
}

CylindricalJoint to_cpp(const cairn_cylindrical_joint& c) {
    CylindricalJoint x;
    x.translation = to_cpp(c.translation);
    x.angle = to_cpp(c.angle);
    return x;
}
cairn_cylindrical_joint to_c(const CylindricalJoint& x) {
    cairn_cylindrical_joint c{};
    c.translation = to_c(x.translation);
    c.angle = to_c(x.angle);
    return c;
}

UniversalJoint to_cpp(const cairn_universal_joint& c) {
    UniversalJoint x;
    x.first = to_cpp(c.first);
    x.second = to_cpp(c.second);
    return x;
}
cairn_universal_joint to_c(const UniversalJoint& x) {
    cairn_universal_joint c{};
    c.first = to_c(x.first);
    c.second = to_c(x.second);
    return c;
}

DistanceJoint to_cpp(const cairn_distance_joint& c) {
    DistanceJoint x;
    x.distance = to_cpp(c.distance);
    return x;
}
cairn_distance_joint to_c(const DistanceJoint& x) {
    cairn_distance_joint c{};
    c.distance = to_c(x.distance);
    return c;
}

WheelJoint to_cpp(const cairn_wheel_joint& c) {
    WheelJoint x;
    x.suspension = to_cpp(c.suspension);
    if (c.has_steering) x.steering = to_cpp(c.steering);
    x.spin = to_cpp(c.spin);
    return x;
}
cairn_wheel_joint to_c(const WheelJoint& x) {
    cairn_wheel_joint c{};
    c.suspension = to_c(x.suspension);
    c.has_steering = x.steering.has_value();
    if (x.steering) c.steering = to_c(*x.steering);
    c.spin = to_c(x.spin);
    return c;
}

ServoJoint to_cpp(const cairn_servo_joint& c) {
    ServoJoint x;
    x.position = to_cpp(c.position);
    x.rotation = to_cpp(c.rotation);
    x.linear = to_cpp(c.linear);
    x.angular = to_cpp(c.angular);
    x.max_force = c.max_force;
    x.max_torque = c.max_torque;
    return x;
}
cairn_servo_joint to_c(const ServoJoint& x) {
    cairn_servo_joint c{};
    c.position = to_c(x.position);
    c.rotation = to_c(x.rotation);
    c.linear = to_c(x.linear);
    c.angular = to_c(x.angular);
    c.max_force = x.max_force;
    c.max_torque = x.max_torque;
    return c;
}

GearJoint to_cpp(const cairn_gear_joint& c) {
    GearJoint x;
    x.ratio = c.ratio;
    return x;
}
cairn_gear_joint to_c(const GearJoint& x) {
    cairn_gear_joint c{};
    c.ratio = x.ratio;
    return c;
}

RackJoint to_cpp(const cairn_rack_joint& c) {
    RackJoint x;
    x.radius = c.radius;
    return x;
}
cairn_rack_joint to_c(const RackJoint& x) {
    cairn_rack_joint c{};
    c.radius = x.radius;
    return c;
}

PulleyJoint to_cpp(const cairn_pulley_joint& c) {
    PulleyJoint x;
    x.ground_a = to_cpp(c.ground_a);
    x.ground_b = to_cpp(c.ground_b);
    x.ratio = c.ratio;
    if (c.has_length) x.length = c.length;
    return x;
}
cairn_pulley_joint to_c(const PulleyJoint& x) {
    cairn_pulley_joint c{};
    c.ground_a = to_c(x.ground_a);
    c.ground_b = to_c(x.ground_b);
    c.ratio = x.ratio;
    c.has_length = x.length.has_value();
    if (x.length) c.length = *x.length;
    return c;
}

JointLimit to_cpp(const cairn_joint_limit& c) {
    JointLimit x;
    x.kind = to_joint_axis(c.kind, "JointLimit.kind");
    for (std::size_t i = 0; i < 3; ++i) x.axes[i] = c.axes[i];
    if (c.has_min) x.min = c.min;
    if (c.has_max) x.max = c.max;
    if (c.has_stiffness) x.stiffness = c.stiffness;
    x.damping = c.damping;
    return x;
}
cairn_joint_limit to_c(const JointLimit& x) {
    cairn_joint_limit c{};
    c.kind = cairn_joint_axis(x.kind);
    for (std::size_t i = 0; i < 3; ++i) c.axes[i] = x.axes[i];
    c.has_min = x.min.has_value();
    if (x.min) c.min = *x.min;
    c.has_max = x.max.has_value();
    if (x.max) c.max = *x.max;
    c.has_stiffness = x.stiffness.has_value();
    if (x.stiffness) c.stiffness = *x.stiffness;
    c.damping = x.damping;
    return c;
}

JointDrive to_cpp(const cairn_joint_drive& c) {
    JointDrive x;
    x.kind = to_joint_axis(c.kind, "JointDrive.kind");
    x.is_acceleration = c.is_acceleration;
    x.axis = c.axis;
    if (c.has_max_force) x.max_force = c.max_force;
    x.position_target = c.position_target;
    x.velocity_target = c.velocity_target;
    x.stiffness = c.stiffness;
    x.damping = c.damping;
    return x;
}
cairn_joint_drive to_c(const JointDrive& x) {
    cairn_joint_drive c{};
    c.kind = cairn_joint_axis(x.kind);
    c.is_acceleration = x.is_acceleration;
    c.axis = x.axis;
    c.has_max_force = x.max_force.has_value();
    if (x.max_force) c.max_force = *x.max_force;
    c.position_target = x.position_target;
    c.velocity_target = x.velocity_target;
    c.stiffness = x.stiffness;
    c.damping = x.damping;
    return c;
}

GeneralJoint to_cpp(const cairn_general_joint& c) {
    GeneralJoint x;
    require_list(c.limits, c.limit_count, "GeneralJoint.limits");
    for (std::size_t i = 0; i < c.limit_count; ++i) x.limits.push_back(to_cpp(c.limits[i]));
    require_list(c.drives, c.drive_count, "GeneralJoint.drives");
    for (std::size_t i = 0; i < c.drive_count; ++i) x.drives.push_back(to_cpp(c.drives[i]));
    return x;
}
cairn_general_joint to_c(const GeneralJoint& x) {
    cairn_general_joint c{};
    c.limit_count = x.limits.size();
    c.drive_count = x.drives.size();
    return c;
}

JointDef to_cpp(const cairn_joint_def& c) {
    JointDef x;
    x.body_a = to_cpp(c.body_a);
    x.body_b = to_cpp(c.body_b);
    x.frame_a = to_cpp(c.frame_a);
    x.frame_b = to_cpp(c.frame_b);
    x.joint = to_cpp(c.joint);
    x.enable_collision = c.enable_collision;
    x.break_force = c.break_force;
    x.break_torque = c.break_torque;
    x.solver = to_joint_solver(c.solver, "JointDef.solver");
    x.name = text_of(c.name);
    x.user_data = c.user_data;
    x.enabled = c.enabled;
    return x;
}
cairn_joint_def to_c(const JointDef& x) {
    cairn_joint_def c{};
    c.struct_size = sizeof c;
    c.body_a = to_c(x.body_a);
    c.body_b = to_c(x.body_b);
    c.frame_a = to_c(x.frame_a);
    c.frame_b = to_c(x.frame_b);
    c.joint = to_c(x.joint);
    c.enable_collision = x.enable_collision;
    c.break_force = x.break_force;
    c.break_torque = x.break_torque;
    c.solver = cairn_joint_solver(x.solver);
    c.user_data = x.user_data;
    c.enabled = x.enabled;
    return c;
}

cairn_joint_state to_c(const JointState& x) {
    cairn_joint_state c{};
    c.force = to_c(x.force);
    c.torque = to_c(x.torque);
    for (std::size_t i = 0; i < 8; ++i) c.positions[i] = x.positions[i];
    c.position_count = x.position_count;
    c.linear_error = x.linear_error;
    c.angular_error = x.angular_error;
    return c;
}

Joint to_cpp(const cairn_joint& c) {
    switch (c.kind) {
    case CAIRN_JOINT_FIXED: return to_cpp(c.as.fixed);
    case CAIRN_JOINT_BALL: return to_cpp(c.as.ball);
    case CAIRN_JOINT_HINGE: return to_cpp(c.as.hinge);
    case CAIRN_JOINT_SLIDER: return to_cpp(c.as.slider);
    case CAIRN_JOINT_CYLINDRICAL: return to_cpp(c.as.cylindrical);
    case CAIRN_JOINT_UNIVERSAL: return to_cpp(c.as.universal);
    case CAIRN_JOINT_DISTANCE: return to_cpp(c.as.distance);
    case CAIRN_JOINT_WHEEL: return to_cpp(c.as.wheel);
    case CAIRN_JOINT_SERVO: return to_cpp(c.as.servo);
    case CAIRN_JOINT_GEAR: return to_cpp(c.as.gear);
    case CAIRN_JOINT_RACK: return to_cpp(c.as.rack);
    case CAIRN_JOINT_PULLEY: return to_cpp(c.as.pulley);
    case CAIRN_JOINT_GENERAL: return to_cpp(c.as.general);
    default:
        throw Error(ErrorCode::invalid_value, "Joint.kind", std::to_string(c.kind), "must be 0 to 12");
    }
}
cairn_joint to_c(const Joint& x) {
    cairn_joint c{};
    c.kind = cairn_joint_kind(x.index());
    switch (c.kind) {
    case CAIRN_JOINT_FIXED: c.as.fixed = to_c(std::get<0>(x)); break;
    case CAIRN_JOINT_BALL: c.as.ball = to_c(std::get<1>(x)); break;
    case CAIRN_JOINT_HINGE: c.as.hinge = to_c(std::get<2>(x)); break;
    case CAIRN_JOINT_SLIDER: c.as.slider = to_c(std::get<3>(x)); break;
    case CAIRN_JOINT_CYLINDRICAL: c.as.cylindrical = to_c(std::get<4>(x)); break;
    case CAIRN_JOINT_UNIVERSAL: c.as.universal = to_c(std::get<5>(x)); break;
    case CAIRN_JOINT_DISTANCE: c.as.distance = to_c(std::get<6>(x)); break;
    case CAIRN_JOINT_WHEEL: c.as.wheel = to_c(std::get<7>(x)); break;
    case CAIRN_JOINT_SERVO: c.as.servo = to_c(std::get<8>(x)); break;
    case CAIRN_JOINT_GEAR: c.as.gear = to_c(std::get<9>(x)); break;
    case CAIRN_JOINT_RACK: c.as.rack = to_c(std::get<10>(x)); break;
    case CAIRN_JOINT_PULLEY: c.as.pulley = to_c(std::get<11>(x)); break;
    case CAIRN_JOINT_GENERAL: c.as.general = to_c(std::get<12>(x)); break;
    }
    return c;
}

} // namespace cairn::c_api
