// Box-box collision in double precision, written for clarity: the reference for the wide kernels.
#pragma once

#include "collide_test_support.h"

namespace collide_test {

// The separation of two boxes along a unit direction from a to b; negative if their projections overlap.
double separation_along(const Frame& a, const Frame& b, const Vec& n);

// The axis of greatest separation among all 15; it points from a to b.
struct SeparatingAxis {
    double separation;
    Vec normal;
    bool edges;  // a cross product of two edges
    double sine; // sine of the angle between these edges; 1 for faces
};
SeparatingAxis greatest_separation(const Frame& a, const Frame& b);

// Signed distance of a point from a box's surface, negative inside.
double distance_to_box(const Frame& box, const Vec& p);

// A polygon in the plane perpendicular to `normal`, as its vertices in order.
using Polygon = std::vector<std::array<double, 2>>;
double area_of(const Polygon& p);
Polygon convex_hull(Polygon points);

// The incident face of b clipped against the reference face of a whose normal is `normal` (or the reverse if the normal
// is an axis of b), as far as it is closer than `margin`.
struct FaceContact {
    bool is_face; // the normal is an axis of one of the boxes
    Polygon polygon;
};
FaceContact face_contact(const Frame& a, const Frame& b, const Vec& normal, double margin);

// Coordinates in the plane perpendicular to a normal, in the same basis for every point.
std::array<double, 2> across(const Vec& normal, const Vec& p);

} // namespace collide_test
