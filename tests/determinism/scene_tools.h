// Helpers to build the scenes.
#pragma once

#include "scenes.h"

namespace cairn_test {

// Random numbers by plain integer arithmetic, so that the scenes are the same with every standard library.
class Numbers {
  public:
    explicit Numbers(std::uint32_t seed) : state_(seed) {}
    float next() { // -1 to 1
        state_ = state_ * 1664525u + 1013904223u;
        return float(std::int32_t(state_ >> 8) - (1 << 23)) / float(1 << 23);
    }
    cairn::Vec3 vector() {
        const float x = next(), y = next(), z = next();
        return {x, y, z};
    }
    cairn::Quat rotation() {
        const float x = next(), y = next(), z = next();
        return {1.1f, x, y, z}; // the world normalizes it
    }

  private:
    std::uint32_t state_;
};

inline cairn::BodyId add(cairn::World& world, const cairn::Shape& shape, const cairn::BodyDef& def,
                         const cairn::ShapeDef& shape_def = {}) {
    const cairn::BodyId body = world.create_body(def);
    world.add_shape(body, shape, shape_def);
    return body;
}

inline cairn::BodyId add_fixed(cairn::World& world, const cairn::Shape& shape,
                               const cairn::Position& position = {0, 0, 0}, const cairn::ShapeDef& shape_def = {}) {
    cairn::BodyDef def;
    def.type = cairn::BodyType::static_;
    def.position = position;
    return add(world, shape, def, shape_def);
}

inline cairn::Hull rock(Numbers& numbers, int points) {
    std::vector<cairn::Vec3> cloud;
    for (int i = 0; i < points; ++i) cloud.push_back(0.5f * numbers.vector());
    return cairn::Hull(cloud);
}

// A scene is created once, and has no state that persists between two runs.
template <class T> Scene& make() {
    static T scene;
    return scene;
}

Scene& mixed_pile();
Scene& pyramid();
Scene& dominoes();
Scene& materials();
Scene& tumbler();
Scene& sleep_and_wake();
Scene& compounds();
Scene& free_tops();
Scene& explicit_euler();
Scene& whirl();
Scene& changes();
Scene& all_shapes();
Scene& rounded_shapes();
Scene& surfaces();
Scene& all_joints();
Scene& robots();
Scene& chains();

} // namespace cairn_test
