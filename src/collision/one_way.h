// Shapes that hold only what comes from one side (ShapeDef::one_way).
#pragma once

#include "collision/core_sweep.h"
#include "shapes/convex.h"

namespace cairn {

// Whether a shape is wholly beyond another in a direction of the common frame, but for as much as a contact may press
// the two into each other (Layer::deep). What is not came from elsewhere. The second is convex or a rectangle, the
// direction not zero.
bool is_beyond(const Convex& shape, const Convex& other, math::DVec3 direction);
// The same as their paths begin. `direction`: in the frame of the other's geometry.
bool begins_beyond(const SweptShape& shape, const SweptShape& other, math::Vec3 direction);

} // namespace cairn
