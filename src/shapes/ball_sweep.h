// Balls that move past shapes whose nearest point a formula tells, or overlap them.
#pragma once

#include "shapes/convex.h"

namespace cairn {

// A ball, of which a point is none, and a shape whose core has such a formula: see nearest_in_core.
bool is_ball_and_formula(const Convex& ball, const Convex& other);

struct BallSweep {
    enum class State : std::uint8_t {
        missed,      // not before `limit`, a fraction of the way
        met,         // at `fraction` they are nearer than the tolerance
        overlapping, // from the start, and deeper than the tolerance
    };
    State state = State::missed;
    double fraction = 0;
    math::DVec3 nearest; // of the surface of the other shape, where the ball is at the start
    math::DVec3 normal;  // unit, from the other to the ball; 0 where it overlaps and no single way out is the least
};

// Newton's method on the distance, which is a convex function of the fraction: it never passes the first touch. They
// stop at half the tolerance, m > 0. `from`: a fraction before which they do not meet.
BallSweep sweep_ball(const Convex& ball, math::DVec3 way, const Convex& other, double from, double limit,
                     double tolerance);

// Whether they have a point in common.
bool ball_overlaps(const Convex& ball, const Convex& other);

} // namespace cairn
