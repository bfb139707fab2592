// Merges the triangles of a hull into faces.
#pragma once

#include "shapes/hull_exact.h"

namespace cairn::hull {

struct Face {
    math::DVec3 normal;             // unit
    std::uint32_t first, count = 0; // corners are loops[first] to loops[first + count - 1], counterclockwise
};

struct Faces {
    std::vector<Face> faces;
    std::vector<std::uint32_t> loops;
    // Points to remove from the input: they are no corners (fewer than three faces) or nearly none (see
    // `corner_tolerance`). The faces may be used only if there are none of these.
    std::vector<std::uint32_t> redundant;
    // False if a point with fewer than three faces protrudes between them: a smaller tolerance is required.
    bool is_sound = true;
};

// `points` are those of the triangulation, all of them used. Neighboring triangles are merged into one face if their
// points lie within `plane_tolerance` (grid units) below the plane of the largest triangle and the outline is convex.
// Once no point is redundant, each corner protrudes by more than `corner_tolerance` beyond the line from the previous
// to the next corner in each of its faces. With both tolerances 0 the result is exact.
Faces make_faces(std::span<const GridPoint> points, std::span<const Triangle> triangles, double plane_tolerance,
                 double corner_tolerance);

} // namespace cairn::hull
