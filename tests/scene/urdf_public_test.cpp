// Physically impossible or unusual data in the URDF files of public robots, and how it is interpreted.
#include "urdf_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;
using scene_test::link; // not POSIX link

// The dummy base links of public robots have this inertia: all nine entries are equal, so that only one principal
// moment is nonzero.
TEST(PublicRobots, AnInertiaOfRankOneIsTakenAsTheNearestOfABody) {
    const Scene scene = load_robot(
        link("a", R"(<inertial><mass value="1e-6"/>)"
                  R"(<inertia ixx="1e-6" ixy="1e-6" ixz="1e-6" iyy="1e-6" iyz="1e-6" izz="1e-6"/></inertial>)"));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("the nearest possible moments are used"), std::string::npos) << scene.warnings[0];
    const Vec3 moments = scene.world.body(scene.world.bodies()[0]).mass_properties().inertia_diagonal;
    EXPECT_NEAR(std::max({moments.x, moments.y, moments.z}), 2e-6f, 1e-11f);
    EXPECT_NEAR(std::min({moments.x, moments.y, moments.z}), 1e-6f, 1e-11f);
    EXPECT_NEAR(moments.x + moments.y + moments.z, 4e-6f, 1e-11f);
}

// A tenth of all links of public robots only represent frames, and are fixed to a real link; their inertia is
// physically impossible.
TEST(PublicRobots, OnlyTheInertiaOfAllLinksOfABodyTogetherMustBeThatOfABody) {
    const std::string frame = R"(<inertial><mass value="1e-6"/>)"
                              R"(<inertia ixx="1e-9" ixy="2e-9" ixz="0" iyy="1e-9" iyz="0" izz="1e-9"/></inertial>)";
    const Scene scene = load_robot(link("a", inertial("2")) + link("b", frame) + joint("j", "fixed", "a", "b"));
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_NEAR(scene.world.body(scene.world.bodies()[0]).mass_properties().mass, 2.0f, 1e-5f);
}

// An inertia of about 1e-20 for 2 kg means that none is given.
TEST(PublicRobots, AnInertiaThatIsNextToNothingIsTakenAsNone) {
    const Scene scene =
        load_robot(link("a", R"(<inertial><mass value="2"/>)"
                             R"(<inertia ixx="1e-20" ixy="-1e-20" ixz="0" iyy="0" iyz="0" izz="4e-18"/></inertial>)"));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("the inertia of a ball of 0.1 m radius is used"), std::string::npos);
}

// The contact point of a leg: 10 g without inertia, 0.16 m below a shank. Without the fix it was taken as a ball of 0.1
// m radius.
TEST(PublicRobots, ALinkWithoutInertiaThatIsFixedToOneWithSomeIsAPoint) {
    const Scene scene = load_robot(
        link("a", inertial("2")) +
        link("b",
             R"(<inertial><mass value="2"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial>)") +
        joint("j", "fixed", "a", "b", R"(<origin xyz="0 0 1"/>)"));
    EXPECT_TRUE(scene.warnings.empty());
    const auto of = [](const Scene& robot) { return robot.world.body(robot.world.bodies()[0]).mass_properties(); };
    const float alone = of(load_robot(link("a", inertial("2")))).inertia_diagonal.x;
    EXPECT_NEAR(of(scene).inertia_diagonal.x - alone, 1.0f, 1e-5f); // two masses of 2 kg, 1 m apart
}

