// Ray casts at shapes; meshes and height fields are in triangle_rays.cpp.
#include "shapes/rays.h"

#include "shapes/gjk.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::DVec3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::optional<ShapeRayHit> cast_sphere(double radius, DVec3 o, DVec3 d, double max_distance) {
    // Starts from the point of the line nearest to the center, which avoids cancellation for a distant origin.
    const double t = -math::dot(o, d);
    const DVec3 nearest = o + t * d;
    const double square = radius * radius - math::dot(nearest, nearest);
    if (math::dot(o, o) < radius * radius || square < 0) return std::nullopt;
    const double distance = t - std::sqrt(square);
    if (distance < 0 || distance > max_distance) return std::nullopt;
    return ShapeRayHit{distance, (1 / radius) * (o + distance * d)};
}

std::optional<ShapeRayHit> cast_box(DVec3 half, DVec3 o, DVec3 d, double max_distance) {
    double enter = -infinity, leave = infinity;
    int axis = -1;
    for (int i = 0; i < 3; ++i) {
        if (d[i] == 0) {
            if (std::fabs(o[i]) > half[i]) return std::nullopt;
            continue;
        }
        const double a = (-half[i] - o[i]) / d[i], b = (half[i] - o[i]) / d[i];
        const double near = std::min(a, b), far = std::max(a, b);
        if (near > enter) enter = near, axis = i;
        leave = std::min(leave, far);
    }
    if (axis < 0 || enter > leave || enter < 0 || enter > max_distance) return std::nullopt;
    DVec3 normal;
    normal[axis] = d[axis] > 0 ? -1 : 1;
    return ShapeRayHit{enter, normal};
}

std::optional<ShapeRayHit> cast_plane(const Geometry& shape, DVec3 o, DVec3 d, double max_distance) {
    // a double-sided plane is hit from the side on which the ray starts
    const double side = shape.is_double_sided && o.y < 0 ? -1 : 1;
    o.y *= side, d.y *= side;
    if (shape.type == ShapeType::plane && o.y < 0) return ShapeRayHit{0, {0, 1, 0}};
    if (!(d.y < 0)) return std::nullopt; // one-sided
    const double distance = -o.y / d.y;
    if (distance < 0 || distance > max_distance) return std::nullopt;
    const DVec3 p = o + distance * d;
    if (shape.type == ShapeType::rectangle && (std::fabs(p.x) > shape.size.x || std::fabs(p.z) > shape.size.z))
        return std::nullopt;
    return ShapeRayHit{distance, {0, side, 0}};
}

// The part of a line inside a convex body, and the normal at the entry. It is cut by one face at a time; as adjacent
// faces share an edge, no line passes between them.
struct Chord {
    double enter = -infinity, leave = infinity;
    DVec3 normal;

    void cut(double from, double to, DVec3 n) {
        if (from > enter) enter = from, normal = n;
        if (to < leave) leave = to;
    }
    void cut_none() { enter = infinity, leave = -infinity; }
    bool is_empty() const { return !(enter <= leave); }
    // Keeps the part below the plane normal . x = offset.
    void cut_below(DVec3 n, double offset, DVec3 o, DVec3 d) {
        const double height = offset - math::dot(n, o), speed = math::dot(n, d);
        if (speed < 0)
            cut(height / speed, infinity, n);
        else if (speed > 0)
            cut(-infinity, height / speed, n);
        else if (height < 0)
            cut_none();
    }
};

// The lateral surface of a solid of revolution about y, whose outline runs from (radius a, y0) to (radius b, y1). The
// solid is the set of points with c rho <= w, where rho is the distance from the axis, w = k - s y, and (c, s) the unit
// normal of the outline.
struct ConeSide {
    double c, s, k;

