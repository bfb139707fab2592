// Linear sweeps and overlap tests of balls against shapes whose nearest point has a closed form.
#pragma once

#include "shapes/convex.h"

namespace cairn {

// Whether `ball` is a ball of nonzero radius, and the core of `other` has a closed-form nearest point
// (nearest_in_core).
bool is_ball_and_formula(const Convex& ball, const Convex& other);

struct BallSweep {
    enum class State : std::uint8_t {
        missed,      // no touch before `limit`, a fraction of the translation
        met,         // at `fraction` the distance is within the tolerance
        overlapping, // from the start, by more than the tolerance
    };
    State state = State::missed;
    double fraction = 0;
    math::DVec3 nearest; // on the surface of the other shape, with the ball at its start
    // unit, from the other shape to the ball; 0 for an overlap without a unique least separating direction
    math::DVec3 normal;
};

// Newton's method on the distance, which is a convex function of the fraction, so that it never passes the first touch.
// The ball stops at half the tolerance, m > 0. `from`: a fraction before which they do not touch.
BallSweep sweep_ball(const Convex& ball, math::DVec3 way, const Convex& other, double from, double limit,
                     double tolerance);

// Whether ball and shape have a point in common.
bool ball_overlaps(const Convex& ball, const Convex& other);

} // namespace cairn
