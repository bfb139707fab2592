// Everyday situations with known outcomes: a free wedge, a load on a truck, bodies that fall down a shaft.
#include "starts.h"
#include "support.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cairn_test {
namespace {

constexpr double gravity = double(9.81f);

// Without friction, a block slides down a wedge that slides away below it. A wedge of mass M and angle a has the
// acceleration m g sin a cos a / (M + m sin^2 a).
TEST(Everyday, AWedgeSlidesAwayUnderABlock) {
    Starts starts(5);
    for (int i = 0; i < 24; ++i) {
        World world;
        add_ground(world, surface(0));
        const double angle = starts.between(0.3, 1), length = 4, heavy = starts.between(1, 20),
                     light = starts.between(1, 20);
        const glm::dquat yaw = glm::angleAxis(starts.between(0, 6), glm::dvec3(0, 1, 0));
        std::vector<Vec3> corners;
        for (const float z : {-1.0f, 1.0f})
            corners.insert(corners.end(), {{0, 0, z}, {float(length), 0, z}, {0, float(length * std::tan(angle)), z}});
        BodyDef def;
        def.mass = float(heavy);
        def.rotation = Quat(yaw);
        const BodyId wedge = add_body(world, Hull(corners), def, surface(0));
        const glm::dvec3 normal(std::sin(angle), std::cos(angle), 0);
        const glm::dvec3 on_face(0.3 * length, 0.7 * length * std::tan(angle), 0);
        def.mass = float(light);
        def.position = yaw * (on_face + 0.1 * normal);
        def.rotation = Quat(yaw * glm::angleAxis(-angle, glm::dvec3(0, 0, 1)));
        add_body(world, Box{{0.1f, 0.1f, 0.1f}}, def, surface(0));
        run(world, 1.0f / 60, 24);
        const double sine = std::sin(angle), cosine = std::cos(angle);
        const double expected = 0.4 * light * gravity * sine * cosine / (heavy + light * sine * sine);
        EXPECT_NEAR(glm::length(glm::dvec3(world.body(wedge).linear_velocity())), expected, 0.001 * expected);
    }
}

// A load of 10 kg on a truck of 1,000 kg that accelerates for two seconds: the load stays up to mu g, and slips beyond.
TEST(Everyday, ALoadStaysOnATruckAsLongAsFrictionHolds) {
    Starts starts(6);
    for (int i = 0; i < 24; ++i) {
        World world;
        const double friction = starts.between(0.2, 0.8), most = friction * gravity;
        const bool is_too_fast = i % 2 == 1;
        const double acceleration = most * (is_too_fast ? 1.03 : 0.97);
        const BodyId ground = add_ground(world, surface(0));
        BodyDef def;
        def.mass = 1000;
        def.position = {0, 0.3, 0};
        const BodyId truck = add_body(world, Box{{3, 0.1f, 1}}, def, surface(float(friction)));
        world.create_joint(world.joint_at(ground, truck, def.position, {1, 0, 0}, SliderJoint{}));
        def.mass = 10;
        def.position = {0, 0.5, 0};
        const BodyId load = add_body(world, Box{{0.1f, 0.1f, 0.1f}}, def, surface(float(friction)));
        const auto ahead = [&] { return world.body(load).position().x - world.body(truck).position().x; };
        run(world, 1.0f / 60, 30);
        const double before = ahead();
        for (int k = 0; k < 120; ++k) {
            world.body(truck).add_force(Vec3(1000 * acceleration + 10 * std::min(acceleration, most), 0, 0));
            world.step(1.0f / 60);
        }
        const double expected = is_too_fast ? -0.5 * (acceleration - most) * 4 : 0;
        EXPECT_NEAR(ahead() - before, expected, 0.001 + 0.06 * std::abs(expected)) << i;
    }
}

// A body in a shaft of boxes, with 0.3 to 10 mm clearance on each side and without friction, is in free fall.
TEST(Everyday, WhatFitsIntoAShaftFallsFreely) {
    constexpr float half = 0.2f;
    Starts starts(7);
    for (const Shape& shape : {Shape(Box{{half, half, half}}), Shape(Cylinder{half, half}), Shape(Sphere{half})})
        for (int i = 0; i < 12; ++i) {
            World world;
            const double air = std::pow(10, starts.between(-3.5, -2));
            BodyDef def;
            def.type = BodyType::static_;
            for (int k = 0; k < 10; ++k)
                for (const double side : {-1.0, 1.0}) {
                    def.position = {side * (double(half) + air + 0.5), -double(k), 0};
                    add_body(world, Box{{0.5f, 0.5f, 0.5f}}, def, surface(0));
                }
            def.type = BodyType::dynamic;
            def.position = {0, 2, 0};
            const Body body = world.body(add_body(world, shape, def, surface(0)));
            run(world, 1.0f / 60, 60);
            EXPECT_NEAR(double(body.linear_velocity().y), -gravity, 0.003 * gravity) << i;
        }
}

} // namespace
} // namespace cairn_test
