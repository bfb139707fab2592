// Convex polyhedra. What a Hull shares: made once, never changed.
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

// A plane that the polyhedron lies below, normal . x = offset, and the corners in it: loops[first] to
// loops[first + count - 1], counterclockwise as seen from outside.
struct HullFace {
    math::Vec3 normal;
    float offset = 0;
    std::uint32_t first = 0, count = 0;
    std::uint32_t first_side = 0; // of a large face, in HullData::sides: the blocks of its sides
};

// The sides of larger faces are kept; those of others are made when they are asked for: in a pile that takes no longer
// than to get them from memory, where they would be half of a hull.
inline constexpr std::size_t made_blocks = 2, max_made_sides = made_blocks * SideBlock::width;

// A face in its own plane: about its first corner, with x along e1, a unit vector in the plane.
struct HullOutline {
    math::DVec3 e1;
    double size = 0; // the largest coordinate of a corner
    std::span<const SideBlock> sides;
};

struct HullData {
    std::vector<math::Vec3> vertices;
    std::vector<HullFace> faces; // triangles of one plane are one face
    std::vector<std::uint32_t> loops;
    // The vertices that share an edge with vertex i: neighbors[neighbor_start[i]] to
    // neighbors[neighbor_start[i + 1] - 1]. neighbor_start has one entry more than vertices.
    std::vector<std::uint32_t> neighbor_start, neighbors;
    std::vector<std::uint32_t> faces_at; // likewise the faces that meet in vertex i: as many as it has neighbors

    // The polyhedron with every face moved inward by `inset`, m (> 0; a small part of its width): its corners, in no
    // particular relation to `vertices`. Two hulls that touch are found apart by their cores.
    Columns core;
    float inset = 0;

    // How exact it is, m: the points that it was made of lie at most this far above the plane of any face, and the
    // corners of a face at most this far off its plane.
    float tolerance = 0;

    // The same, arranged for searches (see arrange).
    Columns vertex_columns;
    PlaneColumns plane_columns;
    std::vector<double> unit_factors; // of the faces: what makes their normals unit vectors in double
    std::vector<SideBlock> sides;     // of large faces
    math::DVec3 inside;               // deep inside: the middle of the bounds, or of mass
    double inner_radius = 0;          // of a ball about that which lies within

    MassSum unit_mass;         // of density 1
    math::Vec3 lo, hi;         // bounds
    float bounding_radius = 0; // about the origin of the shape's frame
    float width = 0;           // least distance of two parallel planes that hold it between them (by its faces)

    math::DVec3 unit_normal(std::size_t face) const { return unit_factors[face] * math::to_double(faces[face].normal); }
};

// Fills the columns, unit factors and sides of a hull that is otherwise complete.
void arrange(HullData& hull);

// `made`: room for the sides of a face that is not large.
HullOutline outline_of(const HullData& hull, std::size_t face, SideBlock (&made)[made_blocks]);

// The convex hull of the points. Throws Error(invalid_value) with field "Hull points" (see Hull in shape.h); also when
// the points are all within 1e-6 m of each other, and when they are thinner than 1e-6 of the largest coordinate (planes
// are kept in floats, and would not be told apart).
//
// What holds for every result, with E the longest side of the bounds and M the largest coordinate:
//   - The surface is closed, V - E + F = 2, and every vertex is one of the points and is in three faces at least.
//   - No point is more than `tolerance` above the plane of a face, no corner of a face more than that off its plane.
//     tolerance = min(1e-5 E + min(2^-20 M, 1e-3 E), 0.05 thickness) + 2^-23 M. The second term lets faces stay flat
//     whose corners were rounded to floats away from the origin, up to 1000 E; beyond, the points are taken as they
//     are. The last term is the rounding of a plane's offset.
//   - Each face is convex once its corners are moved by up to 2^-29 E (to the grid that decisions are exact on), and
//     none of them is then on the line of its neighbors. Triangles of a quarter of the
//     tolerance off a plane are one face wherever that gives a convex one.
//   - Each corner of the core is below all planes by inset (1 - 1e-3) at least, and by inset (1 + 1e-3) at most below
//     three of them, but for rounding to floats (2^-22 M).
// A walk along `neighbors` towards what is higher ends at most `tolerance` below the farthest vertex.
HullData build_hull(std::span<const math::Vec3> points);

} // namespace cairn
