// The nearest points of a box and a triangle, in a third of the time of GJK.
#pragma once

#include "math/vec.h"

namespace cairn {

// In the frame of the box, which has half extents `half`. Returns false if they intersect, which leaves no distance.
bool nearest_of_box_and_triangle(math::DVec3 half, const math::DVec3 (&corners)[3], math::DVec3& on_box,
                                 math::DVec3& on_triangle);

} // namespace cairn
