// Convex polyhedra. What a Hull shares: made once, never changed.
#pragma once

#include "math/bounds.h"
#include "math/vec.h"
#include "shapes/mass.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cairn {

// A plane that the polyhedron lies below, normal . x = offset, and the corners in it: loops[first] to
// loops[first + count - 1], counterclockwise as seen from outside.
struct HullFace {
    math::Vec3 normal;
    float offset = 0;
    std::uint32_t first = 0, count = 0;
};

struct HullData {
    std::vector<math::Vec3> vertices;
    std::vector<HullFace> faces; // triangles of one plane are one face
    std::vector<std::uint32_t> loops;
    // The vertices that share an edge with vertex i: neighbors[neighbor_start[i]] to
    // neighbors[neighbor_start[i + 1] - 1]. neighbor_start has one entry more than vertices.
    std::vector<std::uint32_t> neighbor_start, neighbors;

    // The polyhedron with every face moved inward by `inset`, m (> 0; a small part of its width): its corners, in no
    // particular relation to `vertices`. Two hulls that touch are found apart by their cores.
    std::vector<math::Vec3> core;
    float inset = 0;

    // How exact it is, m: the points that it was made of lie at most this far above the plane of any face, and the
    // corners of a face at most this far off its plane.
    float tolerance = 0;

    MassSum unit_mass;         // of density 1
    math::Vec3 lo, hi;         // bounds
    float bounding_radius = 0; // about the origin of the shape's frame
    float width = 0;           // least distance of two parallel planes that hold it between them (by its faces)
};

// The convex hull of the points. Throws Error(invalid_value) with field "Hull points" (see Hull in shape.h).
HullData build_hull(std::span<const math::Vec3> points);

} // namespace cairn
