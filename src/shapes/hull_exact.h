// Convex hulls of points with whole coordinates. Every decision about which side of a plane a point is on is exact, so
// that the surface is closed and convex whatever the points are; tolerances only decide which points may be left out.
#pragma once

#include "math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cairn::hull {

// Coordinates from 0 to 2^30: the normal of three points fits 64 bits, and the side of a fourth 128.
struct GridPoint {
    std::int32_t x = 0, y = 0, z = 0;
};
inline constexpr int grid_bits = 30;

struct GridVector {
    std::int64_t x = 0, y = 0, z = 0;
};

constexpr math::DVec3 to_double(GridPoint p) { return {double(p.x), double(p.y), double(p.z)}; }
constexpr math::DVec3 to_double(GridVector v) { return {double(v.x), double(v.y), double(v.z)}; }

// (b - a) x (c - a): twice the area, along the normal of a triangle.
GridVector area_vector(GridPoint a, GridPoint b, GridPoint c);
// 1 if p is above the plane of a, b, c (where they are seen counterclockwise), 0 in it, -1 below.
int side_of(GridPoint a, GridPoint b, GridPoint c, GridPoint p);

// Four points that span much: two far apart, one far from their line, one far from the plane of these.
struct Simplex {
    std::uint32_t corners[4]{};
    double breadth = 0;   // distance of the third from the line
    double thickness = 0; // how far the points reach across the plane of the first three, both sides together
};
// Needs four points at least. Where breadth or thickness is 0 there is no simplex.
Simplex first_simplex(std::span<const GridPoint> points);

struct Triangle {
    std::uint32_t corners[3];   // counterclockwise as seen from outside
    std::uint32_t neighbors[3]; // neighbors[i] lies across the edge from corner i to corner i + 1
};

struct Triangulation {
    std::vector<std::uint32_t> points; // that became corners: ascending indices of the input
    std::vector<Triangle> triangles;   // corners are positions in `points`
    // Points that may lie outside, at most 2 x tolerance away; none where the tolerance is 0.
    std::vector<std::uint32_t> left_out;
};

// The hull of the points but for those that stick out little: by `tolerance` (grid units; 0 or at least 0.01) above
// every face, and twice that in any direction.
Triangulation triangulate(std::span<const GridPoint> points, const Simplex& simplex, double tolerance);

// Which of many points lies farthest in a direction: a tree of boxes, each turned as its points lie, for questions that
// most points are no answer to.
class PointTree {
  public:
    PointTree(std::span<const GridPoint> points, std::span<const std::uint32_t> chosen);

    struct Farthest {
        bool found = false;
        std::uint32_t point = 0;
        double reach = 0; // normal . point
    };
    // The point with the largest normal . p, of equal ones that of least index; found only if that exceeds `least`.
    Farthest farthest(math::DVec3 normal, double least) const;

  private:
    struct Node {
        math::DVec3 middle, edges[3]; // a box along the principal axes of its points: thin where these are a surface
        std::uint32_t first, count;   // children are 2 i + 1 and 2 i + 2
    };
    void build(std::size_t node, std::uint32_t first, std::uint32_t count);

    std::span<const GridPoint> points_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace cairn::hull
