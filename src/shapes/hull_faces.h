// From the triangles of a hull to its faces.
#pragma once

#include "shapes/hull_exact.h"

namespace cairn::hull {

struct Face {
    math::DVec3 normal;             // unit
    std::uint32_t first, count = 0; // corners: loops[first] to loops[first + count - 1], counterclockwise
};

struct Faces {
    std::vector<Face> faces;
    std::vector<std::uint32_t> loops;
    // Points that should go: they are no corners (of fewer than three faces) or hardly any (see `corner_tolerance`).
    // While there are any, the faces are not to be used.
    std::vector<std::uint32_t> redundant;
    // False if there is a point of fewer than three faces that sticks out between them: less tolerance is needed.
    bool is_sound = true;
};

// `points` are those of the triangulation, none left over. Neighboring triangles become one face where their points
// lie within `plane_tolerance` (grid units) below the plane of the largest and their outline is convex. Once no point
// is redundant, each corner sticks out by more than `corner_tolerance` beyond the line from the corner before it to
// the one after it, in each of its faces. With both tolerances 0 this is exact.
Faces make_faces(std::span<const GridPoint> points, std::span<const Triangle> triangles, double plane_tolerance,
                 double corner_tolerance);

} // namespace cairn::hull
