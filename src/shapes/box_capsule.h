// Distances and linear sweeps between boxes and capsules with equal end radii, in closed form.
#pragma once

#include "shapes/ball_sweep.h"
#include "shapes/convex.h"

namespace cairn {

inline bool is_capsule_of_one_radius(const Convex& c) {
    return c.kind == Convex::Kind::capsule && c.size.x == c.size.z;
}
inline bool is_box_and_capsule(const Convex& a, const Convex& b) {
    return (a.kind == Convex::Kind::box && is_capsule_of_one_radius(b)) ||
           (b.kind == Convex::Kind::box && is_capsule_of_one_radius(a));
}

// The vector `off` from the nearest point of a box to that of a segment, in the frame of the box; 0 where they
// intersect.
struct SegmentGap {
    math::DVec3 on_box, off;
};
// The gap between the cores of a box and a capsule.
SegmentGap gap_to_segment(const Convex& box, const Convex& capsule);
// The square of the distance between the cores of a box and a capsule, given in either order.
double square_of_box_and_capsule(const Convex& a, const Convex& b);

struct CapsuleSweep {
    using State = BallSweep::State;
    State state = State::missed;
    double fraction = 0;
    math::DVec3 point;  // on the surface of the still shape
    math::DVec3 normal; // unit, outward from the still shape
};

// Newton's method on the distance, as for balls (ball_sweep.h), whichever shape moves: it never passes the first touch.
// The shapes stop at half the tolerance, m > 0. `from`: a fraction before which they do not touch.
CapsuleSweep sweep_box_and_capsule(const Convex& moving, math::DVec3 way, const Convex& still, double from,
                                   double limit, double tolerance);

} // namespace cairn