// Hulls of hollow links overlap other links of the robot: here the first and the last of three links in a row.
TEST(PublicRobots, LinksThatOverlapAsTheRobotIsDrawnDoNotPushEachOtherAway) {
    const auto ball = [](const std::string& radius) {
        return inertial() + "<collision><geometry><sphere radius=\"" + radius + "\"/></geometry></collision>";
    };
    const auto hinge = [](const std::string& name, const std::string& from, const std::string& to) {
        return joint(name, "continuous", from, to, R"(<origin xyz="0.3 0 0"/><axis xyz="0 0 1"/>)");
    };
    Scene scene =
        load_robot(link("a", ball("0.5")) + link("b", ball("0.1")) + link("c", ball("0.5")) + link("d", ball("0.1")) +
                   hinge("j", "a", "b") + hinge("k", "b", "c") + hinge("l", "c", "d"));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "test.urdf: links that overlap in the initial pose do not collide: \"a\" and \"c\"");
    for (int i = 0; i < 60; ++i) scene.world.step(1.0f / 60.0f);
    for (const BodyId id : scene.world.bodies()) {
        EXPECT_LT(glm::length(scene.world.body(id).angular_velocity()), 1e-3f); // it falls in its initial configuration
    }
    // The links collide with everything else.
    BodyDef ground;
    ground.type = BodyType::static_;
    ground.position = body(scene, "c").position() - Position(0, 1, 0);
    scene.world.add_shape(scene.world.create_body(ground), Plane{});
    for (int i = 0; i < 120; ++i) scene.world.step(1.0f / 60.0f);
    EXPECT_NEAR(body(scene, "c").position().y, ground.position.y + 0.5, 0.01);
}

// In tiago_dual 68 pairs of links overlap. Without the fix both links of each pair had a layer of their own, and there
// are only 63.
TEST(PublicRobots, EightyLinksThatOverlapInPairsAndOneThatOverlapsAllDoNotPushEachOtherAway) {
    const auto ball = [](const std::string& radius) {
        return inertial() + "<collision><geometry><sphere radius=\"" + radius + "\"/></geometry></collision>";
    };
    std::string robot = link("root") + link("hub", ball("45")) +
                        joint("j", "continuous", "root", "hub", R"(<origin xyz="0 0 0"/><axis xyz="0 0 1"/>)");
    for (int i = 0; i < 40; ++i) {
        for (const char* half : {"a", "b"}) {
            const std::string name = half + std::to_string(i);
            robot +=
                link(name, ball("0.4")) + joint("to_" + name, "continuous", "root", name,
                                                "<origin xyz=\"" + std::to_string(i) + R"( 0 0"/><axis xyz="0 0 1"/>)");
        }
    }
    Scene scene = load_robot(robot);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0].find("more pairs do collide"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[0].find("117 other pairs"), std::string::npos) << scene.warnings[0];
    EXPECT_TRUE(scene.world.contacts().empty());
    for (int i = 0; i < 3; ++i) scene.world.step(1.0f / 60.0f);
    EXPECT_TRUE(scene.world.contacts().empty());
    Scene again = load_text(scene::save_to_string(scene));
    for (int i = 0; i < 3; ++i) again.world.step(1.0f / 60.0f);
    EXPECT_TRUE(again.world.contacts().empty());
}

// The floor (link "world") does not count as a link of the robot: a link that overlaps it initially still collides.
TEST(PublicRobots, WhatStandsTooDeepInTheLinkWorldIsHeldByItAllTheSame) {
    Scene scene =
        load_robot(link("world", R"(<collision><geometry><box size="9 9 1"/></geometry></collision>)") +
                   link("a", inertial() + R"(<collision><geometry><sphere radius="0.5"/></geometry></collision>)") +
                   joint("j", "floating", "world", "a", R"(<origin xyz="0 0 0.95"/>)"));
    for (int i = 0; i < 120; ++i) scene.world.step(1.0f / 60.0f);
    EXPECT_NEAR(scene.world.body(*scene.world.find_body("a")).position().y, 1.0, 0.01);
}

// Rotors with limits of 1e16 rad.
TEST(PublicRobots, ALimitBeyondABillionIsNone) {
    const Scene scene = load_robot(
        link("a") + link("b") + link("c") +
        joint("free", "revolute", "a", "b", R"(<limit lower="-1e16" upper="1e16" effort="1" velocity="1"/>)") +
        joint("half", "revolute", "a", "c", R"(<limit lower="-1" upper="1e16" effort="1" velocity="1"/>)"));
    const auto limits = [&](const char* name) {
        return std::get<HingeJoint>(scene.world.joint_def(scene.world.find_joint(name).value()).joint).angle.limits;
    };
    EXPECT_FALSE(limits("free"));
    ASSERT_TRUE(limits("half"));
    EXPECT_EQ(limits("half")->lower, -1.0f);
    EXPECT_EQ(limits("half")->upper, 1e9f);
}

} // namespace
