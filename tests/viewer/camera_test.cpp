#include "viewer/camera.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace cairn;
using namespace cairn::viewer;

void expect_near(const Position& a, const Position& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(OrbitCamera, KeepsThePoseItIsGiven) {
    const CameraPose pose{{3.0, 4.0, -5.0}, {0.5, 1.0, 2.0}, 0.9f};
    const OrbitCamera camera(pose);
    expect_near(camera.position(), pose.position, 1e-5);
    expect_near(camera.target(), pose.target, 0.0);
    EXPECT_FLOAT_EQ(camera.vertical_fov(), 0.9f);
}

TEST(OrbitCamera, OrbitKeepsTheDistanceAndTheTarget) {
    OrbitCamera camera(CameraPose{{0.0, 2.0, 10.0}, {0.0, 2.0, 0.0}});
    camera.orbit(1.5707963f, 0.0f);
    expect_near(camera.position(), {10.0, 2.0, 0.0}, 1e-4);
    camera.orbit(0.0f, 100.0f); // stops short of the pole
    EXPECT_NEAR(glm::distance(camera.position(), camera.target()), 10.0, 1e-4);
    EXPECT_GT(camera.position().y, 11.9);
    EXPECT_GT(camera.up().y, 0.0f);
    expect_near(camera.target(), {0.0, 2.0, 0.0}, 0.0);
}

TEST(OrbitCamera, ZoomStaysWithinBounds) {
    OrbitCamera camera;
    const float before = camera.distance();
    camera.zoom(1.0f);
    EXPECT_NEAR(camera.distance(), 0.9f * before, 1e-4f);
    camera.zoom(1e4f);
    EXPECT_GT(camera.distance(), 0.0f);
    camera.zoom(-1e4f);
    EXPECT_TRUE(std::isfinite(camera.distance()));
}

TEST(OrbitCamera, PanMovesThePictureByThatFractionOfItsHeight) {
    OrbitCamera camera(CameraPose{{0.0, 0.0, 10.0}, {0.0, 0.0, 0.0}});
    const Position before = camera.target();
    camera.pan(0.0f, 0.5f, 1.0f);
    // The point that was in the middle is now at the lower edge.
    const auto device = camera.project(before, 1.0f);
    ASSERT_TRUE(device);
    EXPECT_NEAR(device->y, -1.0f, 1e-4f);
    EXPECT_NEAR(device->x, 0.0f, 1e-5f);
}

TEST(OrbitCamera, FramePutsTheBallInsideThePicture) {
    OrbitCamera camera;
    const Position center(100.0, 5.0, -40.0);
    camera.frame(center, 3.0f);
    const auto middle = camera.project(center, 2.0f);
    const auto top = camera.project(center + Position(camera.up()) * 3.0, 2.0f);
    ASSERT_TRUE(middle && top);
    EXPECT_NEAR(middle->y, 0.0f, 1e-5f);
    EXPECT_GT(top->y, 0.3f);
    EXPECT_LT(top->y, 0.7f);
}

TEST(OrbitCamera, CursorRayGoesThroughWhatIsSeenThere) {
    const OrbitCamera camera(CameraPose{{4.0, 3.0, 8.0}, {0.0, 1.0, 0.0}});
    for (const glm::vec2 device : {glm::vec2(0.0f, 0.0f), glm::vec2(0.7f, -0.4f), glm::vec2(-1.0f, 1.0f)}) {
        const Ray ray = camera.cursor_ray(device, 1.6f);
        EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-5f);
        const auto back = camera.project(ray.origin + Position(ray.direction) * 7.0, 1.6f);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->x, device.x, 1e-4f);
        EXPECT_NEAR(back->y, device.y, 1e-4f);
    }
}

TEST(OrbitCamera, MatricesAgreeWithProject) {
    const OrbitCamera camera(CameraPose{{4.0, 3.0, 8.0}, {0.0, 1.0, 0.0}});
    const Position origin = camera.render_origin(), point(0.5, 1.5, -1.0);
    const glm::vec4 clip = camera.projection(1.6f) * camera.view(origin) * glm::vec4(Vec3(point - origin), 1.0f);
    const auto device = camera.project(point, 1.6f);
    ASSERT_TRUE(device);
    EXPECT_NEAR(clip.x / clip.w, device->x, 1e-4f);
    EXPECT_NEAR(clip.y / clip.w, device->y, 1e-4f);
    EXPECT_GT(clip.z / clip.w, -1.0f);
    EXPECT_LT(clip.z / clip.w, 1.0f);
}

