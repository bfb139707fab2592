// Robots from URDF files.
#include "urdf_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace cairn;
using namespace cairn::scene_test;
using scene::Scene;
using scene_test::link; // not POSIX link
namespace fs = std::filesystem;

const std::string bounds = R"(<limit lower="-1" upper="0.5" effort="20" velocity="2"/>)";

const JointDef& def(const Scene& scene, const char* name) {
    return scene.world.joint_def(scene.world.find_joint(name).value());
}
void run_pushed(Scene& scene, double seconds, const std::function<void()>& before_step) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 60)); ++i) {
        before_step();
        scene.world.step(1.0f / 60.0f);
    }
}

TEST(Urdf, StandsUprightInTheWorld) {
    // The file's z axis is up, which is the world's y axis; the file's y axis is the world's -z axis.
    Scene scene = load_robot(link("a") + link("b") +
                             joint("j", "floating", "a", "b", R"(<origin xyz="1 2 3" rpy="0 0 1.5707963"/>)"));
    EXPECT_EQ(scene.info.title, "test");
    EXPECT_EQ(body(scene, "a").position(), Position(0.0));
    const Position b = body(scene, "b").position();
    EXPECT_NEAR(b.x, 1.0, 1e-6);
    EXPECT_NEAR(b.y, 3.0, 1e-6);
    EXPECT_NEAR(b.z, -2.0, 1e-6);
    const Vec3 x = body(scene, "b").rotation() * Vec3(1.0f, 0.0f, 0.0f); // the file's y axis
    EXPECT_NEAR(x.z, -1.0f, 1e-6f);
    EXPECT_EQ(scene.world.settings().gravity, WorldDef{}.gravity);
    run(scene, 0.5);
    EXPECT_NEAR(body(scene, "a").linear_velocity().y, -9.81f * 0.5f, 1e-3f); // the base is free
}

TEST(Urdf, TheWorldLinkDoesNotMove) {
    const std::string ground = link("world", R"(<collision><geometry><box size="4 4 1"/></geometry></collision>)");
    Scene fixed = load_robot(ground + link("base") + link("arm") + joint("mount", "fixed", "world", "base") +
                             joint("hinge", "continuous", "base", "arm", R"(<origin xyz="0 0 2"/>)"));
    EXPECT_EQ(fixed.world.bodies().size(), 2u);
    EXPECT_EQ(body(fixed, "world").type(), BodyType::static_);
    EXPECT_EQ(def(fixed, "hinge").body_a, fixed.world.find_body("world"));

    Scene bare = load_robot(link("world", "") + link("base") +
                            joint("hinge", "continuous", "world", "base", R"(<origin xyz="0 0 2"/>)"));
    EXPECT_EQ(bare.world.bodies().size(), 1u);
    EXPECT_TRUE(def(bare, "hinge").body_a.is_null());
    run(bare, 1.0);
    EXPECT_NEAR(body(bare, "base").position().y, 2.0, 1e-4);

    Scene floats = load_robot(link("world", "") + link("base") + joint("free", "floating", "world", "base"));
    run(floats, 1.0);
    EXPECT_NEAR(body(floats, "base").position().y, -4.9, 0.1);
    EXPECT_TRUE(floats.world.joints().empty());
}

TEST(Urdf, FixedLinksAreOneBody) {
    // Two point masses of 1 and 3 kg, 2 m apart along z, the second one rotated.
    const Scene scene =
        load_robot(link("a", inertial("1")) + link("b", inertial("3")) + link("tip", "") +
                   joint("f", "fixed", "a", "b", R"(<origin xyz="0 0 2" rpy="1.5707963267948966 0 0"/>)") +
                   joint("g", "fixed", "b", "tip"));
    ASSERT_EQ(scene.world.bodies().size(), 1u);
    EXPECT_TRUE(scene.world.joints().empty());
    const MassProperties mass = scene.world.body(scene.world.bodies()[0]).mass_properties();
    EXPECT_NEAR(mass.mass, 4.0f, 1e-6f);
    EXPECT_NEAR(mass.center_of_mass.z, 1.5f, 1e-6f);
    // 0.1 + 0.1 + 1 * 1.5^2 + 3 * 0.5^2; 0.2 + 0.25 + the same; 0.25 + 0.2.
    EXPECT_NEAR(mass.inertia_diagonal.x, 3.2f, 1e-5f);
    EXPECT_NEAR(mass.inertia_diagonal.y, 3.45f, 1e-5f);
    EXPECT_NEAR(mass.inertia_diagonal.z, 0.45f, 1e-5f);
}

