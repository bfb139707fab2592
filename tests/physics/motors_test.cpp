// Velocity motors at the limits of their axis, and under the load that they lift.
#include "support.h"

#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cairn_test {
namespace {

constexpr float dt = 1.0f / 60.0f;

// A light arm on a joint to the world, and a body on it that a motor drives from one limit to the other.
struct Driven {
    World world;
    JointId joint;
};

Joint driven_joint(int kind, const JointControl& control) {
    if (kind == 0) return HingeJoint{control};
    if (kind == 1) return SliderJoint{control};
    return CylindricalJoint{control, {}};
}

Driven driven(RandomStart& random, int kind, JointSolver solver, float ratio, float velocity, float max_force) {
    Driven result{World(without_sleep()), {}};
    World& world = result.world;
    WorldDef settings = world.settings();
    settings.gravity = Vec3(random.turned({random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)}));
    world.set_settings(settings);
    const BodyId arm =
        world.create_body({.position = random.place({0.5, 0, 0}), .rotation = random.quat(), .mass = 1.0f});
    const BodyId load =
        world.create_body({.position = random.place({1.5, 0, 0}), .rotation = random.quat(), .mass = ratio});
    for (const BodyId body : {arm, load}) world.add_shape(body, Box{{0.4f, 0.1f, 0.1f}});
    JointDef held = world.joint_at({}, arm, random.place({0, 0, 0}), Vec3(random.turned({0, 0, 1})), FixedJoint{});
    held.solver = solver;
    world.create_joint(held);
    JointControl control;
    control.limits = JointRange{-0.4f, 0.5f};
    control.motor = JointMotor{.velocity = velocity, .max_force = max_force};
    const glm::dvec3 axis = kind == 0 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    JointDef def =
        world.joint_at(arm, load, random.place({1, 0, 0}), Vec3(random.turned(axis)), driven_joint(kind, control));
    def.solver = solver;
    result.joint = world.create_joint(def);
    return result;
}

// Limits hold whatever the strength of the motor and the solver. In the direct solver, motors rotated on through both
// limits.
TEST(Motors, StopAtTheLimitsOfTheirAxis) {
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        RandomStart random(seed);
        const int kind = int(seed % 3);
        const auto solver = JointSolver(seed / 3 % 3);
        const double greatest = solver == JointSolver::iterative ? 1.3 : 3; // iterative: not for high mass ratios
        const float ratio = float(std::pow(10, random.uniform(0, greatest))), velocity = float(random.uniform(0.5, 3));
        const float enough = 20 * ratio; // N or N m; gravity contributes at most 3.5 m/s^2
        const float strength =
            seed % 2 ? std::numeric_limits<float>::infinity() : enough * float(random.uniform(1, 100));
        Driven machine = driven(random, kind, solver, ratio, velocity, strength);
        const std::string name = "start " + std::to_string(seed) + ", joint " + std::to_string(kind) + ", solver " +
                                 std::to_string(int(solver));
        const double tolerance = solver == JointSolver::iterative ? 0.03 : 0.005;
        for (const double way : {1.0, -1.0}) {
            Joint joint = machine.world.joint_def(machine.joint).joint;
            JointControl control;
            control.limits = JointRange{-0.4f, 0.5f};
            control.motor = JointMotor{.velocity = float(way) * velocity, .max_force = strength};
            machine.world.set_joint(machine.joint, driven_joint(kind, control));
            double farthest = -1, nearest = 1;
            for (int i = 0; i < 240; ++i) {
                machine.world.step(dt);
                const double at = double(machine.world.joint_state(machine.joint).positions[0]);
                farthest = std::max(farthest, at), nearest = std::min(nearest, at);
            }
            EXPECT_LT(farthest, 0.5 + tolerance) << name;
            EXPECT_GT(nearest, -0.4 - tolerance) << name;
            EXPECT_NEAR(double(machine.world.joint_state(machine.joint).positions[0]), way > 0 ? 0.5 : -0.4, tolerance)
                << name;
        }
    }
}

// A crane: a winch at the end of a rope lifts 100 kg to 20 t steadily, and the joints of the rope do not open.
TEST(Motors, AWinchLiftsItsLoadSteadily) {
    for (const int links : {1, 2, 5, 12, 30})
        for (const float mass : {100.0f, 2000.0f, 20000.0f}) {
            World world(without_sleep());
            BodyId last{};
            Position at(0, 40, 0);
            std::vector<JointId> joints;
            for (int i = 0; i < links; ++i) {
                const BodyId link = world.create_body({.position = at - Position(0, 0.25, 0), .mass = 2.0f});
                world.add_shape(link, Capsule{0.2f, 0.05f});
                joints.push_back(world.create_joint(world.joint_at(last, link, at, {0, 1, 0}, BallJoint{})));
                last = link, at.y -= 0.5;
            }
            const BodyId load = world.create_body({.position = at - Position(0, 5.5, 0), .mass = mass});
            world.add_shape(load, Box{{0.5f, 0.5f, 0.5f}});
            DistanceJoint winch;
            winch.distance.limits = JointRange{0.3f, 10.0f};
            winch.distance.motor = JointMotor{.velocity = -1.0f, .max_force = 1.5f * mass * float(gravity)};
            JointDef def;
            def.body_a = last, def.body_b = load;
            def.frame_a.position = {0, -0.25, 0}, def.frame_b.position = {0, 0.5, 0};
            def.joint = winch;
            const JointId joint = world.create_joint(def);
            run(world, dt, 60);
            double open = 0;
            for (int i = 0; i < 120; ++i) {
                world.step(dt);
                for (const JointId link : joints) open = std::max(open, double(world.joint_state(link).linear_error));
                EXPECT_NEAR(world.body(load).linear_velocity().y, 1, 0.01) << links << " links, " << mass << " kg";
                EXPECT_NEAR(world.joint_state(joint).force.y, double(mass) * gravity, 0.02 * double(mass) * gravity);
            }
            EXPECT_LT(open, 0.001) << links << " links, " << mass << " kg";
            run(world, dt, 240);
            EXPECT_NEAR(double(world.joint_state(joint).positions[0]), 0.3, 0.005)
                << links << " links, " << mass << " kg";
            EXPECT_LT(std::abs(world.body(load).linear_velocity().y), 0.02f) << links << " links, " << mass << " kg";
        }
}

} // namespace
} // namespace cairn_test