    // Cuts with the upper half (w >= 0) of the double cone c^2 rho^2 = w^2, for which the line satisfies a quadratic
    // inequality in t, A t^2 + 2 B t + C <= 0. The caller has to cut off the lower half.
    void cut(Chord& chord, DVec3 o, DVec3 d) const {
        const double w0 = k - s * o.y, w1 = -s * d.y;
        const double A = c * c * (d.x * d.x + d.z * d.z) - w1 * w1;
        const double B = c * c * (o.x * d.x + o.z * d.z) - w0 * w1;
        const double C = c * c * (o.x * o.x + o.z * o.z) - w0 * w0;
        // B^2 - A C = c^2 (|g|^2 - c^2 x^2), computed without cancellation (Lagrange's identity).
        const double g_x = w0 * d.x - w1 * o.x, g_z = w0 * d.z - w1 * o.z;
        const double g = std::sqrt(g_x * g_x + g_z * g_z), x = c * std::fabs(o.x * d.z - o.z * d.x);
        if (A > 0 && g < x) return chord.cut_none();
        const double root = c * std::sqrt(std::max(0.0, (g - x) * (g + x)));
        // The roots (-B - root) / A, where the line enters, and (-B + root) / A, where it leaves.
        double enter = -infinity, leave = infinity;
        const bool goes_in = A > 0 || w1 > 0, comes_out = A > 0 || w1 < 0;
        if (goes_in) enter = B < 0 ? C / (root - B) : A != 0 ? (-B - root) / A : -infinity;
        if (comes_out) leave = B > 0 ? -C / (root + B) : A != 0 ? (root - B) / A : infinity;
        if (A == 0 && w1 == 0 && C > 0) return chord.cut_none(); // parallel to a cylinder's side, outside of it
        chord.cut(enter, leave, normal_at(o + (goes_in ? enter : 0) * d));
    }
    DVec3 normal_at(DVec3 p) const {
        const double rho = std::sqrt(p.x * p.x + p.z * p.z);
        if (!(rho > 0) || !std::isfinite(rho)) return {0, s < 0 ? -1.0 : 1.0, 0};
        return {c * p.x / rho, s, c * p.z / rho};
    }
};

// Converts a chord to a hit. The line starts near the shape, at o; the ray starts at the distance `start` along it.
std::optional<ShapeRayHit> ray_hit(const Chord& chord, double start, double max_distance) {
    const double distance = chord.enter - start;
    if (chord.is_empty() || !std::isfinite(distance) || distance < 0 || distance > max_distance) return std::nullopt;
    return ShapeRayHit{distance, chord.normal};
}

Chord cylinder_chord(DVec3 size, DVec3 o, DVec3 d) {
    const double a = size.x, h = size.y, b = size.z;
    const double length = std::sqrt(4 * h * h + (a - b) * (a - b));
    const double c = 2 * h / length, s = (a - b) / length;
    Chord chord;
    chord.cut_below({0, 1, 0}, h, o, d);
    chord.cut_below({0, -1, 0}, h, o, d);
    ConeSide{c, s, a * c - h * s}.cut(chord, o, d);
    return chord;
}

Chord ball_chord(double radius, double y, DVec3 o, DVec3 d) {
    o.y -= y;
    const double t = -math::dot(o, d);
    const DVec3 nearest = o + t * d;
    const double square = radius * radius - math::dot(nearest, nearest);
    Chord chord;
    if (square < 0) {
        chord.cut_none();
        return chord;
    }
    const double half = std::sqrt(square), enter = t - half;
    chord.cut(enter, t + half, radius > 0 ? (1 / radius) * (o + enter * d) : -d);
    return chord;
}

// A capsule consists of two balls, and the cone that touches both, between the circles of contact. As the end caps of
// the cone are inside the balls, a line enters the capsule where it first enters any of the three.
Chord capsule_chord(DVec3 size, DVec3 o, DVec3 d) {
    const double a = size.x, h = size.y, b = size.z, s = (a - b) / (2 * h);
    const Chord low = ball_chord(a, -h, o, d), high = ball_chord(b, h, o, d);
    Chord first = high.is_empty() || (!low.is_empty() && low.enter <= high.enter) ? low : high;
    if (!(s > -1 && s < 1)) return first; // one ball is inside the other
    const double c = std::sqrt((1 - s) * (1 + s));
    Chord side;
    ConeSide{c, s, a - h * s}.cut(side, o, d);
    const double y = o.y + side.enter * d.y;
    if (!side.is_empty() && y >= -h + a * s && y <= h + b * s && (first.is_empty() || side.enter < first.enter))
        first = side;
    return first;
}

