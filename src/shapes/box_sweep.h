// Linear sweeps and penetration of boxes, in closed form.
#pragma once

#include "shapes/convex.h"

namespace cairn {

struct BoxSweep {
    enum class State : std::uint8_t {
        missed,      // no touch before `limit`, a fraction of the translation
        met,         // at `fraction` the boxes are half the tolerance apart
        overlapping, // from the start, by more than the tolerance
        // undecided: the boxes touch at the start, edges are nearly parallel, or several points touch at once
        unsettled,
    };
    State state = State::unsettled;
    double fraction = 0;
    math::DVec3 point; // on the still box
    // unit, outward from the still box, along the least separating translation; 0 if several points are deepest
    math::DVec3 normal;
};

// For sharp boxes. On each of the fifteen potential separating axes of two boxes (Gottschalk, Lin and Manocha,
// "OBBTree", 1996) their projections overlap during one interval of the translation. The boxes touch when the last of
// these intervals begins, provided that none has ended by then.
BoxSweep sweep_boxes(const Convex& moving, math::DVec3 way, const Convex& still, double limit, double tolerance);

} // namespace cairn
