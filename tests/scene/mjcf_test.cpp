// Models in MJCF.
#include "scene_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;
namespace fs = std::filesystem;

using std::numbers::pi;

Scene load_model(const std::string& elements) {
    return load_text(std::string("<mujoco model=\"test\">").append(elements).append("</mujoco>"), "test.xml");
}
Scene load_bodies(const std::string& bodies, const std::string& more = "") {
    return load_model(std::string(more).append("<worldbody>").append(bodies).append("</worldbody>"));
}
std::string text(const glm::dvec3& v) {
    return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z);
}

TEST(Mjcf, GeomsHaveTheMassAndTheBoundsThatTheirSizesSay) {
    struct Case {
        const char* geom;
        double mass;
        glm::dvec3 half; // half extents of the bounds, in the file's axes
    };
    for (const Case& c : {
             Case{R"(<geom size=".3"/>)", 4.0 / 3.0 * pi * 27.0, {.3, .3, .3}},
             Case{R"(<geom type="box" size=".1 .2 .3"/>)", 48.0, {.1, .2, .3}},
             Case{R"(<geom type="cylinder" size=".1 .3"/>)", 6.0 * pi, {.1, .1, .3}},
             Case{R"(<geom type="capsule" size=".1 .3"/>)", 6.0 * pi + 4.0 / 3.0 * pi, {.1, .1, .4}},
             Case{R"(<geom type="capsule" size=".1" fromto="-.3 0 0 .3 0 0"/>)",
                  6.0 * pi + 4.0 / 3.0 * pi,
                  {.4, .1, .1}},
             Case{R"(<geom type="box" size=".1 .2" fromto="0 -.3 0 0 .3 0"/>)", 48.0, {.1, .3, .2}},
             Case{R"(<geom type="ellipsoid" size=".1 .2 .3"/>)", 8.0 * pi, {.1, .2, .3}},
             Case{R"(<geom type="box" size=".1 .2 .3" density="500" euler="0 0 90"/>)", 24.0, {.2, .1, .3}},
             Case{R"(<geom type="box" size=".1 .2 .3" mass="7"/>)", 7.0, {.1, .2, .3}},
         }) {
        SCOPED_TRACE(c.geom);
        Scene scene = load_bodies("<body name=\"b\"><freejoint/>" + std::string(c.geom) + "</body>");
        EXPECT_NEAR(body(scene, "b").mass(), c.mass, 1e-4 * c.mass);
        const Bounds bounds = scene.world.shape_bounds(body(scene, "b").shapes().at(0));
        const glm::dvec3 half = seen(c.half);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(bounds.max[i], std::fabs(half[i]), 0.002) << i; // ellipsoids are approximated by hulls
            EXPECT_NEAR(bounds.min[i], -std::fabs(half[i]), 0.002) << i;
        }
    }
}

TEST(Mjcf, AMeshWeighsWhatItsTrianglesEncloseAndTouchesAsItsHull) {
    // A unit cube in which one face is replaced by a dent to the center: the mass is that of the concave mesh, the
    // shape is its hull.
    const std::string corners = "0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1  .5 .5 .5";
    const std::string faces =
        "0 3 2 0 2 1  0 1 5 0 5 4  1 2 6 1 6 5  2 3 7 2 7 6  3 0 4 3 4 7  4 5 8 5 6 8 6 7 8 7 4 8";
    Scene scene = load_model("<asset><mesh name=\"m\" scale=\"2 1 1\" vertex=\"" + corners + "\" face=\"" + faces +
                             "\"/></asset><worldbody><body name=\"b\"><freejoint/><geom type=\"mesh\" mesh=\"m\" "
                             "density=\"60\"/></body></worldbody>");
    EXPECT_NEAR(body(scene, "b").mass(), 60.0 * 2.0 * (1.0 - 1.0 / 6.0), 1e-3); // minus a pyramid of 1/6
    EXPECT_NEAR(std::get<Hull>(scene.world.shape(body(scene, "b").shapes().at(0))).volume(), 2.0, 1e-5);
}

