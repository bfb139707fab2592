// The contact points of two shapes at given poses of their bodies.
#pragma once

#include "impacts/impact_law.h"
#include "impacts/movers.h"

#include <vector>

namespace cairn {

// Appends all points at which the shapes touch within the touch tolerance (core_sweep.h); one impact acts at all of
// them. `axis`: from A to B, where they are nearest, or zero.
void find_meeting_points(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape_a, const MovingState& a,
                         std::uint32_t shape_b, const MovingState& b, math::DVec3 axis, NarrowBatch& scratch,
                         std::vector<ImpactPoint>& points);

} // namespace cairn
