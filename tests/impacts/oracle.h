// A slow, independent reference in double precision for the question whether the cores of two shapes meet along the
// motions of a step. The core of a solid is the solid without the layer of a given depth at its surface; the core of a
// plane, mesh or height field is the surface itself (of an infinite plane, the half-space behind it).
#pragma once

#include <cairn/cairn.h>

#include <limits>
#include <optional>
#include <vector>

namespace cairn_test {

// The convex hull of balls (or points), or a solid of revolution about y with straight sides; expanded by a ball.
struct CorePiece {
    struct Ball {
        glm::dvec3 center{0, 0, 0};
        double radius = 0; // m
    };
    struct Round {
        double low = 0, high = 0;               // m, flat ends along y
        double radius_low = 0, radius_high = 0; // m
    };
    std::vector<Ball> balls{};
    std::optional<Round> round{}; // in place of the balls
    double rounding = 0;          // m, radius of the ball by which it is expanded

    glm::dvec3 support(const glm::dvec3& direction) const; // unit vector
};

struct Core {
    std::vector<CorePiece> pieces{};                   // none: the shape is too thin for a core
    std::optional<glm::dvec3> half_space{};            // the normal of an infinite plane, without pieces
    double reach_from(const glm::dvec3& center) const; // m, radius of the enclosing ball about it
};

// `shrink`, m: the inset of the core from the surface of the shape. It does not apply to surfaces.
Core make_core(const cairn::Shape& shape, double shrink);

// The radius of the largest inscribed ball of a shape, m; of a hull, of that about the mean of its vertices; 0 for
// surfaces.
double inner_radius(const cairn::Shape& shape);

// A pose in double precision.
struct Pose {
    glm::dvec3 position{0, 0, 0};
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 apply(const glm::dvec3& local) const { return position + rotation * local; }
};

// The distance of two pieces, m; 0 if they overlap. It may be too small by a relative 1e-9, never too large.
double separation(const CorePiece& a, const Pose& pose_a, const CorePiece& b, const Pose& pose_b);

// The motion of a shape from one pose to another within a step: the center moves along a line, and the shape rotates
// about it at a constant rate about a constant axis, by the smaller angle.
struct Moving {
    const cairn::Shape* shape;
    cairn::Transform from, to;  // of the shape
    glm::dvec3 center{0, 0, 0}; // center of mass of the body in the shape's frame, m
    double shrink = 0;          // m
    const Core* core = nullptr; // result of make_core for both, if known
    Pose at(double time) const; // `time`: 0 to 1
};

// The time, as a fraction of the step, at which the cores first overlap; none if they do not. Touching, or an overlap
// of less than 1e-5 of the size, may count as either.
std::optional<double> cores_meet(const Moving& a, const Moving& b);
bool cores_overlap_at_start(const Moving& a, const Moving& b);

// The same for shapes whose frames are at the centers of mass, both with the same inset.
bool cores_meet(const cairn::Shape& shape_a, const cairn::Transform& from_a, const cairn::Transform& to_a,
                const cairn::Shape& shape_b, const cairn::Transform& from_b, const cairn::Transform& to_b,
                double core_shrink);

} // namespace cairn_test