TEST(Urdf, InertiaTensorsAreTurnedToTheirAxes) {
    // Principal moments 1, 2 and 3, rotated by 30 degrees about z and then by 40 degrees about x.
    const glm::dmat3 turn =
        glm::mat3_cast(glm::angleAxis(0.6981317, glm::dvec3(1, 0, 0)) * glm::angleAxis(0.5235988, glm::dvec3(0, 0, 1)));
    const glm::dmat3 diagonal(glm::dvec3(1, 0, 0), glm::dvec3(0, 2, 0), glm::dvec3(0, 0, 3));
    const glm::dmat3 tensor = turn * diagonal * glm::transpose(turn);
    char text[300];
    std::snprintf(text, sizeof text,
                  R"(<inertial><mass value="2"/><inertia ixx="%.12f" ixy="%.12f" ixz="%.12f" iyy="%.12f" iyz="%.12f" )"
                  R"(izz="%.12f"/></inertial>)",
                  tensor[0][0], tensor[1][0], tensor[2][0], tensor[1][1], tensor[2][1], tensor[2][2]);
    const Scene scene = load_robot(link("a", text));
    const MassProperties mass = scene.world.body(scene.world.bodies()[0]).mass_properties();
    const glm::dmat3 axes = glm::mat3_cast(glm::dquat(mass.inertia_orientation));
    glm::dmat3 values(0.0);
    for (int i = 0; i < 3; ++i) values[i][i] = double(mass.inertia_diagonal[i]);
    const glm::dmat3 again = axes * values * glm::transpose(axes);
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(again[i / 3][i % 3], tensor[i / 3][i % 3], 1e-6);
}

TEST(Urdf, ShapesStandAsTheFileSays) {
    const auto collision = [](const std::string& geometry, const std::string& origin) {
        return "<collision>" + origin + "<geometry>" + geometry + "</geometry></collision>";
    };
    const Scene scene =
        load_robot(link("a", inertial() + collision(R"(<box size="1 2 3"/>)", R"(<origin xyz="0 0 5"/>)") +
                                 collision(R"(<cylinder radius="0.5" length="4"/>)", R"(<origin xyz="10 0 0"/>)") +
                                 collision(R"(<sphere radius="0.75"/>)", R"(<origin xyz="-10 0 0"/>)") +
                                 R"(<visual><geometry><box size="1 1 1"/></geometry>)"
                                 R"(<material name="m"><color rgba="1 0.5 0 1"/></material></visual>)"));
    const std::vector<ShapeId> shapes = scene.world.body(scene.world.bodies().at(0)).shapes();
    ASSERT_EQ(shapes.size(), 3u);
    const auto expect_bounds = [&](ShapeId shape, Position min, Position max) {
        const Bounds bounds = scene.world.shape_bounds(shape);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(bounds.min[i], min[i], 1e-4);
            EXPECT_NEAR(bounds.max[i], max[i], 1e-4);
        }
    };
    expect_bounds(shapes[0], {-0.5, 3.5, -1.0}, {0.5, 6.5, 1.0});
    expect_bounds(shapes[1], {9.5, -2.0, -0.5}, {10.5, 2.0, 0.5}); // the cylinder's axis is z
    expect_bounds(shapes[2], {-10.75, -0.75, -0.75}, {-9.25, 0.75, 0.75});
    ASSERT_EQ(scene.visuals.size(), 1u);
    EXPECT_EQ(scene.visuals[0].color, Vec3(1.0f, 0.5f, 0.0f));
    ASSERT_EQ(scene.appearances.size(), 3u);
    EXPECT_EQ(scene.appearances[2].color, Vec3(1.0f, 0.5f, 0.0f));
}

