#include "shapes/gjk.h"

#include "shapes/cylinder_touch.h"

#include <limits>
#include <optional>

namespace cairn {

using math::cross;
using math::dot;
using math::DVec3;

namespace {

constexpr int max_iterations = 64;
// Cores closer than this overlap, relative to their size.
constexpr double touching = 1e-10;
// The relative rounding error of a squared length.
constexpr double rounding = 1e-15;

// The nearest point of a simplex to the origin: a subset of its corners, with weights relative to `whole`.
struct Nearest {
    double square = std::numeric_limits<double>::infinity();
    DVec3 point;
    int count = 0;
    int corner[3];
    double weight[3], whole = 1;

    void offer(const Simplex& s, int i) {
        const DVec3 p = s.points[i].w;
        const double at = dot(p, p);
        if (!(at < square)) return;
        square = at, point = p, count = 1, corner[0] = i, weight[0] = whole = 1;
    }
};

void offer_segment(Nearest& best, const Simplex& s, int i, int j) {
    const DVec3 p = s.points[i].w, q = s.points[j].w, d = q - p;
    const double along = -dot(p, d), length = dot(d, d);
    if (!(along > 0)) return best.offer(s, i);
    if (!(along < length)) return best.offer(s, j);
    const double t = along / length;
    const DVec3 v = p + t * d;
    const double square = dot(v, v);
    if (!(square < best.square)) return;
    best.square = square, best.point = v, best.count = 2;
    best.corner[0] = i, best.corner[1] = j, best.weight[0] = 1 - t, best.weight[1] = t, best.whole = 1;
}

// If the origin projects into the triangle, the nearest point is the projection of the origin onto the plane: its
// direction is that of the normal, free of the rounding of weights. Otherwise the nearest point is on an edge that has
// the origin beyond it.
void offer_triangle(Nearest& best, const Simplex& s, int i, int j, int k, DVec3 normal) {
    const DVec3 a = s.points[i].w, b = s.points[j].w, c = s.points[k].w;
    const double square = dot(normal, normal);
    const double wa = dot(cross(b, c), normal), wb = dot(cross(c, a), normal), wc = dot(cross(a, b), normal);
    if (square > 0 && wa > 0 && wb > 0 && wc > 0) {
        // The normal of a narrow triangle is inaccurate: it is rotated about the longest edge. Hence the height of the
        // plane is measured at the point of this edge's line nearest to the origin.
        const DVec3 ab = b - a, bc = c - b, ca = a - c;
        const double ab2 = dot(ab, ab), bc2 = dot(bc, bc), ca2 = dot(ca, ca);
        const bool is_ab = ab2 >= bc2 && ab2 >= ca2, is_bc = !is_ab && bc2 >= ca2;
        const DVec3 from = is_ab ? a : is_bc ? b : c, edge = is_ab ? ab : is_bc ? bc : ca;
        const DVec3 passing = from - dot(from, edge) / (is_ab ? ab2 : is_bc ? bc2 : ca2) * edge;
        const double height = dot(passing, normal);
        const double to_plane = height * height / square;
        if (!(to_plane < best.square)) return;
        best.square = to_plane, best.point = (height / square) * normal, best.count = 3;
        best.corner[0] = i, best.corner[1] = j, best.corner[2] = k;
        best.weight[0] = wa, best.weight[1] = wb, best.weight[2] = wc, best.whole = wa + wb + wc;
        return;
    }
    if (!(wc > 0 && square > 0)) offer_segment(best, s, i, j);
    if (!(wa > 0 && square > 0)) offer_segment(best, s, j, k);
    if (!(wb > 0 && square > 0)) offer_segment(best, s, k, i);
}

// Returns false if the tetrahedron contains the origin. Near convergence on a curved shape its corners are almost
// collinear; an origin within rounding error of a side counts as outside, so that such a sliver contains nothing.
bool on_tetrahedron(const Simplex& s, Nearest& best) {
    constexpr int faces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    constexpr double error = 1e-28; // the square of a few rounding errors
    double size = 0;
    for (const DifferencePoint& p : s.points) size = std::max(size, dot(p.w, p.w));
    bool is_outside = false;
    for (const auto& f : faces) {
        const DVec3 a = s.points[f[0]].w, ab = s.points[f[1]].w - a, ac = s.points[f[2]].w - a;
        const DVec3 normal = cross(ab, ac), inner = s.points[f[3]].w - a;
        const double inside = dot(normal, inner), origin = -dot(normal, a);
        // Rounding of the corners changes the normal by about size x sides.
        const double sides = dot(ab, ab) + dot(ac, ac), slack = error * size * sides;
        const bool is_flat = inside * inside <= slack * dot(inner, inner) + error * size * dot(ab, ab) * dot(ac, ac);
        const bool is_near = origin * origin <= slack * size;
        if (!is_flat && !is_near && (inside > 0) == (origin > 0)) continue;
        is_outside = true;
        offer_triangle(best, s, f[0], f[1], f[2], normal);
    }
    return is_outside;
}

// Reduces the simplex to the corners that span the nearest point.
void keep(Simplex& s, const Nearest& n) {
    for (int i = 0; i < n.count; ++i) s.weights[i] = n.weight[i] / n.whole;
    s.nearest = n.point;
    if (n.count == s.count) return; // all corners, in their order
    DifferencePoint kept[3];
    for (int i = 0; i < n.count; ++i) kept[i] = s.points[n.corner[i]];
    for (int i = 0; i < n.count; ++i) s.points[i] = kept[i];
    s.count = n.count;
}

// Finds the point of a simplex nearest to the origin. Returns false for a tetrahedron that contains the origin.
bool nearest_of(const Simplex& s, Nearest& best) {
    if (s.count == 4) return on_tetrahedron(s, best);
    if (s.count == 3)
        offer_triangle(best, s, 0, 1, 2, cross(s.points[1].w - s.points[0].w, s.points[2].w - s.points[0].w));
    else if (s.count == 2)
        offer_segment(best, s, 0, 1);
    else
        best.offer(s, 0);
    return true;
}

bool holds(const Simplex& s, const DifferencePoint& p) {
    for (int i = 0; i < s.count; ++i)
        if (s.points[i].w == p.w) return true;
    return false;
}

void finish(GjkResult& r, const Simplex& s) {
    for (int i = 0; i < s.count; ++i) {
        r.on_a += s.weights[i] * s.points[i].a;
        r.on_b += s.weights[i] * s.points[i].b;
    }
    r.distance = math::length(s.nearest);
    r.normal = (-1 / r.distance) * s.nearest;
}
void finish(GjkCast& r, const Simplex& s) {
    r.state = GjkCast::State::met;
    for (int i = 0; i < s.count; ++i) r.on_b += s.weights[i] * s.points[i].b;
    r.distance = math::length(s.nearest);
    r.normal = (-1 / r.distance) * s.nearest;
}

// The touch of the features that GJK has found on two shapes, regarded in isolation, at a `fraction` of the translation
// from the current position. The features are then half the tolerance apart, or less if the translation is oblique: it
// stops at most one tolerance of path length before the touch.
struct Touch {
    double fraction;
    DVec3 normal; // unit, from a to b
    DVec3 on_b;   // on the core of b
};

bool is_cylinder(const Core& c) { return c.radius == 0 && c.shape->kind == Convex::Kind::cylinder; }
bool has_corners(const Core& c) {
    return c.radius == 0 && c.shape->kind != Convex::Kind::cylinder && c.shape->kind != Convex::Kind::capsule;
}

// The touch of a cylinder with the corners in the simplex.
std::optional<Touch> touch_of_cylinder(const CorePair& pair, const Simplex& s, DVec3 way, DVec3 so_far,
                                       double tolerance) {
    const bool is_moving = is_cylinder(pair.a);
    DVec3 corners[3];
    std::size_t count = 0;
    for (int i = 0; i < s.count; ++i) {
        const DVec3 p = is_moving ? s.points[i].b : s.points[i].a + so_far;
        bool is_known = false;
        for (std::size_t k = 0; k < count; ++k) is_known = is_known || corners[k] == p;
        if (!is_known) corners[count++] = p;
    }
    const Convex& cylinder = is_moving ? *pair.a.shape : *pair.b.shape;
    const auto met = is_moving ? touch_cylinder({corners, count}, -way, cylinder, cylinder.center + so_far, -s.nearest)
                               : touch_cylinder({corners, count}, way, cylinder, cylinder.center, s.nearest);
    if (!met) return std::nullopt;
    Touch r{met->fraction, is_moving ? -met->normal : met->normal, met->point};
    if (is_moving) r.on_b += met->fraction * way;
    const double speed = dot(way, r.normal), length = math::length(way);
    r.fraction -= tolerance / (2 * speed > length ? 2 * speed : length);
    return r;
}

} // namespace

GjkResult gjk_distance(const CorePair& pair, DVec3 guess, double max_distance, double tolerance) {
    if (!(dot(guess, guess) > 0)) guess = middle(*pair.b.shape) - middle(*pair.a.shape);
    if (!(dot(guess, guess) > 0)) guess = {0, 1, 0};
    Simplex start;
    start.points[0] = pair.support(guess);
    start.count = 1;
    return gjk_distance_from(pair, start, max_distance, tolerance);
}

GjkResult gjk_distance_from(const CorePair& pair, const Simplex& start, double max_distance, double tolerance) {
    GjkResult r;
    Simplex& s = r.simplex;
    s = start;
    Nearest first;
    nearest_of(s, first);
    keep(s, first);
    double square = first.square, size = square;
    for (int i = 0; i < s.count; ++i) size = std::max(size, dot(s.points[i].w, s.points[i].w));

    r.state = GjkResult::State::apart;
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
        if (!(square > touching * touching * size)) {
            r.state = GjkResult::State::overlapping;
            return r;
        }
        const DifferencePoint next = pair.support(-s.nearest);
        const double along = dot(s.nearest, next.w), next_square = dot(next.w, next.w);
        if (along > 0 && along * along > max_distance * max_distance * square) {
            r.state = GjkResult::State::far;
            r.distance = along / std::sqrt(square);
            r.normal = (-1 / std::sqrt(square)) * s.nearest;
            return r;
        }
        if (next_square > size) size = next_square;
        if (square - along <= tolerance * square + rounding * std::sqrt(square * size)) break;
        if (holds(s, next)) break;

        s.points[s.count++] = next;
        Nearest best;
        if (!nearest_of(s, best)) {
            r.state = GjkResult::State::overlapping;
            return r;
        }
        if (!(best.square < square)) { // no progress, due to rounding
            --s.count;
            break;
        }
        keep(s, best);
        square = best.square;
    }
    finish(r, s);
    return r;
}

