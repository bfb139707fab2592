// Joint drives of the draft: springs and motors, in force and in acceleration mode, with and without a maximum force.
#include "joint_text.h"

#include <gtest/gtest.h>

namespace {

using namespace cairn;
using namespace cairn::scene_test;

const std::string hinge_about_x =
    R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[1,2],"min":0,"max":0}],)";

std::string drive(const std::string& type, const std::string& mode, int axis, const std::string& members) {
    return R"("drives":[{"type":")" + type + R"(","mode":")" + mode + R"(","axis":)" + std::to_string(axis) + members +
           "}]";
}

TEST(JointDrives, ASpringReachesItsTarget) {
    for (const char* mode : {"force", "acceleration"}) {
        for (const int axis : {0, 1, 2}) {
            OneJoint one(joint_text(drive(
                "linear", mode, axis, R"(,"positionTarget":0.75,"stiffness":100,"velocityTarget":0,"damping":20)")));
            one.run(3.0);
            for (int i = 0; i < 3; ++i) EXPECT_NEAR(one.position()[i], i == axis ? 0.75 : 0.0, 1e-4) << mode << axis;
        }
    }
}

TEST(JointDrives, AForceGivesByTheWeightAndAnAccelerationDoesNot) {
    // Equilibrium: k x = m g in force mode, k x = g in acceleration mode.
    for (const char* mode : {"force", "acceleration"}) {
        const bool is_force = mode[0] == 'f';
        std::string text = joint_text(drive("linear", mode, 1, R"(,"positionTarget":0,"stiffness":400,"damping":60)"),
                                      "", "0,-9.81,0");
        text.replace(text.find(R"("mass":1)"), 8, R"("mass":4)");
        OneJoint one(text);
        one.run(6.0);
        EXPECT_NEAR(one.position().y, -9.81 / 400 * (is_force ? 4 : 1), 3e-4) << mode;
    }
}

TEST(JointDrives, AVelocityIsApproachedAtTheRateOfTheDamping) {
    // v = 2 (1 - exp(-c t / m)); in acceleration mode the mass cancels.
    for (const char* mode : {"force", "acceleration"}) {
        const bool is_force = mode[0] == 'f';
        std::string text = joint_text(drive("linear", mode, 0, R"(,"velocityTarget":2,"damping":4)"));
        text.replace(text.find(R"("mass":1)"), 8, R"("mass":4)");
        OneJoint one(text);
        one.run(0.5);
        EXPECT_NEAR(one.speed().x, 2 * (1 - std::exp(is_force ? -0.5 : -2.0)), 0.02) << mode;
        one.run(8.0);
        EXPECT_NEAR(one.speed().x, 2.0, 2e-3) << mode;
    }
}

TEST(JointDrives, AnAngleTurnsTheConnectedNode) {
    for (const double target : {0.5, -1.25}) {
        OneJoint one(joint_text(hinge_about_x +
                                drive("angular", "acceleration", 0,
                                      R"(,"stiffness":100,"damping":20,"positionTarget":)" + std::to_string(target))));
        one.run(3.0);
        EXPECT_NEAR(one.turned().x, target, 1e-3);
    }
    OneJoint one(joint_text(hinge_about_x + drive("angular", "force", 0, R"(,"velocityTarget":-3,"damping":5)")));
    one.run(4.0);
    EXPECT_NEAR(one.spin().x, -3.0f, 1e-3f);
}

TEST(JointDrives, APositionIsThatOfTheConnectedNodeSeenFromTheNodeOfTheJoint) {
    // The joint is on the ball's node, and the world is the connected node: the target puts the world at +0.5, so that
    // the ball goes to -0.5.
    std::string text =
        joint_text(drive("linear", "acceleration", 0, R"(,"positionTarget":0.5,"stiffness":100,"damping":20)"));
    const std::string joint = R"("extensions":{"KHR_physics_rigid_bodies":{"joint":{"joint":0,"connectedNode":2}}})";
    text.erase(text.find("," + joint), joint.size() + 1);
    const std::string frame = R"("name":"frame")";
    std::string reversed = joint;
    reversed.replace(reversed.find(":2}"), 2, ":0");
    text.replace(text.find(frame), frame.size(), frame + "," + reversed);
    OneJoint one(text);
    EXPECT_EQ(one.scene.world.joint_def(one.joint).body_a, one.ball);
    one.run(3.0);
    EXPECT_NEAR(one.position().x, -0.5, 1e-3);
}

TEST(JointDrives, AreBoundedByTheirGreatestForce) {
    // A force of 3 N acts on 1 kg for 1 s.
    OneJoint pushed(joint_text(drive("linear", "force", 2, R"(,"maxForce":3,"velocityTarget":100,"damping":1000)")));
    pushed.run(1.0);
    EXPECT_NEAR(pushed.speed().z, 3.0f, 0.03f);
    OneJoint turned(joint_text(
        hinge_about_x + drive("angular", "acceleration", 0, R"(,"maxForce":2,"velocityTarget":100,"damping":1000)")));
    turned.run(1.0);
    EXPECT_NEAR(turned.spin().x, 2.0f, 0.02f);
    // The maximum force is less than the weight: the ball sinks with the remaining acceleration.
    OneJoint weak(
        joint_text(drive("linear", "force", 1, R"(,"maxForce":5,"positionTarget":0,"stiffness":1e6,"damping":1e4)"), "",
                   "0,-9.81,0"));
    weak.run(1.0);
    EXPECT_NEAR(weak.position().y, -0.5 * (9.81 - 5.0), 0.05);
    // A maximum of 0 is no force at all.
    OneJoint none(joint_text(drive("linear", "force", 1, R"(,"maxForce":0,"positionTarget":1,"stiffness":100)")));
    none.run(1.0);
    EXPECT_EQ(none.position().y, 0.0);
}

TEST(JointDrives, WorkWithinLimits) {
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,2],"min":0,"max":0},{"angularAxes":[0,1,2],"min":0,"max":0},)"
                            R"({"linearAxes":[1],"min":0,"max":0.5}],)" +
                                drive("linear", "force", 1, R"(,"positionTarget":2,"stiffness":100,"damping":20)"),
                            "", "0,-9.81,0"));
    one.run(3.0);
    EXPECT_NEAR(one.position().y, 0.5, 2e-3);
    EXPECT_NEAR(one.position().x, 0.0, 1e-4);
    EXPECT_NEAR(glm::length(one.turned()), 0.0, 1e-4);
}

TEST(JointDrives, SeveralAnglesAtATimeAreARotationVector) {
    std::string drives = R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0}],"drives":[)";
    const char* targets[] = {"0.4", "-0.3", "0.5"};
    for (int i = 0; i < 3; ++i) {
        drives += std::string(i == 0 ? "" : ",") + R"({"type":"angular","mode":"acceleration","axis":)" +
                  std::to_string(i) + R"(,"stiffness":100,"damping":20,"positionTarget":)" + targets[i] + "}";
    }
    OneJoint one(joint_text(drives + "]"));
    one.run(4.0);
    EXPECT_NEAR(one.turned().x, 0.4, 2e-3);
    EXPECT_NEAR(one.turned().y, -0.3, 2e-3);
    EXPECT_NEAR(one.turned().z, 0.5, 2e-3);
}

} // namespace
