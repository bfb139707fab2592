// Box against box in double precision, written for clarity: the reference for the wide kernels.
#pragma once

#include "collide_test_support.h"

namespace collide_test {

// The separation of two boxes along a unit direction from a to b, negative when their shadows overlap.
double separation_along(const Frame& a, const Frame& b, const Vec& n);

// The axis of greatest separation over all 15; the direction is from a to b.
struct SeparatingAxis {
    double separation;
    Vec normal;
    bool edges;  // a product of two edges
    double sine; // of the angle between these edges; 1 for faces
};
SeparatingAxis greatest_separation(const Frame& a, const Frame& b);

// How far a point is from a box's surface, negative inside.
double distance_to_box(const Frame& box, const Vec& p);

// A polygon as its corners in order, in the plane across `normal`.
using Polygon = std::vector<std::array<double, 2>>;
double area_of(const Polygon& p);
Polygon convex_hull(Polygon points);

// The polygon in which the face of b that looks at a most, cut by the face of a that looks along `normal`
// (or the other way around when the normal is an axis of b), comes closer than `margin`.
struct FaceContact {
    bool is_face; // the normal is an axis of one of the boxes
    Polygon polygon;
};
FaceContact face_contact(const Frame& a, const Frame& b, const Vec& normal, double margin);

// Coordinates across a normal, the same for every point.
std::array<double, 2> across(const Vec& normal, const Vec& p);

} // namespace collide_test