// Random bodies with one or two joints each, with reference positions, and a key frame that moves all of them.
TEST(Mjcf, JointsStandWhereTheKeyFrameSays) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const auto direction = [&] { return glm::normalize(glm::dvec3(any(random), any(random), any(random))); };
    for (int round = 0; round < 30; ++round) {
        std::string bodies, closing, key;
        std::vector<std::pair<std::string, std::array<double, 2>>> expected;
        for (int i = 0; i < 5; ++i) {
            const glm::dvec3 axis = direction(), other = glm::normalize(glm::cross(axis, direction()));
            const std::string name = std::string("j").append(std::to_string(i)), anchor = text(direction());
            const auto joint = [&](const std::string& joint_name, const char* type, const glm::dvec3& along) {
                const double q = any(random);
                key += std::to_string(q) + " ";
                bodies += std::string("<joint name=\"").append(joint_name) + "\" type=\"" + type + "\" axis=\"" +
                          text(along) + "\" pos=\"" + anchor + "\" ref=\"" + std::to_string(any(random)) +
                          "\" range=\"-2 2\"/>";
                return q;
            };
            bodies += std::string("<body name=\"b").append(std::to_string(i)) + "\" pos=\"" + text(direction()) +
                      "\" euler=\"" + text(direction()) + "\"><geom size=\".1\" contype=\"0\"/>";
            closing += "</body>";
            const int kind = static_cast<int>(random() % 4);
            std::array<double, 2> at{};
            if (kind == 0) at[0] = joint(name, "hinge", axis);
            if (kind == 1) at[0] = joint(name, "slide", axis);
            if (kind == 2) at[0] = joint(name, "hinge", axis), at[1] = joint(name + "b", "hinge", other);
            if (kind == 3) at[0] = joint(name, "slide", axis), at[1] = joint(name + "b", "hinge", axis);
            expected.push_back({kind < 2 ? name : name + "+" + name + "b", at});
        }
        Scene scene = load_model("<compiler angle=\"radian\"/><option gravity=\"0 0 0\"/><worldbody>" + bodies +
                                 closing + "</worldbody><keyframe><key qpos=\"" + key + "\"/></keyframe>");
        for (const auto& [name, at] : expected) {
            const JointState there = joint_state(scene, name.c_str());
            for (int i = 0; i < there.position_count; ++i) {
                EXPECT_NEAR(there.positions[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(i)], 2e-5)
                    << name;
            }
            EXPECT_LT(there.linear_error, 1e-5f) << name;
            EXPECT_LT(there.angular_error, 1e-5f) << name;
        }
    }
}

TEST(Mjcf, RatesOfTheKeyFrameAreThoseOfTheBodies) {
    // A hinge at the origin carries an arm, which carries a slider along it.
    Scene scene = load_model(R"(<compiler angle="radian"/><option gravity="0 0 0"/><worldbody>
        <body name="arm"><joint name="h" axis="0 0 1"/><geom size=".1" pos="1 0 0" contype="0"/>
          <body name="sled" pos="2 0 0"><joint name="s" type="slide" axis="1 0 0"/><geom size=".1" contype="0"/></body>
        </body><body name="free" pos="0 0 9"><freejoint/><geom size=".1"/></body></worldbody>
        <keyframe><key qpos="0 0.5 0 0 9 1 0 0 0" qvel="2 0.25 1 2 3 0.1 0.2 0.3"/></keyframe>)");
    const Vec3 arm = body(scene, "arm").linear_velocity(), sled = body(scene, "sled").linear_velocity();
    EXPECT_NEAR(glm::length(arm - Vec3(seen({0, 2, 0}))), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::length(sled - Vec3(seen({0.25, 5, 0}))), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::length(body(scene, "sled").angular_velocity() - Vec3(seen({0, 0, 2}))), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::length(body(scene, "free").linear_velocity() - Vec3(seen({1, 2, 3}))), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::length(body(scene, "free").angular_velocity() - Vec3(seen({0.1, 0.2, 0.3}))), 0.0f, 1e-5f);
}

