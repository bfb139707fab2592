#include "viewer/drag.h"

#include "test_scene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::viewer;

constexpr float dt = 1.0f / 60.0f;
const Vec3 ahead(0.0f, 0.0f, -1.0f);

Ray towards(const Position& from, const Position& to) { return {from, Vec3(glm::normalize(to - from))}; }

TEST(DragTarget, FollowsTheCursorInThePlaneFacingTheCamera) {
    const Position grabbed(1.0, 2.0, 3.0);
    const Position target =
        drag_target(towards({0.0, 2.0, 10.0}, {4.0, 5.0, 3.0}), grabbed, ahead, DragConstraint::view_plane);
    EXPECT_NEAR(target.x, 4.0, 1e-5);
    EXPECT_NEAR(target.y, 5.0, 1e-5);
    EXPECT_NEAR(target.z, 3.0, 1e-5);
}

TEST(DragTarget, VerticalKeepsTheFootAndGroundKeepsTheHeight) {
    const Position grabbed(1.0, 2.0, 3.0);
    const Ray ray = towards({0.0, 6.0, 10.0}, {4.0, 1.0, 2.0});
    const Position vertical = drag_target(ray, grabbed, ahead, DragConstraint::vertical);
    EXPECT_EQ(vertical.x, 1.0);
    EXPECT_EQ(vertical.z, 3.0);
    EXPECT_NE(vertical.y, 2.0);
    const Position ground = drag_target(ray, grabbed, ahead, DragConstraint::ground);
    EXPECT_EQ(ground.y, 2.0);
    EXPECT_NE(ground.x, 1.0);
}

TEST(DragTarget, RaysThatMissThePlaneKeepThePoint) {
    const Position grabbed(1.0, 2.0, 3.0);
    const Ray upwards{{0.0, 6.0, 10.0}, glm::normalize(Vec3(0.0f, 1.0f, -1.0f))};
    EXPECT_EQ(drag_target(upwards, grabbed, ahead, DragConstraint::ground), grabbed);
    const Ray level{{0.0, 6.0, 10.0}, ahead};
    EXPECT_EQ(drag_target(level, grabbed, ahead, DragConstraint::ground), grabbed);
}

TEST(DragTarget, ALongRayIsCutShort) {
    const Position eye(0.0, 10.0, 0.0);
    const Ray grazing{eye, glm::normalize(Vec3(0.0f, -1e-5f, -1.0f))};
    const Position target = drag_target(grazing, {0.0, 0.0, -5.0}, ahead, DragConstraint::ground, 100.0);
    EXPECT_LE(glm::distance(target, eye), 110.0);
}

struct Floating {
    World world{WorldDef{.gravity = {0.0f, 0.0f, 0.0f}, .enable_sleep = false}};
    BodyId body;
    JointId drag;

    explicit Floating(float mass, const Vec3& velocity = Vec3(0.0f)) {
        BodyDef def;
        def.linear_velocity = velocity;
        def.mass = mass;
        body = world.create_body(def);
        world.add_shape(body, Box{{0.5f, 0.5f, 0.5f}});
    }
    Position held(const Vec3& local) const {
        const Transform pose = world.body(body).transform();
        return pose.position + Position(pose.rotation * local);
    }
    void pull(const Vec3& local, const Position& target, int steps, float step = dt) {
        if (!drag) drag = world.create_joint(drag_joint(world, body, local));
        for (int i = 0; i < steps; ++i) {
            pull_to(world, drag, target);
            world.step(step);
        }
    }
};

TEST(DragJoint, HeavyAndLightBodiesFollowAlike) {
    const Position target(0.4, 0.8, -0.3);
    Floating light(0.01f), heavy(10000.0f);
    for (int i = 0; i < 60; ++i) {
        light.pull(Vec3(0.0f), target, 1);
        heavy.pull(Vec3(0.0f), target, 1);
        EXPECT_LT(glm::distance(light.held(Vec3(0.0f)), heavy.held(Vec3(0.0f))), 1e-3);
    }
    EXPECT_LT(glm::distance(heavy.held(Vec3(0.0f)), target), 0.01);
}

