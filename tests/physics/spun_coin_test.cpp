// Coins that are spun on edge, and fall. The contact point moves around the rim many times as fast as the coin rotates,
// by a radian and more per step.
#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>

namespace cairn_test {
namespace {

struct Spun {
    double rise;        // greatest increase of the energy above its minimum, as a fraction of the initial energy
    double left, depth; // fraction of the energy at the end; greatest penetration, m
};
Spun spin_coin(RandomStart& random, double radius, int hertz) {
    World world(without_sleep());
    const double half = radius * random.uniform(0.05, 0.12);
    const Material material = surface(float(random.uniform(0.2, 0.6)));
    add_ground(world, material);
    BodyDef def;
    def.position = {0, 1.02 * radius, 0};
    def.rotation = glm::angleAxis(float(random.uniform(0, 2 * pi)), Vec3(0, 1, 0)) *
                   glm::angleAxis(float(random.uniform(-0.1, 0.1)), Vec3(0, 0, 1)) *
                   glm::angleAxis(float(pi / 2), Vec3(1, 0, 0));
    def.linear_velocity = {float(random.uniform(-0.1, 0.1)), 0, float(random.uniform(-0.1, 0.1))};
    def.angular_velocity = {0, float(random.uniform(1, 2.5) * std::sqrt(gravity / radius)), 0};
    const BodyId coin = add_body(world, Cylinder{float(half), float(radius)}, def, material);
    const auto energy = [&] { return world.kinetic_energy() + world.potential_energy(); };
    const double start = energy();
    double least = start;
    Spun spun = {0, 0, 0};
    for (int i = 0; i < 6 * hertz; ++i) {
        world.step(1.0f / float(hertz));
        const double sine = std::fabs((world.body(coin).rotation() * Vec3(0, 1, 0)).y);
        const double lowest =
            world.body(coin).position().y - half * sine - radius * std::sqrt(std::max(1 - sine * sine, 0.0));
        spun.depth = std::max(spun.depth, -lowest);
        spun.rise = std::max(spun.rise, (energy() - least) / start);
        least = std::min(least, energy());
    }
    spun.left = least / start;
    return spun;
}

// When the contact point moved on a straight line within a step, 45 of 96 coins like these gained up to 0.7 of their
// energy at 60 Hz, and 21 at 120 Hz.
TEST(SpunCoin, GainsNothing) {
    RandomStart random(5);
    for (const int hertz : {60, 120, 240})
        for (const double radius : {0.0125, 0.025, 0.05, 0.1}) {
            if (hertz == 60 && radius < 0.02) continue; // see known_limits.md
            for (int i = 0; i < 24; ++i) {
                const Spun spun = spin_coin(random, radius, hertz);
                EXPECT_LT(spun.rise, 0.02) << radius << " " << hertz << " " << i;
                EXPECT_LT(spun.depth, 0.1 * radius) << radius << " " << hertz << " " << i;
            }
        }
}

// The contact point of such a coin moves by half a radian to more than one per step.
TEST(KnownLimits, ACoinOfACentimeterMayGainEnergy) {
    RandomStart random(6);
    int gained = 0;
    for (int i = 0; i < 96; ++i) gained += spin_coin(random, 0.012, 60).rise > 0.02;
    EXPECT_LT(gained, 36); // measured: 120 of 600
}

} // namespace
} // namespace cairn_test
