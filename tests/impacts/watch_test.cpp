// Tests of the watch on cores: paths known in closed form, and worlds in which a body does pass.
#include "cells.h"
#include "core_watch.h"

#include <gtest/gtest.h>

namespace cairn_test {
namespace {

glm::dquat turn(const glm::dvec3& by) {
    const double angle = glm::length(by);
    return angle > 0 ? glm::angleAxis(angle, by / angle) : glm::dquat(1, 0, 0, 0);
}
double angle_between(const glm::dquat& a, const glm::dquat& b) {
    return 2 * std::acos(std::min(1.0, std::fabs(glm::dot(a, b))));
}

// A symmetric top with the moments 1, 1, 2 spins about its axis at w3 and precesses about its angular momentum, both at
// constant rates.
TEST(BodyPath, OfASymmetricTopIsThatOfPoinsot) {
    const double dt = 1.0 / 60, w1 = 40, w3 = 30;
    const FreeBody top{{1, 1, 2}, {1, 0, 0, 0}, 0.1, 1e-4};
    const glm::dvec3 momentum(w1, 0, 2 * w3); // the body begins with the identity rotation
    const auto rotation_at = [&](double t) { return turn(t * momentum) * turn({0, 0, -w3 * t}); };
    const auto spin_at = [&](double t) {
        const glm::dvec3 local = glm::conjugate(rotation_at(t)) * momentum;
        return rotation_at(t) * (local / top.inertia);
    };
    const BodyState from{{0, 0, 0}, rotation_at(0), {3, 0, 0}, spin_at(0)};
    const BodyState to{{3 * dt, 0, 0}, rotation_at(dt), {3, 0, 0}, spin_at(dt)};
    const BodyPath way = reconstruct_path(top, from, to, dt);
    ASSERT_GT(way.knots.size(), 2u);
    EXPECT_FALSE(way.is_broken);
    for (const Knot& knot : way.knots) {
        EXPECT_LT(angle_between(knot.rotation, rotation_at(knot.time * dt)), 1e-5) << knot.time;
        EXPECT_NEAR(knot.center.x, 3 * dt * knot.time, 1e-12);
    }
    BodyState other = to;
    other.rotation = turn({0, 0.01, 0}) * to.rotation;
    EXPECT_TRUE(reconstruct_path(top, from, other, dt).knots.empty());
}

TEST(BodyPath, HasTheImpactWhereTheLinesMeet) {
    const FreeBody ball{{1, 1, 1}, {1, 0, 0, 0}, 0.05, 1e-4};
    const BodyState from{{0, 0, 0}, {1, 0, 0, 0}, {60, 30, 0}, {0, 0, 10}};
    const double dt = 1.0 / 60, time = 0.3;
    const BodyState to{{0.3 - 0.7 * 0.5, 0.5, 0}, turn({0, 0, (10 * time - 20 * 0.7) * dt}), {-30, 30, 0}, {0, 0, -20}};
    const BodyPath way = reconstruct_path(ball, from, to, dt);
    ASSERT_EQ(way.knots.size(), 3u);
    EXPECT_TRUE(way.is_broken);
    EXPECT_NEAR(way.knots[1].time, time, 1e-9);
    EXPECT_NEAR(way.knots[1].center.x, 0.3, 1e-9);
    EXPECT_NEAR(way.knots[1].center.y, 0.15, 1e-9);
}

// Adds a body that collides with nothing.
BodyId add_ghost(World& world, const std::vector<Shape>& shapes, const BodyDef& def) {
    const BodyId id = world.create_body(def);
    ShapeDef shape_def;
    shape_def.filter.collides_with = 0;
    for (const Shape& shape : shapes) world.add_shape(id, shape, shape_def);
    return id;
}

WorldDef telling() {
    WorldDef def = without_gravity();
    def.hit_speed = 0;
    return def;
}

// These bodies pass through the wall; neither their first nor their last poses overlap it.
TEST(CoreWatch, SeesWhatPassesThroughAWall) {
    for (const Kind kind : all_kinds) {
        World world(telling());
        BodyDef wall;
        wall.type = BodyType::static_;
        add_body(world, Box{{0.005f, 1, 1}}, wall);
        BodyDef def;
        def.position = {-0.3, 0, 0};
        def.linear_velocity = {40, 0, 0};
        def.angular_velocity = {30, 20, -50};
        add_ghost(world, make_bullet(kind, 0.05).shapes, def);
        CoreWatch watch(world);
        world.step(frame);
        const CoreEncounters met = watch.look(world, double(frame));
        EXPECT_EQ(met.passed, 1) << name_of(kind);
        EXPECT_EQ(met.overlapping, 0) << name_of(kind);
    }
}

// The ghost is off the line from the first to the last pose of the ball, but on its actual path.
TEST(CoreWatch, SeesWhatPassesAfterAnImpact) {
    World world(telling());
    Material elastic = surface(0, 1);
    BodyDef wall;
    wall.type = BodyType::static_;
    wall.position = {0.5, 0, 0};
    add_body(world, Box{{0.1f, 2, 2}}, wall, elastic);
    BodyDef def;
    def.linear_velocity = {30, 30, 0};
    const BodyId ball = add_body(world, Sphere{0.05f}, def, elastic);
    BodyDef ghost;
    ghost.type = BodyType::static_;
    ghost.position = {0.32, 0.38, 0};
    add_ghost(world, {Sphere{0.02f}}, ghost);
    CoreWatch watch(world);
    world.step(frame);
    EXPECT_LT(world.body(ball).linear_velocity().x, -29);
    const CoreEncounters met = watch.look(world, double(frame));
    EXPECT_EQ(met.deep, 1);
    EXPECT_NE(met.worst, "");
}

TEST(CoreWatch, SeesNothingWhereBallsOnlyBounce) {
    World world(telling());
    Random random(3);
    for (int i = 0; i < 27; ++i) {
        BodyDef def;
        def.position = 0.3 * Position(i % 3, i / 3 % 3, i / 9);
        def.linear_velocity = Vec3(20.0 * random.direction());
        add_body(world, Sphere{0.1f}, def, surface(0, 1));
    }
    CoreWatch watch(world);
    std::size_t impacts = 0;
    for (int i = 0; i < 20; ++i) {
        world.step(frame);
        impacts += world.statistics().impacts;
        const CoreEncounters met = watch.look(world, double(frame));
        EXPECT_EQ(met.overlapping + met.passed + met.deep, 0) << i << ": " << met.worst;
    }
    EXPECT_GT(impacts, 10u);
}

} // namespace
} // namespace cairn_test
