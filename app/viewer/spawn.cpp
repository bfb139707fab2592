#include "viewer/spawn.h"

#include <algorithm>

namespace cairn::viewer {

namespace {

constexpr int most_tries = 256;

Shape shape_of(const SpawnSettings& settings) {
    const float half = 0.5f * settings.size;
    if (settings.kind == SpawnSettings::Kind::sphere) return Sphere{half};
    return Box{Vec3(half)};
}

} // namespace

SpawnSettings box_preset() { return {}; }

SpawnSettings large_sphere_preset() {
    SpawnSettings settings;
    settings.kind = SpawnSettings::Kind::sphere;
    settings.size = 1.0f;
    return settings;
}

SpawnSettings small_sphere_preset() {
    SpawnSettings settings = large_sphere_preset();
    settings.size = 0.4f;
    return settings;
}

BodyId spawn(World& world, const SpawnSettings& settings, const Position& position, const Vec3& velocity) {
    BodyDef def;
    def.position = position;
    def.linear_velocity = velocity;
    ShapeDef shape;
    shape.density = settings.density;
    shape.material.static_friction = shape.material.dynamic_friction = settings.friction;
    shape.material.restitution = settings.restitution;
    const BodyId body = world.create_body(def);
    try {
        world.add_shape(body, shape_of(settings), shape);
    } catch (const Error&) {
        world.destroy_body(body);
        throw;
    }
    return body;
}

Position free_place(const World& world, const SpawnSettings& settings, const Position& wanted) {
    Position place = wanted;
    for (int i = 0; i < most_tries; ++i) {
        if (world.overlap(shape_of(settings), Transform{place, Quat(1.0f, 0.0f, 0.0f, 0.0f)}).empty()) return place;
        place.y += 0.5 * double(settings.size);
    }
    return place;
}

} // namespace cairn::viewer
