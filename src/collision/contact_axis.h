// Directions in which two convex shapes may be separated: how far, and by which face.
#pragma once

#include "shapes/convex.h"

#include <limits>

namespace cairn {

// The sine of the angle at which edges or axes cross: at less they are side by side.
inline constexpr double min_crossing = 1e-2;

// A direction in which the shapes are separated, and the face that it is the normal of, if any.
struct FaceAxis {
    math::DVec3 normal; // from a to b
    double separation = -std::numeric_limits<double>::infinity();
    int face = -1;
    bool is_second = false;        // the face is b's
    int opposite = unknown_vertex; // of the other shape, if it is a hull: its vertex that is nearest to the face
    math::DVec3 on_face;           // some point of the face
};
struct Axis : FaceAxis {
    math::DVec3 on_a, on_b; // the points of the shapes that are farthest along the normal and against it
    math::DVec3 touch;      // midway between the points of the cores that are nearest to each other
};

inline double separation_along(const Convex& a, const Convex& b, math::DVec3 n) {
    return math::dot(n, near_support(b, -n).point - near_support(a, n).point);
}
// The points of the shapes along the axis, and how far they are apart.
inline void measure(const Convex& a, const Convex& b, Axis& axis) {
    axis.on_a = near_support(a, axis.normal).point;
    axis.on_b = near_support(b, -axis.normal).point;
    axis.separation = math::dot(axis.normal, axis.on_b - axis.on_a);
}

// The face of `c` along whose normal the shapes are farthest apart, if more than `floor`: that is one of its faces as
// well, or none with the separation that others must exceed. p: some point of the other, best one that is near.
FaceAxis best_face(const Convex& c, const Convex& other, const math::DVec3& p, const FaceAxis& floor);

} // namespace cairn