TEST(Mjcf, ServosSpringsAndMotorsDoWhatTheirNumbersSay) {
    // Without gravity, each joint follows its own closed form.
    Scene scene = load_model(R"(<compiler angle="radian"/><option gravity="0 0 0" timestep="0.001"/><worldbody>
        <body name="servo"><joint name="servo" axis="0 0 1" damping="1"/><geom size=".1" contype="0"/></body>
        <body name="spring" pos="5 0 0"><joint name="spring" type="slide" axis="1 0 0" stiffness="400" springref="0.1"/>
          <geom size=".1" mass="4" contype="0"/></body>
        <body name="motor" pos="9 0 0"><joint name="motor" type="slide" axis="0 1 0"/>
          <geom size=".1" mass="2" contype="0"/></body>
        </worldbody><actuator><position joint="servo" kp="50" kv="2" ctrlrange="-1 1" gear="2"/>
        <motor joint="motor" gear="3"/></actuator><keyframe><key ctrl="5 0.5"/></keyframe>)");
    run(scene, 0.5 * pi / 10.0); // half a period at sqrt(400 / 4) = 10 rad/s is pi / 10
    EXPECT_NEAR(joint_state(scene, "spring").positions[0], 0.1f, 0.002f);
    run(scene, 0.5 * pi / 10.0);
    EXPECT_NEAR(joint_state(scene, "spring").positions[0], 0.2f, 0.002f);
    EXPECT_NEAR(joint_state(scene, "motor").positions[0], 0.5 * 1.5 / 2.0 * std::pow(pi / 10.0, 2.0), 0.001);
    run(scene, 5.0);
    EXPECT_NEAR(joint_state(scene, "servo").positions[0], 0.5f,
                0.001f); // the control is clamped to 1, and the gear halves it
}

TEST(Mjcf, AnArmatureSlowsAHingeAsARotorWould) {
    // A motor of 1 N m accelerates the body's 0.4 m r^2 plus the armature.
    for (const double armature : {0.0, 0.02, 1.0}) {
        Scene scene =
            load_model("<option gravity=\"0 0 0\"/><worldbody><body name=\"b\"><joint name=\"j\" axis=\"0 0 1\" "
                       "armature=\"" +
                       std::to_string(armature) +
                       "\"/><geom size=\".5\" mass=\"1\" "
                       "contype=\"0\"/></body></worldbody><actuator><motor joint=\"j\"/></actuator>"
                       "<keyframe><key ctrl=\"1\"/></keyframe>");
        run(scene, 0.2);
        EXPECT_NEAR(body(scene, "b").angular_velocity().y, 0.2 / (0.1 + armature), 0.002 / (0.1 + armature));
    }
}

// Without the fix an ankle with a range of 30 to 100 degrees that was drawn at 0 flew off with 17 kJ.
TEST(Mjcf, WhatBeginsOutsideOfItsRangeBeginsAtItsEnd) {
    Scene scene = load_model(R"(<worldbody><body name="b"><joint name="j" axis="0 1 0" range="30 100" armature="1"/>
        <geom type="capsule" fromto="0 0 0 .5 0 0" size=".05" contype="0"/></body></worldbody>)");
    EXPECT_NEAR(joint_state(scene, "j").positions[0], pi / 6, 1e-5);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("outside of its range at the start"), std::string::npos) << scene.warnings[0];
    scene.world.step(0.01f);
    EXPECT_LT(scene.world.kinetic_energy(), 1.0);
}

// Three hinges, all bent to their limits. Without the fix the limits applied to the rotation vector, which differs from
// the angles.
TEST(Mjcf, ThreeHingesThatBeginAtTheirEndsStayThere) {
    for (const char* ends : {"-1.9 -0.5 -0.9", "0.1 0.6 0.3", "0.1 -0.5 0.3", "-1.9 0.6 -0.9"}) {
        Scene scene = load_model(R"(<compiler angle="radian"/><option gravity="0 0 0"/><worldbody><body name="b">
            <joint axis="0 1 0" range="-1.9 0.1"/><joint axis="1 0 0" range="-0.5 0.6"/>
            <joint axis="0 0 1" range="-0.9 0.3"/>
            <geom type="capsule" fromto="0 0 0 .5 0 0" size=".05" contype="0"/></body></worldbody>
            <keyframe><key qpos=")" +
                                 std::string(ends) + "\"/></keyframe>");
        for (int i = 0; i < 50; ++i) scene.world.step(0.01f);
        EXPECT_LT(scene.world.kinetic_energy(), 1e-6) << ends;
    }
}

