// Bodies held together by joints: chains and nets.
#pragma once

#include "validation/worlds.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cairn::validation {

inline BodyId add_dynamic(World& world, const Shape& shape, const Position& at, float mass, float angle = 0) {
    BodyDef def;
    def.position = at;
    def.rotation = glm::angleAxis(angle, Vec3(0, 0, 1));
    def.mass = mass;
    return add_body(world, shape, def);
}

inline JointId hold(World& world, BodyId a, BodyId b, const Position& at, const Joint& joint,
                    JointSolver solver = JointSolver::automatic) {
    JointDef def = world.joint_at(a, b, at, {0, 0, 1}, joint);
    def.solver = solver;
    return world.create_joint(def);
}

// Returns the greatest separation of the anchors of any joint, m; not finite if any of them is not.
inline double greatest_gap(const World& world) {
    double greatest = 0;
    for (const JointId joint : world.joints()) {
        const double gap = double(world.joint_state(joint).linear_error);
        if (!std::isfinite(gap)) return gap;
        greatest = std::max(greatest, gap);
    }
    return greatest;
}

// A chain of links of 0.5 m and 1 kg that hangs from a point at an angle from the vertical, with a ball of 0.6 m at the
// end.
struct Chain {
    std::vector<BodyId> links;
    BodyId ball;
};
inline constexpr double link_length = 0.5; // m

inline Chain add_chain(World& world, int count, float end_mass, const glm::dvec3& from = {}, double angle = 0,
                       JointSolver solver = JointSolver::automatic) {
    const glm::dvec3 along(std::sin(angle), -std::cos(angle), 0);
    Chain chain;
    BodyId above;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 top = from + (link_length * i) * along;
        chain.links.push_back(
            add_dynamic(world, Box{{0.05f, 0.25f, 0.05f}}, top + 0.5 * link_length * along, 1, float(angle)));
        hold(world, above, chain.links.back(), top, BallJoint{}, solver);
        above = chain.links.back();
    }
    const glm::dvec3 end = from + (link_length * count) * along;
    chain.ball = add_dynamic(world, Sphere{0.6f}, end + 0.6 * along, end_mass);
    hold(world, above, chain.ball, end, BallJoint{}, solver);
    return chain;
}

// Two rods of 1 m and 1 kg that start horizontally, the first attached to the origin.
struct DoublePendulum {
    BodyId rods[2];
};
inline DoublePendulum add_double_pendulum(World& world, JointSolver solver) {
    DoublePendulum pendulum;
    BodyId above;
    for (int i = 0; i < 2; ++i) {
        pendulum.rods[i] = add_dynamic(world, Box{{0.5f, 0.05f, 0.05f}}, {0.5 + i, 0, 0}, 1);
        hold(world, above, pendulum.rods[i], {double(i), 0, 0}, BallJoint{}, solver);
        above = pendulum.rods[i];
    }
    return pendulum;
}

// Adds n x n balls of 1 kg, 1 m apart in rows along x and columns along `down`, each joined to its neighbors; the first
// row is attached to the world.
inline void add_net(World& world, int n, const glm::dvec3& down, JointSolver solver = JointSolver::automatic) {
    std::vector<BodyId> bodies;
    for (int i = 0; i < n * n; ++i) {
        const glm::dvec3 at = glm::dvec3(i % n, 0, 0) + double(i / n) * down;
        const BodyId above = i >= n ? bodies[std::size_t(i - n)] : BodyId{};
        bodies.push_back(add_dynamic(world, Sphere{0.4f}, at, 1));
        hold(world, above, bodies.back(), at - 0.5 * down, BallJoint{}, solver);
        if (i % n == 0) continue;
        hold(world, bodies[std::size_t(i - 1)], bodies.back(), at - glm::dvec3(0.5, 0, 0), BallJoint{}, solver);
    }
}

} // namespace cairn::validation
