// A single joint on one or two bodies: all of its constraint rows are satisfied in a single solve, whatever the lengths
// and masses. Joints are assigned to the iterative solver; the direct solver has tests of its own.
#include "support.h"
#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>

namespace cairn_test {
namespace {

constexpr double gravity = 9.81;

Vec3 direction(RandomStart& start) {
    const double z = start.uniform(-1, 1), angle = start.uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
    return Vec3(r * std::cos(angle), r * std::sin(angle), z);
}

// A ball at the end of a massless arm, on a hinge to the world whose axis is perpendicular to the arm.
struct ArmWithBall {
    World world;
    BodyId ball;
    JointId joint;
    Vec3 arm, axis;
    double mass;

    template <class MakeHinge>
    ArmWithBall(RandomStart& start, JointSolver solver, const WorldDef& settings, MakeHinge&& make_hinge)
        : world(settings) {
        const double radius = std::exp(start.uniform(std::log(0.01), std::log(0.2)));
        mass = start.uniform(1, 20);
        arm = float(start.uniform(0.3, 1.5)) * direction(start);
        axis = glm::normalize(glm::cross(arm, direction(start)));
        BodyDef def;
        def.position = Position(arm);
        def.mass = float(mass);
        ball = add_body(world, Sphere{float(radius)}, def);
        JointDef joint_def = world.joint_at(BodyId{}, ball, {0, 0, 0}, axis, make_hinge(*this));
        joint_def.solver = solver;
        joint = world.create_joint(joint_def);
    }
    // The torque of the weight about the axis, N m.
    double load() const { return mass * gravity * double(glm::dot(axis, glm::cross(arm, Vec3(0, -1, 0)))); }
    double angle() const { return double(world.joint_state(joint).positions[0]); }
};

// When the rows for the anchor and for the angle were solved one after the other, each undid the result of the other: a
// ball of 1 cm on an arm of 1 m crept by 0.76 rad in 3 s.
TEST(SingleJoints, MotorsAndFrictionHoldWhatTheyCan) {
    for (std::uint32_t seed = 0; seed < 40; ++seed)
        for (const bool is_motor : {false, true}) {
            RandomStart start(seed);
            ArmWithBall arm(start, JointSolver::iterative, without_sleep(), [&](const ArmWithBall& a) {
                const float most = 1.02f * float(std::fabs(a.load()));
                HingeJoint hinge;
                if (is_motor)
                    hinge.angle.motor = JointMotor{.velocity = 0, .max_force = most};
                else
                    hinge.angle.friction = most;
                return hinge;
            });
            for (int i = 0; i < 180; ++i) arm.world.step(1.0f / 60);
            EXPECT_LT(std::fabs(arm.angle()), 2e-3) << "start " << seed << (is_motor ? ", motor" : ", friction");
            EXPECT_LT(arm.world.joint_state(arm.joint).linear_error, 3e-4f) << "start " << seed;
        }
}

// With rows solved one after the other, the limit was exceeded by up to 0.5 rad, and the ball thrown back by up to 0.9
// rad.
TEST(SingleJoints, WhatFallsOnARigidLimitStops) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        RandomStart start(seed);
        double most = 0; // rad; before the arm hangs straight down, so that the weight presses on the limit
        ArmWithBall arm(start, JointSolver::iterative, without_sleep(), [&](const ArmWithBall& a) {
            const Vec3 down(0, -1, 0);
            const double lowest = std::atan2(a.load() / (a.mass * gravity), double(glm::dot(a.arm, down)));
            most = std::fabs(lowest) * start.uniform(0.3, 0.9);
            HingeJoint hinge;
            hinge.angle.limits = JointRange{-float(most), float(most), {}};
            return hinge;
        });
        const double side = arm.load() > 0 ? 1 : -1;
        double reached = 0, least_later = most;
        for (int i = 0; i < 240; ++i) {
            arm.world.step(1.0f / 60);
            const double angle = side * arm.angle();
            if (reached > most - 0.003) least_later = std::min(least_later, angle);
            reached = std::max(reached, angle);
        }
        EXPECT_LT(reached, most + 0.003) << "start " << seed;
        EXPECT_GT(least_later, most - 0.01) << "start " << seed;
    }
}