TEST(Mjcf, GeomsMeetByTheirBits) {
    // Two overlapping balls, which separate if they collide.
    struct Case {
        const char* first;
        const char* second;
        bool meet;
    };
    for (const Case& c : {Case{"", "", true}, Case{R"(contype="0" conaffinity="0")", "", false},
                          Case{R"(contype="2" conaffinity="0")", R"(contype="0" conaffinity="2")", true},
                          Case{R"(contype="2" conaffinity="0")", R"(contype="0" conaffinity="4")", false},
                          Case{R"(contype="0" conaffinity="1")", R"(contype="1" conaffinity="0")", true},
                          Case{R"(contype="0" conaffinity="1")", R"(contype="0" conaffinity="1")", false}}) {
        Scene scene = load_bodies("<body name=\"a\"><freejoint/><geom size=\".5\" " + std::string(c.first) +
                                      "/></body><body name=\"b\" pos=\".9 0 0\"><freejoint/><geom size=\".5\" " +
                                      c.second + "/></body>",
                                  "<option gravity=\"0 0 0\"/>");
        run(scene, 0.5);
        const double gap = body(scene, "b").position().x - body(scene, "a").position().x;
        EXPECT_EQ(gap > 0.95, c.meet) << c.first << " and " << c.second;
    }
}

TEST(Mjcf, PairsMeetAndExcludedBodiesDoNot) {
    const std::string two = R"(<body name="a"><freejoint/><geom name="g" size=".5" BITS/></body>
                               <body name="b" pos=".9 0 0"><freejoint/><geom name="h" size=".5" BITS/></body>)";
    const auto parted = [&](const std::string& bits, const std::string& contact) {
        std::string bodies = two;
        for (std::size_t at; (at = bodies.find("BITS")) != std::string::npos;) bodies.replace(at, 4, bits);
        Scene scene = load_bodies(
            bodies, std::string("<option gravity=\"0 0 0\"/><contact>").append(contact).append("</contact>"));
        run(scene, 0.5);
        return body(scene, "b").position().x - body(scene, "a").position().x > 0.95;
    };
    EXPECT_TRUE(parted("", ""));
    EXPECT_FALSE(parted("", R"(<exclude body1="a" body2="b"/>)"));
    const std::string never = R"(contype="2" conaffinity="4")";
    EXPECT_FALSE(parted(never, ""));
    EXPECT_TRUE(parted(never, R"(<pair geom1="g" geom2="h"/>)"));
}

// Without the fix the light intermediate body hid that the two bodies are jointed: they collided and flew apart.
TEST(Mjcf, BodiesOfSeveralJointsDoNotTouchTheirParents) {
    Scene scene = load_model(R"(<option gravity="0 0 0"/><worldbody><body name="a"><freejoint/><geom size=".2"/>
        <body name="b" pos="0.1 0 0"><joint axis="0 1 0"/><joint axis="1 0 0"/><joint axis="0 0 1"/><geom size=".2"/>
        </body></body></worldbody>)");
    ASSERT_EQ(scene.world.bodies().size(), 3u); // including one between the joints
    EXPECT_NEAR(body(scene, "a").mass() + body(scene, "b").mass() + body(scene, "b between joints").mass(),
                2.0 * 4000.0 / 3.0 * pi * 0.008, 0.1);
    run(scene, 1.0);
    EXPECT_LT(scene.world.kinetic_energy(), 1e-9);
}

