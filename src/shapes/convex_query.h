// Questions about convex shapes beside contact: distance, containment, rays and sweeps.
#pragma once

#include "shapes/convex.h"
#include "shapes/mesh.h"

#include <optional>

namespace cairn {

// The nearest points of two shapes, or where they overlap the points that are deepest within each other.
struct ClosestPoints {
    double distance;    // < 0: overlap by as much along the normal
    math::DVec3 normal; // unit, from a to b
    math::DVec3 on_a, on_b;
};
ClosestPoints closest_points(const Convex& a, const Convex& b);

// The point of a shape that is nearest to another point, up to a distance; that one itself if it is inside.
struct NearPoint {
    math::DVec3 point;
    double distance;
    std::uint32_t triangle = no_triangle; // of a mesh or height field, if it is on one
};
std::optional<NearPoint> nearest_point(const Convex& c, math::DVec3 to, double max_distance);
// The point of an exact core that is nearest to one, both in the frame of its center and axes, where a formula tells
// it.
std::optional<math::DVec3> nearest_in_core(const Convex& c, math::DVec3 to);
bool has_nearest(const Convex& c); // whether one does

// Whether they have a point in common; touching counts.
bool overlap(const Convex& a, const Convex& b);

// The surface belongs to the shape, within rounding.
bool contains(const Convex& c, math::DVec3 point);

struct ConvexHit {
    double fraction;                      // of the way, 0 to 1
    math::DVec3 point;                    // of the still shape
    math::DVec3 normal;                   // unit, out of the still shape
    std::uint32_t triangle = no_triangle; // of a mesh or height field, if that is it
};

// Where a ray from `origin` over `way` meets the shape. Not met from within.
std::optional<ConvexHit> cast_ray(const Convex& c, math::DVec3 origin, math::DVec3 way);

// What may be known of a sweep before it.
struct Approach {
    math::DVec3 toward;  // from one to the other where they may touch, of any length; 0: unknown
    double fraction = 0; // before which they do not meet
};

// When a shape that moves by `way` without turning first touches another: within a millionth of the size of the smaller
// one. Shapes that overlap from the start meet at 0; those that only touch meet at 0 unless they move apart. Hits
// beyond the fraction `limit` do not count. Of shapes that overlap deep only the fraction is told, as the rest takes
// longest: the normal is 0 then, and `overlap_hit` tells point and normal, those of the least way apart.
std::optional<ConvexHit> cast_convex(const Convex& moving, math::DVec3 way, const Convex& still, double limit = 1,
                                     Approach start = {});
ConvexHit overlap_hit(const Convex& moving, const Convex& still);

} // namespace cairn
