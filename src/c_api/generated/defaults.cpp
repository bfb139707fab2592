// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"

#include <cairn/c/cairn.h>

using namespace cairn::c_api;

cairn_transform cairn_default_transform(void) {
    return to_c(cairn::Transform{});
}
cairn_bounds cairn_default_bounds(void) {
    return to_c(cairn::Bounds{});
}
cairn_sphere cairn_default_sphere(void) {
    return to_c(cairn::Sphere{});
}
cairn_box cairn_default_box(void) {
    return to_c(cairn::Box{});
}
cairn_plane cairn_default_plane(void) {
    return to_c(cairn::Plane{});
}
cairn_capsule cairn_default_capsule(void) {
    return to_c(cairn::Capsule{});
}
cairn_cylinder cairn_default_cylinder(void) {
    return to_c(cairn::Cylinder{});
}
cairn_hull cairn_default_hull(void) {
    return cairn_hull{};
}
cairn_mesh cairn_default_mesh(void) {
    return cairn_mesh{};
}
cairn_height_field cairn_default_height_field(void) {
    return cairn_height_field{};
}
cairn_material cairn_default_material(void) {
    return to_c(cairn::Material{});
}
cairn_collision_filter cairn_default_collision_filter(void) {
    return to_c(cairn::CollisionFilter{});
}
cairn_shape_def cairn_default_shape_def(void) {
    return to_c(cairn::ShapeDef{});
}
cairn_mass_properties cairn_default_mass_properties(void) {
    return to_c(cairn::MassProperties{});
}
cairn_body_def cairn_default_body_def(void) {
    return to_c(cairn::BodyDef{});
}
cairn_character_def cairn_default_character_def(void) {
    return to_c(cairn::CharacterDef{});
}
cairn_joint_spring cairn_default_joint_spring(void) {
    return to_c(cairn::JointSpring{});
}
cairn_joint_range cairn_default_joint_range(void) {
    return to_c(cairn::JointRange{});
}
cairn_joint_motor cairn_default_joint_motor(void) {
    return to_c(cairn::JointMotor{});
}
cairn_joint_control cairn_default_joint_control(void) {
    return to_c(cairn::JointControl{});
}
cairn_fixed_joint cairn_default_fixed_joint(void) {
    return to_c(cairn::FixedJoint{});
}
cairn_ball_joint cairn_default_ball_joint(void) {
    return to_c(cairn::BallJoint{});
}
cairn_hinge_joint cairn_default_hinge_joint(void) {
    return to_c(cairn::HingeJoint{});
}
cairn_slider_joint cairn_default_slider_joint(void) {
    return to_c(cairn::SliderJoint{});
}
cairn_cylindrical_joint cairn_default_cylindrical_joint(void) {
    return to_c(cairn::CylindricalJoint{});
}
cairn_universal_joint cairn_default_universal_joint(void) {
    return to_c(cairn::UniversalJoint{});
}
cairn_distance_joint cairn_default_distance_joint(void) {
    return to_c(cairn::DistanceJoint{});
}
cairn_wheel_joint cairn_default_wheel_joint(void) {
    return to_c(cairn::WheelJoint{});
}
cairn_servo_joint cairn_default_servo_joint(void) {
    return to_c(cairn::ServoJoint{});
}
cairn_gear_joint cairn_default_gear_joint(void) {
    return to_c(cairn::GearJoint{});
}
cairn_rack_joint cairn_default_rack_joint(void) {
    return to_c(cairn::RackJoint{});
}
cairn_pulley_joint cairn_default_pulley_joint(void) {
    return to_c(cairn::PulleyJoint{});
}
cairn_joint_limit cairn_default_joint_limit(void) {
    return to_c(cairn::JointLimit{});
}
cairn_joint_drive cairn_default_joint_drive(void) {
    return to_c(cairn::JointDrive{});
}
cairn_general_joint cairn_default_general_joint(void) {
    return to_c(cairn::GeneralJoint{});
}
cairn_joint_def cairn_default_joint_def(void) {
    return to_c(cairn::JointDef{});
}
cairn_debug_lines_def cairn_default_debug_lines_def(void) {
    return to_c(cairn::DebugLinesDef{});
}
cairn_query_filter cairn_default_query_filter(void) {
    return to_c(cairn::QueryFilter{});
}
cairn_world_def cairn_default_world_def(void) {
    return to_c(cairn::WorldDef{});
}
cairn_force_field cairn_default_force_field(void) {
    return to_c(cairn::ForceField{});
}
cairn_statistics cairn_default_statistics(void) {
    return to_c(cairn::Statistics{});
}
cairn_body_arrays cairn_default_body_arrays(void) {
    cairn_body_arrays c{};
    c.struct_size = sizeof c;
    return c;
}
cairn_shape cairn_default_shape(cairn_shape_kind kind) {
    cairn_shape c{};
    switch (kind) {
    case CAIRN_SHAPE_BOX: c.as.box = cairn_default_box(); break;
    case CAIRN_SHAPE_PLANE: c.as.plane = cairn_default_plane(); break;
    case CAIRN_SHAPE_CAPSULE: c.as.capsule = cairn_default_capsule(); break;
    case CAIRN_SHAPE_CYLINDER: c.as.cylinder = cairn_default_cylinder(); break;
    case CAIRN_SHAPE_HULL: c.as.hull = cairn_default_hull(); break;
    case CAIRN_SHAPE_MESH: c.as.mesh = cairn_default_mesh(); break;
    case CAIRN_SHAPE_HEIGHT_FIELD: c.as.height_field = cairn_default_height_field(); break;
    default: kind = 0; c.as.sphere = cairn_default_sphere(); break;
    }
    c.kind = kind;
    return c;
}
cairn_joint cairn_default_joint(cairn_joint_kind kind) {
    cairn_joint c{};
    switch (kind) {
    case CAIRN_JOINT_BALL: c.as.ball = cairn_default_ball_joint(); break;
    case CAIRN_JOINT_HINGE: c.as.hinge = cairn_default_hinge_joint(); break;
    case CAIRN_JOINT_SLIDER: c.as.slider = cairn_default_slider_joint(); break;
    case CAIRN_JOINT_CYLINDRICAL: c.as.cylindrical = cairn_default_cylindrical_joint(); break;
    case CAIRN_JOINT_UNIVERSAL: c.as.universal = cairn_default_universal_joint(); break;
    case CAIRN_JOINT_DISTANCE: c.as.distance = cairn_default_distance_joint(); break;
    case CAIRN_JOINT_WHEEL: c.as.wheel = cairn_default_wheel_joint(); break;
    case CAIRN_JOINT_SERVO: c.as.servo = cairn_default_servo_joint(); break;
    case CAIRN_JOINT_GEAR: c.as.gear = cairn_default_gear_joint(); break;
    case CAIRN_JOINT_RACK: c.as.rack = cairn_default_rack_joint(); break;
    case CAIRN_JOINT_PULLEY: c.as.pulley = cairn_default_pulley_joint(); break;
    case CAIRN_JOINT_GENERAL: c.as.general = cairn_default_general_joint(); break;
    default: kind = 0; c.as.fixed = cairn_default_fixed_joint(); break;
    }
    c.kind = kind;
    return c;
}
