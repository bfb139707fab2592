// Joint limits of the draft: what each kind constrains, and what it leaves free. All numbers follow from a mass of 1 kg
// and an inertia of 1 kg m^2.
#include "joint_text.h"

#include <gtest/gtest.h>

namespace {

using namespace cairn;
using namespace cairn::scene_test;

constexpr double length_tolerance = 2e-3, angle_tolerance = 5e-3;

TEST(JointLimits, OneLinearAxisKeepsARange) {
    for (const double sign : {1.0, -1.0}) {
        OneJoint one(joint_text(R"("limits":[{"linearAxes":[0],"min":-0.5,"max":1}])",
                                R"(,"linearVelocity":[)" + std::to_string(sign * 2) + ",0.25,-0.5]"));
        double least = 0, most = 0;
        one.run(2.0, [&] {
            least = std::min(least, one.position().x);
            most = std::max(most, one.position().x);
        });
        EXPECT_NEAR(sign > 0 ? most : least, sign > 0 ? 1.0 : -0.5, length_tolerance);
        EXPECT_GT(least, -0.5 - length_tolerance);
        EXPECT_LT(most, 1.0 + length_tolerance);
        EXPECT_NEAR(one.position().y, 0.5, 1e-4); // the other axes are free
        EXPECT_NEAR(one.position().z, -1.0, 1e-4);
        EXPECT_NEAR(one.speed().x, 0.0, 1e-3); // no rebound
    }
}

TEST(JointLimits, OneLinearAxisIsThatOfTheFirstFrame) {
    // The frame's x axis is the world's y axis.
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0],"min":-0.5,"max":0.25}])", "", "0,-9.81,0",
                            R"("rotation":[0,0,0.70710678,0.70710678],)"));
    one.run(2.0);
    EXPECT_NEAR(one.position().y, -0.5, length_tolerance);
}

TEST(JointLimits, OneLinearAxisHoldsOneValue) {
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[1],"min":0.3,"max":0.3}])", "", "1,-9.81,0"));
    one.run(1.0);
    one.run(1.0, [&] { EXPECT_NEAR(one.position().y, 0.3, length_tolerance); });
    EXPECT_GT(one.position().x, 1.9); // t^2 / 2 at 2 s
    EXPECT_NEAR(one.scene.world.joint_state(one.joint).force.y, 9.81f, 0.02f);
}

TEST(JointLimits, ABoundOnOneSideLeavesTheOther) {
    OneJoint below(joint_text(R"("limits":[{"linearAxes":[1],"min":-1}])", R"(,"linearVelocity":[0,3,0])"));
    below.run(1.0);
    EXPECT_NEAR(below.position().y, 3.0, 1e-3);
    OneJoint above(joint_text(R"("limits":[{"linearAxes":[1],"max":1}])", R"(,"linearVelocity":[0,3,0])"));
    above.run(1.0);
    EXPECT_NEAR(above.position().y, 1.0, length_tolerance);
}

TEST(JointLimits, TwoLinearAxesKeepADistanceFromALine) {
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,1],"min":0,"max":0.5}])", R"(,"linearVelocity":[3,4,1])"));
    double most = 0;
    one.run(2.0, [&] { most = std::max(most, glm::length(glm::dvec2(one.position()))); });
    EXPECT_NEAR(most, 0.5, length_tolerance);
    EXPECT_NEAR(one.position().x, 0.3, length_tolerance); // where it reached the limiting cylinder
    EXPECT_NEAR(one.position().y, 0.4, length_tolerance);
    EXPECT_NEAR(one.position().z, 2.0, 1e-3);
}

TEST(JointLimits, TwoLinearAxesKeepARing) {
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,2],"min":0.5,"max":0.75}])", R"(,"linearVelocity":[0.1,0,0])",
                            "1,0,0"));
    one.run(1.0);
    one.run(4.0, [&] {
        const double distance = glm::length(glm::dvec2(one.position().x, one.position().z));
        EXPECT_GT(distance, 0.5 - length_tolerance);
        EXPECT_LT(distance, 0.75 + length_tolerance);
    });
    EXPECT_NEAR(one.position().x, 0.75, length_tolerance);
}

TEST(JointLimits, ThreeLinearAxesAreARope) {
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":1}])", R"(,"linearVelocity":[0.5,0,0.5])",
                            "0,-9.81,0"));
    double most = 0;
    one.run(5.0, [&] { most = std::max(most, glm::length(glm::dvec3(one.position()))); });
    EXPECT_NEAR(most, 1.0, length_tolerance);
    EXPECT_LT(one.position().y, -0.8);
}

TEST(JointLimits, ThreeLinearAxesWithEqualBoundsAreARod) {
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,1,2],"min":0.5,"max":0.5}])",
                            R"(,"linearVelocity":[2,-1,0.5])", "0,-9.81,0"));
    one.run(1.0);
    one.run(4.0, [&] { EXPECT_NEAR(glm::length(glm::dvec3(one.position())), 0.5, length_tolerance); });
}

TEST(JointLimits, OneAngularAxisKeepsARange) {
    for (const double sign : {1.0, -1.0}) {
        for (const int axis : {0, 1, 2}) {
            std::string spin[3] = {"0", "0", "0"}, others[3] = {"1,2", "0,2", "0,1"};
            spin[axis] = std::to_string(sign * 3);
            OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[)" +
                                        others[axis] + R"(],"min":0,"max":0},{"angularAxes":[)" + std::to_string(axis) +
                                        R"(],"min":-0.5,"max":1}])",
                                    R"(,"angularVelocity":[)" + spin[0] + "," + spin[1] + "," + spin[2] + "]"));
            one.run(2.0);
            EXPECT_NEAR(one.turned()[axis], sign > 0 ? 1.0 : -0.5, angle_tolerance) << axis;
            EXPECT_NEAR(one.turned()[(axis + 1) % 3], 0.0, angle_tolerance);
            EXPECT_NEAR(one.turned()[(axis + 2) % 3], 0.0, angle_tolerance);
        }
    }
}

