// Separating directions of two convex shapes: the separation along each, and the face whose normal it is.
#pragma once

#include "shapes/convex.h"

#include <limits>

namespace cairn {

// Sine of an angle: edges or axes that cross at less are treated as parallel.
inline constexpr double min_crossing = 1e-2;

// A separating direction, and the face whose normal it is, if any.
struct FaceAxis {
    math::DVec3 normal; // from a to b
    double separation = -std::numeric_limits<double>::infinity();
    int face = -1;
    bool is_second = false;        // the face is b's
    int opposite = unknown_vertex; // if the other shape is a hull: its vertex nearest to the face
    math::DVec3 on_face;           // any point of the face
};
struct Axis : FaceAxis {
    math::DVec3 on_a, on_b; // support points of the shapes along the normal and against it
    math::DVec3 touch;      // midway between the nearest points of the cores
};

inline double separation_along(const Convex& a, const Convex& b, math::DVec3 n) {
    return math::dot(n, near_support(b, -n).point - near_support(a, n).point);
}
// Computes the support points of the shapes along the axis, and their separation.
inline void measure(const Convex& a, const Convex& b, Axis& axis) {
    axis.on_a = near_support(a, axis.normal).point;
    axis.on_b = near_support(b, -axis.normal).point;
    axis.separation = math::dot(axis.normal, axis.on_b - axis.on_a);
}

// The face of `c` along whose normal the shapes are farthest apart, if the separation exceeds that of `floor`, and
// `floor` otherwise: this is another face of `c`, or only a separation to exceed. p: any point of the other shape, best
// one near `c`.
FaceAxis best_face(const Convex& c, const Convex& other, const math::DVec3& p, const FaceAxis& floor);

} // namespace cairn
