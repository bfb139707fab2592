// Reconstructs the path of a body through a step from its initial and final states, by the laws of motion of a free
// body, in double precision, and independently of the engine.
#pragma once

#include <cairn/cairn.h>

#include <vector>

namespace cairn_test {

struct BodyState {
    glm::dvec3 center{0, 0, 0}; // center of mass, m
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 velocity{0, 0, 0}, spin{0, 0, 0};
};

struct FreeBody {
    glm::dvec3 inertia{0, 0, 0};      // principal moments, kg m^2; 0: constant angular velocity, as of kinematic bodies
    glm::dquat principal{1, 0, 0, 0}; // from the principal axes to the body's
    double reach = 0;                 // m, from the center of mass
    double tolerance = 0;             // m, error allowed for any point of the body
};

// Between knots the center moves along a line, and the body rotates about it at a constant rate about a constant axis,
// by at most 2 rad.
struct Knot {
    double time = 0; // 0 to 1
    glm::dvec3 center{0, 0, 0};
    glm::dquat rotation{1, 0, 0, 0};
};

struct BodyPath {
    std::vector<Knot> knots{}; // none: no such path exists
    bool is_broken = false;    // by an impact
};

// The path between two states `dt` seconds apart of a body without forces, with at most one impact.
BodyPath reconstruct_path(const FreeBody& body, const BodyState& from, const BodyState& to, double dt);

} // namespace cairn_test
