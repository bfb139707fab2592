// A slow answer, of its own and in double, to the question whether the cores of two shapes meet along the motions of a
// step. The core of a solid is the solid without all that is nearer to its surface than some length; that of a plane, a
// mesh or a height field is the surface itself (of an infinite plane, all that is behind it).
#pragma once

#include <cairn/cairn.h>

#include <limits>
#include <optional>
#include <vector>

namespace cairn_test {

// The convex hull of balls, points among them, or a solid of revolution about y with straight sides; and a ball added
// to it.
struct CorePiece {
    struct Ball {
        glm::dvec3 center{0, 0, 0};
        double radius = 0; // m
    };
    struct Round {
        double low = 0, high = 0;               // m: its flat ends, along y
        double radius_low = 0, radius_high = 0; // m
    };
    std::vector<Ball> balls{};
    std::optional<Round> round{}; // instead of them
    double rounding = 0;          // m: radius of the ball that is added

    glm::dvec3 support(const glm::dvec3& direction) const; // unit
};

struct Core {
    std::vector<CorePiece> pieces{};                   // none: the shape is too thin to have a core
    std::optional<glm::dvec3> half_space{};            // of an infinite plane its normal; there are no pieces then
    double reach_from(const glm::dvec3& center) const; // m: of the least ball about it that has all of the core
};

// `shrink`, m: how far inside of the shape its core ends. It does not count for surfaces.
Core make_core(const cairn::Shape& shape, double shrink);

// The radius of a ball inside of the shape, m: the largest there is, but of a hull about the mean of its corners, and 0
// for surfaces.
double inner_radius(const cairn::Shape& shape);

// A pose in double.
struct Pose {
    glm::dvec3 position{0, 0, 0};
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 apply(const glm::dvec3& local) const { return position + rotation * local; }
};

// The distance of two pieces, m; 0 where they overlap. It may be too small by a little (1e-9 of it), never too large.
double separation(const CorePiece& a, const Pose& pose_a, const CorePiece& b, const Pose& pose_b);

// A shape that goes from one pose to another within a step: the center goes in a line, and the shape turns about it at
// a constant rate about a constant axis, the shorter way round.
struct Moving {
    const cairn::Shape* shape;
    cairn::Transform from, to;  // of the shape
    glm::dvec3 center{0, 0, 0}; // in the shape's frame, m: where the body's center of mass is
    double shrink = 0;          // m
    const Core* core = nullptr; // what make_core says of the two, if that is known
    Pose at(double time) const; // 0 to 1
};

// When, as a part of the step, the cores first overlap; none if they do not. What only touches, or overlaps by less
// than a hundred-thousandth of its size, may count as either.
std::optional<double> cores_meet(const Moving& a, const Moving& b);
bool cores_overlap_at_start(const Moving& a, const Moving& b);

// Likewise, of shapes whose frames are at the centers of mass, both with the same shrink.
bool cores_meet(const cairn::Shape& shape_a, const cairn::Transform& from_a, const cairn::Transform& to_a,
                const cairn::Shape& shape_b, const cairn::Transform& from_b, const cairn::Transform& to_b,
                double core_shrink);

} // namespace cairn_test
