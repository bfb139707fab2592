// Shared by the tests of characters.
#pragma once

#include <cairn/cairn.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cairn_test {

using namespace cairn;

inline constexpr float frame = 1.0f / 60.0f; // s

class Chance {
  public:
    explicit Chance(unsigned seed) : random_(seed) {}
    double between(double a, double b) { return a + (b - a) * (double(random_()) / 4294967295.0); }
    // A random unit vector in the horizontal plane.
    Vec3 heading() {
        const double angle = between(0, 2 * 3.14159265358979);
        return {float(std::cos(angle)), 0, float(std::sin(angle))};
    }

  private:
    std::mt19937 random_;
};

inline Quat about_up(double angle) { return Quat(float(std::cos(0.5 * angle)), 0, float(std::sin(0.5 * angle)), 0); }

inline BodyId add_body(World& world, BodyType type, const Position& position, const Shape& shape,
                       const ShapeDef& def = {}, const Quat& rotation = Quat(1, 0, 0, 0)) {
    BodyDef body;
    body.type = type, body.position = position, body.rotation = rotation;
    const BodyId id = world.create_body(body);
    world.add_shape(id, shape, def);
    return id;
}

inline BodyId add_fixed(World& world, const Position& position, const Shape& shape,
                        const Quat& rotation = Quat(1, 0, 0, 0)) {
    return add_body(world, BodyType::static_, position, shape, {}, rotation);
}

inline BodyId add_floor(World& world) { return add_fixed(world, {0, 0, 0}, Plane{}); }

inline constexpr float half_height = 0.5f, radius = 0.3f, foot = half_height + radius; // of the default capsule, m
inline constexpr float usual_skin = 0.02f;

// Adds a character that stands at `feet`, one skin width above it.
inline BodyId add_character(World& world, const Position& feet, const CharacterDef& def = {},
                            const Shape& shape = Capsule{half_height, radius}) {
    const BodyId id =
        add_body(world, BodyType::kinematic, feet + Position(0, double(foot) + double(def.skin), 0), shape);
    world.body(id).set_character(def);
    return id;
}

inline Position feet_of(const World& world, BodyId character) {
    return world.body(character).position() - Position(0, double(foot + usual_skin), 0);
}

inline void run(World& world, int steps, float dt = frame) {
    for (int i = 0; i < steps; ++i) world.step(dt);
}

inline bool stands(const World& world, BodyId character) {
    return world.body(character).character_state().support == CharacterSupport::ground;
}

// Whether a shape at the pose of the character overlaps any other body.
inline bool overlaps_something(const World& world, BodyId character,
                               const Shape& shape = Capsule{half_height, radius}) {
    for (const ShapeId s : world.overlap(shape, world.body(character).transform()))
        if (world.body_of(s) != character) return true;
    return false;
}

} // namespace cairn_test
