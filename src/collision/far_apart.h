// A quick look at two convex shapes: most pairs whose bounds overlap do not come near each other.
#pragma once

#include "collision/shape_pose.h"
#include "shapes/geometry.h"

namespace cairn {

// How far apart two shapes are at least, in meters: as far as capsules around them (spheres around hulls). Negative
// where those overlap.
float gap_lower_bound(const Geometry& a, const ShapePose& pose_a, const Geometry& b, const ShapePose& pose_b);

} // namespace cairn
