// A quick look at two convex shapes: most pairs whose bounds overlap do not come near each other.
#pragma once

#include "collision/shape_pose.h"
#include "shapes/geometry.h"

namespace cairn {

// Whether capsules around the shapes (spheres around hulls) are more than `margin` meters apart.
// May say no where they are; never yes where they are not.
bool are_far_apart(const Geometry& a, const ShapePose& pose_a, const Geometry& b, const ShapePose& pose_b,
                   float margin);

} // namespace cairn
