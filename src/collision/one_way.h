// One-way shapes, which hold only bodies that come from one side (ShapeDef::one_way).
#pragma once

#include "collision/core_sweep.h"
#include "shapes/convex.h"

namespace cairn {

// Whether a shape is completely beyond another one in a direction of the common frame, except for the depth up to which
// a contact may press them into each other (Layer::deep). A shape that is not came from elsewhere. The second shape is
// convex or a rectangle; the direction is not zero.
bool is_beyond(const Convex& shape, const Convex& other, math::DVec3 direction);
// The same at the beginning of their paths. `direction`: in the frame of the other's geometry.
bool begins_beyond(const SweptShape& shape, const SweptShape& other, math::Vec3 direction);

} // namespace cairn
