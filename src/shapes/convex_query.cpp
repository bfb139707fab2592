#include "shapes/convex_query.h"

#include "shapes/epa.h"

#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// Sweeps stop when the shapes are this near, as part of the extent.
constexpr double sweep_tolerance = 1e-6;
// Each round at least halves what is left of the distance.
constexpr int max_rounds = 64;

Convex make_point(DVec3 p) {
    Convex c;
    c.center = p;
    return c;
}

double extent_of(const Convex& a, const Convex& b) {
    double extent = a.extent > 0 && a.extent < b.extent ? a.extent : b.extent;
    if (!(extent > 0)) extent = a.extent;
    return extent < 1e30 ? extent : math::length(b.corners[1] - b.corners[0]);
}

Convex moved(const Convex& c, DVec3 by) {
    Convex r = c;
    r.center += by;
    for (DVec3& corner : r.corners) corner += by;
    return r;
}

// Conservative advancement (Mirtich 1996). The distance of two convex shapes is a convex function of the fraction, so
// that this is Newton's method from below: it never passes the first touch.
std::optional<ConvexHit> sweep(const Convex& moving, DVec3 way, const Convex& still) {
    const double tolerance = sweep_tolerance * extent_of(moving, still);
    ClosestPoints c = closest_points(moving, still);
    double fraction = 0;
    if (c.distance < -tolerance) return ConvexHit{0, c.on_b, -c.normal};
    for (int round = 0; round < max_rounds; ++round) {
        const double speed = dot(way, c.normal);
        if (!(speed > 0)) return std::nullopt; // they move apart or past each other
        if (!(c.distance > tolerance)) break;
        // Half the tolerance is kept, so that the normal is still known.
        fraction += (c.distance - 0.5 * tolerance) / speed;
        if (!(fraction <= 1)) return std::nullopt;
        c = closest_points(moved(moving, fraction * way), still);
    }
    return ConvexHit{fraction, c.on_b, -c.normal};
}

} // namespace

ClosestPoints closest_points(const Convex& a, const Convex& b) {
    const CorePair pair{exact_core(a), exact_core(b)};
    const GjkResult r = gjk_distance(pair, {}, std::numeric_limits<double>::infinity());
    const double radii = pair.a.radius + pair.b.radius;
    ClosestPoints c;
    if (r.state == GjkResult::State::overlapping) {
        const Penetration p = epa_depth(pair, r.simplex);
        c = {-p.depth - radii, p.normal, p.on_a, p.on_b};
    } else {
        c = {r.distance - radii, r.normal, r.on_a, r.on_b};
    }
    c.on_a += pair.a.radius * c.normal;
    c.on_b -= pair.b.radius * c.normal;
    return c;
}

bool overlap(const Convex& a, const Convex& b) {
    const CorePair pair{exact_core(a), exact_core(b)};
    const double radii = pair.a.radius + pair.b.radius;
    const GjkResult r = gjk_distance(pair, {}, radii);
    return r.state == GjkResult::State::overlapping || (r.state == GjkResult::State::apart && r.distance <= radii);
}

bool contains(const Convex& c, DVec3 point) {
    const Convex p = make_point(point);
    const Core core = exact_core(c);
    const GjkResult r = gjk_distance({{&p, false, 0}, core}, {}, core.radius);
    return r.state == GjkResult::State::overlapping ||
           (r.state == GjkResult::State::apart && r.distance <= core.radius * (1 + 1e-12));
}

std::optional<ConvexHit> cast_ray(const Convex& c, DVec3 origin, DVec3 way) {
    if (contains(c, origin)) return std::nullopt;
    return sweep(make_point(origin), way, c);
}

std::optional<ConvexHit> cast_convex(const Convex& moving, DVec3 way, const Convex& still) {
    return sweep(moving, way, still);
}

} // namespace cairn
