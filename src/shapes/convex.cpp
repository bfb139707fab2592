#include "shapes/convex.h"

#include <limits>

namespace cairn {

using math::DVec3;

namespace {

// Inset of the core of sharp shapes: a fraction of the smallest half width, and the greatest inset in m.
constexpr double inset_part = 0.05, greatest_inset = 0.02;

double inset_for(double extent) { return std::min(inset_part * extent, greatest_inset); }

// The frustum with its three surfaces moved inward by m. If the lateral surfaces meet below an end, the end becomes a
// tip.
Frustum inset_frustum(double low_radius, double half, double high_radius, double m) {
    const double difference = low_radius - high_radius;
    const double side = m * std::sqrt(4 * half * half + difference * difference) / (2 * half);
    const double slope = -difference / (2 * half); // change of the radius per height
    Frustum f{-half + m, low_radius + slope * m - side, half - m, high_radius - slope * m - side};
    const double middle_radius = 0.5 * (low_radius + high_radius) - side; // at height 0
    if (f.high_radius < 0) f.high = -middle_radius / slope, f.high_radius = 0;
    if (f.low_radius < 0) f.low = -middle_radius / slope, f.low_radius = 0;
    return f;
}

DVec3 frustum_support(const Frustum& f, DVec3 d) {
    const double across = std::sqrt(d.x * d.x + d.z * d.z);
    const bool is_high = d.y * f.high + across * f.high_radius > d.y * f.low + across * f.low_radius;
    const double y = is_high ? f.high : f.low, r = is_high ? f.high_radius : f.low_radius;
    if (!(across > 0)) return {0, y, 0};
    const double s = r / across;
    return {s * d.x, y, s * d.z};
}

// The support point of a capsule's core: a segment, or the convex hull of a ball and a point if the radii differ.
DVec3 capsule_support(const Convex& c, DVec3 d) {
    const double length = c.size.x == c.size.z ? 0 : math::length(d);
    const double low = c.size.x - c.radius, high = c.size.z - c.radius;
    const bool is_high = d.y * c.size.y + length * high > -d.y * c.size.y + length * low;
    const double r = is_high ? high : low;
    const DVec3 end{0, is_high ? c.size.y : -c.size.y, 0};
    return r > 0 && length > 0 ? end + (r / length) * d : end;
}

Convex make_polygon(std::span<const DVec3> corners) {
    Convex r;
    r.kind = Convex::Kind::polygon;
    r.is_sharp = true;
    r.extent = std::numeric_limits<double>::infinity();
    r.corner_count = static_cast<int>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        r.corners[i] = corners[i];
        r.center += (1.0 / r.corner_count) * corners[i];
    }
    DVec3 normal = math::cross(r.corners[1] - r.corners[0], r.corners[2] - r.corners[0]);
    const double length = math::length(normal);
    normal = length > 0 ? (1 / length) * normal : DVec3{0, 1, 0};
    DVec3 x = r.corners[1] - r.corners[0];
    x = x - math::dot(x, normal) * normal;
    const double along = math::length(x);
    x = along > 0 ? (1 / along) * x : math::to_double(math::any_orthogonal(math::to_float(normal)));
    r.axes = {x, normal, math::cross(x, normal)};
    return r;
}

} // namespace

namespace {

// Turns a sharp shape into a rounded one: the sharp shape becomes the core.
void round_off(Convex& c, double rounding) {
    c.is_sharp = false;
    c.shallow = rounding + c.radius;
    c.radius = rounding;
    c.extent += rounding;
}

} // namespace

Convex make_convex(const Geometry& geometry, const ShapeData& data, const DVec3& center, const math::DQuat& rotation) {
    Convex c;
    c.center = center;
    c.axes = math::to_matrix(rotation);
    c.size = math::to_double(geometry.size);
    const DVec3 s = c.size;
    switch (geometry.type) {
    case ShapeType::box:
        c.kind = Convex::Kind::box;
        c.is_sharp = true;
        c.extent = std::min(s.x, std::min(s.y, s.z));
        c.radius = inset_for(c.extent);
        break;
    case ShapeType::capsule:
        c.kind = Convex::Kind::capsule;
        c.radius = std::min(s.x, s.z);
        c.extent = std::max(s.x, s.z);
        break;
    case ShapeType::cylinder:
        c.kind = Convex::Kind::cylinder;
        c.is_sharp = true;
        c.extent = std::min(s.y, std::max(s.x, s.z));
        c.radius = inset_for(c.extent);
        c.core = inset_frustum(s.x, s.y, s.z, c.radius);
        break;
    case ShapeType::hull:
        c.kind = Convex::Kind::hull;
        c.is_sharp = true;
        c.hull = &hull_of(data);
        c.extent = 0.5 * c.hull->width;
        c.radius = c.hull->inset;
        break;
    case ShapeType::rectangle: {
        const DVec3 x = s.x * c.axes.c0, z = s.z * c.axes.c2;
        c = make_polygon(std::array{center - x - z, center - x + z, center + x + z, center + x - z});
        break;
    }
    default:
        c.kind = Convex::Kind::ball;
        c.radius = c.extent = s.x;
    }
    c.shallow = c.radius;
    if (geometry.rounding > 0) round_off(c, double(geometry.rounding));
    return c;
}

