// Balls with rolling resistance, and bodies that rotate slowly. Rolling without resistance is covered by cases 8, 9 and
// 16 of the validation.
#include "support.h"

namespace cairn_test {
namespace {

constexpr float radius = 0.5f;

// Resistance also acts when both materials have restitution: such a ball rests by bouncing in every substep, and would
// roll and spin forever if the impulses of bounces did not count as load.
TEST(RollingResistance, StopsBallsOnBouncingGround) {
    for (const float restitution : {0.0f, 0.05f, 0.5f}) {
        World world(without_sleep());
        Material material = surface(0.6f, restitution);
        material.rolling_friction = 0.15f;
        material.torsional_friction = 0.05f;
        add_ground(world, material);
        BodyDef def;
        def.position = {0, double(radius), 0};
        def.linear_velocity = {3, 0, 0};
        def.angular_velocity = {0, 0, -6};
        const BodyId ball = add_body(world, Sphere{radius}, def, material);
        run(world, 1.0f / 60.0f, 30);
        // The couple mu_r m g acts on the effective inertia (7/5) m r^2: v' = -(5/7) g mu_r / r.
        EXPECT_NEAR(world.body(ball).linear_velocity().x, 3 - 0.5 * 5.0 / 7.0 * gravity * 0.15 / radius, 0.1)
            << restitution;
        world.body(ball).set_angular_velocity(world.body(ball).angular_velocity() + Vec3(0, 5, 0));
        run(world, 1.0f / 60.0f, 120);
        EXPECT_NEAR(world.body(ball).linear_velocity().x, 0, 1e-3) << restitution;
        EXPECT_NEAR(world.body(ball).angular_velocity().y, 0, 1e-3) << restitution;
    }
}

// The inertia tensor is not rotated within a step for slow rotations, so the angular momentum must be right at its end.
// The ball has three different moments of inertia and touches the ground without weight, so that the contact solver
// handles it: free bodies are integrated differently.
TEST(SlowTurn, KeepsItsAngularMomentum) {
    for (const float speed : {0.001f, 0.0035f, 0.0045f, 0.05f}) {
        WorldDef settings = without_sleep();
        settings.gravity = {0, 0, 0};
        World world(settings);
        add_ground(world);
        BodyDef def;
        def.position = {0, double(radius), 0};
        def.angular_velocity = speed * glm::normalize(Vec3(1, 2, 3));
        def.mass_properties = MassProperties{};
        def.mass_properties->inertia_diagonal = {1, 2, 2.5f};
        const BodyId body = add_body(world, Sphere{radius}, def);
        const Vec3 before = world.body(body).angular_momentum();
        run(world, 1.0f / 60, 6000);
        EXPECT_GT(world.statistics().colors, 0u) << "without a contact nothing is tested";
        EXPECT_LT(glm::length(world.body(body).angular_momentum() - before), 5e-4f * glm::length(before)) << speed;
        EXPECT_GT(glm::angle(world.body(body).rotation()), 0.05f);
    }
}

// A helicoid of triangles that rotates about y like an Archimedes screw: y = pitch / (2 pi) (angle + turn). The angle
// counts from x to z, opposite to a positive rotation about y. Posts keep a marble from revolving with the screw.
double rise_of_marble(float pitch, float speed, double seconds) {
    constexpr int rings = 3, per_turn = 48, turns = 3;
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i <= per_turn * turns; ++i) {
        const float turn = float(i) / per_turn - 0.5f * turns, angle = 6.28318531f * turn;
        for (int k = 0; k < rings; ++k) {
            const float r = 0.01f + 0.02f * float(k);
            corners.push_back({r * std::cos(angle), pitch * turn, r * std::sin(angle)});
        }
        if (i == 0) continue;
        for (int k = 0; k + 1 < rings; ++k) {
            const std::uint32_t b = std::uint32_t(rings * i + k), a = b - rings;
            indices.insert(indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    }
    World world(without_sleep());
    BodyDef def;
    def.type = BodyType::kinematic;
    def.angular_velocity = {0, speed, 0};
    add_body(world, Mesh(corners, indices), def, surface(0.2f));
    def = {};
    def.type = BodyType::static_;
    for (const double side : {-1.0, 1.0}) {
        def.position = {0.035, 0, side * 0.021};
        add_body(world, Box{{0.02f, 0.3f, 0.01f}}, def, surface(0));
    }
    def.position = {0.065, 0, 0};
    add_body(world, Box{{0.01f, 0.3f, 0.03f}}, def, surface(0));
    def.type = BodyType::dynamic;
    def.position = {0.04, 0.012, 0};
    const BodyId marble = add_body(world, Sphere{0.01f}, def, surface(0.2f));
    run(world, 1.0f / 60, 30);
    const double before = world.body(marble).position().y;
    run(world, 1.0f / 60, int(seconds * 60));
    return world.body(marble).position().y - before;
}

// In the public sample WaterWheel no marble is lifted, because its screw rotates downward (docs/scene_format.md).
TEST(Rolling, AScrewOfTrianglesLiftsAMarbleByItsPitchOrLowersIt) {
    const float pitch = 0.08f;
    for (const float speed : {1.5f, 3.0f, -1.5f}) {
        const double expected = double(pitch) * double(speed) / 6.28318531;
        EXPECT_NEAR(rise_of_marble(pitch, speed, 1.0), expected, 0.01 * std::fabs(expected)) << speed;
    }
}

} // namespace
} // namespace cairn_test
