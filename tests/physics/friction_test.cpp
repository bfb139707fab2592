// Friction acts where the contact pressure is.
#include "support.h"

#include <random>

namespace cairn_test {
namespace {

struct SlidingBox {
    double turned = 0;   // rotation about the vertical, degrees, without sign
    double distance = 0; // m
};

// A box whose center of mass is off its center slides until it stops, in the given direction and heading.
SlidingBox slide(glm::dvec2 offset, double direction, double heading, float friction, double speed) {
    World world;
    add_ground(world, surface(friction));
    BodyDef def;
    def.position = {0, 0.1, 0};
    def.rotation = glm::angleAxis(float(heading), Vec3(0, 1, 0));
    def.linear_velocity = {float(speed * std::cos(direction)), 0, float(speed * std::sin(direction))};
    const BodyId id = add_body(world, Box{{0.25f, 0.1f, 0.25f}}, def, surface(friction));
    MassProperties mass = world.body(id).mass_properties();
    mass.center_of_mass = {float(offset.x), 0, float(offset.y)};
    world.body(id).set_mass_properties(mass);
    world.body(id).set_linear_velocity(def.linear_velocity);
    const Position start = world.body(id).position();
    SlidingBox result;
    double before = heading;
    for (int i = 0; i < 400; ++i) {
        world.step(1.0f / 60);
        const Vec3 along = world.body(id).rotation() * Vec3(1, 0, 0);
        const double now = std::atan2(-along.z, along.x);
        result.turned += std::fabs(std::remainder(now - before, 2 * glm::pi<double>())) / radians(1);
        before = now;
    }
    result.distance = glm::length(world.body(id).position() - start);
    return result;
}

TEST(Friction, BoxWithItsMassAsideSlidesStraight) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(0, 2 * glm::pi<double>()), aside(-0.18, 0.18), coefficient(0.1, 0.6);
    for (int i = 0; i < 40; ++i) {
        const double friction = coefficient(random), direction = angle(random), heading = angle(random);
        const glm::dvec2 offset(aside(random), aside(random));
        const double speed = std::sqrt(2 * friction * gravity * 5);
        const SlidingBox box = slide(offset, direction, heading, float(friction), speed);
        SCOPED_TRACE(testing::Message() << "offset " << offset.x << " " << offset.y << ", friction " << friction
                                        << ", direction " << direction << ", heading " << heading);
        EXPECT_LT(box.turned, 2);
        EXPECT_NEAR(box.distance, 5, 0.1);
    }
}

TEST(Friction, StopsWhatCannotTurn) {
    World world(without_sleep());
    add_ground(world, surface(0.5f));
    BodyDef def;
    def.position = {0, 0.5, 0};
    const BodyId id = add_body(world, Box{}, def, surface(0.5f));
    MassProperties mass = world.body(id).mass_properties();
    mass.inertia_diagonal = {0, 0, 0};
    world.body(id).set_mass_properties(mass);
    world.body(id).set_linear_velocity({5, 0, 0});
    run(world, 1.0f / 60, 30);
    EXPECT_NEAR(world.body(id).linear_velocity().x, 5 - 0.5 * 0.5 * gravity, 0.03);
    run(world, 1.0f / 60, 60);
    EXPECT_NEAR(world.body(id).linear_velocity().x, 0, 1e-4);
}

// A stack on a slope slightly too steep for its friction, in the given direction; the lowest box lies alone or under
// others.
struct OnTooSteepASlope {
    World world;
    Slope slope;
    std::vector<BodyId> boxes;

    OnTooSteepASlope(double friction, double degrees_more, double heading, int stack)
        : slope{std::atan(friction) + radians(degrees_more)} {
        slope.add_to(world, surface(float(friction)));
        for (int i = 0; i < stack; ++i) {
            BodyDef def;
            def.rotation = slope.rotation() * glm::angleAxis(float(heading), Vec3(0, 1, 0));
            def.position = (0.1 + 0.2 * i) * slope.normal();
            boxes.push_back(add_body(world, Box{{0.5f, 0.1f, 0.4f}}, def, surface(i == 0 ? float(friction) : 2.0f)));
        }
    }
    double way() { return glm::dot(world.body(boxes[0]).position(), slope.downhill()); }
};

TEST(Friction, WhatSlidesSlowlyDoesNotFallAsleep) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> angle(0, 2 * glm::pi<double>()), coefficient(0.2, 0.8), more(0.25, 0.6);
    for (int i = 0; i < 20; ++i) {
        const double friction = coefficient(random), degrees = more(random), heading = angle(random);
        const int stack = 1 + i % 3;
        SCOPED_TRACE(testing::Message() << "friction " << friction << ", " << degrees << " degrees more, heading "
                                        << heading << ", boxes " << stack);
        OnTooSteepASlope sliding(friction, degrees, heading, stack);
        const double start = sliding.way(), steep = std::atan(friction) + radians(degrees);
        run(sliding.world, 1.0f / 60, 300);
        const double expected = 0.5 * gravity * (std::sin(steep) - friction * std::cos(steep)) * 25;
        EXPECT_GT(sliding.way() - start, 0.98 * expected);
        EXPECT_LT(sliding.way() - start, 1.02 * expected + 0.1); // 20 mm/s from before friction builds up
        OnTooSteepASlope standing(friction, -0.25, heading, stack);
        run(standing.world, 1.0f / 60, 300);
        EXPECT_FALSE(standing.world.body(standing.boxes[0]).is_awake());
    }
}

} // namespace
} // namespace cairn_test
