#include "viewer/inspect.h"

#include "viewer/scaling.h"
#include "viewer/world_state.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cairn::viewer {

namespace {

constexpr MaterialPreset presets[] = {{"rubber on dry concrete", 1.0f, 0.7f},
                                      {"rubber on wet concrete", 0.7f, 0.5f},
                                      {"shoes on wood", 0.9f, 0.7f},
                                      {"steel on steel, dry", 0.6f, 0.3f},
                                      {"wood on wood", 0.5f, 0.3f},
                                      {"metal on wood", 0.5f, 0.3f},
                                      {"steel on ice", 0.4f, 0.02f},
                                      {"waxed wood on wet snow", 0.14f, 0.1f},
                                      {"ice on ice", 0.1f, 0.03f},
                                      {"steel on steel, oiled", 0.05f, 0.03f},
                                      {"Teflon on steel", 0.04f, 0.04f}};

struct KindOf {
    const char* operator()(const Sphere&) const { return "sphere"; }
    const char* operator()(const Box&) const { return "box"; }
    const char* operator()(const Plane&) const { return "plane"; }
    const char* operator()(const Capsule&) const { return "capsule"; }
    const char* operator()(const Cylinder&) const { return "cylinder"; }
    const char* operator()(const Hull&) const { return "hull"; }
    const char* operator()(const Mesh&) const { return "mesh"; }
    const char* operator()(const HeightField&) const { return "height field"; }
};

void read_touches(BodyFacts& facts, const World& world, double step_length) {
    for (const Contact& contact : world.contacts(facts.id)) {
        const BodyId other = contact.body_a == facts.id ? contact.body_b : contact.body_a;
        auto touch = std::find_if(facts.touches.begin(), facts.touches.end(),
                                  [&](const BodyFacts::Touch& known) { return known.other == other; });
        if (touch == facts.touches.end()) {
            const std::string& name = world.body(other).name();
            facts.touches.push_back({other, label_of(other, name)});
            touch = std::prev(facts.touches.end());
        }
        touch->points += contact.point_count;
        for (int i = 0; i < contact.point_count; ++i)
            touch->normal_force += contact.points[i].normal_impulse / float(step_length);
        touch->friction_force += glm::length(contact.friction_impulse) / float(step_length);
    }
}

struct CarryOut {
    World& world;
    Body body;

    void operator()(const edit::Name& name) { body.set_name(name.name); }
    void operator()(const edit::Type& type) { body.set_type(type.type); }
    void operator()(const edit::Mass& mass) { body.set_mass_from_shapes(mass.mass); }
    void operator()(const edit::Place& place) { body.set_position(place.position); }
    void operator()(const edit::Pose& pose) {
        body.set_transform(pose.position, pose.rotation);
        if (body.type() == BodyType::static_) return;
        body.set_linear_velocity(Vec3(0.0f));
        body.set_angular_velocity(Vec3(0.0f));
    }
    void operator()(const edit::Scale& scale) {
        scale_body(world, body.id(), scale.factors);
        body.wake();
    }
    void operator()(const edit::Velocity& velocity) { body.set_linear_velocity(velocity.velocity); }
    void operator()(const edit::Turning& angular_velocity) {
        body.set_angular_velocity(angular_velocity.angular_velocity);
    }
    void operator()(const edit::Trigger& trigger) {
        for (const ShapeId shape : body.shapes()) {
            ShapeDef def = world.shape_def(shape);
            def.is_trigger = trigger.on;
            world.set_shape_def(shape, def);
        }
        body.wake();
    }
    void operator()(const edit::Enabled& enabled) { body.set_enabled(enabled.on); }
    void operator()(const edit::Surface& surface) {
        std::vector<BodyId> bodies{body.id()};
        if (surface.also_what_it_touches)
            for (const Contact& contact : world.contacts(body.id()))
                bodies.push_back(contact.body_a == body.id() ? contact.body_b : contact.body_a);
        for (const BodyId id : bodies)
            for (const ShapeId shape : world.body(id).shapes()) world.set_material(shape, surface.material);
        body.wake();
    }
};

struct EditNames {
    const char* operator()(const edit::Trigger&) const { return "trigger"; }
    const char* operator()(const edit::Enabled&) const { return "enable or disable a body"; }
    const char* operator()(const edit::Name&) const { return "name of a body"; }
    const char* operator()(const edit::Type&) const { return "type of a body"; }
    const char* operator()(const edit::Mass&) const { return "mass of a body"; }
    const char* operator()(const edit::Place&) const { return "position of a body"; }
    const char* operator()(const edit::Pose&) const { return "move or rotate a body"; }
    const char* operator()(const edit::Scale&) const { return "scale a body"; }
    const char* operator()(const edit::Velocity&) const { return "velocity of a body"; }
    const char* operator()(const edit::Turning&) const { return "angular velocity of a body"; }
    const char* operator()(const edit::Surface&) const { return "material"; }
};

} // namespace

