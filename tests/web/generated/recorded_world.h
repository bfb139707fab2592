// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#pragma once

#include "javascript.h"

namespace cairn {

inline std::string js(CombineRule x) {
    constexpr const char* names[] = {"'average'", "'minimum'", "'maximum'", "'multiply'"};
    return names[std::size_t(x)];
}
inline std::string js(BodyType x) {
    constexpr const char* names[] = {"'static'", "'kinematic'", "'dynamic'"};
    return names[std::size_t(x)];
}
inline std::string js(CharacterSupport x) {
    constexpr const char* names[] = {"'none'", "'steep'", "'ground'"};
    return names[std::size_t(x)];
}
inline std::string js(JointAxis x) {
    constexpr const char* names[] = {"'linear'", "'angular'"};
    return names[std::size_t(x)];
}
inline std::string js(JointSolver x) {
    constexpr const char* names[] = {"'automatic'", "'iterative'", "'direct'"};
    return names[std::size_t(x)];
}
inline std::string js(BroadPhaseTree x) {
    constexpr const char* names[] = {"'fixed'", "'awake'", "'large'", "'sleeping'"};
    return names[std::size_t(x)];
}
inline std::string js(Integrator x) {
    constexpr const char* names[] = {"'semiImplicitEuler'", "'explicitEuler'", "'rk4'"};
    return names[std::size_t(x)];
}
inline std::string js(ForceField::Kind x) {
    constexpr const char* names[] = {"'uniform'", "'radial'", "'fluid'"};
    return names[std::size_t(x)];
}
std::string js(const Transform& x);
std::string js(const Bounds& x);
std::string js(const Sphere& x);
std::string js(const Box& x);
std::string js(const Plane& x);
std::string js(const Capsule& x);
std::string js(const Cylinder& x);
std::string js(const Material& x);
std::string js(const CollisionFilter& x);
std::string js(const ShapeDef& x);
std::string js(const MassProperties& x);
std::string js(const BodyDef& x);
std::string js(const CharacterDef& x);
std::string js(const JointSpring& x);
std::string js(const JointRange& x);
std::string js(const JointMotor& x);
std::string js(const JointControl& x);
std::string js(const FixedJoint& x);
std::string js(const BallJoint& x);
std::string js(const HingeJoint& x);
std::string js(const SliderJoint& x);
std::string js(const CylindricalJoint& x);
std::string js(const UniversalJoint& x);
std::string js(const DistanceJoint& x);
std::string js(const WheelJoint& x);
std::string js(const ServoJoint& x);
std::string js(const GearJoint& x);
std::string js(const RackJoint& x);
std::string js(const PulleyJoint& x);
std::string js(const JointLimit& x);
std::string js(const JointDrive& x);
std::string js(const GeneralJoint& x);
std::string js(const JointDef& x);
std::string js(const DebugLinesDef& x);
std::string js(const QueryFilter& x);
std::string js(const WorldDef& x);
std::string js(const ForceField& x);
std::string js(const Shape& x);
std::string js(const Joint& x);
inline std::string js(const Transform& x) { return object({{"position", js(x.position)}, {"rotation", js(x.rotation)}}); }
inline std::string js(const Bounds& x) { return object({{"min", js(x.min)}, {"max", js(x.max)}}); }
inline std::string js(const Sphere& x) { return object({{"radius", js(x.radius)}}); }
inline std::string js(const Box& x) { return object({{"halfExtents", js(x.half_extents)}, {"rounding", js(x.rounding)}}); }
inline std::string js(const Plane& x) { return object({{"normal", js(x.normal)}, {"tangent", js(x.tangent)}, {"halfExtents", js(x.half_extents)}, {"doubleSided", js(x.double_sided)}}); }
inline std::string js(const Capsule& x) { return object({{"halfHeight", js(x.half_height)}, {"radius", js(x.radius)}, {"radiusTop", js(x.radius_top)}}); }
inline std::string js(const Cylinder& x) { return object({{"halfHeight", js(x.half_height)}, {"radius", js(x.radius)}, {"radiusTop", js(x.radius_top)}, {"rounding", js(x.rounding)}}); }
inline std::string js(const Material& x) { return object({{"staticFriction", js(x.static_friction)}, {"dynamicFriction", js(x.dynamic_friction)}, {"restitution", js(x.restitution)}, {"rollingFriction", js(x.rolling_friction)}, {"torsionalFriction", js(x.torsional_friction)}, {"frictionCombine", js(x.friction_combine)}, {"restitutionCombine", js(x.restitution_combine)}}); }
inline std::string js(const CollisionFilter& x) { return object({{"layers", js(x.layers)}, {"collidesWith", js(x.collides_with)}}); }
inline std::string js(const ShapeDef& x) { return object({{"position", js(x.position)}, {"rotation", js(x.rotation)}, {"density", js(x.density)}, {"material", js(x.material)}, {"filter", js(x.filter)}, {"isTrigger", js(x.is_trigger)}, {"surfaceVelocity", js(x.surface_velocity)}, {"userData", js(x.user_data)}, {"oneWay", js(x.one_way)}}); }
inline std::string js(const MassProperties& x) { return object({{"mass", js(x.mass)}, {"centerOfMass", js(x.center_of_mass)}, {"inertiaDiagonal", js(x.inertia_diagonal)}, {"inertiaOrientation", js(x.inertia_orientation)}}); }
inline std::string js(const BodyDef& x) { return object({{"type", js(x.type)}, {"position", js(x.position)}, {"rotation", js(x.rotation)}, {"linearVelocity", js(x.linear_velocity)}, {"angularVelocity", js(x.angular_velocity)}, {"linearDamping", js(x.linear_damping)}, {"angularDamping", js(x.angular_damping)}, {"gravityScale", js(x.gravity_scale)}, {"allowSleep", js(x.allow_sleep)}, {"mass", js(x.mass)}, {"massProperties", js(x.mass_properties)}, {"name", js(x.name)}, {"userData", js(x.user_data)}, {"enabled", js(x.enabled)}}); }
inline std::string js(const CharacterDef& x) { return object({{"up", js(x.up)}, {"maxSlope", js(x.max_slope)}, {"stepHeight", js(x.step_height)}, {"stickDistance", js(x.stick_distance)}, {"skin", js(x.skin)}, {"mass", js(x.mass)}, {"maxPushForce", js(x.max_push_force)}, {"airAcceleration", js(x.air_acceleration)}, {"flies", js(x.flies)}}); }
inline std::string js(const JointSpring& x) { return object({{"stiffness", js(x.stiffness)}, {"damping", js(x.damping)}, {"isAcceleration", js(x.is_acceleration)}}); }
inline std::string js(const JointRange& x) { return object({{"lower", js(x.lower)}, {"upper", js(x.upper)}, {"spring", js(x.spring)}}); }
inline std::string js(const JointMotor& x) { return object({{"velocity", js(x.velocity)}, {"position", js(x.position)}, {"spring", js(x.spring)}, {"maxForce", js(x.max_force)}}); }
inline std::string js(const JointControl& x) { return object({{"limits", js(x.limits)}, {"motor", js(x.motor)}, {"friction", js(x.friction)}}); }
inline std::string js([[maybe_unused]] const FixedJoint& x) { return object({}); }
inline std::string js(const BallJoint& x) { return object({{"coneAngle", js(x.cone_angle)}, {"twist", js(x.twist)}, {"friction", js(x.friction)}}); }
inline std::string js(const HingeJoint& x) { return object({{"angle", js(x.angle)}}); }
inline std::string js(const SliderJoint& x) { return object({{"translation", js(x.translation)}}); }
inline std::string js(const CylindricalJoint& x) { return object({{"translation", js(x.translation)}, {"angle", js(x.angle)}}); }
inline std::string js(const UniversalJoint& x) { return object({{"first", js(x.first)}, {"second", js(x.second)}}); }
inline std::string js(const DistanceJoint& x) { return object({{"distance", js(x.distance)}}); }
inline std::string js(const WheelJoint& x) { return object({{"suspension", js(x.suspension)}, {"steering", js(x.steering)}, {"spin", js(x.spin)}}); }
inline std::string js(const ServoJoint& x) { return object({{"position", js(x.position)}, {"rotation", js(x.rotation)}, {"linear", js(x.linear)}, {"angular", js(x.angular)}, {"maxForce", js(x.max_force)}, {"maxTorque", js(x.max_torque)}}); }
inline std::string js(const GearJoint& x) { return object({{"ratio", js(x.ratio)}}); }
inline std::string js(const RackJoint& x) { return object({{"radius", js(x.radius)}}); }
inline std::string js(const PulleyJoint& x) { return object({{"groundA", js(x.ground_a)}, {"groundB", js(x.ground_b)}, {"ratio", js(x.ratio)}, {"length", js(x.length)}}); }
inline std::string js(const JointLimit& x) { return object({{"kind", js(x.kind)}, {"axes", js(x.axes)}, {"min", js(x.min)}, {"max", js(x.max)}, {"stiffness", js(x.stiffness)}, {"damping", js(x.damping)}}); }
inline std::string js(const JointDrive& x) { return object({{"kind", js(x.kind)}, {"isAcceleration", js(x.is_acceleration)}, {"axis", js(x.axis)}, {"maxForce", js(x.max_force)}, {"positionTarget", js(x.position_target)}, {"velocityTarget", js(x.velocity_target)}, {"stiffness", js(x.stiffness)}, {"damping", js(x.damping)}}); }
inline std::string js(const GeneralJoint& x) { return object({{"limits", js(x.limits)}, {"drives", js(x.drives)}}); }
inline std::string js(const JointDef& x) { return object({{"bodyA", js(x.body_a)}, {"bodyB", js(x.body_b)}, {"frameA", js(x.frame_a)}, {"frameB", js(x.frame_b)}, {"joint", js(x.joint)}, {"enableCollision", js(x.enable_collision)}, {"breakForce", js(x.break_force)}, {"breakTorque", js(x.break_torque)}, {"solver", js(x.solver)}, {"name", js(x.name)}, {"userData", js(x.user_data)}, {"enabled", js(x.enabled)}}); }
inline std::string js(const DebugLinesDef& x) { return object({{"shapes", js(x.shapes)}, {"bounds", js(x.bounds)}, {"centers", js(x.centers)}, {"velocities", js(x.velocities)}, {"contacts", js(x.contacts)}, {"joints", js(x.joints)}, {"size", js(x.size)}, {"impulseScale", js(x.impulse_scale)}}); }
inline std::string js(const QueryFilter& x) { return object({{"layers", js(x.layers)}, {"ownLayers", js(x.own_layers)}, {"staticBodies", js(x.static_bodies)}, {"kinematicBodies", js(x.kinematic_bodies)}, {"dynamicBodies", js(x.dynamic_bodies)}, {"triggers", js(x.triggers)}, {"any", js(x.any)}, {"ignoredBodies", js(x.ignored_bodies)}}); }
inline std::string js(const WorldDef& x) { return object({{"gravity", js(x.gravity)}, {"substeps", js(x.substeps)}, {"adaptiveSubsteps", js(x.adaptive_substeps)}, {"integrator", js(x.integrator)}, {"enableSleep", js(x.enable_sleep)}, {"sleepSpeed", js(x.sleep_speed)}, {"sleepTime", js(x.sleep_time)}, {"restitutionSpeed", js(x.restitution_speed)}, {"hitSpeed", js(x.hit_speed)}, {"recoverySpeed", js(x.recovery_speed)}, {"maxLinearSpeed", js(x.max_linear_speed)}, {"maxAngularSpeed", js(x.max_angular_speed)}}); }
inline std::string js(const ForceField& x) { return object({{"kind", js(x.kind)}, {"direction", js(x.direction)}, {"center", js(x.center)}, {"strength", js(x.strength)}, {"exponent", js(x.exponent)}, {"isForce", js(x.is_force)}, {"halfExtents", js(x.half_extents)}, {"density", js(x.density)}, {"drag", js(x.drag)}, {"skinFriction", js(x.skin_friction)}, {"addedMass", js(x.added_mass)}, {"waveDamping", js(x.wave_damping)}}); }
inline std::string js(const Shape& x) {
    constexpr const char* kinds[] = {"sphere", "box", "plane", "capsule", "cylinder", "hull", "mesh", "heightField"};
    return of_kind(kinds[x.index()], std::visit([](const auto& y) { return js(y); }, x));
}
inline std::string js(const Joint& x) {
    constexpr const char* kinds[] = {"fixed", "ball", "hinge", "slider", "cylindrical", "universal", "distance", "wheel", "servo", "gear", "rack", "pulley", "general"};
    return of_kind(kinds[x.index()], std::visit([](const auto& y) { return js(y); }, x));
}

class RecordedBody;

class RecordedWorld : public Recording {
  public:
    using Recording::Recording;
    RecordedBody body(BodyId body);
    auto add_shape(BodyId body, const Shape& shape, const ShapeDef& def = {}) {
        const auto answer = world_.add_shape(body, shape, def);
        note("keep(" + name(answer) + ", " + "world.addShape(" + js(body) + ", " + js(shape) + ", " + js(def) + ")" + ");");
        return answer;
    }
    auto remove_shape(ShapeId shape) {
        world_.remove_shape(shape);
        note("world.removeShape(" + js(shape) + ")" + ";");
    }
    auto set_shape(ShapeId shape, const Shape& geometry) {
        world_.set_shape(shape, geometry);
        note("world.setShape(" + js(shape) + ", " + js(geometry) + ")" + ";");
    }
    auto set_shape_def(ShapeId shape, const ShapeDef& def) {
        world_.set_shape_def(shape, def);
        note("world.setShapeDef(" + js(shape) + ", " + js(def) + ")" + ";");
    }
    auto body_of(ShapeId shape) const { return world_.body_of(shape); }
    auto shape(ShapeId shape) const { return world_.shape(shape); }
    auto shape_def(ShapeId shape) const { return world_.shape_def(shape); }
    auto shape_transform(ShapeId shape) const { return world_.shape_transform(shape); }
    auto shape_bounds(ShapeId shape) const { return world_.shape_bounds(shape); }
    auto set_material(ShapeId shape, const Material& material) {
        world_.set_material(shape, material);
        note("world.setMaterial(" + js(shape) + ", " + js(material) + ")" + ";");
    }
    auto set_filter(ShapeId shape, const CollisionFilter& filter) {
        world_.set_filter(shape, filter);
        note("world.setFilter(" + js(shape) + ", " + js(filter) + ")" + ";");
    }
    auto set_surface_velocity(ShapeId shape, const Vec3& velocity) {
        world_.set_surface_velocity(shape, velocity);
        note("world.setSurfaceVelocity(" + js(shape) + ", " + js(velocity) + ")" + ";");
    }
    auto create_body(const BodyDef& def = {}) {
        const auto answer = world_.create_body(def);
        note("keep(" + name(answer) + ", " + "world.createBody(" + js(def) + ")" + ".id);");
        return answer;
    }
    auto destroy_body(BodyId body) {
        world_.destroy_body(body);
        note("world.destroyBody(" + js(body) + ")" + ";");
    }
    auto bodies() const { return world_.bodies(); }
    auto find_body(std::string_view name) const { return world_.find_body(name); }
    auto create_joint(const JointDef& def) {
        const auto answer = world_.create_joint(def);
        note("keep(" + name(answer) + ", " + "world.createJoint(" + js(def) + ")" + ");");
        return answer;
    }
    auto joint_at(BodyId body_a, BodyId body_b, const Position& anchor, const Vec3& axis, const Joint& joint) const { return world_.joint_at(body_a, body_b, anchor, axis, joint); }
    auto destroy_joint(JointId joint) {
        world_.destroy_joint(joint);
        note("world.destroyJoint(" + js(joint) + ")" + ";");
    }
    auto joint_def(JointId joint) const { return world_.joint_def(joint); }
    auto set_joint(JointId id, const Joint& joint) {
        world_.set_joint(id, joint);
        note("world.setJoint(" + js(id) + ", " + js(joint) + ")" + ";");
    }
    auto set_joint_strength(JointId joint, float break_force, float break_torque) {
        world_.set_joint_strength(joint, break_force, break_torque);
        note("world.setJointStrength(" + js(joint) + ", " + js(break_force) + ", " + js(break_torque) + ")" + ";");
    }
    auto set_joint_enabled(JointId joint, bool enabled) {
        world_.set_joint_enabled(joint, enabled);
        note("world.setJointEnabled(" + js(joint) + ", " + js(enabled) + ")" + ";");
    }
    auto joint_state(JointId joint) const { return world_.joint_state(joint); }
    auto joints() const { return world_.joints(); }
    auto joints(BodyId body) const { return world_.joints(body); }
    auto find_joint(std::string_view name) const { return world_.find_joint(name); }
    auto cast_ray(const Position& origin, const Vec3& direction, double max_distance, const QueryFilter& filter = {}) const { return world_.cast_ray(origin, direction, max_distance, filter); }
    auto cast_ray_all(const Position& origin, const Vec3& direction, double max_distance, const QueryFilter& filter = {}) const { return world_.cast_ray_all(origin, direction, max_distance, filter); }
    auto cast_shape(const Shape& shape, const Transform& start, const Vec3& translation, const QueryFilter& filter = {}) const { return world_.cast_shape(shape, start, translation, filter); }
    auto closest_point(const Position& point, double max_distance, const QueryFilter& filter = {}) const { return world_.closest_point(point, max_distance, filter); }
    auto overlap(const Shape& shape, const Transform& pose, const QueryFilter& filter = {}) const { return world_.overlap(shape, pose, filter); }
    auto overlap_bounds(const Bounds& bounds, const QueryFilter& filter = {}) const { return world_.overlap_bounds(bounds, filter); }
    auto broad_phase_nodes(int max_depth, int max_count) const { return world_.broad_phase_nodes(max_depth, max_count); }
    auto solver_contacts() const { return world_.solver_contacts(); }
    auto debug_lines(const DebugLinesDef& what = {}) const { return world_.debug_lines(what); }
    auto contact_begins() const { return world_.contact_begins(); }
    auto contact_ends() const { return world_.contact_ends(); }
    auto contact_hits() const { return world_.contact_hits(); }
    auto trigger_events() const { return world_.trigger_events(); }
    auto joint_events() const { return world_.joint_events(); }
    auto sleep_events() const { return world_.sleep_events(); }
    auto contacts() const { return world_.contacts(); }
    auto contacts(BodyId body) const { return world_.contacts(body); }
    auto settings() const { return world_.settings(); }
    auto set_settings(const WorldDef& def) {
        world_.set_settings(def);
        note("world.settings = " + js(def) + ";");
    }
    auto usual_substeps(float dt) const { return world_.usual_substeps(dt); }
    auto set_threads(int count) {
        world_.set_threads(count);
        note("world.threads = " + js(count) + ";");
    }
    auto threads() const { return world_.threads(); }
    auto add_force_field(const ForceField& field) {
        const auto answer = world_.add_force_field(field);
        note("keep(" + name(answer) + ", " + "world.addForceField(" + js(field) + ")" + ");");
        return answer;
    }
    auto set_force_field(ForceFieldId id, const ForceField& field) {
        world_.set_force_field(id, field);
        note("world.setForceField(" + js(id) + ", " + js(field) + ")" + ";");
    }
    auto remove_force_field(ForceFieldId id) {
        world_.remove_force_field(id);
        note("world.removeForceField(" + js(id) + ")" + ";");
    }
    auto force_field(ForceFieldId id) const { return world_.force_field(id); }
    auto force_fields() const { return world_.force_fields(); }
    auto step_count() const { return world_.step_count(); }
    auto time() const { return world_.time(); }
    auto kinetic_energy() const { return world_.kinetic_energy(); }
    auto potential_energy() const { return world_.potential_energy(); }
    auto linear_momentum() const { return world_.linear_momentum(); }
    auto angular_momentum() const { return world_.angular_momentum(); }
    auto state_hash() const { return world_.state_hash(); }
    auto statistics() const { return world_.statistics(); }
};

class RecordedBody : public RecordedBodyBase {
  public:
    using RecordedBodyBase::RecordedBodyBase;
    auto type() const { return real().type(); }
    auto name() const { return real().name(); }
    auto user_data() const { return real().user_data(); }
    auto position() const { return real().position(); }
    auto rotation() const { return real().rotation(); }
    auto transform() const { return real().transform(); }
    auto center_of_mass() const { return real().center_of_mass(); }
    auto linear_velocity() const { return real().linear_velocity(); }
    auto angular_velocity() const { return real().angular_velocity(); }
    auto velocity_at(const Position& point) const { return real().velocity_at(point); }
    auto mass() const { return real().mass(); }
    auto mass_properties() const { return real().mass_properties(); }
    auto world_inertia() const { return real().world_inertia(); }
    auto angular_momentum() const { return real().angular_momentum(); }
    auto kinetic_energy() const { return real().kinetic_energy(); }
    auto gravity_scale() const { return real().gravity_scale(); }
    auto linear_damping() const { return real().linear_damping(); }
    auto angular_damping() const { return real().angular_damping(); }
    auto is_awake() const { return real().is_awake(); }
    auto allow_sleep() const { return real().allow_sleep(); }
    auto enabled() const { return real().enabled(); }
    auto shapes() const { return real().shapes(); }
    auto set_transform(const Position& position, const Quat& rotation) {
        real().set_transform(position, rotation);
        note("" + body_text() + ".setTransform(" + js(position) + ", " + js(rotation) + ")" + ";");
    }
    auto set_position(const Position& position) {
        real().set_position(position);
        note("" + body_text() + ".position = " + js(position) + ";");
    }
    auto set_rotation(const Quat& rotation) {
        real().set_rotation(rotation);
        note("" + body_text() + ".rotation = " + js(rotation) + ";");
    }
    auto set_linear_velocity(const Vec3& velocity) {
        real().set_linear_velocity(velocity);
        note("" + body_text() + ".linearVelocity = " + js(velocity) + ";");
    }
    auto set_angular_velocity(const Vec3& velocity) {
        real().set_angular_velocity(velocity);
        note("" + body_text() + ".angularVelocity = " + js(velocity) + ";");
    }
    auto move_to(const Transform& target, float seconds) {
        real().move_to(target, seconds);
        note("" + body_text() + ".moveTo(" + js(target) + ", " + js(seconds) + ")" + ";");
    }
    auto set_gravity_scale(float scale) {
        real().set_gravity_scale(scale);
        note("" + body_text() + ".gravityScale = " + js(scale) + ";");
    }
    auto set_damping(float linear, float angular) {
        real().set_damping(linear, angular);
        note("" + body_text() + ".setDamping(" + js(linear) + ", " + js(angular) + ")" + ";");
    }
    auto set_allow_sleep(bool allow) {
        real().set_allow_sleep(allow);
        note("" + body_text() + ".allowSleep = " + js(allow) + ";");
    }
    auto set_type(BodyType type) {
        real().set_type(type);
        note("" + body_text() + ".type = " + js(type) + ";");
    }
    auto set_enabled(bool enabled) {
        real().set_enabled(enabled);
        note("" + body_text() + ".enabled = " + js(enabled) + ";");
    }
    auto set_name(std::string_view name) {
        real().set_name(name);
        note("" + body_text() + ".name = " + js(name) + ";");
    }
    auto set_mass_properties(const MassProperties& properties) {
        real().set_mass_properties(properties);
        note("" + body_text() + ".massProperties = " + js(properties) + ";");
    }
    auto set_mass_from_shapes(std::optional<float> mass = {}) {
        real().set_mass_from_shapes(mass);
        note("" + body_text() + ".setMassFromShapes(" + js(mass) + ")" + ";");
    }
    auto wake() {
        real().wake();
        note("" + body_text() + ".wake(" + ")" + ";");
    }
    auto sleep() {
        real().sleep();
        note("" + body_text() + ".sleep(" + ")" + ";");
    }
    auto add_force(const Vec3& force) {
        real().add_force(force);
        note("" + body_text() + ".addForce(" + js(force) + ")" + ";");
    }
    auto add_force_at(const Vec3& force, const Position& point) {
        real().add_force_at(force, point);
        note("" + body_text() + ".addForceAt(" + js(force) + ", " + js(point) + ")" + ";");
    }
    auto add_torque(const Vec3& torque) {
        real().add_torque(torque);
        note("" + body_text() + ".addTorque(" + js(torque) + ")" + ";");
    }
    auto apply_impulse(const Vec3& impulse) {
        real().apply_impulse(impulse);
        note("" + body_text() + ".applyImpulse(" + js(impulse) + ")" + ";");
    }
    auto apply_impulse_at(const Vec3& impulse, const Position& point) {
        real().apply_impulse_at(impulse, point);
        note("" + body_text() + ".applyImpulseAt(" + js(impulse) + ", " + js(point) + ")" + ";");
    }
    auto apply_angular_impulse(const Vec3& impulse) {
        real().apply_angular_impulse(impulse);
        note("" + body_text() + ".applyAngularImpulse(" + js(impulse) + ")" + ";");
    }
    auto is_character() const { return real().is_character(); }
    auto character() const { return real().character(); }
    auto set_character(const CharacterDef& def) {
        real().set_character(def);
        note("" + body_text() + ".character = " + js(def) + ";");
    }
    auto remove_character() {
        real().remove_character();
        note("" + body_text() + ".removeCharacter(" + ")" + ";");
    }
    auto walk_velocity() const { return real().walk_velocity(); }
    auto set_walk_velocity(const Vec3& velocity) {
        real().set_walk_velocity(velocity);
        note("" + body_text() + ".walkVelocity = " + js(velocity) + ";");
    }
    auto jump(float speed) {
        real().jump(speed);
        note("" + body_text() + ".jump(" + js(speed) + ")" + ";");
    }
    auto character_state() const { return real().character_state(); }
};

inline RecordedBody RecordedWorld::body(BodyId body) { return {*this, body}; }

} // namespace cairn
