// Mass properties of rounded shapes (Minkowski sums with a ball) at density 1, in the shape's frame.
#pragma once

#include "shapes/hull.h"

namespace cairn {

MassSum rounded_box_mass(math::DVec3 half, double radius);
// `size` is as in Geometry.
MassSum rounded_cylinder_mass(math::DVec3 size, double radius);
MassSum rounded_hull_mass(const HullData& hull, double radius);

} // namespace cairn
