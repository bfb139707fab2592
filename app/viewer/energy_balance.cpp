#include "viewer/energy_balance.h"

#include "viewer/inspect.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace cairn::viewer {

namespace {

double energy_of(const World& world, const Body& body) {
    if (!can_be_pushed(body)) return 0.0;
    return body.kinetic_energy() - double(body.mass()) * double(body.gravity_scale()) *
                                       glm::dot(glm::dvec3(world.settings().gravity), body.center_of_mass());
}

// The friction center: the mean of the contact points, weighted by normal impulse.
Position middle_of(const Contact& contact, float& normal_impulse) {
    Position sum(0.0);
    normal_impulse = 0.0f;
    for (int i = 0; i < contact.point_count; ++i) {
        normal_impulse += contact.points[i].normal_impulse;
        sum += contact.points[i].point * double(contact.points[i].normal_impulse);
    }
    return normal_impulse > 0.0f ? sum / double(normal_impulse) : contact.points[0].point;
}

} // namespace

// The impulse and work on one body in a step, as far as their causes are known.
struct EnergyBalance::Work {
    glm::dvec3 impulse{0.0, 0.0, 0.0};                  // N s, from contacts and joints
    double friction = 0.0, joints = 0.0, scenery = 0.0; // J
    bool touches = false, is_hit = false;
};

const EnergyBalance::Before* EnergyBalance::known(BodyId body) const {
    if (!body || body.index() >= bodies_.size() || bodies_[body.index()].id != body) return nullptr;
    return &bodies_[body.index()];
}

void EnergyBalance::before_step(const World& world) {
    bodies_.clear();
    energy_ = world.kinetic_energy() + world.potential_energy();
    for (const BodyId id : world.bodies()) {
        const Body body = world.body(id);
        if (id.index() >= bodies_.size()) bodies_.resize(id.index() + 1);
        bodies_[id.index()] = {id, body.linear_velocity(), body.angular_velocity(), energy_of(world, body)};
    }
}

glm::dvec3 EnergyBalance::mean_turning(const World& world, BodyId id) const {
    const Before* before = known(id);
    return before ? glm::dvec3(before->angular_velocity + world.body(id).angular_velocity()) * 0.5 : glm::dvec3(0.0);
}

glm::dvec3 EnergyBalance::mean_velocity(const World& world, BodyId id, const Position& point) const {
    const Before* before = known(id);
    if (!before) return glm::dvec3(0.0);
    const Body body = world.body(id);
    return glm::dvec3(before->velocity + body.linear_velocity()) * 0.5 +
           glm::cross(mean_turning(world, id), point - body.center_of_mass());
}

void EnergyBalance::add_contact(const World& world, const Contact& contact, std::vector<Work>& works,
                                EnergyFlow& flow) const {
    float normal_impulse = 0.0f;
    const Position middle = middle_of(contact, normal_impulse);
    const glm::dvec3 friction(contact.friction_impulse);
    const glm::dvec3 normal = glm::dvec3(contact.normal) * double(normal_impulse);
    if (normal_impulse == 0.0f && friction == glm::dvec3(0.0)) return;
    const BodyId bodies[] = {contact.body_a, contact.body_b};
    const ShapeId shapes[] = {contact.shape_a, contact.shape_b};
    glm::dvec3 velocities[2];
    for (int i = 0; i < 2; ++i) {
        const Body body = world.body(bodies[i]);
        velocities[i] = mean_velocity(world, bodies[i], middle);
        if (!can_be_pushed(body)) // a conveyor's surface moves although its body does not
            velocities[i] += glm::dvec3(
                body.rotation() * (world.shape_def(shapes[i]).rotation * world.shape_def(shapes[i]).surface_velocity));
    }
    flow.friction -= glm::dot(friction, velocities[1] - velocities[0]);
    for (int i = 0; i < 2; ++i) {
        if (!known(bodies[i]) || !can_be_pushed(world.body(bodies[i]))) continue;
        const double sign = i == 1 ? 1.0 : -1.0;
        Work& work = works[bodies[i].index()];
        work.touches = true;
        work.impulse += sign * (friction + normal);
        work.friction += sign * glm::dot(friction, velocities[i]);
        if (can_be_pushed(world.body(bodies[1 - i]))) continue;
        work.scenery += sign * glm::dot(normal, velocities[1 - i]);
        flow.external_work += sign * glm::dot(friction + normal, velocities[1 - i]);
    }
}

void EnergyBalance::add_joint(const World& world, JointId id, double step_length, std::vector<Work>& works,
                              EnergyFlow& flow) const {
    const JointDef& def = world.joint_def(id);
    const JointState state = world.joint_state(id);
    const glm::dvec3 impulse = glm::dvec3(state.force) * step_length, turn = glm::dvec3(state.torque) * step_length;
    Position anchor = def.frame_b.position;
    if (def.body_b) {
        const Transform pose = world.body(def.body_b).transform();
        anchor = pose.position + Position(pose.rotation * Vec3(def.frame_b.position));
    }
    for (const BodyId body : {def.body_a, def.body_b}) {
        if (!known(body) || !can_be_pushed(world.body(body))) continue;
        const double sign = body == def.body_b ? 1.0 : -1.0;
        const double done =
            sign * (glm::dot(impulse, mean_velocity(world, body, anchor)) + glm::dot(turn, mean_turning(world, body)));
        works[body.index()].impulse += sign * impulse;
        works[body.index()].joints += done;
        flow.external_work += done;
    }
}

EnergyFlow EnergyBalance::after_step(const World& world, double step_length, double previous) const {
    std::vector<Work> works(bodies_.size());
    EnergyFlow flow;
    flow.external_work = energy_ - previous;
    for (const Contact& contact : world.contacts()) add_contact(world, contact, works, flow);
    for (const JointId id : world.joints()) add_joint(world, id, step_length, works, flow);
    // After a collision the bodies may already have separated, and then no contact has the impulse.
    const auto hit = [&](BodyId id) {
        if (known(id)) works[id.index()].touches = works[id.index()].is_hit = true;
    };
    const auto hit_both = [&](const auto& events) {
        for (const auto& event : events) {
            hit(event.body_a);
            hit(event.body_b);
        }
    };
    hit_both(world.contact_begins());
    hit_both(world.contact_ends());
    hit_both(world.contact_hits());
    for (const Before& before : bodies_) {
        if (!before.id || !world.is_valid(before.id)) continue;
        const Body body = world.body(before.id);
        if (!can_be_pushed(body) || !body.is_awake()) continue;
        const Work& work = works[before.id.index()];
        const double mass = double(body.mass());
        const glm::dvec3 mean = glm::dvec3(before.velocity + body.linear_velocity()) * 0.5;
        const glm::dvec3 gained = glm::dvec3(body.linear_velocity() - before.velocity) * mass;
        const glm::dvec3 gravity =
            glm::dvec3(world.settings().gravity) * (double(body.gravity_scale()) * mass * step_length);
        const double fields = work.is_hit ? 0.0 : glm::dot(gained - gravity - work.impulse, mean); // and damping
        flow.external_work += fields;
        if (!work.touches) continue;
        const double explained = work.friction + work.joints + work.scenery + fields;
        flow.impacts -= energy_of(world, body) - before.energy - explained;
    }
    return flow;
}

} // namespace cairn::viewer
