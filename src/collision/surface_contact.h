// Contacts of a convex shape with the triangles of a mesh or height field.
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
    math::DVec3 center; // of the surface's own frame
    math::DMat3 axes;
};

// The contact of the shape with one triangle: in the box's frame if the shape is a sharp box, else in the common frame.
struct TriangleHit {
    math::DVec3 normal;                     // from the shape to the triangle
    math::DVec3 foot;                       // the first point, on the triangle
    double depth;                           // of the deepest point; negative if separated
    std::uint32_t first_point, point_count; // in SurfaceScratch::points
    std::uint32_t triangle;
    bool on_face;      // the contact is on the triangle's face, not at its edges
    bool is_lifted;    // the center of the shape is behind the triangle
    std::size_t patch; // the patch that the hit belongs to
};

// The part of the contact with one normal and one material.
struct SurfacePatch {
    math::DVec3 normal; // from the shape to the surface
    math::DVec3 foot;   // a point on the surface
    double depth = 0;
    bool on_face = false;       // on the face of a triangle with this normal
    std::uint32_t material = 0; // number of the triangles' material (SurfaceMaterials)
};

// Working memory.
struct SurfaceScratch {
    std::vector<TriangleHit> hits;
    std::vector<std::uint32_t> order; // indices of hits, deepest first
    std::vector<SurfacePoint> points;
    std::vector<SurfacePatch> patches;
    std::vector<FlatPoint> flat;      // of one patch
    std::vector<std::uint32_t> which; // indices of these points
};

// Finds all parts of the contact of a shape with a surface, within `margin`: manifolds with different normals or
// materials, deepest first. Coplanar triangles count as one face, so that nothing catches at internal edges.
// `manifolds` is cleared first. If there are none, returns a lower bound of the distance. It is at most `reach`, the
// radius of the search, which is at least the margin.
double collide_triangles(const TriangleKernels& kernels, const Convex& a, const Surface& surface, double margin,
                         double reach, SurfaceScratch& scratch, std::vector<Manifold>& manifolds);

} // namespace cairn
