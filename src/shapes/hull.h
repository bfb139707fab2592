// Convex polyhedra: the immutable data that Hull shapes share.
#pragma once

#include "math/bounds.h"
#include "math/vec.h"
#include "shapes/columns.h"
#include "shapes/mass.h"
#include "shapes/sides.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cairn {

// A face: the polyhedron lies below its plane, normal . x = offset. Its corners are loops[first] to
// loops[first + count - 1], counterclockwise as seen from outside.
struct HullFace {
    math::Vec3 normal;
    float offset = 0;
    std::uint32_t first = 0, count = 0;
    std::uint32_t first_side = 0; // for a large face: its first side block in HullData::sides
};

// The number of side blocks up to which the sides of a face are computed on demand; only larger faces store them. In a
// pile, computing them takes no longer than loading them from memory, where they would be half of a hull's data.
inline constexpr std::size_t made_blocks = 2, max_made_sides = made_blocks * SideBlock::width;

// The outline of a face in its own plane: the origin is its first corner, and x points along e1, a unit vector in the
// plane.
struct HullOutline {
    math::DVec3 e1;
    double size = 0; // the largest coordinate of a corner, m
    std::span<const SideBlock> sides;
};

struct HullData {
    std::vector<math::Vec3> vertices;
    std::vector<HullFace> faces; // coplanar triangles are merged into one face
    std::vector<std::uint32_t> loops;
    // The vertices that share an edge with vertex i: neighbors[neighbor_start[i]] to
    // neighbors[neighbor_start[i + 1] - 1]. neighbor_start has one entry more than vertices.
    std::vector<std::uint32_t> neighbor_start, neighbors;
    std::vector<std::uint32_t> faces_at; // faces that meet in vertex i, at the same indices as its neighbors

    // The corners of the core, which is the polyhedron with every face moved inward by `inset`, m (> 0, a small part of
    // its width); their order is unrelated to `vertices`. Contact normals of touching hulls are computed from their
    // cores.
    Columns core;
    float inset = 0;

    // The accuracy of the hull, m: input points lie at most this far above the plane of any face, and corners of a face
    // at most this far off its plane.
    float tolerance = 0;

    // The data above, rearranged for SIMD searches (see arrange).
    Columns vertex_columns;
    PlaneColumns plane_columns;
    std::vector<double> unit_factors; // per face: the scale that makes its normal a unit vector in double precision
    std::vector<SideBlock> sides;     // of large faces
    math::DVec3 inside;               // a point deep inside: the middle of the bounds, or the center of mass
    double inner_radius = 0;          // of a ball about `inside` that lies within the hull

    MassSum unit_mass;         // at density 1
    math::Vec3 lo, hi;         // bounds
    float bounding_radius = 0; // about the origin of the shape's frame
    float width = 0; // least distance of two parallel planes, one of them through a face, that enclose the hull

    math::DVec3 unit_normal(std::size_t face) const { return unit_factors[face] * math::to_double(faces[face].normal); }
};

// Fills the columns, unit factors and sides of an otherwise complete hull.
void arrange(HullData& hull);

// The outline of a face. `made`: memory for the sides of a face that is not large.
HullOutline outline_of(const HullData& hull, std::size_t face, SideBlock (&made)[made_blocks]);

// Computes the convex hull of the points. Throws Error(invalid_value) with field "Hull points" (see Hull in shape.h),
// also if all points are within 1e-6 m of each other, or if they are thinner than 1e-6 of the largest coordinate (the
// planes are stored as floats and could not be distinguished).
//
// Guarantees, with E the longest side of the bounds and M the largest coordinate:
//   - The surface is closed, V - E + F = 2, and every vertex is an input point and belongs to at least three faces.
//   - No point is more than `tolerance` above the plane of a face, and no corner of a face more than that off
//     its plane.
//     tolerance = min(1e-5 E + min(2^-20 M, 1e-3 E), 0.05 thickness) + 2^-23 M. The second term keeps faces flat whose
//     corners were rounded to floats away from the origin, up to 1000 E; beyond that, the points are taken as they are.
//     The last term is the rounding error of a plane's offset.
//   - Each face is convex after its corners are moved by up to 2^-29 E (to the grid on which decisions are exact), and
//     none of them is then collinear with its neighbors. Triangles within a quarter of the tolerance of a common plane
//     are merged into one face wherever the result is convex.
//   - Each corner of the core is below all planes by at least inset (1 - 1e-3), and below three of them by at most
//     inset (1 + 1e-3), up to rounding to floats (2^-22 M).
// Hill climbing along `neighbors` ends at most `tolerance` below the support vertex.
HullData build_hull(std::span<const math::Vec3> points);

} // namespace cairn
