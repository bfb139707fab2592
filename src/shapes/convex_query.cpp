#include "shapes/convex_query.h"

#include "shapes/ball_sweep.h"
#include "shapes/box_capsule.h"
#include "shapes/box_depth.h"
#include "shapes/box_sweep.h"
#include "shapes/epa.h"

#include <limits>

namespace cairn {

using math::dot;
using math::DVec3;

namespace {

// The distance at which sweeps stop, relative to the extent.
constexpr double sweep_tolerance = 1e-6;
// The maximum number of iterations of a sweep. Each at least halves the remaining distance.
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

// Conservative advancement (Mirtich 1996), starting at a fraction. The distance of two convex shapes is a convex
// function of the fraction, so that this is Newton's method from below and never passes the first touch.
std::optional<ConvexHit> advance(const Convex& moving, DVec3 way, const Convex& still, double tolerance, double limit,
                                 double fraction) {
    for (int round = 0;; ++round) {
        const ClosestPoints c = closest_points(moved(moving, fraction * way), still);
        if (fraction == 0 && c.distance < -tolerance) return ConvexHit{0, c.on_b, -c.normal};
        const double speed = dot(way, c.normal);
        if (!(speed > 0)) return std::nullopt; // they move apart or past each other
        if (!(c.distance > tolerance) || round == max_rounds) return ConvexHit{fraction, c.on_b, -c.normal};
        // Half the tolerance is kept as a gap, so that the normal stays defined.
        fraction += (c.distance - 0.5 * tolerance) / speed;
        if (!(fraction <= limit)) return std::nullopt;
    }
}

// Whether the simplex of a core difference contains the origin, deeper than `depth` below each of its faces.
bool is_deeper(const Simplex& s, double depth) {
    if (s.count < 4) return false;
    constexpr int faces[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    for (const auto& f : faces) {
        const DVec3 a = s.points[f[0]].w;
        const DVec3 normal = math::cross(s.points[f[1]].w - a, s.points[f[2]].w - a);
        const double height = dot(normal, a);
        if (!(height * height > depth * depth * dot(normal, normal))) return false;
    }
    return true;
}

// The radius of a ball about inside_of(c) that lies within the shape; 0 if unknown.
double inner_radius(const Convex& c) {
    if (c.kind == Convex::Kind::hull) return c.hull->inner_radius + outer_radius(c);
    return has_nearest(c) ? c.extent : 0;
}

// Whether the shape overlaps a ball inside the other by more than a depth, which proves an overlap without GJK.
bool overlaps_inner_ball(const Convex& c, const Convex& other, double depth) {
    if (!has_nearest(c)) return false;
    const DVec3 p = to_local(c, inside_of(other) - c.center), off = p - *nearest_in_core(c, p);
    const double reach = inner_radius(other) + outer_radius(c) - depth;
    return reach > 0 && dot(off, off) < reach * reach;
}
bool overlap_by_formula(const Convex& a, const Convex& b, double depth) {
    return overlaps_inner_ball(a, b, depth) || overlaps_inner_ball(b, a, depth);
}

bool is_sharp_box(const Convex& c) { return c.kind == Convex::Kind::box && c.is_sharp; }

// The sweep of a ball against a shape with a closed-form nearest point, whichever of them moves.
std::optional<ConvexHit> sweep_ball_and(const Convex& moving, DVec3 way, const Convex& still, double from, double limit,
                                        double tolerance) {
    const bool is_moving = is_ball_and_formula(moving, still);
    const BallSweep s = is_moving ? sweep_ball(moving, way, still, from, limit, tolerance)
                                  : sweep_ball(still, -way, moving, from, limit, tolerance);
    if (s.state == BallSweep::State::missed) return std::nullopt;
    if (is_moving) return ConvexHit{s.fraction, s.nearest, s.normal};
    return ConvexHit{s.fraction, still.center - still.radius * s.normal, -s.normal};
}

} // namespace

bool has_nearest(const Convex& c) {
    if (c.kind == Convex::Kind::capsule || c.kind == Convex::Kind::cylinder) return c.size.x == c.size.z;
    return c.kind == Convex::Kind::ball || c.kind == Convex::Kind::box;
}

std::optional<DVec3> nearest_in_core(const Convex& c, DVec3 p) {
    const auto within = [](double x, double most) { return x < -most ? -most : x > most ? most : x; };
    switch (c.kind) {
    case Convex::Kind::ball:
        return DVec3{};
    case Convex::Kind::box:
        return DVec3{within(p.x, c.size.x), within(p.y, c.size.y), within(p.z, c.size.z)};
    case Convex::Kind::capsule:
        if (c.size.x != c.size.z) return std::nullopt;
        return DVec3{0, within(p.y, c.size.y), 0};
    case Convex::Kind::cylinder: {
        if (c.size.x != c.size.z) return std::nullopt;
        const double across = std::sqrt(p.x * p.x + p.z * p.z), scale = across > c.size.x ? c.size.x / across : 1;
        return DVec3{scale * p.x, within(p.y, c.size.y), scale * p.z};
    }
    default:
        return std::nullopt;
    }
}

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

std::optional<NearPoint> nearest_point(const Convex& c, DVec3 to, double max_distance) {
    const double radius = outer_radius(c);
    const DVec3 from_center = to_local(c, to - c.center);
    DVec3 off; // from the core to the point
    double distance = 0;
    if (const auto local = nearest_in_core(c, from_center)) {
        const DVec3 local_off = from_center - *local;
        off = c.axes * local_off;
        distance = math::length(local_off);
    } else {
        const Convex point = make_point(to);
        const GjkResult r = gjk_distance({{&point, false, 0}, exact_core(c)}, {}, max_distance + radius);
        if (r.state == GjkResult::State::far) return std::nullopt;
        if (r.state == GjkResult::State::apart) off = to - r.on_b, distance = r.distance;
    }
    if (distance <= radius) return NearPoint{to, 0};
    if (distance - radius > max_distance) return std::nullopt;
    return NearPoint{to - (1 - radius / distance) * off, distance - radius};
}

bool overlap(const Convex& a, const Convex& b) {
    if (is_ball_and_formula(a, b)) return ball_overlaps(a, b);
    if (is_ball_and_formula(b, a)) return ball_overlaps(b, a);
    if (is_box_and_capsule(a, b)) {
        const double reach = outer_radius(a) + outer_radius(b);
        return square_of_box_and_capsule(a, b) <= reach * reach;
    }
    if (overlap_by_formula(a, b, 0)) return true;
    if (is_sharp_box(a) && is_sharp_box(b)) {
        const BoxSweep boxes = sweep_boxes(a, {}, b, 0, sweep_tolerance * extent_of(a, b));
        if (boxes.state != BoxSweep::State::unsettled) return boxes.state == BoxSweep::State::overlapping;
    }
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
    return cast_convex(make_point(origin), way, c, 1);
}

std::optional<ConvexHit> cast_convex(const Convex& moving, DVec3 way, const Convex& still, double limit,
                                     Approach start) {
    const double tolerance = sweep_tolerance * extent_of(moving, still);
    if (is_ball_and_formula(moving, still) || is_ball_and_formula(still, moving))
        return sweep_ball_and(moving, way, still, start.fraction, limit, tolerance);
    if (is_sharp_box(moving) && is_sharp_box(still)) {
        const BoxSweep boxes = sweep_boxes(moving, way, still, limit, tolerance);
        if (boxes.state == BoxSweep::State::missed) return std::nullopt;
        if (boxes.state != BoxSweep::State::unsettled) return ConvexHit{boxes.fraction, boxes.point, boxes.normal};
    }
    if (is_box_and_capsule(moving, still)) {
        const CapsuleSweep c = sweep_box_and_capsule(moving, way, still, start.fraction, limit, tolerance);
        if (c.state == CapsuleSweep::State::missed) return std::nullopt;
        return ConvexHit{c.state == CapsuleSweep::State::met ? c.fraction : 0, c.point, c.normal};
    }
    if (start.fraction == 0 && overlap_by_formula(moving, still, tolerance)) return ConvexHit{0, {}, {}};
    const CorePair pair{exact_core(moving), exact_core(still)};
    const GjkCast c = gjk_cast(pair, way, limit, tolerance, start.toward);
    switch (c.state) {
    case GjkCast::State::missed:
        return std::nullopt;
    case GjkCast::State::overlapping:
        if (pair.a.radius + pair.b.radius > tolerance || is_deeper(c.simplex, tolerance)) return ConvexHit{0, {}, {}};
        break;
    case GjkCast::State::met:
        if (c.fraction == 0 && c.distance >= pair.a.radius + pair.b.radius - tolerance && !(dot(way, c.normal) > 0))
            return std::nullopt; // they touch, and move apart or past each other
        return ConvexHit{c.fraction, c.on_b - pair.b.radius * c.normal, -c.normal};
    case GjkCast::State::unsettled:
        break;
    }
    return advance(moving, way, still, tolerance, limit, c.fraction);
}

ConvexHit overlap_hit(const Convex& moving, const Convex& still) {
    if (moving.kind == Convex::Kind::box) {
        if (const auto d = box_depth(moving, still))
            return {0, d->on_other - outer_radius(still) * d->normal, -d->normal};
    } else if (still.kind == Convex::Kind::box) {
        if (const auto d = box_depth(still, moving)) return {0, d->on_box + outer_radius(still) * d->normal, d->normal};
    }
    const ClosestPoints c = closest_points(moving, still);
    return {0, c.on_b, -c.normal};
}

} // namespace cairn
