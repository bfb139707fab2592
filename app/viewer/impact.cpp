#include "viewer/impact.h"

#include "viewer/inspect.h"
#include "viewer/world_state.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cairn::viewer {

namespace {

// Computes r and the quantities that depend on it, for the present pose of the body.
void read_arm(ImpactSide& side, const Body& body, const Position& point, const Vec3& normal) {
    side.arm = Vec3(point - body.center_of_mass());
    side.at_point = side.velocity + glm::cross(side.angular_velocity, side.arm);
    if (!can_be_pushed(body)) return;
    side.inverse_mass = 1.0 / double(body.mass());
    const Vec3 turn = glm::inverse(body.world_inertia()) * glm::cross(side.arm, normal);
    side.turn_term = double(glm::dot(normal, glm::cross(turn, side.arm)));
}

// Equations 4.12 and 4.13, which differ in the sign of the impulse.
void apply_formula(ImpactSide& side, const Body& body, const Vec3& impulse) {
    side.velocity_then = side.velocity;
    side.turning_then = side.angular_velocity;
    if (side.inverse_mass == 0.0) return;
    side.velocity_then += impulse * float(side.inverse_mass);
    side.turning_then += glm::inverse(body.world_inertia()) * glm::cross(side.arm, impulse);
}

} // namespace

double restitution_between(const Material& a, const Material& b) {
    const double first = double(a.restitution), second = double(b.restitution);
    switch (std::min(a.restitution_combine, b.restitution_combine)) {
    case CombineRule::average:
        return 0.5 * (first + second);
    case CombineRule::minimum:
        return std::min(first, second);
    case CombineRule::maximum:
        return std::max(first, second);
    case CombineRule::multiply:
        break;
    }
    return first * second;
}

Impact explain_impact(World& world, const KnownHit& known, float step_length) {
    const ContactHit& hit = known.hit;
    Impact impact;
    impact.step = known.step;
    impact.time = double(hit.time);
    impact.point = hit.point;
    impact.normal = hit.normal; // points from body A to B, so the formula's first body is B
    impact.first.body = hit.body_b;
    impact.second.body = hit.body_a;
    if (!can_be_pushed(world.body(hit.body_b))) {
        std::swap(impact.first, impact.second);
        impact.normal = -impact.normal;
    }
    ImpactSide* const sides[] = {&impact.first, &impact.second};
    for (ImpactSide* side : sides) {
        const Body body = world.body(side->body);
        side->name = label_of(side->body, body.name());
        side->velocity = body.linear_velocity();
        side->angular_velocity = body.angular_velocity();
    }
    impact.restitution =
        restitution_between(world.shape_def(hit.shape_a).material, world.shape_def(hit.shape_b).material);
    world.step(step_length);
    // The contact point is where the bodies met during the step, so the arms are taken after the step.
    for (ImpactSide* side : sides) read_arm(*side, world.body(side->body), impact.point, impact.normal);
    impact.relative_speed = double(glm::dot(impact.normal, impact.first.at_point - impact.second.at_point));
    impact.denominator =
        impact.first.inverse_mass + impact.second.inverse_mass + impact.first.turn_term + impact.second.turn_term;
    impact.impulse =
        impact.denominator > 0.0 ? -(1.0 + impact.restitution) * impact.relative_speed / impact.denominator : 0.0;
    for (ImpactSide* side : sides) {
        const Body body = world.body(side->body);
        apply_formula(*side, body, impact.normal * float(side == &impact.first ? impact.impulse : -impact.impulse));
        side->velocity_after = body.linear_velocity();
        side->turning_after = body.angular_velocity();
    }
    const Body first = world.body(impact.first.body);
    const Vec3 gravity = world.settings().gravity * (first.gravity_scale() * step_length);
    const Vec3 gained = impact.first.velocity_after - impact.first.velocity - gravity;
    if (impact.first.inverse_mass > 0.0)
        impact.given = double(glm::dot(gained, impact.normal)) / impact.first.inverse_mass;
    return impact;
}

} // namespace cairn::viewer