TEST(Mjcf, WeldsAndConnectsHold) {
    Scene scene = load_model(R"(<worldbody>
        <body name="a" pos="0 0 3"><freejoint/><geom type="box" size=".1 .1 .1"/></body>
        <body name="b" pos="1 0 3" euler="0 0 30"><freejoint/><geom type="box" size=".1 .1 .1"/></body>
        <body name="c" pos="2 0 3"><freejoint/><geom type="box" size=".1 .1 .1"/></body></worldbody>
        <equality><connect body1="a" body2="world" anchor="0 0 1"/><weld body1="a" body2="b"/>
        <weld name="later" body1="c" active="false"/></equality>)");
    run(scene, 2.0);
    const glm::dvec3 between = body(scene, "b").position() - body(scene, "a").position();
    EXPECT_NEAR(glm::length(between), 1.0, 1e-3);
    EXPECT_GT(body(scene, "a").position().y, 2.0);                            // hangs 1 m below 0 0 4
    EXPECT_NEAR(body(scene, "c").position().y, 3.0 - 0.5 * 9.81 * 4.0, 0.05); // falls freely
    scene.world.set_joint_enabled(scene.world.find_joint("later").value(), true);
    run(scene, 10.0); // it is moved back to its initial position
    EXPECT_NEAR(body(scene, "c").position().y, 3.0, 1e-3);
}

TEST(Mjcf, ClassesFillInWhatElementsLeaveOut) {
    Scene scene = load_model(R"(<default><geom size=".1"/><default class="big"><geom size=".2"/>
        <default class="box"><geom type="box" size=".3 .3 .3"/></default></default></default><worldbody>
        <body name="a" pos="0 0 1"><freejoint/><geom/></body>
        <body name="b" pos="1 0 1" childclass="big"><freejoint/><geom/></body>
        <body name="c" pos="2 0 1" childclass="big"><freejoint/><geom class="box"/></body>
        <body name="d" pos="3 0 1"><freejoint/><geom class="box" size=".4 .4 .4"/></body></worldbody>)");
    const double expected[] = {0.1, 0.2, 0.3, 0.4};
    const char* names[] = {"a", "b", "c", "d"};
    for (std::size_t i = 0; i < 4; ++i) {
        const Bounds bounds = scene.world.shape_bounds(body(scene, names[i]).shapes().at(0));
        EXPECT_NEAR(bounds.max.y - bounds.min.y, 2.0 * expected[i], 1e-5) << names[i];
    }
}

TEST(Mjcf, WhatIsSavedAsGltfSwingsTheSame) {
    Scene scene = load_model(R"(<option timestep="0.005"/><default><geom contype="0"/></default><worldbody>
        <geom type="plane" size="5 5 1" pos="0 0 -3" contype="1"/>
        <body name="a"><joint name="j" axis="0 1 0" damping=".1"/><geom type="capsule" fromto="0 0 0 1 0 0" size=".05"/>
          <body name="b" pos="1 0 0"><joint axis="0 1 0"/><joint axis="0 0 1"/>
            <geom type="capsule" fromto="0 0 0 1 0 0" size=".05"/></body></body></worldbody>)");
    const std::string saved = scene::save_to_string(scene);
    Scene again = load_text(saved);
    EXPECT_EQ(scene::save_to_string(again), saved);
    run(scene, 1.0);
    run(again, 1.0);
    EXPECT_EQ(again.info.time_step, scene.info.time_step);
    EXPECT_LT(glm::length(body(again, "b").position() - body(scene, "b").position()), 1e-3);
    EXPECT_GT(glm::length(body(scene, "b").position() - Position(1, 0, 0)), 0.5);
}

TEST(Mjcf, AFixedBaseStands) {
    const std::string robot = R"(<mujoco><worldbody>
        <body name="base" pos="0 0 2"><freejoint/><geom size=".1"/>
        <body name="arm" pos="0 0 -.5"><joint name="j" axis="0 1 0"/><geom size=".1"/></body></body>
        </worldbody></mujoco>)";
    const fs::path file = fs::path(testing::TempDir()) / "cairn_mjcf_base.xml";
    std::ofstream(file) << robot;
    Scene scene = scene::load(file, {.fixed_base = true});
    fs::remove(file);
    run(scene, 1.0);
    EXPECT_LT(glm::length(body(scene, "base").position() - Position(0, 2, 0)), 1e-12);
    EXPECT_NEAR(body(scene, "arm").position().y, 1.5, 1e-3);
}

} // namespace
