// The surface of a solid as triangles, for what acts on all of it.
#pragma once

#include "math/vec.h"
#include "shapes/geometry.h"

#include <vector>

namespace cairn {

struct SurfaceTriangle {
    math::DVec3 a, b, c; // counterclockwise as seen from outside
};

// Replaces `triangles` by those of a shape, in the frame of its body. Round sides are polygons, and all of it is as
// large as the shape: the triangles enclose its volume to rounding. None of balls, of which all is known in closed
// form, and of surfaces.
void make_solid_surface(const Geometry& shape, const ShapeData& data, std::vector<SurfaceTriangle>& triangles);

} // namespace cairn