namespace {

// The scale of a shrunk hull's core, about the point inside of it: per axis, so that long hulls keep their ends; or
// uniform if that point is the center of mass, because a uniform scale never leaves a convex shape.
DVec3 scale_of_core(const HullData& hull, double depth) {
    const DVec3 lo = math::to_double(hull.lo), hi = math::to_double(hull.hi);
    const bool is_even = !(hull.inside == 0.5 * (lo + hi));
    DVec3 scale;
    for (int i = 0; i < 3; ++i) {
        const double half = is_even ? hull.inner_radius : 0.5 * (hi[i] - lo[i]);
        scale[i] = half > 0 ? std::max(0.0, 1 - depth / half) : 0;
    }
    return scale;
}

} // namespace

void shrink(Convex& c, double depth) {
    if (c.kind == Convex::Kind::polygon) return;
    const double around = c.is_sharp ? 0 : c.radius, left = std::max(0.0, depth - around);
    c.is_sharp = false;
    c.radius = std::max(0.0, around - depth);
    if (c.kind == Convex::Kind::box) {
        for (int i = 0; i < 3; ++i) c.size[i] = std::max(0.0, c.size[i] - left);
    } else if (c.kind == Convex::Kind::capsule) { // reduces both end radii, of which `radius` is the smaller one
        c.size.x = std::max(0.0, c.size.x - depth), c.size.z = std::max(0.0, c.size.z - depth);
    } else if (c.kind == Convex::Kind::cylinder && left > 0) {
        const Frustum f = inset_frustum(c.size.x, c.size.y, c.size.z, std::min(left, 0.999 * c.size.y));
        const double half = std::max(0.0, 0.5 * (f.high - f.low));
        c.center += 0.5 * (f.low + f.high) * c.axes.c1;
        c.size = {std::max(0.0, f.low_radius), half, std::max(0.0, f.high_radius)};
    } else if (c.kind == Convex::Kind::hull && left > 0) {
        const DVec3 scale = scale_of_core(*c.hull, left);
        c.center = inside_of(c);
        c.axes = {scale.x * c.axes.c0, scale.y * c.axes.c1, scale.z * c.axes.c2};
        c.center = c.center - c.axes * c.hull->inside;
    }
}

Convex make_triangle(DVec3 a, DVec3 b, DVec3 c) { return make_polygon(std::array{a, b, c}); }

Convex reversed(const Convex& polygon) {
    DVec3 corners[4];
    const int n = polygon.corner_count;
    for (int i = 0; i < n; ++i) corners[i] = polygon.corners[n - 1 - i];
    return make_polygon({corners, static_cast<std::size_t>(n)});
}

Convex moved(const Convex& c, DVec3 by) {
    Convex r = c;
    r.center += by;
    if (c.kind == Convex::Kind::polygon)
        for (DVec3& corner : r.corners) corner += by;
    return r;
}

DVec3 round_support(const Core& core, DVec3 d) {
    const Convex& c = *core.shape;
    DVec3 local;
    switch (c.kind) {
    case Convex::Kind::ball:
        return c.center;
    case Convex::Kind::capsule:
        local = capsule_support(c, to_local(c, d));
        break;
    case Convex::Kind::cylinder:
        local =
            frustum_support(core.is_inset ? c.core : Frustum{-c.size.y, c.size.x, c.size.y, c.size.z}, to_local(c, d));
        break;
    case Convex::Kind::box:
    case Convex::Kind::hull:
    case Convex::Kind::polygon:
        break; // handled by core_support
    }
    return c.center + c.axes * local;
}

DVec3 middle(const Convex& c) {
    if (c.kind != Convex::Kind::hull) return c.center;
    return c.center + c.axes * (0.5 * (math::to_double(c.hull->lo) + math::to_double(c.hull->hi)));
}

DVec3 inside_of(const Convex& c) {
    return c.kind == Convex::Kind::hull ? c.center + c.axes * c.hull->inside : c.center;
}

int face_count(const Convex& c) {
    switch (c.kind) {
    case Convex::Kind::box:
        return 6;
    case Convex::Kind::cylinder:
        return 2;
    case Convex::Kind::polygon:
        return 1;
    case Convex::Kind::hull:
        return static_cast<int>(c.hull->faces.size());
    default:
        return 0;
    }
}

bool has_face(const Convex& c, int face) {
    if (face < 0 || face >= face_count(c)) return false;
    return c.kind != Convex::Kind::cylinder || (face == 0 ? c.size.z : c.size.x) > 0;
}

namespace {

DVec3 core_face_point(const Convex& c, int face) {
    switch (c.kind) {
    case Convex::Kind::box:
        return c.center + c.size[face / 2] * face_normal(c, face);
    case Convex::Kind::hull: {
        const std::uint32_t first = c.hull->faces[static_cast<std::size_t>(face)].first;
        return hull_point(c, c.hull->vertices[c.hull->loops[first]]);
    }
    case Convex::Kind::cylinder:
        return c.center + c.size.y * face_normal(c, face);
    default:
        return c.corners[0];
    }
}

} // namespace

DVec3 face_point(const Convex& c, int face) {
    const DVec3 p = core_face_point(c, face);
    return c.is_sharp ? p : p + c.radius * face_normal(c, face);
}

} // namespace cairn