bool can_be_pushed(const Body& body) {
    return body.type() == BodyType::dynamic && std::isfinite(body.mass()) && body.enabled();
}

std::optional<BodyFacts> read_facts(const World& world, BodyId id, double step_length) {
    if (!id || !world.is_valid(id)) return std::nullopt;
    const Body body = world.body(id);
    BodyFacts facts;
    facts.id = id;
    facts.name = body.name();
    facts.type = body.type();
    facts.mass = body.mass_properties();
    facts.position = body.position();
    facts.center = body.center_of_mass();
    facts.rotation = body.rotation();
    facts.can_be_stretched = can_be_stretched(world, id);
    facts.velocity = body.linear_velocity();
    facts.angular_velocity = body.angular_velocity();
    facts.is_awake = body.is_awake();
    facts.is_enabled = body.enabled();
    if (can_be_pushed(body)) {
        const double mass = double(facts.mass.mass);
        facts.linear_energy = 0.5 * mass * double(glm::dot(facts.velocity, facts.velocity));
        facts.angular_energy = body.kinetic_energy() - facts.linear_energy;
        facts.potential_energy = -mass * double(body.gravity_scale()) *
                                 glm::dot(glm::dvec3(world.settings().gravity), glm::dvec3(facts.center));
    }
    facts.is_trigger = !body.shapes().empty();
    for (const ShapeId shape : body.shapes()) {
        const ShapeDef& def = world.shape_def(shape);
        facts.is_trigger &= def.is_trigger;
        facts.shapes.push_back({shape, std::visit(KindOf{}, world.shape(shape)), def.material, def.density});
    }
    read_touches(facts, world, step_length);
    return facts;
}

std::span<const MaterialPreset> material_presets() { return presets; }

const char* material_source() { return "OpenStax, University Physics vol. 1 (2016), table 6.1"; }

Material with_preset(Material material, const MaterialPreset& preset) {
    material.static_friction = preset.static_friction;
    material.dynamic_friction = preset.dynamic_friction;
    return material;
}

const char* name_of(const BodyEdit& edit) { return std::visit(EditNames{}, edit); }

void carry_out(World& world, BodyId body, const BodyEdit& edit) { std::visit(CarryOut{world, world.body(body)}, edit); }

BodyId duplicate(World& world, BodyId id, const Position& shift, std::vector<ShapeId>& copies) {
    const Body body = std::as_const(world).body(id);
    BodyDef def;
    def.type = body.type();
    def.position = body.position() + shift;
    def.rotation = body.rotation();
    def.linear_velocity = body.linear_velocity();
    def.angular_velocity = body.angular_velocity();
    def.linear_damping = body.linear_damping();
    def.angular_damping = body.angular_damping();
    def.gravity_scale = body.gravity_scale();
    def.allow_sleep = body.allow_sleep();
    def.name = body.name();
    def.user_data = body.user_data();
    def.enabled = body.enabled();
    if (def.type == BodyType::dynamic) def.mass_properties = body.mass_properties();
    const std::vector<ShapeId> shapes = body.shapes();
    const BodyId copy = world.create_body(def);
    for (const ShapeId shape : shapes)
        copies.push_back(world.add_shape(copy, world.shape(shape), world.shape_def(shape)));
    if (body.is_character()) {
        world.body(copy).set_character(body.character());
        world.body(copy).set_walk_velocity(body.walk_velocity());
    }
    return copy;
}

} // namespace cairn::viewer