TEST(DragJoint, ArrivesWithoutOvershooting) {
    Floating scene(5.0f);
    const Position target(0.8, 0.0, 0.0);
    double farthest = 0.0;
    for (int i = 0; i < 120; ++i) {
        scene.pull(Vec3(0.0f), target, 1);
        farthest = std::max(farthest, scene.held(Vec3(0.0f)).x);
    }
    EXPECT_LT(farthest, 0.8 * 1.02);
    EXPECT_GT(farthest, 0.79);
}

TEST(DragJoint, AnOffCenterPointArrivesAndTheSpinDiesDown) {
    Floating scene(5.0f, {0.0f, 3.0f, 0.0f});
    const Vec3 corner(0.5f, 0.5f, 0.5f);
    const Position target(2.0, 1.0, 1.0);
    scene.pull(corner, target, 300);
    EXPECT_LT(glm::distance(scene.held(corner), target), 0.02);
    EXPECT_LT(glm::length(scene.world.body(scene.body).angular_velocity()), 0.1f);
}

TEST(DragJoint, StaysFiniteWithVeryLongSteps) {
    Floating scene(1.0f, {5.0f, 0.0f, 0.0f});
    scene.pull({0.5f, 0.0f, 0.0f}, {3.0, 0.0, 0.0}, 100, 0.5f);
    EXPECT_LT(glm::distance(scene.held({0.5f, 0.0f, 0.0f}), Position(3.0, 0.0, 0.0)), 1.0);
}

TEST(DragJoint, FollowsATargetFarAwayNoFasterThanNearby) {
    Floating scene(2.0f);
    float fastest = 0.0f;
    for (int i = 0; i < 60; ++i) {
        scene.pull(Vec3(0.0f), {500.0, 0.0, 0.0}, 1);
        fastest = std::max(fastest, glm::length(scene.world.body(scene.body).linear_velocity()));
    }
    EXPECT_LT(fastest, 20.0f); // half the angular frequency times the longest stretch
    EXPECT_GT(scene.held(Vec3(0.0f)).x, 8.0);
}

TEST(DragJoint, HoldsABodyAgainstItsWeight) {
    Floating scene(3.0f);
    WorldDef settings = scene.world.settings();
    settings.gravity = {0.0f, -9.81f, 0.0f};
    scene.world.set_settings(settings);
    scene.pull({0.0f, 0.5f, 0.0f}, {0.0, 2.0, 0.0}, 180);
    EXPECT_LT(glm::distance(scene.held({0.0f, 0.5f, 0.0f}), Position(0.0, 2.0, 0.0)), 0.02); // sag g / omega^2 = 1 cm
}

// A box of 1 kg at the bottom of a tower.
TEST(DragJoint, PullingALightBoxFromUnderHeavyOnesThrowsNothingAway) {
    for (const float mass : {15.0f, 2000.0f}) {
        World world;
        world.add_shape(world.create_body(test::static_body()), Plane{});
        std::vector<BodyId> boxes;
        for (int i = 0; i < 4; ++i) {
            BodyDef def;
            def.position = {0.0, 0.5 + 1.0 * i, 0.0};
            def.mass = i == 0 ? 1.0f : mass;
            boxes.push_back(world.create_body(def));
            world.add_shape(boxes.back(), Box{});
        }
        for (int i = 0; i < 60; ++i) world.step(dt);
        const JointId drag = world.create_joint(drag_joint(world, boxes[0], {0.5f, 0.0f, 0.5f}));
        float fastest = 0.0f;
        for (int i = 0; i < 240; ++i) {
            pull_to(world, drag, {6.0, i % 40 < 20 ? 0.5 : 2.0, 3.0});
            world.step(dt);
            for (std::size_t k = 1; k < boxes.size(); ++k)
                fastest = std::max(fastest, glm::length(world.body(boxes[k]).linear_velocity()));
        }
        EXPECT_LT(fastest, 12.0f) << mass; // the boxes fall from a few meters
        for (const BodyId box : boxes) {
            EXPECT_LT(glm::length(Vec3(world.body(box).position())), 12.0f) << mass;
            EXPECT_GT(world.body(box).position().y, 0.0) << mass;
        }
        // The friction under six tons holds the box; that under 45 kg does not.
        EXPECT_EQ(glm::length(Vec3(world.body(boxes[0]).position())) > 4.0f, mass < 100.0f) << mass;
    }
}

