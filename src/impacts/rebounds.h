// What touches and does not bounce is held by impacts one after another, between which it sinks: each lets it leave as
// fast as brings it back up to where it touches.
#pragma once

#include "impacts/movers.h"

#include <span>

namespace cairn {

// A body at a touch, and what of it touches: a point on a rim with that axis, a unit vector, and the radius, about
// `middle`, or a part of a ball about such a point. A corner is a rim with a radius of 0, the side of a cylinder one
// with the normal across the axis.
struct TouchingBody {
    const MovingState& now;
    math::DVec3 middle;
    math::DVec3 axis{};
    double radius = 0;         // m
    bool is_flat = false;      // its surface is a face with that normal
    math::DVec3 pull{};        // m/s^2: the acceleration of its center of mass
    math::DVec3 spin_change{}; // rad/s^2
};

// How fast the speed grows at which two come nearer along `normal`, from the first to the second, m/s^2, as both go on
// freely. Points of what turns are drawn to its center, w x (w x r), and rims tilt; a face that turns leaves, or
// follows, what slides over it, by 2 normal . (w x slip): of which of the two the face is is not asked where neither
// or both have one with that normal, or in part where edges cross, and the greater one is taken.
double closing_acceleration(const TouchingBody& a, const TouchingBody& b, math::DVec3 normal);

// Of the points of a pair that has met: `rebound`, by their depth and what presses the two together. What that adds to
// the energy with which they came is no more than the work of their forces as they sank.
void set_rebounds(const Movers& movers, const Shapes& shapes, const SweptPair& pair, const MovingState& now_a,
                  const MovingState& now_b, std::span<ImpactPoint> points);

} // namespace cairn
