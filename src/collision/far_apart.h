// A quick rejection test of two convex shapes: most pairs whose bounds overlap do not touch.
#pragma once

#include "collision/shape_pose.h"
#include "shapes/geometry.h"

namespace cairn {

// A lower bound of the distance of two shapes, in meters: that of capsules around them (spheres around hulls). Negative
// if these overlap.
float gap_lower_bound(const Geometry& a, const ShapePose& pose_a, const Geometry& b, const ShapePose& pose_b);

} // namespace cairn
