// Where two shapes touch at given poses of their bodies.
#pragma once

#include "impacts/impact_law.h"
#include "impacts/movers.h"

#include <vector>

namespace cairn {

// Appends all points in which the shapes touch, within the tolerance of touches (core_sweep.h): those are struck at
// once. `axis`: from A to B, where they are nearest, or zero.
void find_meeting_points(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape_a, const MovingState& a,
                         std::uint32_t shape_b, const MovingState& b, math::DVec3 axis, NarrowBatch& scratch,
                         std::vector<ImpactPoint>& points);

} // namespace cairn
