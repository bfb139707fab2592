// The way of a body through a step, found again from how it began and ended: by the laws of motion of what is free, in
// double, and by nothing of the engine.
#pragma once

#include <cairn/cairn.h>

#include <vector>

namespace cairn_test {

struct BodyState {
    glm::dvec3 center{0, 0, 0}; // of mass, m
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 velocity{0, 0, 0}, spin{0, 0, 0};
};

struct FreeBody {
    glm::dvec3 inertia{0, 0, 0};      // kg m^2, principal; 0: its spin stays as it is, as of what is moved
    glm::dquat principal{1, 0, 0, 0}; // from their axes to the body's
    double reach = 0;                 // m: of the body from its center of mass
    double tolerance = 0;             // m: how far off any of its points may be
};

// From knot to knot the center goes in a line, and the body turns about it at a constant rate about a constant axis by
// at most 2 rad.
struct Knot {
    double time = 0; // 0 to 1
    glm::dvec3 center{0, 0, 0};
    glm::dquat rotation{1, 0, 0, 0};
};

struct FlownWay {
    std::vector<Knot> knots{}; // none: there is no such way
    bool is_broken = false;    // by an impact
};

// The way of a body that no force moves from one state to the other in `dt` seconds, with one impact on it or none.
FlownWay find_way(const FreeBody& body, const BodyState& from, const BodyState& to, double dt);

} // namespace cairn_test
