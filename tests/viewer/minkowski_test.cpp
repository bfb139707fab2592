// The Minkowski difference of two shapes, and GJK on it.
#include "viewer/minkowski.h"
#include "viewer/solver_view.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

std::vector<Shape> shapes() {
    return {Sphere{0.4f},
            Box{{0.5f, 0.3f, 0.2f}},
            Box{{0.3f, 0.2f, 0.1f}, 0.1f},
            Capsule{0.4f, 0.2f, {}},
            Capsule{0.4f, 0.3f, 0.1f},
            Cylinder{0.4f, 0.3f, {}},
            cone(0.4f, 0.5f),
            Hull(test::cube_corners())};
}

Quat some_turn(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return glm::normalize(Quat(normal(random), normal(random), normal(random), normal(random)));
}

// The engine's distance of a ball's center from a shape equals GJK's distance of the ball plus its radius.
TEST(Minkowski, GjkFindsTheDistancesThatTheEngineFinds) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    for (const Shape& shape : shapes()) {
        int apart = 0;
        for (int i = 0; i < 60; ++i) {
            World world;
            BodyDef def;
            def.rotation = some_turn(random);
            const ShapeId id = world.add_shape(world.create_body(def), shape);
            const Position middle(place(random), place(random), place(random));
            const auto known = world.closest_point(middle, 100.0);
            ASSERT_TRUE(known);
            const double distance = glm::length(known->point - middle);
            const GjkResult found =
                gjk(*convex_shape(world, id), {Sphere{0.1f}, {middle, Quat(1.0f, 0.0f, 0.0f, 0.0f)}});
            if (distance < 0.11 || known->distance <= 0.0) continue; // inside the shape
            ++apart;
            EXPECT_NEAR(found.distance, distance - 0.1, 1e-4) << shape.index() << " " << i;
            EXPECT_LE(found.simplex.size(), 3u);
        }
        EXPECT_GT(apart, 15) << shape.index();
    }
}

TEST(Minkowski, WhereShapesOverlapTheOriginIsInside) {
    std::mt19937 random(8);
    for (const Shape& a : shapes())
        for (const Shape& b : shapes()) {
            const ConvexShape first{a, {{0.05, 0.02, 0.0}, some_turn(random)}};
            const ConvexShape second{b, {{0.0, 0.0, 0.0}, some_turn(random)}};
            EXPECT_EQ(gjk(first, second).distance, 0.0) << a.index() << " " << b.index();
        }
}

TEST(Minkowski, TheSurfaceOfTwoBoxesIsABoxOfBothSizes) {
    World world;
    const BodyId a = world.create_body(test::body_at({3.0, 0.0, 0.0})), b = world.create_body();
    world.add_shape(a, Box{{0.5f, 0.4f, 0.3f}});
    world.add_shape(b, Box{{0.1f, 0.2f, 0.3f}});
    const BodyId far = world.create_body(test::body_at({-9.0, 0.0, 0.0}));
    world.add_shape(far, Sphere{});
    const auto difference = nearest_difference(world, a);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->other, b);
    EXPECT_NEAR(difference->gjk.distance, 2.4, 1e-6);
    ASSERT_FALSE(difference->triangles.empty());
    for (const Vec3& point : difference->points) {
        EXPECT_NEAR(std::abs(point.x - 3.0f), 0.6f, 1e-5f);
        EXPECT_NEAR(std::abs(point.y), 0.6f, 1e-5f);
        EXPECT_NEAR(std::abs(point.z), 0.6f, 1e-5f);
    }
    EXPECT_FALSE(nearest_difference(world, {}));
}

TEST(Minkowski, ItIsDrawnAboutTheOtherBody) {
    World world;
    const BodyId a = world.create_body(test::body_at({3.0, 0.0, 0.0})),
                 b = world.create_body(test::body_at({0.0, 1.0, 0.0}));
    for (const BodyId id : {a, b}) world.add_shape(id, Sphere{0.5f});
    SolverShown shown;
    shown.difference = true;
    RenderFrame frame;
    draw_solver(frame, *read_solver(world, shown, 1.0 / 60.0, a));
    EXPECT_GT(frame.veils.size(), 500u);
    ASSERT_FALSE(frame.strokes.empty());
    EXPECT_EQ(frame.strokes.back().from, Vec3(0.0f, 1.0f, 0.0f)); // the origin
    draw_solver(frame, *read_solver(world, shown, 1.0 / 60.0));   // without a selection
}

} // namespace
