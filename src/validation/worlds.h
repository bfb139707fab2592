// Small worlds for measurements: a ground, bodies on slopes, and running for some steps. Used by the cases and by the
// physics tests.
#pragma once

#include <cairn/cairn.h>

#include <algorithm>
#include <cmath>

namespace cairn::validation {

inline constexpr double pi = 3.14159265358979323846;
inline const double gravity = double(9.81f); // the world's default gravity as a float, m/s^2

inline double radians(double degrees) { return degrees * pi / 180; }

inline WorldDef without_gravity() {
    WorldDef def;
    def.gravity = {0, 0, 0};
    return def;
}
inline WorldDef without_sleep() {
    WorldDef def;
    def.enable_sleep = false;
    return def;
}

inline Material surface(float friction, float restitution = 0) {
    Material material;
    material.static_friction = material.dynamic_friction = friction;
    material.restitution = restitution;
    return material;
}

// Material for rolling bodies with point contacts: friction, but no torsional friction about the normal.
inline Material rough() {
    Material material = surface(1);
    material.torsional_friction = 0;
    return material;
}

inline BodyId add_body(World& world, const Shape& shape, const BodyDef& def, const Material& material = {}) {
    const BodyId body = world.create_body(def);
    ShapeDef shape_def;
    shape_def.material = material;
    world.add_shape(body, shape, shape_def);
    return body;
}

// An infinite plane through the origin that descends towards +x at the given angle.
struct Slope {
    double angle = 0; // radians

    glm::dvec3 downhill() const { return {std::cos(angle), -std::sin(angle), 0}; }
    glm::dvec3 normal() const { return {std::sin(angle), std::cos(angle), 0}; }
    Quat rotation() const { return glm::angleAxis(float(-angle), Vec3(0, 0, 1)); }
    BodyId add_to(World& world, const Material& material = {}) const {
        BodyDef def;
        def.type = BodyType::static_;
        return add_body(world, Plane{Vec3(normal()), {1, 0, 0}, {}}, def, material);
    }
};

inline BodyId add_ground(World& world, const Material& material = {}) { return Slope{}.add_to(world, material); }

inline void run(World& world, float dt, int steps) {
    for (int i = 0; i < steps; ++i) world.step(dt);
}

// Sum of the normal impulses of a contact, N s.
inline double normal_impulse(const Contact& contact) {
    double sum = 0;
    for (int i = 0; i < contact.point_count; ++i) sum += double(contact.points[i].normal_impulse);
    return sum;
}

// Greatest penetration over all current contacts, m.
inline double deepest_overlap(const World& world) {
    double deepest = 0;
    for (const Contact& contact : world.contacts())
        for (int i = 0; i < contact.point_count; ++i)
            deepest = std::max(deepest, -double(contact.points[i].separation));
    return deepest;
}

} // namespace cairn::validation
