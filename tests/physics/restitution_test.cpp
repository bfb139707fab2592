// Impacts (rows 13, 14, 15, 17 and 18 of docs/validation.md).
#include "support.h"

namespace cairn_test {
namespace {

class Impact : public EveryStep {
  protected:
    // A ball of radius 0.5 m whose lowest point is 1 m above the ground.
    struct Drop {
        World world;
        BodyId ball;
        explicit Drop(float restitution) {
            add_ground(world, surface(0, restitution));
            BodyDef def;
            def.position = {0, 1.5, 0};
            ball = add_body(world, Sphere{0.5f}, def, surface(0, restitution));
        }
        double height() { return world.body(ball).position().y - 0.5; }
        double speed() { return double(world.body(ball).linear_velocity().y); }
    };

    BodyId add_ball(World& world, const Position& position, const Vec3& velocity, float mass, float restitution) {
        BodyDef def;
        def.position = position;
        def.linear_velocity = velocity;
        def.mass = mass;
        return add_body(world, Sphere{0.5f}, def, surface(0, restitution));
    }
};
CAIRN_AT_EVERY_STEP(Impact);

TEST_P(Impact, BouncesReachTheHeightsAndEndAtTheTimeOfTheirCoefficient) {
    struct Case {
        float restitution;
        double total_time;
    };
    for (const Case& c : {Case{0.5f, 1.35457}, Case{0.8f, 4.06371}, Case{0.9f, 8.57895}}) {
        Drop drop(c.restitution);
        const double h = double(dt()) / drop.world.settings().substeps;
        double last_speed = 0, end = 0, expected = 1;
        for (int i = 1; i <= steps_in(c.total_time + 1); ++i) {
            drop.world.step(dt());
            const double speed = drop.speed();
            if (last_speed > 0 && speed <= 0) { // past the top: the height of the parabola that it is on
                const double v = speed - 0.5 * gravity * h;
                const double top = drop.height() + v * v / (2 * gravity);
                expected *= double(c.restitution) * double(c.restitution);
                if (expected > 0.01) {
                    EXPECT_NEAR(top / expected, 1, 0.01) << "restitution " << c.restitution;
                }
            }
            if (std::abs(speed) > double(drop.world.settings().restitution_speed)) end = i * double(dt());
            last_speed = speed;
        }
        EXPECT_LT(expected, 0.01) << "restitution " << c.restitution;
        // The sum of all flights, without those that begin slower than what still bounces.
        const double least = double(drop.world.settings().restitution_speed);
        const double total = c.total_time - 2 * least / gravity / (1 - double(c.restitution));
        EXPECT_NEAR(end, total, 0.01 * total + double(dt())) << "restitution " << c.restitution;
    }
}

TEST_P(Impact, ElasticBallNeverGainsEnergy) {
    Drop drop(1);
    const double mass = double(drop.world.body(drop.ball).mass()), start = mass * gravity;
    const double h = double(dt()) / drop.world.settings().substeps;
    double least = 1e9, most = 0;
    for (int i = 0; i < steps_in(20); ++i) {
        drop.world.step(dt());
        const double v = drop.speed() - 0.5 * gravity * h; // of the parabola that the ball is on
        const double energy = mass * (gravity * drop.height() + 0.5 * v * v);
        least = std::min(least, energy);
        most = std::max(most, energy);
    }
    EXPECT_LE(most / start, 1 + 1e-4);
    EXPECT_GE(least / start, 0.99);
}

TEST_P(Impact, HeadOnBallsExchangeMomentumAsTheoryTells) {
    struct Case {
        float ratio, restitution;
        double first, second;
    };
    for (const Case& c : {Case{1, 1, 0, 1}, Case{2, 1, -1.0 / 3, 2.0 / 3}, Case{8, 1, -0.77778, 0.22222},
                          Case{100, 1, -0.98020, 0.01980}, Case{1, 0, 0.5, 0.5}}) {
        WorldDef settings = without_gravity();
        settings.enable_sleep = false; // the heaviest leaves more slowly than what may sleep
        World world{settings};
        const BodyId first = add_ball(world, {-1.2345, 0, 0}, {1, 0, 0}, 1, c.restitution);
        const BodyId second = add_ball(world, {0.2, 0, 0}, {0, 0, 0}, c.ratio, c.restitution);
        run(world, dt(), steps_in(1));
        EXPECT_NEAR(double(world.body(first).linear_velocity().x), c.first, 1e-4) << "mass ratio " << c.ratio;
        EXPECT_NEAR(double(world.body(second).linear_velocity().x), c.second, 1e-4) << "mass ratio " << c.ratio;
    }
}

TEST_P(Impact, ObliqueBallsLeaveAtARightAngle) {
    // The first moves along x; where they touch, the line of centers is 30 degrees off.
    World world{without_gravity()};
    const BodyId first = add_ball(world, {-2.2345, 0, -0.5}, {1, 0, 0}, 1, 1);
    const BodyId second = add_ball(world, {0, 0, 0}, {0, 0, 0}, 1, 1);
    run(world, dt(), steps_in(3));
    const glm::dvec3 a(world.body(first).linear_velocity()), b(world.body(second).linear_velocity());
    const double between = std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b)));
    EXPECT_NEAR(between, radians(90), radians(0.1));
    EXPECT_NEAR(std::atan2(b.z, b.x), radians(30), radians(0.1));
    EXPECT_NEAR(glm::length(a), 0.5, 0.002);
    EXPECT_NEAR(glm::length(b), 0.8660, 0.002);
}

TEST_P(Impact, CradleSendsAsManyBallsOutAsCameIn) {
    for (const double gap : {0.0, 0.001})
        for (int incoming = 1; incoming <= 4; ++incoming) {
            World world{without_gravity()};
            std::vector<BodyId> balls;
            for (int i = 0; i < 5; ++i) {
                const double x = i * (1 + gap) - (i < incoming ? 0.5 : 0);
                balls.push_back(add_ball(world, {x, 0, 0}, {i < incoming ? 1.0f : 0.0f, 0, 0}, 1, 1));
            }
            run(world, dt(), steps_in(1));
            for (int i = 0; i < 5; ++i) {
                const double expected = i >= 5 - incoming ? 1 : 0;
                EXPECT_NEAR(double(world.body(balls[std::size_t(i)]).linear_velocity().x), expected, 0.01)
                    << "ball " << i << " of " << incoming << " in, gap " << gap;
            }
        }
}

} // namespace
} // namespace cairn_test
