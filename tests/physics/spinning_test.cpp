// Bodies that spin fast about no principal axis while they touch something: what turns them changes within the step.
#include "support.h"

#include <algorithm>
#include <random>

namespace cairn_test {
namespace {

class Starts {
  public:
    explicit Starts(unsigned seed) : bits_(seed) {}
    float between(float low, float high) { return low + (high - low) * float(double(bits_()) / 4294967296.0); }
    Vec3 direction() {
        const float x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
        return glm::normalize(Vec3(x, y, z));
    }
    Quat rotation() {
        const float w = between(-1, 1), x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
        return glm::normalize(Quat(w, x, y, z));
    }

  private:
    std::mt19937 bits_;
};

const std::vector<Shape>& shapes() {
    static const std::vector<Shape> all = {Box{{0.1f, 0.05f, 0.025f}}, Capsule{0.2f, 0.05f}, Capsule{0.3f, 0.03f},
                                           Cylinder{0.03f, 0.15f, 0.15f}, Cylinder{0.2f, 0.05f, 0.05f}};
    return all;
}

Material slippery_or_not(float friction) {
    Material material = surface(friction, 0);
    if (friction == 0) material.torsional_friction = 0;
    return material;
}

// The energy of a world, and how much it rose at most above the least that it had, as a share of that at the start.
class Gain {
  public:
    explicit Gain(const World& world) : world_(world), first_(energy()), least_(first_) {}
    void look() {
        most_ = std::max(most_, (energy() - least_) / first_);
        least_ = std::min(least_, energy());
    }
    double most() const { return most_; }

  private:
    double energy() const { return world_.kinetic_energy() + world_.potential_energy(); }
    const World& world_;
    const double first_;
    double least_, most_ = 0;
};

// Contacts and inertia that were kept for a step in which the body turned gave it energy without end: a capsule that
// lay on the ground at 100 rad/s jumped up with 21 times what it had.
TEST(Spinning, WhatSpinsOnTheGroundGainsNothing) {
    Starts starts(5);
    for (const float spin : {30.0f, 70.0f, 150.0f, 300.0f})
        for (const float friction : {0.0f, 0.5f})
            for (std::size_t k = 0; k < 4 * shapes().size(); ++k) {
                World world(without_sleep());
                add_ground(world, slippery_or_not(friction));
                BodyDef def;
                def.position = {0, 0.45, 0};
                def.rotation = starts.rotation();
                def.angular_velocity = spin * starts.direction();
                add_body(world, shapes()[k / 4], def, slippery_or_not(friction));
                Gain gain(world);
                for (int i = 0; i < 240; ++i) world.step(1.0f / 60), gain.look();
                EXPECT_LT(gain.most(), 0.1) << "shape " << k / 4 << ", " << spin << " rad/s, friction " << friction;
            }
}

// In a pit of 1.1 m. What touched several others had the contacts of the start of the step for all of it: up to 28 %.
TEST(Spinning, HeapOfWhatSpinsGainsNothing) {
    Starts starts(5);
    for (const float spin : {100.0f, 300.0f})
        for (const float friction : {0.0f, 0.0f, 0.5f}) {
            World world(without_sleep());
            const Material material = slippery_or_not(friction);
            add_ground(world, material);
            for (int side = 0; side < 4; ++side) {
                const double angle = side * glm::half_pi<double>();
                BodyDef wall;
                wall.type = BodyType::static_;
                wall.position = {0.6 * std::cos(angle), 1, 0.6 * std::sin(angle)};
                wall.rotation = glm::angleAxis(float(-angle), Vec3(0, 1, 0));
                add_body(world, Box{{0.05f, 1.0f, 0.7f}}, wall, material);
            }
            for (int i = 0; i < 12; ++i) {
                BodyDef def;
                def.position = {double(starts.between(-0.3f, 0.3f)), 0.4 + 0.3 * i, 0};
                def.position.z = double(starts.between(-0.3f, 0.3f));
                def.rotation = starts.rotation();
                def.angular_velocity = spin * starts.direction();
                add_body(world, shapes()[std::size_t(i) % shapes().size()], def, material);
            }
            Gain gain(world);
            for (int i = 0; i < 300; ++i) world.step(1.0f / 60), gain.look();
            EXPECT_LT(gain.most(), 0.02) << spin << " rad/s, friction " << friction;
        }
}

} // namespace
} // namespace cairn_test
