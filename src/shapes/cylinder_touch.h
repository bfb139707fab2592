// Time of impact between a cylinder and the corners of another shape that moves without rotating, in closed form.
#pragma once

#include "shapes/convex.h"

#include <optional>
#include <span>

namespace cairn {

struct CylinderTouch {
    double fraction;    // of the translation; negative: in the past
    math::DVec3 point;  // common to both shapes
    math::DVec3 normal; // unit, from the corners' shape to the cylinder
};

// Touch of one corner with the side or an end, of the edge between two corners with the rim or the side, or of the
// triangle of three corners with the rim, each in isolation: whether other features touch earlier has to be decided by
// support points along the normal. `center`: of the cylinder; `toward`: from the cylinder to the corners, which selects
// the rim.
std::optional<CylinderTouch> touch_cylinder(std::span<const math::DVec3> corners, math::DVec3 way,
                                            const Convex& cylinder, math::DVec3 center, math::DVec3 toward);

} // namespace cairn
