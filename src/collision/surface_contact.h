// A convex shape against the triangles of a mesh or height field.
#pragma once

#include "collision/flat_points.h"
#include "collision/manifold.h"
#include "shapes/convex.h"

#include <vector>

namespace cairn {

struct TriangleKernels;

// A mesh or height field in the common frame of Convex.
struct Surface {
    const ShapeData& data;
    math::DVec3 center; // of its own frame
    math::DMat3 axes;
};

// What the shape has to do with one triangle, in the frame of boxes, for other shapes in the common one.
struct TriangleHit {
    math::DVec3 normal;                     // from the shape to the triangle
    math::DVec3 foot;                       // where the triangle is, at the first of the points
    double depth;                           // of the deepest point; negative when apart
    std::uint32_t first_point, point_count; // in SurfaceScratch::points
    std::uint32_t triangle;
    bool on_face;      // of the triangle, not at its edges
    bool is_lifted;    // the middle of the shape is behind the triangle
    std::size_t patch; // that it is a part of
};

// One direction in which the shape touches the surface, where that is of one material.
struct SurfacePatch {
    math::DVec3 normal; // from the shape to the surface
    math::DVec3 foot;   // where the surface is
    double depth = 0;
    bool on_face = false;       // of a triangle that has its normal
    std::uint32_t material = 0; // of its triangles: the number (SurfaceMaterials)
};

// Working memory.
struct SurfaceScratch {
    std::vector<TriangleHit> hits;
    std::vector<std::uint32_t> order; // of hits: the deepest first
    std::vector<SurfacePoint> points;
    std::vector<SurfacePatch> patches;
    std::vector<FlatPoint> flat;      // of one patch
    std::vector<std::uint32_t> which; // of points they are
};

// All directions in which the shape touches the surface, or is nearer than `margin`: manifolds with different normals
// or materials, deepest first. Triangles in one plane count as one face, and nothing catches at the edges between them.
// `manifolds` is emptied before. Where there are none, returns how far apart they are at least, as far as has been
// looked: `reach`, at least the margin, at most.
double collide_triangles(const TriangleKernels& kernels, const Convex& a, const Surface& surface, double margin,
                         double reach, SurfaceScratch& scratch, std::vector<Manifold>& manifolds);

} // namespace cairn