Chord hull_chord(const HullData& hull, DVec3 o, DVec3 d) {
    Chord chord;
    for (const HullFace& face : hull.faces) {
        chord.cut_below(math::to_double(face.normal), double(face.offset), o, d);
        if (chord.is_empty()) return chord;
    }
    chord.normal = math::normalized(chord.normal);
    return chord;
}

// The ray cast for a rounded shape: conservative advancement, that is, Newton's method from below on the distance to
// the core, which is a convex function of the distance along the ray. It starts where the line enters the bounding
// sphere. The line starts near the shape, at o; the ray starts at the distance `start` along it.
std::optional<ShapeRayHit> cast_rounded(const Geometry& shape, const ShapeData& data, DVec3 o, DVec3 d, double start,
                                        double max_distance) {
    constexpr int max_rounds = 64; // each at least halves the remaining distance
    const double radius = double(shape.rounding), size = double(shape.bounding_radius), tolerance = 1e-9 * size;
    const DVec3 to_middle = math::to_double(shape.middle) - o;
    const double nearest = math::dot(to_middle, d);
    const DVec3 off = to_middle - nearest * d;
    const double square = size * size * (1 + 1e-5) - math::dot(off, off);
    if (!(square > 0)) return std::nullopt;
    const double half = std::sqrt(square), last = std::min(nearest + half, start + max_distance);
    double at = std::max(nearest - half, start);
    const Convex convex = make_convex(shape, data, {}, {});
    Convex point;
    const CorePair pair{{&point, false, 0}, exact_core(convex)};
    DVec3 normal; // outward
    for (int round = 0; round < max_rounds && at <= last; ++round) {
        point.center = o + at * d;
        const GjkResult r = gjk_distance(pair, round > 0 ? -normal : DVec3{}, infinity);
        const bool is_inside = r.state == GjkResult::State::overlapping || r.distance < radius - tolerance;
        if (is_inside) return std::nullopt; // possible only if the ray starts inside
        normal = -r.normal;
        const double speed = -math::dot(d, normal);
        if (!(speed > 0)) return std::nullopt; // the ray passes or moves away
        const double gap = r.distance - radius;
        if (gap <= tolerance) return ShapeRayHit{at - start, normal};
        at += (gap - 0.5 * tolerance) / speed; // keeps a gap, so that the point never reaches the core
    }
    return std::nullopt;
}

std::optional<ShapeRayHit> cast_local(const Geometry& shape, const ShapeData& data, const LocalRay& ray) {
    const DVec3 o = ray.origin, d = ray.direction, size = math::to_double(shape.size);
    // The point of the line nearest to the shape's origin, which avoids cancellation for a distant ray origin.
    const double start = math::dot(o, d);
    const DVec3 near = o - start * d;
    if (shape.rounding > 0) return cast_rounded(shape, data, near, d, start, ray.max_distance);
    switch (shape.type) {
    case ShapeType::sphere:
        return cast_sphere(size.x, o, d, ray.max_distance);
    case ShapeType::box:
        return cast_box(size, o, d, ray.max_distance);
    case ShapeType::plane:
    case ShapeType::rectangle:
        return cast_plane(shape, o, d, ray.max_distance);
    case ShapeType::capsule:
        return ray_hit(capsule_chord(size, near, d), start, ray.max_distance);
    case ShapeType::cylinder:
        return ray_hit(cylinder_chord(size, near, d), start, ray.max_distance);
    case ShapeType::hull:
        return ray_hit(hull_chord(hull_of(data), near, d), start, ray.max_distance);
    case ShapeType::mesh:
        return cast_at_mesh(mesh_of(data), ray);
    case ShapeType::height_field:
        return cast_at_height_field(height_field_of(data), ray);
    }
    return std::nullopt;
}

} // namespace

std::optional<ShapeRayHit> cast_ray(const Geometry& shape, const ShapeData& data, DVec3 position, math::Quat rotation,
                                    DVec3 origin, DVec3 direction, double max_distance) {
    const math::DQuat q = math::normalized(math::to_double(rotation));
    const LocalRay ray{math::rotate_back(q, origin - position), math::rotate_back(q, direction), max_distance};
    auto hit = cast_local(shape, data, ray);
    if (hit) hit->normal = math::rotate(q, hit->normal);
    return hit;
}

} // namespace cairn