// A body of 0.5 kg carries 70 kg that hang from it by joints.
TEST(DragJoint, AHandCarriesItsPuppet) {
    World world;
    BodyDef hand;
    hand.position = {0.0, 3.0, 0.0};
    hand.mass = 0.5f;
    BodyDef trunk;
    trunk.position = {0.0, 2.0, 0.0};
    trunk.mass = 70.0f;
    const BodyId upper = world.create_body(hand), lower = world.create_body(trunk);
    world.add_shape(upper, Sphere{0.1f});
    world.add_shape(lower, Box{{0.2f, 0.4f, 0.1f}});
    const JointId wrist =
        world.create_joint(world.joint_at(upper, lower, {0.0, 2.9, 0.0}, {0.0f, 1.0f, 0.0f}, BallJoint{}));
    const JointId drag = world.create_joint(drag_joint(world, upper, Vec3(0.0f)));
    const Position target(0.5, 4.0, 0.0);
    float gap = 0.0f;
    for (int i = 0; i < 600; ++i) {
        pull_to(world, drag, target);
        world.step(dt);
        gap = std::max(gap, world.joint_state(wrist).linear_error);
    }
    EXPECT_LT(glm::distance(dragged_point(world, drag), target), 0.1);
    EXPECT_LT(gap, 0.05f);
}

TEST(DragJoint, ABodyPullsWhatIsJoinedToIt) {
    Floating scene(1.0f);
    BodyDef def;
    def.position = {-2.0, 0.0, 0.0};
    def.mass = 4.0f;
    const BodyId trailer = scene.world.create_body(def);
    scene.world.add_shape(trailer, Box{{0.5f, 0.5f, 0.5f}});
    scene.world.create_joint(
        scene.world.joint_at(scene.body, trailer, {-1.0, 0.0, 0.0}, {1.0f, 0.0f, 0.0f}, BallJoint{}));
    scene.pull({0.5f, 0.0f, 0.0f}, {4.0, 0.0, 0.0}, 180);
    EXPECT_LT(glm::distance(scene.held({0.5f, 0.0f, 0.0f}), Position(4.0, 0.0, 0.0)), 0.05);
    EXPECT_NEAR(scene.world.body(trailer).position().x, 1.5, 0.1);
    EXPECT_LT(scene.world.joint_state(scene.world.joints().front()).linear_error, 0.01f);
}

TEST(DragJoint, WhatCannotBeMovedStays) {
    World world;
    BodyDef def;
    def.mass = std::numeric_limits<float>::infinity();
    const BodyId body = world.create_body(def);
    world.add_shape(body, Box{});
    const JointId drag = world.create_joint(drag_joint(world, body, {0.5f, 0.5f, 0.0f}));
    for (int i = 0; i < 30; ++i) {
        pull_to(world, drag, {1.5, 0.5, 0.0});
        world.step(dt);
    }
    EXPECT_EQ(world.body(body).position().x, 0.0);
    EXPECT_EQ(world.body(body).rotation(), Quat(1.0f, 0.0f, 0.0f, 0.0f));
}

TEST(DragJoint, ABodyThatCannotTurnIsPulledToo) {
    World world(WorldDef{.gravity = {0.0f, 0.0f, 0.0f}, .enable_sleep = false});
    BodyDef def;
    def.mass_properties = MassProperties{2.0f, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f, 0.0f}};
    const BodyId body = world.create_body(def);
    world.add_shape(body, Box{});
    const JointId drag = world.create_joint(drag_joint(world, body, {0.5f, 0.5f, 0.0f}));
    for (int i = 0; i < 120; ++i) {
        pull_to(world, drag, {1.5, 0.5, 0.0});
        world.step(dt);
    }
    EXPECT_NEAR(world.body(body).position().x, 1.0, 0.01);
    EXPECT_EQ(world.body(body).rotation(), Quat(1.0f, 0.0f, 0.0f, 0.0f));
}

} // namespace
