// What touches and does not bounce is held by impacts one after another, between which it sinks: each lets it leave as
// fast as brings it back up to where it touches.
#pragma once

#include "impacts/movers.h"

#include <span>

namespace cairn {

// A body at a touch.
struct TouchingBody {
    const MovingState& now;
    bool is_round; // a ball about its center of mass: its turns bring its surface nowhere
};

// How fast the speed grows at which two come nearer along `normal`, from the first to the second, m/s^2, as both go on
// with the velocities that they have. Points of what turns are drawn to its center, w x (w x r); and a face that turns
// leaves, or follows, what slides over it, by 2 normal . (w x slip): of which of the two the face is, or of both in
// part where edges cross, is not asked, and the greater one is taken.
double closing_acceleration(const TouchingBody& a, const TouchingBody& b, math::DVec3 point, math::DVec3 normal);

// Of the points of a pair that has met: `rebound`, by their depth and what presses the two together. Nothing leaves
// faster than it came, so that no energy is gained; but for what gyrates and is pressed by its weight and the change of
// its turn: that has to come up from where it was when the step began.
void set_rebounds(const Movers& movers, const Shapes& shapes, const SweptPair& pair, const MovingState& now_a,
                  const MovingState& now_b, std::span<ImpactPoint> points);

} // namespace cairn
