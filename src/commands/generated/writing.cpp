// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "commands/generated/codec.h"

#include <variant>

namespace cairn::commands {

void write(CommandWriter& to, const Transform& x) {
    to.number(2);
    write(to, x.position);
    write(to, x.rotation);
}

void write(CommandWriter& to, const Sphere& x) {
    to.number(1);
    write(to, x.radius);
}

void write(CommandWriter& to, const Box& x) {
    to.number(2);
    write(to, x.half_extents);
    write(to, x.rounding);
}

void write(CommandWriter& to, const Plane& x) {
    to.number(4);
    write(to, x.normal);
    write(to, x.tangent);
    write(to, x.half_extents);
    write(to, x.double_sided);
}

void write(CommandWriter& to, const Capsule& x) {
    to.number(3);
    write(to, x.half_height);
    write(to, x.radius);
    write(to, x.radius_top);
}

void write(CommandWriter& to, const Cylinder& x) {
    to.number(4);
    write(to, x.half_height);
    write(to, x.radius);
    write(to, x.radius_top);
    write(to, x.rounding);
}

void write(CommandWriter& to, const Material& x) {
    to.number(7);
    write(to, x.static_friction);
    write(to, x.dynamic_friction);
    write(to, x.restitution);
    write(to, x.rolling_friction);
    write(to, x.torsional_friction);
    write(to, x.friction_combine);
    write(to, x.restitution_combine);
}

void write(CommandWriter& to, const CollisionFilter& x) {
    to.number(2);
    write(to, x.layers);
    write(to, x.collides_with);
}

void write(CommandWriter& to, const ShapeDef& x) {
    to.number(9);
    write(to, x.position);
    write(to, x.rotation);
    write(to, x.density);
    write(to, x.material);
    write(to, x.filter);
    write(to, x.is_trigger);
    write(to, x.surface_velocity);
    write(to, x.user_data);
    write(to, x.one_way);
}

void write(CommandWriter& to, const MassProperties& x) {
    to.number(4);
    write(to, x.mass);
    write(to, x.center_of_mass);
    write(to, x.inertia_diagonal);
    write(to, x.inertia_orientation);
}

void write(CommandWriter& to, const BodyDef& x) {
    to.number(14);
    write(to, x.type);
    write(to, x.position);
    write(to, x.rotation);
    write(to, x.linear_velocity);
    write(to, x.angular_velocity);
    write(to, x.linear_damping);
    write(to, x.angular_damping);
    write(to, x.gravity_scale);
    write(to, x.allow_sleep);
    write(to, x.mass);
    write(to, x.mass_properties);
    write(to, x.name);
    write(to, x.user_data);
    write(to, x.enabled);
}

void write(CommandWriter& to, const CharacterDef& x) {
    to.number(9);
    write(to, x.up);
    write(to, x.max_slope);
    write(to, x.step_height);
    write(to, x.stick_distance);
    write(to, x.skin);
    write(to, x.mass);
    write(to, x.max_push_force);
    write(to, x.air_acceleration);
    write(to, x.flies);
}

void write(CommandWriter& to, const JointSpring& x) {
    to.number(3);
    write(to, x.stiffness);
    write(to, x.damping);
    write(to, x.is_acceleration);
}

void write(CommandWriter& to, const JointRange& x) {
    to.number(3);
    write(to, x.lower);
    write(to, x.upper);
    write(to, x.spring);
}

void write(CommandWriter& to, const JointMotor& x) {
    to.number(4);
    write(to, x.velocity);
    write(to, x.position);
    write(to, x.spring);
    write(to, x.max_force);
}

void write(CommandWriter& to, const JointControl& x) {
    to.number(3);
    write(to, x.limits);
    write(to, x.motor);
    write(to, x.friction);
}

void write(CommandWriter& to, [[maybe_unused]] const FixedJoint& x) {
    to.number(0);
}

void write(CommandWriter& to, const BallJoint& x) {
    to.number(3);
    write(to, x.cone_angle);
    write(to, x.twist);
    write(to, x.friction);
}

void write(CommandWriter& to, const HingeJoint& x) {
    to.number(1);
    write(to, x.angle);
}

void write(CommandWriter& to, const SliderJoint& x) {
    to.number(1);
    write(to, x.translation);
}

void write(CommandWriter& to, const CylindricalJoint& x) {
    to.number(2);
    write(to, x.translation);
    write(to, x.angle);
}

void write(CommandWriter& to, const UniversalJoint& x) {
    to.number(2);
    write(to, x.first);
    write(to, x.second);
}

void write(CommandWriter& to, const DistanceJoint& x) {
    to.number(1);
    write(to, x.distance);
}

void write(CommandWriter& to, const WheelJoint& x) {
    to.number(3);
    write(to, x.suspension);
    write(to, x.steering);
    write(to, x.spin);
}

void write(CommandWriter& to, const ServoJoint& x) {
    to.number(6);
    write(to, x.position);
    write(to, x.rotation);
    write(to, x.linear);
    write(to, x.angular);
    write(to, x.max_force);
    write(to, x.max_torque);
}

void write(CommandWriter& to, const GearJoint& x) {
    to.number(1);
    write(to, x.ratio);
}

void write(CommandWriter& to, const RackJoint& x) {
    to.number(1);
    write(to, x.radius);
}

void write(CommandWriter& to, const PulleyJoint& x) {
    to.number(4);
    write(to, x.ground_a);
    write(to, x.ground_b);
    write(to, x.ratio);
    write(to, x.length);
}

void write(CommandWriter& to, const JointLimit& x) {
    to.number(6);
    write(to, x.kind);
    write(to, x.axes);
    write(to, x.min);
    write(to, x.max);
    write(to, x.stiffness);
    write(to, x.damping);
}

void write(CommandWriter& to, const JointDrive& x) {
    to.number(8);
    write(to, x.kind);
    write(to, x.is_acceleration);
    write(to, x.axis);
    write(to, x.max_force);
    write(to, x.position_target);
    write(to, x.velocity_target);
    write(to, x.stiffness);
    write(to, x.damping);
}

void write(CommandWriter& to, const GeneralJoint& x) {
    to.number(2);
    write(to, x.limits);
    write(to, x.drives);
}

void write(CommandWriter& to, const Joint& x) {
    to.number(x.index());
    std::visit([&](const auto& alternative) { write(to, alternative); }, x);
}

void write(CommandWriter& to, const JointDef& x) {
    to.number(12);
    write(to, x.body_a);
    write(to, x.body_b);
    write(to, x.frame_a);
    write(to, x.frame_b);
    write(to, x.joint);
    write(to, x.enable_collision);
    write(to, x.break_force);
    write(to, x.break_torque);
    write(to, x.solver);
    write(to, x.name);
    write(to, x.user_data);
    write(to, x.enabled);
}

void write(CommandWriter& to, const WorldDef& x) {
    to.number(12);
    write(to, x.gravity);
    write(to, x.substeps);
    write(to, x.adaptive_substeps);
    write(to, x.integrator);
    write(to, x.enable_sleep);
    write(to, x.sleep_speed);
    write(to, x.sleep_time);
    write(to, x.restitution_speed);
    write(to, x.hit_speed);
    write(to, x.recovery_speed);
    write(to, x.max_linear_speed);
    write(to, x.max_angular_speed);
}

void write(CommandWriter& to, const ForceField& x) {
    to.number(12);
    write(to, x.kind);
    write(to, x.direction);
    write(to, x.center);
    write(to, x.strength);
    write(to, x.exponent);
    write(to, x.is_force);
    write(to, x.half_extents);
    write(to, x.density);
    write(to, x.drag);
    write(to, x.skin_friction);
    write(to, x.added_mass);
    write(to, x.wave_damping);
}

void write(CommandWriter& to, const Shape& x) {
    to.number(x.index());
    std::visit([&](const auto& alternative) { write(to, alternative); }, x);
}

} // namespace cairn::commands