TEST(OrbitCamera, DrawingOriginStaysNearFarFromTheWorldsOrigin) {
    const Position far(1.0e7, 250.0, -3.0e6);
    const OrbitCamera camera(CameraPose{far + Position(0.0, 2.0, 10.0), far});
    EXPECT_LT(glm::distance(camera.render_origin(), far), 100.0);
    expect_near(camera.position(), far + Position(0.0, 2.0, 10.0), 1e-4);
    EXPECT_FALSE(camera.project(far + Position(0.0, 0.0, 20.0), 1.0f)); // behind the camera
}

void expect_above(const OrbitCamera& camera, const Ground& ground) {
    EXPECT_GT(glm::dot(camera.position() - ground.point, glm::dvec3(ground.normal)), 0.005);
    EXPECT_GE(glm::dot(camera.target() - ground.point, glm::dvec3(ground.normal)), -1e-6);
}

TEST(OrbitCamera, StaysAboveTheGroundHoweverItMoves) {
    const Ground ground{{0.0, 1.0, 0.0}, {0.0f, 1.0f, 0.0f}};
    OrbitCamera camera(CameraPose{{0.0, 3.0, 10.0}, {0.0, 2.0, 0.0}});
    camera.set_grounds({ground});
    camera.orbit(0.3f, -2.0f);
    expect_above(camera, ground);
    EXPECT_LT(camera.position().y, 1.5); // at its lowest possible position
    expect_near(camera.target(), {0.0, 2.0, 0.0}, 0.0);
    camera.zoom(-15.0f); // moves back along the ground, not into it
    expect_above(camera, ground);
    expect_near(camera.target(), {0.0, 2.0, 0.0}, 0.0);
    camera.zoom(60.0f);
    expect_above(camera, ground);
    camera.pan(0.0f, -300.0f, 1.0f);
    expect_above(camera, ground);
    camera.frame({5.0, -4.0, 0.0}, 1.0f);
    expect_above(camera, ground);
}

TEST(OrbitCamera, StaysAboveBothSidesOfAValley) {
    const float lean = 0.5f;
    const Ground sides[]{{{0.0, 0.0, 0.0}, {std::sin(lean), std::cos(lean), 0.0f}},
                         {{0.0, 0.0, 0.0}, {-std::sin(lean), std::cos(lean), 0.0f}}};
    OrbitCamera camera(CameraPose{{0.0, 5.0, 12.0}, {0.0, 1.0, 0.0}});
    camera.set_grounds({sides[0], sides[1]});
    camera.orbit(0.0f, -3.0f);
    for (int i = 0; i < 100; ++i) {
        camera.orbit(0.07f, i % 5 == 0 ? -0.2f : 0.02f);
        for (const Ground& side : sides) expect_above(camera, side);
    }
    EXPECT_NEAR(camera.distance(), 12.65f, 0.1f);
}

TEST(OrbitCamera, GoesAnywhereWhereThereIsNoGround) {
    OrbitCamera camera(CameraPose{{0.0, 3.0, 10.0}, {0.0, 2.0, 0.0}});
    camera.orbit(0.0f, -1.0f);
    EXPECT_LT(camera.position().y, -3.0);
}

// The column of the panel makes pictures narrow: what a scene shows at the sides must not be cut off.
TEST(OrbitCamera, NarrowPicturesShowAsMuchToTheSides) {
    const OrbitCamera camera({{3.0, 2.0, 8.0}, {0.5, 1.0, 0.0}, 0.7f});
    for (const float across : {-1.0f, -0.4f, 1.0f}) {
        const Ray wide = camera.cursor_ray({across, 0.0f}, 16.0f / 9.0f);
        for (const float aspect : {1.5f, 980.0f / 720.0f, 1.0f, 0.5f}) {
            EXPECT_LT(glm::distance(camera.cursor_ray({across, 0.0f}, aspect).direction, wide.direction), 1e-6f);
            const Ray ray = camera.cursor_ray({across, 0.7f}, aspect);
            const Position point = ray.origin + Position(ray.direction) * 5.0;
            EXPECT_LT(glm::distance(*camera.project(point, aspect), glm::vec2(across, 0.7f)), 1e-5f);
            const Vec3 offset(point - camera.target());
            const glm::vec4 clip = camera.projection(aspect) * camera.view(camera.target()) * glm::vec4(offset, 1.0f);
            EXPECT_LT(glm::distance(glm::vec2(clip) / clip.w, glm::vec2(across, 0.7f)), 1e-4f);
        }
    }
    // Wider pictures show more at the sides, and the same height.
    EXPECT_FLOAT_EQ(camera.half_height(2.5f), std::tan(0.35f));
}

