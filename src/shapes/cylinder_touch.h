// Where the corners of another shape that moves without turning meet a cylinder, in closed form.
#pragma once

#include "shapes/convex.h"

#include <optional>
#include <span>

namespace cairn {

struct CylinderTouch {
    double fraction;    // of the way; less than 0 where it is behind
    math::DVec3 point;  // of both
    math::DVec3 normal; // unit, from the corners to the cylinder
};

// Of one corner with the side or an end, of the edge between two with the rim or the side, or of the triangle of three
// with the rim, as if there was nothing else: whether anything meets before is for supports along the normal to tell.
// `center`: of the cylinder; `toward`: from it to the corners, which tells the rim.
std::optional<CylinderTouch> touch_cylinder(std::span<const math::DVec3> corners, math::DVec3 way,
                                            const Convex& cylinder, math::DVec3 center, math::DVec3 toward);

} // namespace cairn