// In the first 14 steps the reported torque was 0.5 to 1.5 times the actual one, so that joints broke below their
// strength.
TEST(SingleJoints, AFixedJointTellsTheTorqueThatItGives) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        RandomStart start(seed);
        World world(without_sleep());
        const Vec3 half(start.uniform(0.02, 1), start.uniform(0.02, 1), start.uniform(0.02, 1));
        const Vec3 arm = float(start.uniform(0.5, 2)) * direction(start);
        BodyDef def;
        def.position = Position(arm);
        const float mass = float(start.uniform(1, 50));
        def.mass = mass;
        const BodyId body = add_body(world, Box{half}, def);
        const Vec3 weight(0, -mass * float(gravity), 0), torque = -glm::cross(arm, weight);
        JointDef joint_def = world.joint_at(BodyId{}, body, {0, 0, 0}, direction(start), FixedJoint{});
        joint_def.solver = JointSolver::iterative;
        joint_def.break_torque = 1.02f * glm::length(torque);
        joint_def.break_force = -1.02f * weight.y;
        const JointId joint = world.create_joint(joint_def);
        for (int i = 0; i < 30; ++i) {
            world.step(1.0f / 60);
            ASSERT_TRUE(world.is_valid(joint)) << "start " << seed << ", step " << i;
            const JointState state = world.joint_state(joint);
            EXPECT_LT(glm::length(state.torque - torque), 0.01f * glm::length(torque) + 1e-3f) << "start " << seed;
            EXPECT_LT(glm::length(state.force + weight), 0.01f * glm::length(weight)) << "start " << seed;
        }
    }
}

// The frequency of a spring refers to the effective mass of the joint. When the moment of inertia about the body's own
// center was used instead, springs oscillated at a hundredth of it.
TEST(SingleJoints, ASpringSwingsAtTheFrequencyThatItWasMadeFor) {
    for (const JointSolver solver : {JointSolver::iterative, JointSolver::direct})
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            RandomStart start(seed);
            const double hertz = start.uniform(0.5, 2);
            ArmWithBall arm(start, solver, without_gravity(), [&](const ArmWithBall&) {
                HingeJoint hinge;
                hinge.angle.motor.emplace().spring = JointSpring::from_frequency(float(hertz), 0);
                return hinge;
            });
            Body ball = arm.world.body(arm.ball);
            const Vec3 turning = 0.2f * arm.axis;
            ball.set_angular_velocity(turning);
            ball.set_linear_velocity(glm::cross(turning, arm.arm));
            double time = 0, before = 0;
            int crossings = 0;
            double first = 0, last = 0;
            for (int i = 0; i < 600; ++i) {
                arm.world.step(1.0f / 240);
                time += 1.0 / 240;
                const double now = arm.angle();
                if (before * now < 0) {
                    last = time - now / (now - before) / 240;
                    if (crossings++ == 0) first = last;
                }
                before = now;
            }
            ASSERT_GE(crossings, 2) << "start " << seed;
            EXPECT_NEAR(0.5 * (crossings - 1) / (last - first) / hertz, 1, 0.01) << "start " << seed;
        }
}

// A load beside the axis of a slider does not rotate the slider, and stops with it at the limit.
TEST(SingleJoints, WhatHangsBesideASliderStopsAtItsEnd) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        RandomStart start(seed);
        World world(without_gravity());
        const Vec3 axis = direction(start), beside = glm::normalize(glm::cross(axis, direction(start)));
        BodyDef def;
        def.position = Position(float(start.uniform(0.2, 1)) * beside);
        def.mass = float(start.uniform(1, 20));
        const Vec3 velocity = float(start.uniform(0.5, 5)) * axis;
        def.linear_velocity = velocity;
        const BodyId body = add_body(world, Sphere{float(start.uniform(0.03, 0.2))}, def);
        SliderJoint slider;
        slider.translation.limits = JointRange{-0.5f, 0.5f, {}};
        JointDef joint_def = world.joint_at(BodyId{}, body, {0, 0, 0}, axis, slider);
        joint_def.solver = JointSolver::iterative;
        const JointId joint = world.create_joint(joint_def);
        double back = 0, most = 0;
        for (int i = 0; i < 180; ++i) {
            world.step(1.0f / 60);
            const Vec3 v = world.body(body).linear_velocity();
            back = std::min(back, double(glm::dot(v, axis)));
            most = std::max(most, double(world.joint_state(joint).angular_error));
        }
        EXPECT_GT(back, -0.02) << "start " << seed;
        EXPECT_LT(most, 1e-3) << "start " << seed;
        EXPECT_NEAR(world.joint_state(joint).positions[0], 0.5, 2e-3) << "start " << seed;
    }
}

} // namespace
} // namespace cairn_test