TEST(Urdf, JointsBecomeTheirTypes) {
    const Scene scene = load_robot(
        link("a") + link("b") + link("c") + link("d") + link("e") + link("f") +
        joint("revolute", "revolute", "a", "b", bounds + R"(<dynamics damping="0.5" friction="0.25"/>)") +
        joint("continuous", "continuous", "b", "c", R"(<axis xyz="0 0 -2"/>)") +
        joint("prismatic", "prismatic", "c", "d", R"(<limit lower="0" upper="2" effort="0" velocity="0"/>)") +
        joint("planar", "planar", "d", "e") + joint("floating", "floating", "e", "f"));
    EXPECT_EQ(scene.world.joints().size(), 5u);
    const JointControl angle = std::get<HingeJoint>(def(scene, "revolute").joint).angle;
    EXPECT_EQ(angle.limits->lower, -1.0f);
    EXPECT_EQ(angle.limits->upper, 0.5f);
    EXPECT_EQ(angle.friction, 0.25f);
    EXPECT_EQ(angle.motor->max_force, 20.0f);
    EXPECT_EQ(angle.motor->spring->damping, 0.5f);
    EXPECT_EQ(angle.motor->spring->stiffness, 0.0f);
    const JointControl free = std::get<HingeJoint>(def(scene, "continuous").joint).angle;
    EXPECT_FALSE(free.limits.has_value());
    EXPECT_FALSE(free.motor.has_value());
    EXPECT_EQ(std::get<SliderJoint>(def(scene, "prismatic").joint).translation.limits->upper, 2.0f);
    EXPECT_EQ(std::get<GeneralJoint>(def(scene, "planar").joint).limits.size(), 2u);
    EXPECT_TRUE(std::get<GeneralJoint>(def(scene, "floating").joint).limits.empty());
    for (const JointId id : scene.world.joints()) EXPECT_FALSE(scene.world.joint_def(id).enable_collision);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "test.urdf: the velocity limits of 1 joint hold for the targets of motors only; they "
                                 "do not limit other motion");
    ASSERT_EQ(scene.speed_limits.size(), 1u);
    EXPECT_EQ(scene.speed_limits[0].joint, scene.world.find_joint("revolute"));
    EXPECT_EQ(scene.speed_limits[0].speed, 2.0f);
}

TEST(Urdf, PositiveIsTheWayOfTheAxis) {
    // The file's -y axis is the world's +z axis.
    Scene turns =
        load_robot(link("world", "") + link("a") + joint("j", "continuous", "world", "a", R"(<axis xyz="0 -1 0"/>)"));
    body(turns, "a").set_angular_velocity({0.0f, 0.0f, 0.5f});
    run(turns, 1.0);
    EXPECT_NEAR(body(turns, "a").angular_velocity().z, 0.5f, 1e-3f);
    EXPECT_NEAR(joint_state(turns, "j").positions[0], 0.5f, 1e-3f);
    // An arbitrary axis in a rotated origin.
    Scene slides = load_robot(link("world", "") + link("a") +
                              joint("j", "prismatic", "world", "a",
                                    R"(<origin rpy="0.3 -0.7 1.1"/><axis xyz="1 2 -2"/>)"
                                    R"(<limit lower="-9" upper="9" effort="0" velocity="0"/>)"));
    const Position start = body(slides, "a").position();
    const Vec3 along = body(slides, "a").rotation() * Vec3(1 / 3.0f, 2 / 3.0f, -2 / 3.0f);
    body(slides, "a").set_linear_velocity(2.0f * along);
    run(slides, 0.5);
    const double way = glm::dot(body(slides, "a").position() - start, Position(along));
    EXPECT_NEAR(joint_state(slides, "j").positions[0], way, 1e-4);
    EXPECT_NEAR(way, 1.0 - 0.5 * 9.81 * double(along.y) * 0.25, 0.05);
}

