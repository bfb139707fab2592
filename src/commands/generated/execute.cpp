// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "commands/execute.h"
#include "commands/generated/calls.h"
#include "commands/generated/codec.h"

#include <string>

namespace cairn::commands {

static bool execute_world(World& world, std::uint64_t code, CommandReader& from) {
    switch (code) {
    case WorldSetSettings::code: {
        WorldDef def{};
        read(from, def);
        from.finish();
        world.set_settings(def);
        return true;
    }
    case WorldAddForceField::code: {
        ForceField field{};
        read(from, field);
        from.finish();
        world.add_force_field(field);
        return true;
    }
    case WorldSetForceField::code: {
        ForceFieldId id{};
        read(from, id);
        ForceField field{};
        read(from, field);
        from.finish();
        world.set_force_field(id, field);
        return true;
    }
    case WorldRemoveForceField::code: {
        ForceFieldId id{};
        read(from, id);
        from.finish();
        world.remove_force_field(id);
        return true;
    }
    case WorldStep::code: {
        float dt{};
        read(from, dt);
        from.finish();
        world.step(dt);
        return true;
    }
    case WorldRestore::code: {
        const Snapshot& snapshot = from.snapshot();
        from.finish();
        world.restore(snapshot);
        return true;
    }
    case WorldCreateBody::code: {
        BodyDef def{};
        read(from, def);
        from.finish();
        world.create_body(def);
        return true;
    }
    case WorldDestroyBody::code: {
        BodyId body{};
        read(from, body);
        from.finish();
        world.destroy_body(body);
        return true;
    }
    case WorldAddShape::code: {
        BodyId body{};
        read(from, body);
        Shape shape{};
        read(from, shape);
        ShapeDef def{};
        read(from, def);
        from.finish();
        world.add_shape(body, shape, def);
        return true;
    }
    case WorldRemoveShape::code: {
        ShapeId shape{};
        read(from, shape);
        from.finish();
        world.remove_shape(shape);
        return true;
    }
    case WorldSetMaterial::code: {
        ShapeId shape{};
        read(from, shape);
        Material material{};
        read(from, material);
        from.finish();
        world.set_material(shape, material);
        return true;
    }
    case WorldSetFilter::code: {
        ShapeId shape{};
        read(from, shape);
        CollisionFilter filter{};
        read(from, filter);
        from.finish();
        world.set_filter(shape, filter);
        return true;
    }
    case WorldSetSurfaceVelocity::code: {
        ShapeId shape{};
        read(from, shape);
        Vec3 velocity{};
        read(from, velocity);
        from.finish();
        world.set_surface_velocity(shape, velocity);
        return true;
    }
    case WorldCreateJoint::code: {
        JointDef def{};
        read(from, def);
        from.finish();
        world.create_joint(def);
        return true;
    }
    case WorldDestroyJoint::code: {
        JointId joint{};
        read(from, joint);
        from.finish();
        world.destroy_joint(joint);
        return true;
    }
    case WorldSetJoint::code: {
        JointId id{};
        read(from, id);
        Joint joint{};
        read(from, joint);
        from.finish();
        world.set_joint(id, joint);
        return true;
    }
    case WorldSetJointStrength::code: {
        JointId joint{};
        read(from, joint);
        float break_force{};
        read(from, break_force);
        float break_torque{};
        read(from, break_torque);
        from.finish();
        world.set_joint_strength(joint, break_force, break_torque);
        return true;
    }
    case WorldSetShape::code: {
        ShapeId shape{};
        read(from, shape);
        Shape geometry{};
        read(from, geometry);
        from.finish();
        world.set_shape(shape, geometry);
        return true;
    }
    case WorldSetShapeDef::code: {
        ShapeId shape{};
        read(from, shape);
        ShapeDef def{};
        read(from, def);
        from.finish();
        world.set_shape_def(shape, def);
        return true;
    }
    case WorldSetJointEnabled::code: {
        JointId joint{};
        read(from, joint);
        bool enabled{};
        read(from, enabled);
        from.finish();
        world.set_joint_enabled(joint, enabled);
        return true;
    }
    default: return false;
    }
}
static bool execute_body(World& world, std::uint64_t code, CommandReader& from) {
    switch (code) {
    case BodySetTransform::code: {
        BodyId body{};
        read(from, body);
        Position position{};
        read(from, position);
        Quat rotation{};
        read(from, rotation);
        from.finish();
        world.body(body).set_transform(position, rotation);
        return true;
    }
    case BodySetPosition::code: {
        BodyId body{};
        read(from, body);
        Position position{};
        read(from, position);
        from.finish();
        world.body(body).set_position(position);
        return true;
    }
    case BodySetRotation::code: {
        BodyId body{};
        read(from, body);
        Quat rotation{};
        read(from, rotation);
        from.finish();
        world.body(body).set_rotation(rotation);
        return true;
    }
    case BodySetLinearVelocity::code: {
        BodyId body{};
        read(from, body);
        Vec3 velocity{};
        read(from, velocity);
        from.finish();
        world.body(body).set_linear_velocity(velocity);
        return true;
    }
    case BodySetAngularVelocity::code: {
        BodyId body{};
        read(from, body);
        Vec3 velocity{};
        read(from, velocity);
        from.finish();
        world.body(body).set_angular_velocity(velocity);
        return true;
    }
    case BodyMoveTo::code: {
        BodyId body{};
        read(from, body);
        Transform target{};
        read(from, target);
        float seconds{};
        read(from, seconds);
        from.finish();
        world.body(body).move_to(target, seconds);
        return true;
    }
    case BodySetGravityScale::code: {
        BodyId body{};
        read(from, body);
        float scale{};
        read(from, scale);
        from.finish();
        world.body(body).set_gravity_scale(scale);
        return true;
    }
    case BodySetDamping::code: {
        BodyId body{};
        read(from, body);
        float linear{};
        read(from, linear);
        float angular{};
        read(from, angular);
        from.finish();
        world.body(body).set_damping(linear, angular);
        return true;
    }
    case BodySetAllowSleep::code: {
        BodyId body{};
        read(from, body);
        bool allow{};
        read(from, allow);
        from.finish();
        world.body(body).set_allow_sleep(allow);
        return true;
    }
    case BodySetType::code: {
        BodyId body{};
        read(from, body);
        BodyType type{};
        from.enumerator(type, 2, "type");
        from.finish();
        world.body(body).set_type(type);
        return true;
    }
    case BodySetName::code: {
        BodyId body{};
        read(from, body);
        std::string name{};
        read(from, name);
        from.finish();
        world.body(body).set_name(name);
        return true;
    }
    case BodySetMassProperties::code: {
        BodyId body{};
        read(from, body);
        MassProperties properties{};
        read(from, properties);
        from.finish();
        world.body(body).set_mass_properties(properties);
        return true;
    }
    case BodySetMassFromShapes::code: {
        BodyId body{};
        read(from, body);
        std::optional<float> mass{};
        read(from, mass);
        from.finish();
        world.body(body).set_mass_from_shapes(mass);
        return true;
    }
    case BodyWake::code: {
        BodyId body{};
        read(from, body);
        from.finish();
        world.body(body).wake();
        return true;
    }
    case BodyAddForce::code: {
        BodyId body{};
        read(from, body);
        Vec3 force{};
        read(from, force);
        from.finish();
        world.body(body).add_force(force);
        return true;
    }
    case BodyAddForceAt::code: {
        BodyId body{};
        read(from, body);
        Vec3 force{};
        read(from, force);
        Position point{};
        read(from, point);
        from.finish();
        world.body(body).add_force_at(force, point);
        return true;
    }
    case BodyAddTorque::code: {
        BodyId body{};
        read(from, body);
        Vec3 torque{};
        read(from, torque);
        from.finish();
        world.body(body).add_torque(torque);
        return true;
    }
    case BodyApplyImpulse::code: {
        BodyId body{};
        read(from, body);
        Vec3 impulse{};
        read(from, impulse);
        from.finish();
        world.body(body).apply_impulse(impulse);
        return true;
    }
    case BodyApplyImpulseAt::code: {
        BodyId body{};
        read(from, body);
        Vec3 impulse{};
        read(from, impulse);
        Position point{};
        read(from, point);
        from.finish();
        world.body(body).apply_impulse_at(impulse, point);
        return true;
    }
    case BodyApplyAngularImpulse::code: {
        BodyId body{};
        read(from, body);
        Vec3 impulse{};
        read(from, impulse);
        from.finish();
        world.body(body).apply_angular_impulse(impulse);
        return true;
    }
    case BodySetCharacter::code: {
        BodyId body{};
        read(from, body);
        CharacterDef def{};
        read(from, def);
        from.finish();
        world.body(body).set_character(def);
        return true;
    }
    case BodyRemoveCharacter::code: {
        BodyId body{};
        read(from, body);
        from.finish();
        world.body(body).remove_character();
        return true;
    }
    case BodySetWalkVelocity::code: {
        BodyId body{};
        read(from, body);
        Vec3 velocity{};
        read(from, velocity);
        from.finish();
        world.body(body).set_walk_velocity(velocity);
        return true;
    }
    case BodyJump::code: {
        BodyId body{};
        read(from, body);
        float speed{};
        read(from, speed);
        from.finish();
        world.body(body).jump(speed);
        return true;
    }
    case BodySleep::code: {
        BodyId body{};
        read(from, body);
        from.finish();
        world.body(body).sleep();
        return true;
    }
    case BodySetEnabled::code: {
        BodyId body{};
        read(from, body);
        bool enabled{};
        read(from, enabled);
        from.finish();
        world.body(body).set_enabled(enabled);
        return true;
    }
    default: return false;
    }
}
void execute(World& world, CommandReader& from) {
    const std::uint64_t code = from.number();
    if (!execute_world(world, code, from) && !execute_body(world, code, from)) from.refuse_code(code);
}

std::string_view name_of(std::uint64_t code) {
    switch (code) {
    case 1: return "World::set_settings";
    case 2: return "World::add_force_field";
    case 3: return "World::set_force_field";
    case 4: return "World::remove_force_field";
    case 5: return "World::step";
    case 6: return "World::restore";
    case 7: return "World::create_body";
    case 8: return "World::destroy_body";
    case 9: return "Body::set_transform";
    case 10: return "Body::set_position";
    case 11: return "Body::set_rotation";
    case 12: return "Body::set_linear_velocity";
    case 13: return "Body::set_angular_velocity";
    case 14: return "Body::move_to";
    case 15: return "Body::set_gravity_scale";
    case 16: return "Body::set_damping";
    case 17: return "Body::set_allow_sleep";
    case 18: return "Body::set_type";
    case 19: return "Body::set_name";
    case 20: return "Body::set_mass_properties";
    case 21: return "Body::set_mass_from_shapes";
    case 22: return "Body::wake";
    case 23: return "Body::add_force";
    case 24: return "Body::add_force_at";
    case 25: return "Body::add_torque";
    case 26: return "Body::apply_impulse";
    case 27: return "Body::apply_impulse_at";
    case 28: return "Body::apply_angular_impulse";
    case 29: return "World::add_shape";
    case 30: return "World::remove_shape";
    case 31: return "World::set_material";
    case 32: return "World::set_filter";
    case 33: return "World::set_surface_velocity";
    case 34: return "World::create_joint";
    case 35: return "World::destroy_joint";
    case 36: return "World::set_joint";
    case 37: return "World::set_joint_strength";
    case 38: return "Body::set_character";
    case 39: return "Body::remove_character";
    case 40: return "Body::set_walk_velocity";
    case 41: return "Body::jump";
    case 42: return "World::set_shape";
    case 43: return "World::set_shape_def";
    case 44: return "Body::sleep";
    case 45: return "Body::set_enabled";
    case 46: return "World::set_joint_enabled";
    default: return {};
    }
}

} // namespace cairn::commands
