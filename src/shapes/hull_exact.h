// Convex hulls of points with integer coordinates. All decisions about the side of a plane on which a point lies are
// exact, so that the surface is closed and convex for any input; tolerances only decide which points may be left out.
#pragma once

#include "math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cairn::hull {

// Coordinates from 0 to 2^30, so that the normal of three points fits 64 bits, and the orientation test of a fourth 128
// bits.
struct GridPoint {
    std::int32_t x = 0, y = 0, z = 0;
};
inline constexpr int grid_bits = 30;

struct GridVector {
    std::int64_t x = 0, y = 0, z = 0;
};

constexpr math::DVec3 to_double(GridPoint p) { return {double(p.x), double(p.y), double(p.z)}; }
constexpr math::DVec3 to_double(GridVector v) { return {double(v.x), double(v.y), double(v.z)}; }

// (b - a) x (c - a): the normal of a triangle, with twice its area as length.
GridVector area_vector(GridPoint a, GridPoint b, GridPoint c);
// 1 if p is above the plane of a, b, c (from where they appear counterclockwise), 0 on it, -1 below.
int side_of(GridPoint a, GridPoint b, GridPoint c, GridPoint p);

// Four points that span a large volume: two far apart, one far from their line, and one far from the plane of these
// three.
struct Simplex {
    std::uint32_t corners[4]{};
    double breadth = 0;   // distance of the third point from the line
    double thickness = 0; // extent of all points across the plane of the first three, on both sides together
};
// Requires at least four points. If breadth or thickness is 0, the points span no simplex.
Simplex first_simplex(std::span<const GridPoint> points);

struct Triangle {
    std::uint32_t corners[3];   // counterclockwise as seen from outside
    std::uint32_t neighbors[3]; // neighbors[i]: across the edge from corner i to corner i + 1
};

struct Triangulation {
    std::vector<std::uint32_t> points; // points that became corners: ascending indices of the input
    std::vector<Triangle> triangles;   // their corners are indices into `points`
    // Points that may lie outside, by at most 2 x tolerance; empty if the tolerance is 0.
    std::vector<std::uint32_t> left_out;
};

// The convex hull of the points, except for points that protrude little: by up to `tolerance` (grid units; 0 or at
// least 0.01) above every face, and twice that in any direction.
Triangulation triangulate(std::span<const GridPoint> points, const Simplex& simplex, double tolerance);

// A bounding volume hierarchy of oriented boxes for support point queries on many points, in which most points are far
// from the answer.
class PointTree {
  public:
    PointTree(std::span<const GridPoint> points, std::span<const std::uint32_t> chosen);

    struct Farthest {
        bool found = false;
        std::uint32_t point = 0;
        double reach = 0; // normal . point
    };
    // The point with the largest normal . p, of equal ones the one with the least index; found only if its value
    // exceeds `least`.
    Farthest farthest(math::DVec3 normal, double least) const;

  private:
    struct Node {
        // a box along the principal axes of its points: thin where the points lie on a surface
        math::DVec3 middle, edges[3];
        std::uint32_t first, count; // the children are nodes 2 i + 1 and 2 i + 2
    };
    void build(std::size_t node, std::uint32_t first, std::uint32_t count);

    std::span<const GridPoint> points_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace cairn::hull