TEST(Urdf, PlanarJointsStayInTheirPlane) {
    Scene scene = load_robot(link("world", "") + link("a") +
                             joint("j", "planar", "world", "a", R"(<origin xyz="0 0 1"/><axis xyz="0 0 1"/>)"));
    body(scene, "a").set_linear_velocity({0.5f, 0.0f, -0.25f});
    body(scene, "a").set_angular_velocity({0.0f, 1.0f, 0.0f});
    run(scene, 2.0);
    EXPECT_NEAR(body(scene, "a").position().x, 1.0, 1e-3);
    EXPECT_NEAR(body(scene, "a").position().y, 1.0, 1e-3);
    EXPECT_NEAR(body(scene, "a").position().z, -0.5, 1e-3);
    EXPECT_NEAR(body(scene, "a").angular_velocity().y, 1.0f, 1e-3f);
}

TEST(Urdf, StartsWithinItsLimits) {
    const Scene scene =
        load_robot(link("world", "") + link("a") +
                   joint("j", "revolute", "world", "a",
                         R"(<axis xyz="0 0 1"/><limit lower="0.5" upper="1" effort="0" velocity="0"/>)"));
    EXPECT_NEAR(joint_state(scene, "j").positions[0], 0.5f, 1e-5f);
}

TEST(Urdf, LimitsFrictionAndDampingAct) {
    const auto pendulum = [](const std::string& dynamics) {
        return load_robot(
            link("world", "") + link("a", inertial("1", R"(<origin xyz="1 0 0"/>)")) +
            joint("j", "revolute", "world", "a",
                  R"(<axis xyz="0 1 0"/><limit lower="-2" upper="0.5" effort="0" velocity="0"/>)" + dynamics));
    };
    // It swings down about the file's y axis, by a positive angle, to its limit.
    Scene free = pendulum("");
    run(free, 2.0);
    EXPECT_NEAR(joint_state(free, "j").positions[0], 0.5f, 5e-3f);
    Scene rubs = pendulum(R"(<dynamics friction="12"/>)"); // more than its 9.81 N m
    run(rubs, 2.0);
    EXPECT_NEAR(joint_state(rubs, "j").positions[0], 0.0f, 1e-3f);
    Scene damped = pendulum(R"(<dynamics damping="98.1"/>)");
    run(damped, 2.0);
    EXPECT_NEAR(joint_state(damped, "j").positions[0], 0.2f, 0.02f); // creeps at 0.1 rad/s
}

TEST(Urdf, MimicJointsAreGearsWhereTheyCanBe) {
    const std::string world = link("world", "");
    const auto turning = [](const std::string& name, const std::string& parent, const std::string& child,
                            const std::string& x, const std::string& mimic = "") {
        return joint(name, "continuous", parent, child, "<origin xyz=\"" + x + " 0 0\"/><axis xyz=\"0 1 0\"/>" + mimic);
    };
    Scene scene =
        load_robot(world + link("a") + link("b") + turning("one", "world", "a", "0") +
                   turning("two", "world", "b", "2", R"(<mimic joint="one" multiplier="-0.5" offset="0.25"/>)"));
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_NEAR(joint_state(scene, "two").positions[0], 0.25f, 1e-5f);
    body(scene, "a").set_angular_velocity({0.0f, 0.0f, -2.0f});
    run(scene, 1.0);
    const float one = joint_state(scene, "one").positions[0];
    EXPECT_GT(std::fabs(one), 1.0f);
    EXPECT_NEAR(joint_state(scene, "two").positions[0], 0.25f - 0.5f * one, 5e-3f);

    // Two fingers of a rotating hand: at equal rates the hand's rotation cancels; for other ratios the mimic joint is
    // ignored.
    const std::string hand = world + link("hand") + link("a") + link("b") + turning("wrist", "world", "hand", "0") +
                             turning("one", "hand", "a", "1");
    Scene equal = load_robot(hand + turning("two", "hand", "b", "2", R"(<mimic joint="one"/>)"));
    EXPECT_TRUE(equal.warnings.empty());
    body(equal, "hand").set_angular_velocity({0.0f, 0.0f, 1.0f});
    body(equal, "a").set_angular_velocity({0.0f, 0.0f, 2.0f});
    run(equal, 1.0);
    EXPECT_NEAR(joint_state(equal, "two").positions[0], joint_state(equal, "one").positions[0], 5e-3f);
    const Scene other = load_robot(hand + turning("two", "hand", "b", "2", R"(<mimic joint="one" multiplier="-1"/>)"));
    ASSERT_EQ(other.warnings.size(), 1u);
    EXPECT_EQ(other.warnings[0].substr(0, 52), "test.urdf: joint \"two\": mimic has no effect: the lin");
}

