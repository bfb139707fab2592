#include "shapes/box_capsule.h"

#include <cmath>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// The maximum number of Newton iterations. Each at least halves the remaining distance.
constexpr int max_rounds = 64;

double within(double x, double most) { return !(x > -most) ? -most : x > most ? most : x; }

// The gap between a box and the segment from middle - arm to middle + arm, in the frame of the box. The squared
// distance from the box is a convex function of the position on the segment, and its derivative is linear between the
// parameters at which the segment crosses the planes of faces.
SegmentGap gap_of(DVec3 half, DVec3 middle, DVec3 arm) {
    const auto nearest = [&](double t) {
        const DVec3 p = middle + t * arm;
        const DVec3 on_box{within(p.x, half.x), within(p.y, half.y), within(p.z, half.z)};
        return SegmentGap{on_box, p - on_box};
    };
    const auto rise = [&](double t) { return dot(nearest(t).off, arm); };
    double low = -1, high = 1, below = rise(low), above = rise(high);
    if (!(below < 0)) return nearest(low);
    if (!(above > 0)) return nearest(high);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i)
        for (const double side : {-half[i], half[i]}) {
            const double t = (side - middle[i]) / arm[i];
            if (!(t > low && t < high)) continue;
            const double here = rise(t);
            if (here < 0)
                low = t, below = here;
            else
                high = t, above = here;
        }
    return nearest(low - below / (above - below) * (high - low));
}

// The core of a capsule in the frame of a box.
struct Segment {
    DVec3 middle, arm;
    Segment(const Convex& box, const Convex& capsule)
        : middle(to_local(box, capsule.center - box.center)), arm(capsule.size.y * to_local(box, capsule.axes.c1)) {}
};

} // namespace

SegmentGap gap_to_segment(const Convex& box, const Convex& capsule) {
    const Segment segment(box, capsule);
    return gap_of(box.size, segment.middle, segment.arm);
}

double square_of_box_and_capsule(const Convex& a, const Convex& b) {
    const SegmentGap gap = a.kind == Convex::Kind::box ? gap_to_segment(a, b) : gap_to_segment(b, a);
    return dot(gap.off, gap.off);
}

CapsuleSweep sweep_box_and_capsule(const Convex& moving, DVec3 way, const Convex& still, double from, double limit,
                                   double tolerance) {
    const bool is_box_moving = moving.kind == Convex::Kind::box;
    const Convex &box = is_box_moving ? moving : still, &capsule = is_box_moving ? still : moving;
    const double radii = outer_radius(box) + outer_radius(capsule);
    const Segment segment(box, capsule);
    // translation of the capsule relative to the box
    const DVec3 along = to_local(box, way), step = is_box_moving ? -along : along;
    CapsuleSweep r;
    r.fraction = from;
    for (int round = 0;; ++round) {
        const SegmentGap gap = gap_of(box.size, segment.middle + r.fraction * step, segment.arm);
        const double square = dot(gap.off, gap.off), distance = std::sqrt(square);
        if (r.fraction == 0 && distance < radii - tolerance) {
            r.state = CapsuleSweep::State::overlapping;
            return r;
        }
        const double toward = -dot(gap.off, step); // scaled by the distance
        if (!(toward > 0)) return r;               // they move apart or past each other
        if (!(distance > radii + tolerance) || round == max_rounds) {
            const DVec3 normal = (1 / distance) * gap.off; // from the box to the capsule
            r.state = CapsuleSweep::State::met;
            if (is_box_moving) {
                const DVec3 on_capsule = gap.on_box + gap.off - outer_radius(capsule) * normal;
                r.point = box.center + r.fraction * way + box.axes * on_capsule;
                r.normal = -(box.axes * normal);
            } else {
                r.point = box.center + box.axes * (gap.on_box + outer_radius(box) * normal);
                r.normal = box.axes * normal;
            }
            return r;
        }
        r.fraction += (distance - (radii + 0.5 * tolerance)) * distance / toward;
        if (!(r.fraction <= limit)) return r;
    }
}

} // namespace cairn