TEST(JointLimits, OneAngularAxisHoldsOneValue) {
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[1,2],"min":0,"max":0},)"
                            R"({"angularAxes":[0],"min":0.7,"max":0.7}])"));
    one.run(1.0);
    EXPECT_NEAR(one.turned().x, 0.7, angle_tolerance);
    EXPECT_NEAR(one.scene.world.joint_state(one.joint).positions[0], 0.7f, float(angle_tolerance));
}

TEST(JointLimits, OneAngularAxisAloneIsTheTwist) {
    // Rotation about y is free; rotation about the twist axis is limited.
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[0],"min":-0.25,)"
                            R"("max":0.25}])",
                            R"(,"angularVelocity":[0,1,0])"));
    one.run(1.0);
    EXPECT_NEAR(one.turned().y, 1.0, 1e-3);
    one.body().set_angular_velocity({2.0f, 0.0f, 0.0f});
    one.run(0.5);
    EXPECT_NEAR(one.scene.world.joint_state(one.joint).positions[0], 0.25f, float(angle_tolerance));
}

TEST(JointLimits, TwoAngularAxesAreACone) {
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[1,2],"max":0.5}])",
                            R"(,"angularVelocity":[0,1.2,1.6])"));
    const auto tilt = [&] {
        const Vec3 x = one.body().rotation() * Vec3(1.0f, 0.0f, 0.0f);
        return std::atan2(std::sqrt(double(x.y) * x.y + double(x.z) * x.z), double(x.x));
    };
    double most = 0;
    one.run(2.0, [&] { most = std::max(most, tilt()); });
    EXPECT_NEAR(most, 0.5, angle_tolerance);
    EXPECT_NEAR(tilt(), 0.5, angle_tolerance);
    const Vec3 axis = one.body().rotation() * Vec3(1.0f, 0.0f, 0.0f);
    one.body().set_angular_velocity(axis);
    one.run(1.0);
    EXPECT_NEAR(glm::dot(one.spin(), axis), 1.0f, 0.02f); // rotation about its own axis is free
}

TEST(JointLimits, ThreeAngularAxesKeepAnyTurn) {
    for (const char* spin : {"2,0,0", "0,-2,0", "1,1,1.4142135"}) {
        OneJoint one(
            joint_text(R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[0,1,2],"max":0.5}])",
                       std::string(R"(,"angularVelocity":[)") + spin + "]"));
        double most = 0;
        one.run(2.0, [&] { most = std::max(most, glm::length(one.turned())); });
        EXPECT_NEAR(most, 0.5, angle_tolerance) << spin;
    }
}

TEST(JointLimits, SoftLinearBoundsAreSprings) {
    // Equilibrium: k x = m g; the rope of 0.25 m stretches by 9.81 / 100.
    OneJoint axis(
        joint_text(R"("limits":[{"linearAxes":[1],"min":0,"max":0,"stiffness":100,"damping":8}])", "", "0,-9.81,0"));
    axis.run(6.0);
    EXPECT_NEAR(axis.position().y, -0.0981, 5e-4);
    OneJoint rope(joint_text(R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0.25,"stiffness":100,"damping":8}])", "",
                             "0,-9.81,0"));
    rope.run(6.0);
    EXPECT_NEAR(rope.position().y, -0.25 - 0.0981, 5e-4);
    // Inside soft limits no force acts.
    OneJoint between(joint_text(R"("limits":[{"linearAxes":[1],"min":-1,"max":1,"stiffness":100,"damping":8}])",
                                R"(,"linearVelocity":[0,0.5,0])"));
    between.run(1.0);
    EXPECT_NEAR(between.speed().y, 0.5f, 1e-4f);
}

TEST(JointLimits, StiffnessSetsTheFrequencyAndDampingTheDecay) {
    // omega = sqrt(k / m) = 10 rad/s, 2 zeta omega = c / m; for c = 1: x is proportional to exp(-t / 2) sin(9.987 t).
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0],"min":0,"max":0,"stiffness":100,"damping":1}])",
                            R"(,"linearVelocity":[2,0,0])"));
    double last = 0, peak = 0, crossing = 0;
    int crossings = 0;
    one.run(2.0, [&] {
        const double x = one.position().x, t = one.scene.world.time();
        if (crossings == 0) peak = std::max(peak, x);
        if (last > 0 && x <= 0 && ++crossings == 1) crossing = t - (1.0 / 60) * x / (x - last);
        last = x;
    });
    EXPECT_NEAR(peak, 0.2 * std::exp(-0.5 * 0.152), 0.01);
    EXPECT_NEAR(crossing, 3.14159 / 9.987, 0.01);
}

TEST(JointLimits, SoftAngularBoundsAreSprings) {
    // A torque of 2 N m against a stiffness of 10 N m/rad beyond 0.25 rad.
    OneJoint one(joint_text(R"("limits":[{"linearAxes":[0,1,2],"min":0,"max":0},{"angularAxes":[1,2],"min":0,"max":0},)"
                            R"({"angularAxes":[0],"min":-0.25,"max":0.25,"stiffness":10,"damping":4}])"));
    one.run(6.0, [&] { one.body().add_torque({2.0f, 0.0f, 0.0f}); });
    EXPECT_NEAR(one.turned().x, 0.45, 2e-3);
}

} // namespace