TEST(Urdf, NeighborsDoNotCollide) {
    const std::string ball = inertial() + R"(<collision><geometry><sphere radius="0.5"/></geometry></collision>)";
    Scene scene = load_robot(link("a", ball) + link("b", ball) + link("c", ball) +
                             joint("j", "continuous", "a", "b", R"(<origin xyz="0.5 0 0"/>)") +
                             joint("k", "floating", "b", "c", R"(<origin xyz="0.5 0.25 0"/>)"));
    run(scene, 0.2);
    for (const Contact& contact : scene.world.contacts()) {
        const bool is_far =
            scene.world.body(contact.body_a).name() == "a" && scene.world.body(contact.body_b).name() == "c";
        EXPECT_TRUE(is_far);
    }
}

TEST(Urdf, LinksWithoutMassGetOneWithAWarning) {
    const Scene scene =
        load_robot(link("a", "") + link("b", R"(<collision><geometry><box size="1 1 1"/></geometry></collision>)") +
                   joint("j", "continuous", "a", "b"));
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_EQ(
        scene.warnings[0],
        "test.urdf: link \"a\" has neither inertial nor collision; it is treated as a ball of 1 kg and 0.1 m radius");
    EXPECT_EQ(scene.warnings[1],
              "test.urdf: link \"b\" has no inertial; its mass is computed from its collision shapes at 1000 kg/m3");
    EXPECT_NEAR(scene.world.body(*scene.world.find_body("b")).mass_properties().mass, 1000.0f, 0.01f);
}

TEST(Urdf, MistakesAreNamed) {
    const auto expect_refused = [](const std::string& elements, const std::string& message) {
        try {
            load_robot(elements);
            FAIL() << elements;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()), message);
            EXPECT_EQ(error.code(), ErrorCode::invalid_file);
        }
    };
    const std::string pair = link("a") + link("b");
    expect_refused(link("a", inertial("-2")),
                   "test.urdf: link \"a\": inertial: mass: must be >= 0, and finite, got -2.000000");
    expect_refused(
        link("a",
             R"(<inertial><mass value="1"/><inertia ixx="1" ixy="2" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>)"),
        "test.urdf: link \"a\": inertial: inertia: must have three positive principal moments, got a "
        "principal moment of -1.000000 kg m2");
    expect_refused(link("a", inertial() + R"(<collision><geometry><sphere radius="0"/></geometry></collision>)"),
                   "test.urdf: link \"a\": collision 1: sphere radius: must be > 0, and at most 1000000, got 0");
    expect_refused(pair + joint("j", "revolute", "a", "b", R"(<limit lower="2" upper="1" effort="0" velocity="0"/>)"),
                   "test.urdf: joint \"j\": limit: must have lower <= upper, got 2.000000 to 1.000000");
    expect_refused(pair + joint("j", "continuous", "a", "b", R"(<axis xyz="0 0 0"/>)"),
                   "test.urdf: joint \"j\": axis: must be a vector that is not zero");
    expect_refused(pair + joint("j", "continuous", "a", "b", R"(<dynamics damping="-1"/>)"),
                   "test.urdf: joint \"j\": dynamics damping: must be >= 0, and finite, got -1.000000");
    expect_refused(pair + joint("j", "continuous", "a", "b", R"(<mimic joint="none"/>)"),
                   "test.urdf: joint \"j\": mimic: must be a joint of the robot, got \"none\"");
    expect_refused(pair + joint("j", "continuous", "a", "b", R"(<mimic joint="j"/>)"),
                   "test.urdf: joint \"j\": mimic: must not be circular, or chain more than 16 joints, got \"j\"");
    expect_refused(pair + link("c") + joint("j", "continuous", "b", "c") + joint("k", "continuous", "c", "b"),
                   "test.urdf: link \"b\": must be connected to the root link, \"a\"");
    expect_refused(pair + link("c") + joint("j", "continuous", "a", "b") + joint("k", "continuous", "a", "c") +
                       joint("l", "continuous", "c", "b"),
                   "test.urdf: link \"b\": must be the child of one joint only");
    std::string deep;
    for (int i = 0; i < 100; ++i) deep += "<a>";
    expect_refused(deep, "test.urdf: must have at most 64 elements inside each other");
    expect_refused("\n<link name=>", "test.urdf:2: is not valid XML: Error reading end tag.");
    // The parser's own message, prefixed with the file name.
    for (
        const std::string& broken :
        {link(
             "a",
             R"(<inertial><mass value="heavy"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>)"),
         pair + joint("j", "sideways", "a", "b"), pair + joint("j", "continuous", "a", "missing"), pair, std::string(),
         std::string("<link"), link("a") + link("a"),
         pair + joint("j", "continuous", "a", "b", R"(<origin xyz="1 2"/>)")}) {
        try {
            load_robot(broken);
            FAIL() << broken;
        } catch (const Error& error) {
            std::printf("%s\n", error.what());
            EXPECT_EQ(std::string(error.what()).find("test.urdf:"), 0u);
            EXPECT_EQ(error.code(), ErrorCode::invalid_file);
        }
    }
}