GjkCast gjk_cast(const CorePair& pair, DVec3 way, double limit, double tolerance, DVec3 guess) {
    constexpr double converged = 1e-12; // relative tolerance as in gjk_distance
    const double radius = pair.a.radius + pair.b.radius, reach = radius + tolerance, stop = radius + 0.5 * tolerance;
    const bool is_rim = (is_cylinder(pair.a) && has_corners(pair.b)) || (has_corners(pair.a) && is_cylinder(pair.b));
    GjkCast r;
    Simplex& s = r.simplex;
    if (!(dot(guess, guess) > 0)) guess = middle(*pair.b.shape) - middle(*pair.a.shape);
    if (!(dot(guess, guess) > 0)) guess = {0, 1, 0};
    s.nearest = -guess; // initial search direction
    double square = dot(guess, guess), size = 0;
    bool is_moved = false;
    const auto support = [&](DVec3 normal) {
        DifferencePoint p = pair.support(normal);
        p.w += r.fraction * way;
        return p;
    };
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
        if (!(square > touching * touching * size)) break;
        const double distance = std::sqrt(square);
        DVec3 normal = (-1 / distance) * s.nearest;
        DifferencePoint next;
        double along = 0;
        std::optional<Touch> touch;
        if (is_moved && is_rim) touch = touch_of_cylinder(pair, s, way, r.fraction * way, tolerance);
        if (touch && r.fraction + touch->fraction > 0) {
            next = support(touch->normal), along = -dot(touch->normal, next.w);
            if (along - dot(way, touch->normal) * touch->fraction >= radius) { // no other feature touches earlier
                r.fraction += touch->fraction;
                r.state = r.fraction <= limit ? GjkCast::State::met : GjkCast::State::missed;
                r.normal = touch->normal, r.on_b = touch->on_b, r.distance = stop;
                return r;
            }
            if (along > reach) normal = touch->normal;
        }
        if (!(along > reach)) next = support(normal), along = -dot(normal, next.w);
        const double next_square = dot(next.w, next.w);
        if (next_square > size) size = next_square;
        const bool is_known = holds(s, next), is_first = s.count == 0;
        is_moved = along > reach;
        if (is_moved) { // a separating plane bounds how far the core may move
            const double part = (along - stop) / dot(way, normal);
            if (!(part > 0 && part <= limit - r.fraction)) {
                r.state = GjkCast::State::missed;
                return r;
            }
            const DVec3 move = part * way;
            r.fraction += part;
            for (int i = 0; i < s.count; ++i) s.points[i].w += move;
            next.w += move;
            square = std::numeric_limits<double>::infinity(); // no longer valid at the new position
        } else if (!is_first && (is_known || square - along * distance <=
                                                 converged * square + rounding * std::sqrt(square * size))) {
            finish(r, s);
            return r;
        }
        if (is_first) square = std::numeric_limits<double>::infinity();
        if (!is_known) s.points[s.count++] = next;
        Nearest best;
        if (!nearest_of(s, best)) {
            if (r.fraction == 0) r.state = GjkCast::State::overlapping;
            return r;
        }
        if (!(best.square < square)) { // no progress, due to rounding
            --s.count;
            if (!(distance <= reach)) break;
            finish(r, s);
            return r;
        }
        keep(s, best);
        square = best.square;
    }
    return r;
}

} // namespace cairn
