// ContactHit::time, compared with motion that is known exactly.
#include "test_world.h"

#include <algorithm>
#include <random>
#include <vector>

namespace cairn::test {
namespace {

Material bouncing(float restitution) {
    Material material;
    material.restitution = restitution;
    material.static_friction = material.dynamic_friction = 0.0f;
    return material;
}

BodyId add_wall(World& world, const Position& position, const Material& material) {
    return add_body(world, body_at(position, BodyType::static_), Box{{0.1f, 2.0f, 2.0f}}, with_material(material));
}

// Hit times in seconds since the world began, in the order in which they were reported.
struct Hit {
    double time;
    int step;
};
std::vector<Hit> step_and_list(World& world, int steps, float dt) {
    std::vector<Hit> hits;
    for (int i = 0; i < steps; ++i) {
        world.step(dt);
        for (const ContactHit& hit : world.contact_hits()) {
            EXPECT_GE(hit.time, 0.0f);
            EXPECT_LE(hit.time, dt * 1.000001f);
            hits.push_back({i * double(dt) + double(hit.time), i});
        }
    }
    return hits;
}

TEST(HitTimes, OfABallBetweenWallsAreTheExactOnes) {
    std::mt19937 engine(1);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    int several = 0;
    for (const float dt : {frame, 1.0f / 240})
        for (int shot = 0; shot < 40; ++shot) {
            World world(weightless());
            for (const double side : {-1.0, 1.0}) add_wall(world, {side * 1.1, 0.0, 0.0}, bouncing(1.0f));
            const double speed = std::exp(between(std::log(10.0), std::log(400.0))), start = between(-0.7, 0.7);
            BodyDef ball = body_at({start, 0.0, 0.0});
            ball.linear_velocity = {float(speed), 0.0f, 0.0f};
            add_body(world, ball, Sphere{0.25f}, with_material(bouncing(1.0f)));
            const std::vector<Hit> hits = step_and_list(world, 12, dt);
            const double exact_speed = double(float(speed));
            for (std::size_t k = 0; k < hits.size(); ++k) {
                // The centers move between -0.75 and 0.75.
                const double exact = (0.75 - start + 1.5 * double(k)) / exact_speed;
                ASSERT_NEAR(hits[k].time, exact, 1e-4 * double(dt)) << speed << " m/s, bounce " << k;
                several += k > 0 && hits[k - 1].step == hits[k].step;
            }
            EXPECT_NEAR(double(hits.size()), std::floor((12 * double(dt) * exact_speed - 0.75 + start) / 1.5) + 1, 1);
        }
    EXPECT_GT(several, 100); // hits in the same step as the previous hit
}

TEST(HitTimes, OfWhatStopsAtAWallAreTheExactOnes) {
    std::mt19937 engine(2);
    std::uniform_real_distribution<double> speeds(1.1, 12.0), gaps(0.2, 0.3);
    for (int shot = 0; shot < 200; ++shot) {
        World world(weightless());
        add_wall(world, {0.1, 0.0, 0.0}, bouncing(0.0f));
        const double speed = speeds(engine), gap = gaps(engine);
        BodyDef box = body_at({-0.25 - gap, 0.0, 0.0});
        box.linear_velocity = {float(speed), 0.0f, 0.0f};
        add_body(world, box, Box{{0.25f, 0.25f, 0.25f}}, with_material(bouncing(0.0f)));
        const std::vector<Hit> hits = step_and_list(world, 20, frame);
        ASSERT_EQ(hits.size(), 1u) << speed;
        EXPECT_NEAR(hits[0].time, gap / speed, 1e-3 * double(frame)) << speed << " m/s, gap " << gap;
    }
}

// Gravity adds g t^2 / 2 to the distance traveled in a step, which the estimate may leave out: it is then late by g t^2
// / (2 v). The simulated fall is ahead of the parabola by up to g t h / 2 in substeps of length h, and its chord over a
// step of length T by up to g T^2 / 8.
TEST(HitTimes, OfWhatFallsAndStopsAreOffByNoMoreThanGravityMakesOfAStep) {
    constexpr double g = 9.81;
    for (int shot = 0; shot < 40; ++shot) {
        World world;
        add_ground(world, bouncing(0.0f));
        const BodyId box = add_body(world, body_at({0.0, 0.75 + 0.05 * shot, 0.0}), Box{{0.25f, 0.25f, 0.25f}},
                                    with_material(bouncing(0.0f)));
        double gap = 0, speed = 0;
        for (int i = 0; i < 60 && world.contact_hits().empty(); ++i) {
            gap = world.body(box).position().y - 0.25, speed = -double(world.body(box).linear_velocity().y);
            world.step(frame);
        }
        ASSERT_EQ(world.contact_hits().size(), 1u) << shot;
        const double time = double(world.contact_hits()[0].time);
        const double exact = (std::sqrt(speed * speed + 2 * g * gap) - speed) / g;
        const double h = double(frame) / world.usual_substeps(float(frame)), rounding = 1e-3 * double(frame);
        const double ahead = g * (exact * h / 2 + double(frame) * double(frame) / 8);
        EXPECT_GT(time, exact - ahead / speed - rounding) << shot;
        EXPECT_LT(time, exact + g * exact * exact / (2 * speed) + rounding) << shot;
    }
}

// A spinning top on the ground makes the engine divide the step into several passes, 7 of half a radian each. The
// contact of a jointed body is solved by the contact solver, which may stop the body at the end of the previous pass.
TEST(HitTimes, AreThoseWithinTheStepAlsoWhereItTakesSeveralPasses) {
    for (const auto& [restitution, is_joined] : {std::pair(0.0f, false), {1.0f, false}, {0.0f, true}})
        for (int shot = 0; shot < 30; ++shot) {
            WorldDef settings = weightless();
            settings.max_angular_speed = 1000;
            World world(settings);
            add_wall(world, {0.1, 50.0, 0.0}, bouncing(restitution));
            add_wall(world, {0.1, 0.0, 0.0}, bouncing(0.0f));
            BodyDef top = body_at({-0.25, 0.0, 0.0});
            top.angular_velocity = {200.0f, 0.0f, 0.0f};
            top.linear_velocity = {0.1f, 0.0f, 0.0f};
            add_body(world, top, Box{{0.25f, 0.4f, 0.1f}}, with_material(bouncing(0.0f)));
            world.step(frame); // the top touches the ground
            const double speed = 30.0, gap = 0.02 + 0.015 * shot;
            BodyDef ball = body_at({-0.25 - gap, 50.0, 0.0});
            ball.linear_velocity = {float(speed), 0.0f, 0.0f};
            const BodyId thrown =
                add_body(world, ball, Box{{0.25f, 0.25f, 0.25f}}, with_material(bouncing(restitution)));
            if (is_joined) {
                ball.position.x -= 1.0;
                const BodyId tail = add_body(world, ball, Box{{0.25f, 0.25f, 0.25f}});
                world.create_joint(world.joint_at(thrown, tail, ball.position, {1.0f, 0.0f, 0.0f}, FixedJoint{}));
            }
            world.step(frame);
            const auto hits = world.contact_hits();
            const auto hit = std::find_if(hits.begin(), hits.end(), [&](const ContactHit& h) {
                return h.body_a == thrown || h.body_b == thrown;
            });
            ASSERT_NE(hit, hits.end()) << gap;
            EXPECT_NEAR(double(hit->time), gap / speed, (is_joined ? 1.0 / 7 : 1e-3) * double(frame))
                << gap << ", restitution " << restitution << (is_joined ? ", joined" : "");
        }
}

} // namespace
} // namespace cairn::test
