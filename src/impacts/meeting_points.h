// The contact points of two shapes at given poses of their bodies, and what acts there.
#pragma once

#include "impacts/impact_law.h"
#include "impacts/movers.h"

#include <span>
#include <vector>

namespace cairn {

// Appends all points at which the shapes touch within the touch tolerance (core_sweep.h); one impact acts at all of
// them. `axis`: from A to B, where they are nearest, or zero.
void find_meeting_points(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape_a, const MovingState& a,
                         std::uint32_t shape_b, const MovingState& b, math::DVec3 axis, NarrowBatch& scratch,
                         std::vector<ImpactPoint>& points);

// The combined material of two shapes at a point; `number`: of the material of a mesh or height field there.
// `restitution_speed`: m/s.
ImpactMaterial material_at(const Shapes& shapes, std::uint32_t shape_a, std::uint32_t shape_b, std::uint16_t number,
                           float restitution_speed);

// Tangential surface velocity, at the first of the points, of a body that forces do not move, m/s.
math::DVec3 surface_velocity(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape,
                             std::span<const ImpactPoint> points);

} // namespace cairn