TEST(Urdf, IsSavedAsAScene) {
    const Scene arm = scene::load(fs::path(CAIRN_TEST_DATA) / "arm.urdf");
    const std::string text = scene::save_to_string(arm);
    const Scene again = load_text(text);
    EXPECT_TRUE(scene::save_to_string(again) == text);
    EXPECT_TRUE(again.warnings.empty());
    ASSERT_EQ(again.world.joints().size(), arm.world.joints().size());
    EXPECT_EQ(again.world.bodies().size(), 7u);
    EXPECT_EQ(again.visuals.size(), 7u);
    const auto& lift = std::get<HingeJoint>(def(again, "lift").joint);
    EXPECT_EQ(lift.angle.motor->max_force, 150.0f);
    EXPECT_EQ(lift.angle.limits->lower, -3.1f);
}

// Six servos move the arm from upright to a stretched-out pose, against gravity torques of up to 40 N m.
TEST(Urdf, AnArmHoldsAPoseAgainstItsWeight) {
    Scene arm = scene::load(fs::path(CAIRN_TEST_DATA) / "arm.urdf");
    const std::array<const char*, 6> names{"turn", "lift", "elbow", "wrist_bend", "wrist_turn", "wrist_roll"};
    const std::array<float, 6> pose{0.6f, 1.2f, 0.5f, -0.9f, 0.7f, 1.5f}, stiffness{1e5f, 1e5f, 1e5f, 1e4f, 1e4f, 1e4f};
    ASSERT_EQ(arm.world.joints().size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        const JointId id = arm.world.find_joint(names[i]).value();
        HingeJoint hinge = std::get<HingeJoint>(arm.world.joint_def(id).joint);
        hinge.angle.motor->position = pose[i];
        hinge.angle.motor->spring = JointSpring{stiffness[i], 0.1f * stiffness[i], false};
        arm.world.set_joint(id, hinge);
    }
    run(arm, 5.0);
    std::array<double, 6> worst{};
    double gap = 0, max_torque = 0;
    run_pushed(arm, 5.0, [&] {
        for (std::size_t i = 0; i < 6; ++i) {
            const JointState now = joint_state(arm, names[i]);
            worst[i] = std::max(worst[i], std::fabs(double(now.positions[0]) - double(pose[i])) * 57.29577951);
            gap = std::max(gap, double(now.linear_error));
            max_torque = std::max(max_torque, double(glm::length(now.torque)));
        }
    });
    for (std::size_t i = 0; i < 6; ++i) {
        std::printf("%-10s %.4f degrees off\n", names[i], worst[i]);
        EXPECT_LT(worst[i], 0.1);
    }
    std::printf("gaps %.2e m, torques up to %.1f N m\n", gap, max_torque);
    EXPECT_LT(gap, 2e-4);
    EXPECT_GT(max_torque, 20.0); // gravity does act
}

} // namespace
