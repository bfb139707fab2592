// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#pragma once

#include "c_api/convert.h"

namespace cairn::c_api {

CombineRule to_combine_rule(cairn_combine_rule value, const char* field);
BodyType to_body_type(cairn_body_type value, const char* field);
CharacterSupport to_character_support(cairn_character_support value, const char* field);
JointAxis to_joint_axis(cairn_joint_axis value, const char* field);
JointSolver to_joint_solver(cairn_joint_solver value, const char* field);
BroadPhaseTree to_broad_phase_tree(cairn_broad_phase_tree value, const char* field);
Integrator to_integrator(cairn_integrator value, const char* field);
ForceField::Kind to_force_field_kind(cairn_force_field_kind value, const char* field);

Transform to_cpp(const cairn_transform& c);
cairn_transform to_c(const Transform& x);
Bounds to_cpp(const cairn_bounds& c);
cairn_bounds to_c(const Bounds& x);
Sphere to_cpp(const cairn_sphere& c);
cairn_sphere to_c(const Sphere& x);
Box to_cpp(const cairn_box& c);
cairn_box to_c(const Box& x);
Plane to_cpp(const cairn_plane& c);
cairn_plane to_c(const Plane& x);
Capsule to_cpp(const cairn_capsule& c);
cairn_capsule to_c(const Capsule& x);
Cylinder to_cpp(const cairn_cylinder& c);
cairn_cylinder to_c(const Cylinder& x);
Material to_cpp(const cairn_material& c);
cairn_material to_c(const Material& x);
CollisionFilter to_cpp(const cairn_collision_filter& c);
cairn_collision_filter to_c(const CollisionFilter& x);
ShapeDef to_cpp(const cairn_shape_def& c);
cairn_shape_def to_c(const ShapeDef& x);
MassProperties to_cpp(const cairn_mass_properties& c);
cairn_mass_properties to_c(const MassProperties& x);
BodyDef to_cpp(const cairn_body_def& c);
cairn_body_def to_c(const BodyDef& x);
CharacterDef to_cpp(const cairn_character_def& c);
cairn_character_def to_c(const CharacterDef& x);
cairn_character_state to_c(const CharacterState& x);
JointSpring to_cpp(const cairn_joint_spring& c);
cairn_joint_spring to_c(const JointSpring& x);
JointRange to_cpp(const cairn_joint_range& c);
cairn_joint_range to_c(const JointRange& x);
JointMotor to_cpp(const cairn_joint_motor& c);
cairn_joint_motor to_c(const JointMotor& x);
JointControl to_cpp(const cairn_joint_control& c);
cairn_joint_control to_c(const JointControl& x);
FixedJoint to_cpp(const cairn_fixed_joint& c);
cairn_fixed_joint to_c(const FixedJoint& x);
BallJoint to_cpp(const cairn_ball_joint& c);
cairn_ball_joint to_c(const BallJoint& x);
HingeJoint to_cpp(const cairn_hinge_joint& c);
cairn_hinge_joint to_c(const HingeJoint& x);
SliderJoint to_cpp(const cairn_slider_joint& c);
cairn_slider_joint to_c(const SliderJoint& x);
CylindricalJoint to_cpp(const cairn_cylindrical_joint& c);
cairn_cylindrical_joint to_c(const CylindricalJoint& x);
UniversalJoint to_cpp(const cairn_universal_joint& c);
cairn_universal_joint to_c(const UniversalJoint& x);
DistanceJoint to_cpp(const cairn_distance_joint& c);
cairn_distance_joint to_c(const DistanceJoint& x);
WheelJoint to_cpp(const cairn_wheel_joint& c);
cairn_wheel_joint to_c(const WheelJoint& x);
ServoJoint to_cpp(const cairn_servo_joint& c);
cairn_servo_joint to_c(const ServoJoint& x);
GearJoint to_cpp(const cairn_gear_joint& c);
cairn_gear_joint to_c(const GearJoint& x);
RackJoint to_cpp(const cairn_rack_joint& c);
cairn_rack_joint to_c(const RackJoint& x);
PulleyJoint to_cpp(const cairn_pulley_joint& c);
cairn_pulley_joint to_c(const PulleyJoint& x);
JointLimit to_cpp(const cairn_joint_limit& c);
cairn_joint_limit to_c(const JointLimit& x);
JointDrive to_cpp(const cairn_joint_drive& c);
cairn_joint_drive to_c(const JointDrive& x);
GeneralJoint to_cpp(const cairn_general_joint& c);
cairn_general_joint to_c(const GeneralJoint& x);
JointDef to_cpp(const cairn_joint_def& c);
cairn_joint_def to_c(const JointDef& x);
cairn_joint_state to_c(const JointState& x);
cairn_ray_hit to_c(const RayHit& x);
cairn_shape_cast_hit to_c(const ShapeCastHit& x);
cairn_closest_point to_c(const ClosestPoint& x);
cairn_broad_phase_node to_c(const BroadPhaseNode& x);
cairn_solver_contact to_c(const SolverContact& x);
DebugLinesDef to_cpp(const cairn_debug_lines_def& c);
cairn_debug_lines_def to_c(const DebugLinesDef& x);
cairn_debug_line to_c(const DebugLine& x);
QueryFilter to_cpp(const cairn_query_filter& c);
cairn_query_filter to_c(const QueryFilter& x);
cairn_contact_begin to_c(const ContactBegin& x);
cairn_contact_end to_c(const ContactEnd& x);
cairn_contact_hit to_c(const ContactHit& x);
cairn_trigger_event to_c(const TriggerEvent& x);
cairn_joint_event to_c(const JointEvent& x);
cairn_sleep_event to_c(const SleepEvent& x);
cairn_contact_point to_c(const ContactPoint& x);
cairn_contact to_c(const Contact& x);
WorldDef to_cpp(const cairn_world_def& c);
cairn_world_def to_c(const WorldDef& x);
ForceField to_cpp(const cairn_force_field& c);
cairn_force_field to_c(const ForceField& x);
cairn_stage_times to_c(const StageTimes& x);
cairn_statistics to_c(const Statistics& x);
cairn_snapshot_sizes to_c(const SnapshotSizes& x);
Shape to_cpp(const cairn_shape& c);
cairn_shape to_c(const Shape& x);
Joint to_cpp(const cairn_joint& c);
cairn_joint to_c(const Joint& x);

} // namespace cairn::c_api
