// The surface of a solid as triangles, for forces that act on all of it.
#pragma once

#include "math/vec.h"
#include "shapes/geometry.h"

#include <vector>

namespace cairn {

struct SurfaceTriangle {
    math::DVec3 a, b, c; // counterclockwise as seen from outside
};

// Replaces `triangles` by those of a shape, in the frame of its body. Curved sides become polygons of such a size that
// the triangles enclose the volume of the shape up to rounding. Yields none for spheres, which have closed formulas,
// and for surfaces.
void make_solid_surface(const Geometry& shape, const ShapeData& data, std::vector<SurfaceTriangle>& triangles);

} // namespace cairn
