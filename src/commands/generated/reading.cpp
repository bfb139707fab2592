// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "commands/generated/codec.h"

#include <variant>

namespace cairn::commands {

void read(CommandReader& from, Transform& x) {
    const std::size_t members = from.member_count(2, "Transform");
    if (members > 0) read(from, x.position);
    if (members > 1) read(from, x.rotation);
}

void read(CommandReader& from, Sphere& x) {
    const std::size_t members = from.member_count(1, "Sphere");
    if (members > 0) read(from, x.radius);
}

void read(CommandReader& from, Box& x) {
    const std::size_t members = from.member_count(2, "Box");
    if (members > 0) read(from, x.half_extents);
    if (members > 1) read(from, x.rounding);
}

void read(CommandReader& from, Plane& x) {
    const std::size_t members = from.member_count(4, "Plane");
    if (members > 0) read(from, x.normal);
    if (members > 1) read(from, x.tangent);
    if (members > 2) read(from, x.half_extents);
    if (members > 3) read(from, x.double_sided);
}

void read(CommandReader& from, Capsule& x) {
    const std::size_t members = from.member_count(3, "Capsule");
    if (members > 0) read(from, x.half_height);
    if (members > 1) read(from, x.radius);
    if (members > 2) read(from, x.radius_top);
}

void read(CommandReader& from, Cylinder& x) {
    const std::size_t members = from.member_count(4, "Cylinder");
    if (members > 0) read(from, x.half_height);
    if (members > 1) read(from, x.radius);
    if (members > 2) read(from, x.radius_top);
    if (members > 3) read(from, x.rounding);
}

void read(CommandReader& from, Material& x) {
    const std::size_t members = from.member_count(7, "Material");
    if (members > 0) read(from, x.static_friction);
    if (members > 1) read(from, x.dynamic_friction);
    if (members > 2) read(from, x.restitution);
    if (members > 3) read(from, x.rolling_friction);
    if (members > 4) read(from, x.torsional_friction);
    if (members > 5) from.enumerator(x.friction_combine, 3, "Material.friction_combine");
    if (members > 6) from.enumerator(x.restitution_combine, 3, "Material.restitution_combine");
}

void read(CommandReader& from, CollisionFilter& x) {
    const std::size_t members = from.member_count(2, "CollisionFilter");
    if (members > 0) read(from, x.layers);
    if (members > 1) read(from, x.collides_with);
}

void read(CommandReader& from, ShapeDef& x) {
    const std::size_t members = from.member_count(9, "ShapeDef");
    if (members > 0) read(from, x.position);
    if (members > 1) read(from, x.rotation);
    if (members > 2) read(from, x.density);
    if (members > 3) read(from, x.material);
    if (members > 4) read(from, x.filter);
    if (members > 5) read(from, x.is_trigger);
    if (members > 6) read(from, x.surface_velocity);
    if (members > 7) read(from, x.user_data);
    if (members > 8) read(from, x.one_way);
}

void read(CommandReader& from, MassProperties& x) {
    const std::size_t members = from.member_count(4, "MassProperties");
    if (members > 0) read(from, x.mass);
    if (members > 1) read(from, x.center_of_mass);
    if (members > 2) read(from, x.inertia_diagonal);
    if (members > 3) read(from, x.inertia_orientation);
}

void read(CommandReader& from, BodyDef& x) {
    const std::size_t members = from.member_count(14, "BodyDef");
    if (members > 0) from.enumerator(x.type, 2, "BodyDef.type");
    if (members > 1) read(from, x.position);
    if (members > 2) read(from, x.rotation);
    if (members > 3) read(from, x.linear_velocity);
    if (members > 4) read(from, x.angular_velocity);
    if (members > 5) read(from, x.linear_damping);
    if (members > 6) read(from, x.angular_damping);
    if (members > 7) read(from, x.gravity_scale);
    if (members > 8) read(from, x.allow_sleep);
    if (members > 9) read(from, x.mass);
    if (members > 10) read(from, x.mass_properties);
    if (members > 11) read(from, x.name);
    if (members > 12) read(from, x.user_data);
    if (members > 13) read(from, x.enabled);
}

void read(CommandReader& from, CharacterDef& x) {
    const std::size_t members = from.member_count(9, "CharacterDef");
    if (members > 0) read(from, x.up);
    if (members > 1) read(from, x.max_slope);
    if (members > 2) read(from, x.step_height);
    if (members > 3) read(from, x.stick_distance);
    if (members > 4) read(from, x.skin);
    if (members > 5) read(from, x.mass);
    if (members > 6) read(from, x.max_push_force);
    if (members > 7) read(from, x.air_acceleration);
    if (members > 8) read(from, x.flies);
}

void read(CommandReader& from, JointSpring& x) {
    const std::size_t members = from.member_count(3, "JointSpring");
    if (members > 0) read(from, x.stiffness);
    if (members > 1) read(from, x.damping);
    if (members > 2) read(from, x.is_acceleration);
}

void read(CommandReader& from, JointRange& x) {
    const std::size_t members = from.member_count(3, "JointRange");
    if (members > 0) read(from, x.lower);
    if (members > 1) read(from, x.upper);
    if (members > 2) read(from, x.spring);
}

void read(CommandReader& from, JointMotor& x) {
    const std::size_t members = from.member_count(4, "JointMotor");
    if (members > 0) read(from, x.velocity);
    if (members > 1) read(from, x.position);
    if (members > 2) read(from, x.spring);
    if (members > 3) read(from, x.max_force);
}

void read(CommandReader& from, JointControl& x) {
    const std::size_t members = from.member_count(3, "JointControl");
    if (members > 0) read(from, x.limits);
    if (members > 1) read(from, x.motor);
    if (members > 2) read(from, x.friction);
}

void read(CommandReader& from, [[maybe_unused]] FixedJoint& x) {
    from.member_count(0, "FixedJoint");
}

void read(CommandReader& from, BallJoint& x) {
    const std::size_t members = from.member_count(3, "BallJoint");
    if (members > 0) read(from, x.cone_angle);
    if (members > 1) read(from, x.twist);
    if (members > 2) read(from, x.friction);
}

void read(CommandReader& from, HingeJoint& x) {
    const std::size_t members = from.member_count(1, "HingeJoint");
    if (members > 0) read(from, x.angle);
}

void read(CommandReader& from, SliderJoint& x) {
    const std::size_t members = from.member_count(1, "SliderJoint");
    if (members > 0) read(from, x.translation);
}

void read(CommandReader& from, CylindricalJoint& x) {
    const std::size_t members = from.member_count(2, "CylindricalJoint");
    if (members > 0) read(from, x.translation);
    if (members > 1) read(from, x.angle);
}

void read(CommandReader& from, UniversalJoint& x) {
    const std::size_t members = from.member_count(2, "UniversalJoint");
    if (members > 0) read(from, x.first);
    if (members > 1) read(from, x.second);
}

void read(CommandReader& from, DistanceJoint& x) {
    const std::size_t members = from.member_count(1, "DistanceJoint");
    if (members > 0) read(from, x.distance);
}

void read(CommandReader& from, WheelJoint& x) {
    const std::size_t members = from.member_count(3, "WheelJoint");
    if (members > 0) read(from, x.suspension);
    if (members > 1) read(from, x.steering);
    if (members > 2) read(from, x.spin);
}

void read(CommandReader& from, ServoJoint& x) {
    const std::size_t members = from.member_count(6, "ServoJoint");
    if (members > 0) read(from, x.position);
    if (members > 1) read(from, x.rotation);
    if (members > 2) read(from, x.linear);
    if (members > 3) read(from, x.angular);
    if (members > 4) read(from, x.max_force);
    if (members > 5) read(from, x.max_torque);
}

void read(CommandReader& from, GearJoint& x) {
    const std::size_t members = from.member_count(1, "GearJoint");
    if (members > 0) read(from, x.ratio);
}

void read(CommandReader& from, RackJoint& x) {
    const std::size_t members = from.member_count(1, "RackJoint");
    if (members > 0) read(from, x.radius);
}

void read(CommandReader& from, PulleyJoint& x) {
    const std::size_t members = from.member_count(4, "PulleyJoint");
    if (members > 0) read(from, x.ground_a);
    if (members > 1) read(from, x.ground_b);
    if (members > 2) read(from, x.ratio);
    if (members > 3) read(from, x.length);
}

void read(CommandReader& from, JointLimit& x) {
    const std::size_t members = from.member_count(6, "JointLimit");
    if (members > 0) from.enumerator(x.kind, 1, "JointLimit.kind");
    if (members > 1) read(from, x.axes);
    if (members > 2) read(from, x.min);
    if (members > 3) read(from, x.max);
    if (members > 4) read(from, x.stiffness);
    if (members > 5) read(from, x.damping);
}

void read(CommandReader& from, JointDrive& x) {
    const std::size_t members = from.member_count(8, "JointDrive");
    if (members > 0) from.enumerator(x.kind, 1, "JointDrive.kind");
    if (members > 1) read(from, x.is_acceleration);
    if (members > 2) read(from, x.axis);
    if (members > 3) read(from, x.max_force);
    if (members > 4) read(from, x.position_target);
    if (members > 5) read(from, x.velocity_target);
    if (members > 6) read(from, x.stiffness);
    if (members > 7) read(from, x.damping);
}

void read(CommandReader& from, GeneralJoint& x) {
    const std::size_t members = from.member_count(2, "GeneralJoint");
    if (members > 0) read(from, x.limits);
    if (members > 1) read(from, x.drives);
}

void read(CommandReader& from, Joint& x) {
    switch (from.choice(13, "Joint")) {
    case 0: read(from, x.emplace<0>()); break;
    case 1: read(from, x.emplace<1>()); break;
    case 2: read(from, x.emplace<2>()); break;
    case 3: read(from, x.emplace<3>()); break;
    case 4: read(from, x.emplace<4>()); break;
    case 5: read(from, x.emplace<5>()); break;
    case 6: read(from, x.emplace<6>()); break;
    case 7: read(from, x.emplace<7>()); break;
    case 8: read(from, x.emplace<8>()); break;
    case 9: read(from, x.emplace<9>()); break;
    case 10: read(from, x.emplace<10>()); break;
    case 11: read(from, x.emplace<11>()); break;
    case 12: read(from, x.emplace<12>()); break;
    }
}

void read(CommandReader& from, JointDef& x) {
    const std::size_t members = from.member_count(12, "JointDef");
    if (members > 0) read(from, x.body_a);
    if (members > 1) read(from, x.body_b);
    if (members > 2) read(from, x.frame_a);
    if (members > 3) read(from, x.frame_b);
    if (members > 4) read(from, x.joint);
    if (members > 5) read(from, x.enable_collision);
    if (members > 6) read(from, x.break_force);
    if (members > 7) read(from, x.break_torque);
    if (members > 8) from.enumerator(x.solver, 2, "JointDef.solver");
    if (members > 9) read(from, x.name);
    if (members > 10) read(from, x.user_data);
    if (members > 11) read(from, x.enabled);
}

void read(CommandReader& from, WorldDef& x) {
    const std::size_t members = from.member_count(12, "WorldDef");
    if (members > 0) read(from, x.gravity);
    if (members > 1) read(from, x.substeps);
    if (members > 2) read(from, x.adaptive_substeps);
    if (members > 3) from.enumerator(x.integrator, 2, "WorldDef.integrator");
    if (members > 4) read(from, x.enable_sleep);
    if (members > 5) read(from, x.sleep_speed);
    if (members > 6) read(from, x.sleep_time);
    if (members > 7) read(from, x.restitution_speed);
    if (members > 8) read(from, x.hit_speed);
    if (members > 9) read(from, x.recovery_speed);
    if (members > 10) read(from, x.max_linear_speed);
    if (members > 11) read(from, x.max_angular_speed);
}

void read(CommandReader& from, ForceField& x) {
    const std::size_t members = from.member_count(12, "ForceField");
    if (members > 0) from.enumerator(x.kind, 2, "ForceField.kind");
    if (members > 1) read(from, x.direction);
    if (members > 2) read(from, x.center);
    if (members > 3) read(from, x.strength);
    if (members > 4) read(from, x.exponent);
    if (members > 5) read(from, x.is_force);
    if (members > 6) read(from, x.half_extents);
    if (members > 7) read(from, x.density);
    if (members > 8) read(from, x.drag);
    if (members > 9) read(from, x.skin_friction);
    if (members > 10) read(from, x.added_mass);
    if (members > 11) read(from, x.wave_damping);
}

void read(CommandReader& from, Shape& x) {
    switch (from.choice(8, "Shape")) {
    case 0: read(from, x.emplace<0>()); break;
    case 1: read(from, x.emplace<1>()); break;
    case 2: read(from, x.emplace<2>()); break;
    case 3: read(from, x.emplace<3>()); break;
    case 4: read(from, x.emplace<4>()); break;
    case 5: x = from.hull(); break;
    case 6: x = from.mesh(); break;
    case 7: x = from.height_field(); break;
    }
}

} // namespace cairn::commands
