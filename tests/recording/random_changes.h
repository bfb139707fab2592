// Random changes of a world: every call that changes a world is among them.
#pragma once

#include <cairn/cairn.h>

#include <cstdint>
#include <random>
#include <vector>

namespace cairn::test {

inline constexpr float dt = 1.0f / 60.0f; // length of a step, s

class RandomChanges {
  public:
    explicit RandomChanges(std::uint32_t seed) : random_(seed) {}

    // One call with valid arguments; mostly steps if `steps` is set.
    void change(World& world, bool steps = true);
    // Creates bodies, shapes of every kind, joints and a force field, so that `change` finds something to change.
    void populate(World& world);

  private:
    int pick(int count) { return int(random_() % std::uint32_t(count)); }
    float number(float most) { return most * (float(random_() % 2001) / 1000.0f - 1.0f); }
    Vec3 vector(float most) {
        const float x = number(most), y = number(most), z = number(most);
        return {x, y, z};
    }
    Position place() {
        const Vec3 v = vector(3.0f);
        return {double(v.x), double(v.y) + 4.0, double(v.z)};
    }
    Quat rotation() {
        const Vec3 v = vector(1.0f);
        return {1.0f, v.x, v.y, v.z};
    }
    Shape solid();
    Joint joint();
    void create(World& world);
    void change_character(Body body);
    void change_body(World& world, BodyId id);
    void change_shapes(World& world, BodyId id);
    void change_joints(World& world);
    void change_world(World& world);

    std::mt19937 random_;
    std::vector<ForceFieldId> fields_;
};

} // namespace cairn::test
