// A body that bounces off a jointed body bounces off the effective mass of the whole joint structure.
#include "support.h"
#include "validation/random_starts.h"

#include <algorithm>
#include <cmath>

namespace cairn_test {
namespace {

Material bouncy(double restitution) {
    Material material;
    material.restitution = float(restitution);
    material.static_friction = material.dynamic_friction = 0;
    return material;
}

Quat attitude(RandomStart& start) {
    return glm::normalize(Quat(float(start.uniform(-1, 1)), float(start.uniform(-1, 1)), float(start.uniform(-1, 1)),
                               float(start.uniform(-1, 1))));
}

// A ball hits a rod that is hinged at one end, perpendicular to the rod and to the hinge axis. With the rod's moment of
// inertia I about the hinge and the hit at distance d from it, conservation of angular momentum about the hinge and
// Newton's law of restitution give the ball the speed v (m d^2 - e I) / (m d^2 + I). Without the joint in the impact,
// the ball rebounded as from a free rod, with 0.31 to 1.65 times the energy.
void expect_rebounds(JointSolver solver) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        RandomStart start(seed);
        const double restitution = seed % 2 == 0 ? 1 : 0.5;
        World world(without_gravity());
        const Quat q = attitude(start);
        const double length = start.uniform(0.5, 1.5), rod_mass = start.uniform(1, 10),
                     ball_mass = rod_mass * std::exp(start.uniform(std::log(0.2), std::log(5.0))),
                     distance = length * start.uniform(0.2, 0.95), speed = start.uniform(2, 10),
                     width = start.uniform(0.02, 0.06), radius = start.uniform(0.03, 0.1);
        BodyDef def;
        def.rotation = q;
        def.position = Position(q * Vec3(0.5 * length, 0, 0));
        def.mass = float(rod_mass);
        const BodyId rod =
            add_body(world, Box{{float(0.5 * length), float(width), float(width)}}, def, bouncy(restitution));
        JointDef joint = world.joint_at(BodyId{}, rod, {0, 0, 0}, q * Vec3(0, 0, 1), HingeJoint{});
        joint.solver = solver;
        world.create_joint(joint);
        const double gap = start.uniform(0.01, 0.3);
        def.position = Position(q * Vec3(distance, -(width + radius + gap), 0));
        def.mass = float(ball_mass);
        def.linear_velocity = float(speed) * (q * Vec3(0, 1, 0));
        const BodyId ball = add_body(world, Sphere{float(radius)}, def, bouncy(restitution));
        const Vec3 came = world.body(ball).linear_velocity();
        double time = 0; // s
        while (time < 0.33) {
            world.step(1.0f / 60);
            time += 1.0 / 60;
            if (glm::length(Vec3(world.body(ball).linear_velocity()) - came) > 0.001f) break; // before a second hit
        }
        const double moment = rod_mass * (length * length / 3 + width * width / 3),
                     seen = double(glm::dot(world.body(ball).linear_velocity(), q * Vec3(0, 1, 0))),
                     lever = ball_mass * distance * distance,
                     meant = speed * (lever - restitution * moment) / (lever + moment);
        EXPECT_NEAR(seen / speed, meant / speed, 0.01) << "start " << seed;
        const double turning = double(glm::dot(world.body(rod).angular_velocity(), q * Vec3(0, 0, 1))),
                     turns = (1 + restitution) * ball_mass * distance * speed / (lever + moment);
        EXPECT_NEAR(turning / turns, 1, 0.01) << "start " << seed;
        // The ball reversed at the time of impact, not at the beginning of the substep.
        const double place = glm::dot(world.body(ball).position(), glm::dvec3(q * Vec3(0, 1, 0))),
                     left = -(width + radius) + seen * (time - gap / speed);
        EXPECT_NEAR(place, left, 0.0002 * speed) << "start " << seed;
    }
}
TEST(ElasticJoints, ABallBouncesOffAHingedRod) { expect_rebounds(JointSolver::iterative); }
TEST(ElasticJoints, ABallBouncesOffAHingedRodThatIsSolvedDirectly) { expect_rebounds(JointSolver::direct); }

// Two balls, each on two strings, that collide again and again at the lowest point.
TEST(ElasticJoints, ACradleOfTwoKeepsItsEnergy) {
    RandomStart start(31);
    for (int i = 0; i < 20; ++i) {
        World world;
        const double length = start.uniform(0.3, 0.9), angle = start.uniform(0.2, 0.7), radius = 0.05;
        const double drop = length * (1 - std::cos(angle)), heading = start.uniform(0, 2 * pi);
        const glm::dquat yaw = glm::angleAxis(heading, glm::dvec3(0, 1, 0));
        for (int k = 0; k < 2; ++k) {
            const glm::dvec3 low(k * 2 * radius, 0, 0);
            BodyDef def;
            def.mass = 0.5f;
            def.position = yaw * (k > 0 ? low : low + glm::dvec3(-length * std::sin(angle), drop, 0));
            const BodyId ball = add_body(world, Sphere{float(radius)}, def, bouncy(1));
            for (const double side : {-0.3, 0.3}) { // two strings, so that the balls swing in their plane
                JointDef string;
                string.body_b = ball;
                string.frame_a.position = yaw * (low + glm::dvec3(0, length, side));
                DistanceJoint distance;
                distance.distance.limits = JointRange{0, float(std::hypot(length, side))};
                string.joint = distance;
                world.create_joint(string);
            }
        }
        const double whole = 0.5 * 9.81 * drop, period = 2 * pi * std::sqrt(length / 9.81) * (1 + angle * angle / 16);
        run(world, 1.0f / 60, int(std::lround(50 * period * 60)));
        EXPECT_NEAR((world.kinetic_energy() + world.potential_energy()) / whole, 1, 0.014) << i;
    }
}

} // namespace
} // namespace cairn_test
