// Balls that roll, slip, or come to roll (rows 8, 9 and 16 of docs/validation.md).
#include "support.h"

namespace cairn_test {
namespace {

constexpr float radius = 0.5f;

class Rolling : public EveryStep {
  protected:
    // A ball at rest on a slope of 30 degrees.
    struct OnSlope {
        World world;
        Slope slope{radians(30)};
        BodyId ball;

        explicit OnSlope(float friction) {
            slope.add_to(world, surface(friction));
            BodyDef def;
            def.position = double(radius) * slope.normal();
            ball = add_body(world, Sphere{radius}, def, surface(friction));
        }
        double speed() { return glm::dot(glm::dvec3(world.body(ball).linear_velocity()), slope.downhill()); }
        // Of the ball's surface over the slope, at the contact.
        double slip() { return speed() + double(world.body(ball).angular_velocity().z) * double(radius); }
    };
};
CAIRN_AT_EVERY_STEP(Rolling);

TEST_P(Rolling, BallRollsDownASlopeWithFiveSeventhsOfGravity) {
    OnSlope scene(0.6f);
    const int half = steps_in(0.5);
    run(scene.world, dt(), half);
    const double v0 = scene.speed();
    run(scene.world, dt(), 2 * half);
    EXPECT_NEAR((scene.speed() - v0) / (2 * half * double(dt())) / 3.50357, 1, 0.005);
    const double t = 3 * half * double(dt());
    const double way = glm::dot(scene.world.body(scene.ball).position(), scene.slope.downhill());
    EXPECT_NEAR(way / (0.5 * 3.50357 * t * t), 1, 0.005);
}

TEST_P(Rolling, BallRollsWithoutSlipOnlyAboveTheLeastFriction) {
    const double least = 2.0 / 7.0 * std::tan(radians(30)); // 0.16496
    OnSlope grips(float(least * 1.02)), slips(float(least * 0.98));
    const int steps = steps_in(2);
    run(grips.world, dt(), steps);
    run(slips.world, dt(), steps);
    const double t = steps * double(dt());
    EXPECT_LT(std::abs(grips.slip()), 0.001);
    // a - r alpha, with a = g (sin - mu cos) and r alpha = 5/2 mu g cos.
    const double expected = gravity * (std::sin(radians(30)) - 3.5 * 0.98 * least * std::cos(radians(30))) * t;
    EXPECT_NEAR(slips.slip() / expected, 1, 0.1);
}

TEST_P(Rolling, SlidingBallComesToRoll) {
    for (const double heading : {0.0, 37.0, 90.0, 203.0}) {
        const glm::dvec3 along{std::cos(radians(heading)), 0, std::sin(radians(heading))};
        World world;
        add_ground(world, surface(0.2f));
        BodyDef def;
        def.position = {0, double(radius), 0};
        def.linear_velocity = Vec3(2.0 * along);
        const BodyId ball = add_body(world, Sphere{radius}, def, surface(0.2f));
        auto speed = [&] { return glm::dot(glm::dvec3(world.body(ball).linear_velocity()), along); };
        auto slip = [&] {
            return speed() -
                   glm::dot(glm::cross(glm::dvec3(world.body(ball).angular_velocity()), {0, double(radius), 0}), along);
        };
        const int sliding = steps_in(0.2), rolling = steps_in(0.6);
        run(world, dt(), sliding);
        // The slip falls from 2 m/s at a constant rate.
        const double t = sliding * double(dt());
        EXPECT_NEAR(t * 2 / (2 - slip()) / 0.29125, 1, 0.005);
        run(world, dt(), rolling - sliding);
        EXPECT_NEAR(speed() / 1.42857, 1, 0.005);
        const double expected = 0.49928 + 1.42857 * (rolling * double(dt()) - 0.29125);
        EXPECT_NEAR(glm::dot(world.body(ball).position(), along) / expected, 1, 0.005);
        EXPECT_NEAR(slip(), 0, 0.001);
    }
}

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

} // namespace
} // namespace cairn_test
