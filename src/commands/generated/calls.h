// Made by tools/api.py from api/: change those, and run it.
// clang-format off
// The calls that change a world.
#pragma once

#include <cairn/body.h>
#include <cairn/joint.h>
#include <cairn/shape.h>
#include <cairn/world.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>

namespace cairn::commands {

// `code`: what it is in bytes; 0: nobody is told of it, as no result depends on it. `moves_only`: it leaves alone
// what snapshots have as definitions.
struct WorldSetThreads {
    static constexpr std::uint32_t code = 0;
    static constexpr const char* name = "World::set_threads";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<int>;
};
inline constexpr WorldSetThreads world_set_threads{};
struct WorldSetSettings {
    static constexpr std::uint32_t code = 1;
    static constexpr const char* name = "World::set_settings";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<WorldDef>;
};
inline constexpr WorldSetSettings world_set_settings{};
struct WorldAddForceField {
    static constexpr std::uint32_t code = 2;
    static constexpr const char* name = "World::add_force_field";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<ForceField>;
};
inline constexpr WorldAddForceField world_add_force_field{};
struct WorldSetForceField {
    static constexpr std::uint32_t code = 3;
    static constexpr const char* name = "World::set_force_field";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<ForceFieldId, ForceField>;
};
inline constexpr WorldSetForceField world_set_force_field{};
struct WorldRemoveForceField {
    static constexpr std::uint32_t code = 4;
    static constexpr const char* name = "World::remove_force_field";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<ForceFieldId>;
};
inline constexpr WorldRemoveForceField world_remove_force_field{};
struct WorldStep {
    static constexpr std::uint32_t code = 5;
    static constexpr const char* name = "World::step";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<float>;
};
inline constexpr WorldStep world_step{};
struct WorldRestore {
    static constexpr std::uint32_t code = 6;
    static constexpr const char* name = "World::restore";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<Snapshot>;
};
inline constexpr WorldRestore world_restore{};
struct WorldCreateBody {
    static constexpr std::uint32_t code = 7;
    static constexpr const char* name = "World::create_body";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyDef>;
};
inline constexpr WorldCreateBody world_create_body{};
struct WorldDestroyBody {
    static constexpr std::uint32_t code = 8;
    static constexpr const char* name = "World::destroy_body";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId>;
};
inline constexpr WorldDestroyBody world_destroy_body{};
struct BodySetTransform {
    static constexpr std::uint32_t code = 9;
    static constexpr const char* name = "Body::set_transform";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Position, Quat>;
};
inline constexpr BodySetTransform body_set_transform{};
struct BodySetPosition {
    static constexpr std::uint32_t code = 10;
    static constexpr const char* name = "Body::set_position";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Position>;
};
inline constexpr BodySetPosition body_set_position{};
struct BodySetRotation {
    static constexpr std::uint32_t code = 11;
    static constexpr const char* name = "Body::set_rotation";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Quat>;
};
inline constexpr BodySetRotation body_set_rotation{};
struct BodySetLinearVelocity {
    static constexpr std::uint32_t code = 12;
    static constexpr const char* name = "Body::set_linear_velocity";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Vec3>;
};
inline constexpr BodySetLinearVelocity body_set_linear_velocity{};
struct BodySetAngularVelocity {
    static constexpr std::uint32_t code = 13;
    static constexpr const char* name = "Body::set_angular_velocity";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Vec3>;
};
inline constexpr BodySetAngularVelocity body_set_angular_velocity{};
struct BodyMoveTo {
    static constexpr std::uint32_t code = 14;
    static constexpr const char* name = "Body::move_to";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Transform, float>;
};
inline constexpr BodyMoveTo body_move_to{};
struct BodySetGravityScale {
    static constexpr std::uint32_t code = 15;
    static constexpr const char* name = "Body::set_gravity_scale";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId, float>;
};
inline constexpr BodySetGravityScale body_set_gravity_scale{};
struct BodySetDamping {
    static constexpr std::uint32_t code = 16;
    static constexpr const char* name = "Body::set_damping";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId, float, float>;
};
inline constexpr BodySetDamping body_set_damping{};
struct BodySetAllowSleep {
    static constexpr std::uint32_t code = 17;
    static constexpr const char* name = "Body::set_allow_sleep";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId, bool>;
};
inline constexpr BodySetAllowSleep body_set_allow_sleep{};
struct BodySetType {
    static constexpr std::uint32_t code = 18;
    static constexpr const char* name = "Body::set_type";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId, BodyType>;
};
inline constexpr BodySetType body_set_type{};
struct BodySetName {
    static constexpr std::uint32_t code = 19;
    static constexpr const char* name = "Body::set_name";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId, std::string_view>;
};
inline constexpr BodySetName body_set_name{};
struct BodySetMassProperties {
    static constexpr std::uint32_t code = 20;
    static constexpr const char* name = "Body::set_mass_properties";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId, MassProperties>;
};
inline constexpr BodySetMassProperties body_set_mass_properties{};
struct BodySetMassFromShapes {
    static constexpr std::uint32_t code = 21;
    static constexpr const char* name = "Body::set_mass_from_shapes";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId, std::optional<float>>;
};
inline constexpr BodySetMassFromShapes body_set_mass_from_shapes{};
struct BodyWake {
    static constexpr std::uint32_t code = 22;
    static constexpr const char* name = "Body::wake";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId>;
};
inline constexpr BodyWake body_wake{};
struct BodyAddForce {
    static constexpr std::uint32_t code = 23;
    static constexpr const char* name = "Body::add_force";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Vec3>;
};
inline constexpr BodyAddForce body_add_force{};
struct BodyAddForceAt {
    static constexpr std::uint32_t code = 24;
    static constexpr const char* name = "Body::add_force_at";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Vec3, Position>;
};
inline constexpr BodyAddForceAt body_add_force_at{};
struct BodyAddTorque {
    static constexpr std::uint32_t code = 25;
    static constexpr const char* name = "Body::add_torque";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Vec3>;
};
inline constexpr BodyAddTorque body_add_torque{};
struct BodyApplyImpulse {
    static constexpr std::uint32_t code = 26;
    static constexpr const char* name = "Body::apply_impulse";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Vec3>;
};
inline constexpr BodyApplyImpulse body_apply_impulse{};
struct BodyApplyImpulseAt {
    static constexpr std::uint32_t code = 27;
    static constexpr const char* name = "Body::apply_impulse_at";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Vec3, Position>;
};
inline constexpr BodyApplyImpulseAt body_apply_impulse_at{};
struct BodyApplyAngularImpulse {
    static constexpr std::uint32_t code = 28;
    static constexpr const char* name = "Body::apply_angular_impulse";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Vec3>;
};
inline constexpr BodyApplyAngularImpulse body_apply_angular_impulse{};
struct WorldAddShape {
    static constexpr std::uint32_t code = 29;
    static constexpr const char* name = "World::add_shape";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId, Shape, ShapeDef>;
};
inline constexpr WorldAddShape world_add_shape{};
struct WorldRemoveShape {
    static constexpr std::uint32_t code = 30;
    static constexpr const char* name = "World::remove_shape";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<ShapeId>;
};
inline constexpr WorldRemoveShape world_remove_shape{};
struct WorldSetMaterial {
    static constexpr std::uint32_t code = 31;
    static constexpr const char* name = "World::set_material";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<ShapeId, Material>;
};
inline constexpr WorldSetMaterial world_set_material{};
struct WorldSetFilter {
    static constexpr std::uint32_t code = 32;
    static constexpr const char* name = "World::set_filter";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<ShapeId, CollisionFilter>;
};
inline constexpr WorldSetFilter world_set_filter{};
struct WorldSetSurfaceVelocity {
    static constexpr std::uint32_t code = 33;
    static constexpr const char* name = "World::set_surface_velocity";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<ShapeId, Vec3>;
};
inline constexpr WorldSetSurfaceVelocity world_set_surface_velocity{};
struct WorldCreateJoint {
    static constexpr std::uint32_t code = 34;
    static constexpr const char* name = "World::create_joint";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<JointDef>;
};
inline constexpr WorldCreateJoint world_create_joint{};
struct WorldDestroyJoint {
    static constexpr std::uint32_t code = 35;
    static constexpr const char* name = "World::destroy_joint";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<JointId>;
};
inline constexpr WorldDestroyJoint world_destroy_joint{};
struct WorldSetJoint {
    static constexpr std::uint32_t code = 36;
    static constexpr const char* name = "World::set_joint";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<JointId, Joint>;
};
inline constexpr WorldSetJoint world_set_joint{};
struct WorldSetJointStrength {
    static constexpr std::uint32_t code = 37;
    static constexpr const char* name = "World::set_joint_strength";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<JointId, float, float>;
};
inline constexpr WorldSetJointStrength world_set_joint_strength{};
struct BodySetCharacter {
    static constexpr std::uint32_t code = 38;
    static constexpr const char* name = "Body::set_character";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, CharacterDef>;
};
inline constexpr BodySetCharacter body_set_character{};
struct BodyRemoveCharacter {
    static constexpr std::uint32_t code = 39;
    static constexpr const char* name = "Body::remove_character";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId>;
};
inline constexpr BodyRemoveCharacter body_remove_character{};
struct BodySetWalkVelocity {
    static constexpr std::uint32_t code = 40;
    static constexpr const char* name = "Body::set_walk_velocity";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, Vec3>;
};
inline constexpr BodySetWalkVelocity body_set_walk_velocity{};
struct BodyJump {
    static constexpr std::uint32_t code = 41;
    static constexpr const char* name = "Body::jump";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId, float>;
};
inline constexpr BodyJump body_jump{};
struct WorldSetShape {
    static constexpr std::uint32_t code = 42;
    static constexpr const char* name = "World::set_shape";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<ShapeId, Shape>;
};
inline constexpr WorldSetShape world_set_shape{};
struct WorldSetShapeDef {
    static constexpr std::uint32_t code = 43;
    static constexpr const char* name = "World::set_shape_def";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<ShapeId, ShapeDef>;
};
inline constexpr WorldSetShapeDef world_set_shape_def{};
struct BodySleep {
    static constexpr std::uint32_t code = 44;
    static constexpr const char* name = "Body::sleep";
    static constexpr bool moves_only = true;
    using Arguments = std::tuple<BodyId>;
};
inline constexpr BodySleep body_sleep{};
struct BodySetEnabled {
    static constexpr std::uint32_t code = 45;
    static constexpr const char* name = "Body::set_enabled";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<BodyId, bool>;
};
inline constexpr BodySetEnabled body_set_enabled{};
struct WorldSetJointEnabled {
    static constexpr std::uint32_t code = 46;
    static constexpr const char* name = "World::set_joint_enabled";
    static constexpr bool moves_only = false;
    using Arguments = std::tuple<JointId, bool>;
};
inline constexpr WorldSetJointEnabled world_set_joint_enabled{};

} // namespace cairn::commands