TEST(Camera, ParallelRaysShowNearAndFarAlike) {
    OrbitCamera camera({{0.0, 1.0, 10.0}, {0.0, 1.0, 0.0}, 0.785398f});
    const auto width = [&](double z) {
        return camera.project({1.0, 1.0, z}, 1.0f)->x - camera.project({-1.0, 1.0, z}, 1.0f)->x;
    };
    const float before = width(0.0);
    EXPECT_GT(width(2.0) / width(-2.0), 1.4f);
    camera.set_parallel(true);
    EXPECT_TRUE(camera.is_parallel());
    for (const double z : {0.0, 2.0, -2.0, -500.0, 9.99, 300.0}) // the last point is behind the eye
        EXPECT_NEAR(width(z), before, 1e-5f) << "what is looked at keeps its size, " << z;
    const OrbitCamera copy(camera.pose());
    EXPECT_NEAR(copy.project({1.0, 1.0, -70.0}, 1.0f)->x, 0.5f * before, 1e-5f) << "also for who draws it";
    camera.zoom(3.0f);
    EXPECT_NEAR(width(-70.0), before / 0.729f, 1e-3f);
    camera.zoom(-3.0f);
    camera.set_parallel(false);
    EXPECT_NEAR(width(0.0), before, 1e-3f);
    EXPECT_NEAR(camera.distance(), 10.0f, 1e-4f);
}

TEST(Camera, ParallelRaysAgreeWithTheMatricesFromBeforeTheTargetToBehindTheEye) {
    const OrbitCamera camera({{4.0, 3.0, 8.0}, {0.0, 1.0, 0.0}, 0.785398f, true});
    const Position origin = camera.render_origin();
    for (const float aspect : {0.8f, 1.6f, 2.4f})
        for (const glm::vec2 device : {glm::vec2(0.0f, 0.0f), glm::vec2(0.7f, -0.4f), glm::vec2(-1.0f, 1.0f)}) {
            const Ray cursor = camera.cursor_ray(device, aspect), pick = camera.pick_ray(device, aspect);
            EXPECT_LT(glm::distance(cursor.direction, camera.forward()), 1e-6f);
            const double back = glm::dot(camera.position() - pick.origin, Position(camera.forward()));
            float last_depth = -1.0f;
            for (const double way : {0.01 * back, 0.9 * back, 1.01 * back, 1.9 * back}) {
                const Position point = pick.origin + Position(pick.direction) * way;
                const auto seen = camera.project(point, aspect);
                ASSERT_TRUE(seen);
                EXPECT_LT(glm::distance(*seen, device), 2e-4f);
                const glm::vec4 clip =
                    camera.projection(aspect) * camera.view(origin) * glm::vec4(Vec3(point - origin), 1.0f);
                EXPECT_EQ(clip.w, 1.0f);
                EXPECT_LT(glm::distance(glm::vec2(clip), device), 2e-4f);
                EXPECT_GT(clip.z, last_depth);
                EXPECT_LT(clip.z, 1.0f);
                last_depth = clip.z;
            }
        }
}

TEST(Camera, ParallelRaysMayBeLevelWithAGroundButDoNotComeFromBelow) {
    OrbitCamera camera({{0.0, 5.0, 10.0}, {0.0, 0.0, 0.0}, 0.785398f, true});
    camera.set_grounds({{{0.0, 0.0, 0.0}, {0.0f, 1.0f, 0.0f}}});
    camera.look(0.0f, 0.0f);
    EXPECT_NEAR(camera.forward().y, 0.0f, 1e-6f);
    camera.orbit(0.4f, -0.3f);
    EXPECT_NEAR(camera.forward().y, 0.0f, 1e-6f);
    camera.orbit(0.4f, 0.2f);
    EXPECT_NEAR(camera.forward().y, -std::sin(0.2f), 1e-5f);
    camera.orbit(0.0f, -0.3f);
    camera.set_parallel(false);
    EXPECT_GT(camera.position().y, 0.2) << "an eye stays above it";
}

TEST(Camera, LooksFromTheSidesOfTheWorld) {
    OrbitCamera camera({{3.0, 5.0, 10.0}, {0.0, 1.0, 0.0}, 0.785398f});
    camera.look(0.0f, 0.0f);
    EXPECT_NEAR(camera.forward().z, -1.0f, 1e-5f);
    camera.look(1.5707963f, 0.0f);
    EXPECT_NEAR(camera.forward().x, -1.0f, 1e-5f);
    camera.look(0.0f, 1.5707963f);
    EXPECT_LT(camera.forward().y, -0.999f);
    camera.follow({7.0, 8.0, 9.0});
    EXPECT_EQ(camera.target(), Position(7.0, 8.0, 9.0));
}

} // namespace
