#include "shapes/ball_sweep.h"

#include "shapes/convex_query.h"

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// The maximum number of Newton iterations. Each at least halves the remaining distance.
constexpr int max_rounds = 64;

DVec3 along(int axis, double length) {
    return {axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0};
}

// The least translation from a point within a core to its surface.
std::optional<DVec3> way_out(const Convex& core, DVec3 p) {
    const auto to_face = [&](int axis) { return core.size[axis] - std::fabs(p[axis]); };
    const auto out_of_face = [&](int axis) { return along(axis, p[axis] < 0 ? -to_face(axis) : to_face(axis)); };
    if (core.kind == Convex::Kind::box) {
        const int least = to_face(0) < to_face(1) ? 0 : 1;
        return out_of_face(to_face(2) < to_face(least) ? 2 : least);
    }
    if (core.kind != Convex::Kind::cylinder) return std::nullopt;
    const double across = std::sqrt(p.x * p.x + p.z * p.z), to_side = core.size.x - across;
    if (to_face(1) < to_side || !(across > 0)) return out_of_face(1);
    return DVec3{to_side / across * p.x, 0, to_side / across * p.z};
}

} // namespace

bool is_ball_and_formula(const Convex& ball, const Convex& other) {
    return ball.kind == Convex::Kind::ball && ball.radius > 0 && has_nearest(other);
}

BallSweep sweep_ball(const Convex& ball, DVec3 way, const Convex& other, double from, double limit, double tolerance) {
    const double radius = outer_radius(other), radii = ball.radius + radius;
    const DVec3 start = to_local(other, ball.center - other.center), step = to_local(other, way);
    BallSweep r;
    r.fraction = from;
    for (int round = 0;; ++round) {
        const DVec3 p = start + r.fraction * step;
        DVec3 nearest = *nearest_in_core(other, p), off = p - nearest;
        double distance = math::length(off);
        const bool is_deep = r.fraction == 0 && distance < radii - tolerance;
        const double toward = -dot(off, step);   // scaled by the distance
        if (!is_deep && !(toward > 0)) return r; // they move apart or past each other
        if (is_deep || !(distance > radii + tolerance) || round == max_rounds) {
            r.state = is_deep ? BallSweep::State::overlapping : BallSweep::State::met;
            if (!(distance > 0)) {
                off = way_out(other, p).value_or(DVec3{});
                nearest = p + off;
                distance = math::length(off);
            }
            const DVec3 normal = distance > 0 ? (1 / distance) * off : DVec3{};
            r.normal = other.axes * normal;
            r.nearest = other.center + other.axes * (nearest + radius * normal);
            return r;
        }
        r.fraction += (distance - (radii + 0.5 * tolerance)) * distance / toward;
        if (!(r.fraction <= limit)) return r;
    }
}

bool ball_overlaps(const Convex& ball, const Convex& other) {
    const DVec3 p = to_local(other, ball.center - other.center), off = p - *nearest_in_core(other, p);
    const double radii = ball.radius + outer_radius(other);
    return dot(off, off) <= radii * radii;
}

} // namespace cairn
