// Queries on convex shapes other than contacts: distance, containment, ray casts and sweeps.
#pragma once

#include "shapes/convex.h"
#include "shapes/mesh.h"

#include <optional>

namespace cairn {

// The nearest points of two shapes, or the deepest points of each within the other if they overlap.
struct ClosestPoints {
    double distance;    // negative: penetration along the normal
    math::DVec3 normal; // unit, from a to b
    math::DVec3 on_a, on_b;
};
ClosestPoints closest_points(const Convex& a, const Convex& b);

// The point of a shape that is nearest to a given point, which is the given point itself if that is inside.
struct NearPoint {
    math::DVec3 point;
    double distance;
    std::uint32_t triangle = no_triangle; // index, for meshes and height fields
};
std::optional<NearPoint> nearest_point(const Convex& c, math::DVec3 to, double max_distance);
// The nearest point of an exact core, with both points in the frame of the shape's center and axes; only for shapes
// that have a closed form of it.
std::optional<math::DVec3> nearest_in_core(const Convex& c, math::DVec3 to);
bool has_nearest(const Convex& c); // whether nearest_in_core has a closed form for the shape

// Whether two shapes have a point in common; touching counts.
bool overlap(const Convex& a, const Convex& b);

// Whether a shape contains a point; its surface counts, within rounding.
bool contains(const Convex& c, math::DVec3 point);

struct ConvexHit {
    double fraction;                      // of the translation, 0 to 1
    math::DVec3 point;                    // on the still shape
    math::DVec3 normal;                   // unit, outward from the still shape
    std::uint32_t triangle = no_triangle; // index, for meshes and height fields
};

// Where a ray from `origin` to `origin + way` hits the shape. A ray that starts inside does not hit.
std::optional<ConvexHit> cast_ray(const Convex& c, math::DVec3 origin, math::DVec3 way);

// Hints about a sweep, for speed.
struct Approach {
    math::DVec3 toward;  // from one shape to the other where they may touch, of any length; 0: unknown
    double fraction = 0; // a fraction before which they do not touch
};

// The time of impact of a shape that moves by `way` without rotating, within a millionth of the smaller shape's size.
// Shapes that overlap at the start hit at 0; shapes that merely touch at the start hit at 0 unless they move apart.
// Hits beyond the fraction `limit` do not count. For a deep overlap only the fraction is returned, with normal 0,
// because the rest takes longest; `overlap_hit` gives the point and normal of the least separating translation.
std::optional<ConvexHit> cast_convex(const Convex& moving, math::DVec3 way, const Convex& still, double limit = 1,
                                     Approach start = {});
ConvexHit overlap_hit(const Convex& moving, const Convex& still);

} // namespace cairn
