// Boxes that move past each other without turning, or overlap, in closed form.
#pragma once

#include "shapes/convex.h"

namespace cairn {

struct BoxSweep {
    enum class State : std::uint8_t {
        missed,      // not before `limit`, a fraction of the way
        met,         // at `fraction` they are half the tolerance apart
        overlapping, // from the start, and deeper than the tolerance
        unsettled,   // they touch at the start, edges are nearly parallel, or more than one point meets at once
    };
    State state = State::unsettled;
    double fraction = 0;
    math::DVec3 point;  // of the still one
    math::DVec3 normal; // unit, out of the still one, along the least way apart; 0 where more than one point is deepest
};

// On each of the fifteen axes that can part two boxes (Gottschalk, Lin and Manocha, "OBBTree", 1996) their shadows meet
// during one interval of the way; the boxes meet when the last of these intervals begins, if none has ended by then.
// Of sharp boxes.
BoxSweep sweep_boxes(const Convex& moving, math::DVec3 way, const Convex& still, double limit, double tolerance);

} // namespace cairn
