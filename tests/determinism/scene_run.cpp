#include "scene_run.h"

#include "scene_tools.h"

#include <algorithm>
#include <utility>

namespace cairn_test {

using namespace cairn;

namespace {

constexpr int kick_step = golden_steps / 2;

BodyState state_of(const Body& body) {
    BodyState state;
    state.exists = true;
    state.type = body.type();
    state.is_awake = body.is_awake();
    state.mass = double(body.mass());
    state.kinetic_energy = body.kinetic_energy();
    state.position = body.position();
    state.center = body.center_of_mass();
    state.rotation = body.rotation();
    state.velocity = body.linear_velocity();
    state.spin = body.angular_velocity();
    if (state.is_dynamic()) state.angular_momentum = body.angular_momentum();
    return state;
}

// Moving planes and rectangles push a body that reaches their back out to their front, however deep it is.
bool is_moving_plane(World& world, BodyId body, ShapeId shape) {
    return world.body(body).type() == BodyType::kinematic && std::holds_alternative<Plane>(world.shape(shape));
}

StepState state_of(World& world) {
    StepState state;
    for (const BodyId id : world.bodies()) {
        if (state.bodies.size() <= id.index()) state.bodies.resize(id.index() + 1);
        state.bodies[id.index()] = state_of(world.body(id));
    }
    state.energy = world.kinetic_energy() + world.potential_energy();
    state.momentum = world.linear_momentum();
    for (const Contact& contact : world.contacts()) {
        if (is_moving_plane(world, contact.body_a, contact.shape_a) ||
            is_moving_plane(world, contact.body_b, contact.shape_b))
            continue;
        for (int i = 0; i < contact.point_count; ++i)
            state.overlap = std::max(state.overlap, -double(contact.points[i].separation));
    }
    for (const JointId id : world.joints()) {
        const JointState joint = world.joint_state(id);
        state.gap = std::max(state.gap, double(joint.linear_error));
        state.twist = std::max(state.twist, double(joint.angular_error));
    }
    return state;
}

WorldDef settings_with(WorldDef def, Fault fault) {
    if (fault == Fault::half_gravity) def.gravity *= 0.5f;
    if (fault == Fault::no_sleep) def.enable_sleep = false;
    if (fault == Fault::coarse) def.substeps = 1, def.adaptive_substeps = false;
    return def;
}

Material material_with(Material material, Fault fault) {
    if (fault == Fault::no_friction)
        material.static_friction = material.dynamic_friction = material.rolling_friction = material.torsional_friction =
            0;
    if (fault == Fault::bouncy) material.restitution = 1, material.restitution_combine = CombineRule::maximum;
    return material;
}

// Applied in every step, since scenes create and change shapes while they run; but only to shapes that differ, since a
// change wakes the body.
void put_into_shapes(World& world, Fault fault) {
    for (const BodyId id : world.bodies())
        for (const ShapeId shape : world.body(id).shapes()) {
            const ShapeDef def = world.shape_def(shape);
            const Material material = material_with(def.material, fault);
            if (material.static_friction != def.material.static_friction ||
                material.restitution != def.material.restitution)
                world.set_material(shape, material);
            const bool meets_nothing = fault == Fault::no_contacts || (fault == Fault::deaf_triggers && def.is_trigger);
            if (meets_nothing && def.filter.collides_with != 0)
                world.set_filter(shape, CollisionFilter{def.filter.layers, 0});
        }
}

// The number of shapes in triggers.
int count_in_triggers(World& world) {
    int count = 0;
    for (const BodyId id : world.bodies())
        for (const ShapeId shape : world.body(id).shapes()) {
            if (!world.shape_def(shape).is_trigger) continue;
            for (const ShapeId found : world.overlap(world.shape(shape), world.body(id).transform()))
                count += world.body(world.body_of(found)).type() != BodyType::static_ ||
                         world.body(id).type() != BodyType::static_;
        }
    return count;
}

// Every second joint, except those that a scene finds by name.
void weaken_joints(World& world) {
    const std::vector<JointId> joints = world.joints();
    for (std::size_t i = 0; i < joints.size(); i += 2)
        if (world.joint_def(joints[i]).name.empty()) world.set_joint_strength(joints[i], 1000, 1000);
}

void kick(World& world) {
    Numbers numbers(51);
    for (const BodyId id : world.bodies()) {
        Body body = world.body(id);
        const Vec3 velocity = 30.0f * numbers.vector();
        if (body.type() == BodyType::dynamic) body.set_linear_velocity(body.linear_velocity() + velocity);
    }
}

} // namespace

const char* name_of(Fault fault) {
    static const char* const names[] = {"none",          "half_gravity", "no_friction", "bouncy",
                                        "no_contacts",   "no_sleep",     "coarse",      "slow_clock",
                                        "deaf_triggers", "weak_joints",  "kick"};
    return names[int(fault)];
}

SceneRun run_scene(Scene& scene, Fault fault) {
    SceneRun run{World{settings_with(scene.settings(), fault)}, {}, 0, 0, 0, 0, 0, 0};
    World& world = run.world;
    scene.build(world);
    run.steps.push_back(state_of(world));
    if (fault == Fault::weak_joints) weaken_joints(world);
    for (int i = 0; i < golden_steps; ++i) {
        put_into_shapes(world, fault);
        if (fault == Fault::kick && i == kick_step) kick(world);
        if (i == golden_steps - 1) run.in_triggers = count_in_triggers(world);
        scene.before_step(world);
        world.step(fault == Fault::slow_clock ? 1.0f / 80 : 1.0f / 60);
        for (const TriggerEvent& event : world.trigger_events()) ++(event.inside ? run.entered : run.left);
        for (const JointEvent& event : world.joint_events()) {
            if (!event.broke) continue;
            ++run.broken;
            run.broken_force = event.force;
        }
        run.hits += int(world.contact_hits().size());
        run.steps.push_back(state_of(world));
    }
    return run;
}

} // namespace cairn_test
