// Balls that rolling resistance stops, and bodies that turn slowly. How balls roll without resistance are
// cases 8, 9 and 16 of the validation.
#include "support.h"

namespace cairn_test {
namespace {

constexpr float radius = 0.5f;

// Also where both materials bounce: what rests there does so by bouncing in every substep, and would roll and spin on
// for ever if those impulses did not count.
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
        // The couple mu_r m g against (7/5) m r^2: v' = -(5/7) g mu_r / r.
        EXPECT_NEAR(world.body(ball).linear_velocity().x, 3 - 0.5 * 5.0 / 7.0 * gravity * 0.15 / radius, 0.1)
            << restitution;
        world.body(ball).set_angular_velocity(world.body(ball).angular_velocity() + Vec3(0, 5, 0));
        run(world, 1.0f / 60.0f, 120);
        EXPECT_NEAR(world.body(ball).linear_velocity().x, 0, 1e-3) << restitution;
        EXPECT_NEAR(world.body(ball).angular_velocity().y, 0, 1e-3) << restitution;
    }
}

// Slow turns are not followed within a step: the momentum must be the same at its end. The ball has three different
// moments and touches the ground without weight, so that it is solved with it: free bodies go another way.
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

} // namespace
} // namespace cairn_test
