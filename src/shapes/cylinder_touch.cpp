#include "shapes/cylinder_touch.h"

namespace cairn {

using math::cross;
using math::dot;
using math::DVec3;

namespace {

// The coordinates below are in the frame of the cylinder, whose axis is y.
DVec3 across(DVec3 v) { return {v.x, 0, v.z}; }

struct Rims {
    double radius, end;     // of the near rim, and its y coordinate
    double low, high, half; // radii of both ends, and half the height
    bool is_straight;       // otherwise the side is conical
};

std::optional<CylinderTouch> touch_of_corner(const Rims& c, DVec3 p, DVec3 way) {
    const DVec3 out = across(p), toward = across(way);
    const double a = dot(toward, toward), b = dot(out, toward),
                 under = b * b - a * (dot(out, out) - c.radius * c.radius);
    if (c.is_straight && under > 0) {
        const double at = -(b + std::sqrt(under)) / a;
        const DVec3 point = p + at * way;
        if (std::fabs(point.y) <= c.half) return CylinderTouch{at, point, (-1 / c.radius) * across(point)};
    }
    const bool is_high = way.y < 0; // the end that the corner moves towards
    const double at = ((is_high ? c.half : -c.half) - p.y) / way.y, radius = is_high ? c.high : c.low;
    const DVec3 point = p + at * way, off = across(point);
    if (!(dot(off, off) <= radius * radius)) return std::nullopt;
    return CylinderTouch{at, point, {0, is_high ? -1.0 : 1.0, 0}};
}

// The moving edge sweeps a plane. It touches the rim where the intersection line of this plane with the plane of the
// end enters the end's disc.
std::optional<CylinderTouch> touch_of_edge(const Rims& c, DVec3 p, DVec3 edge, DVec3 way) {
    const DVec3 along = edge.y * way - way.y * edge; // direction of the intersection line
    const DVec3 line = across(edge.y < 0 ? -along : along);
    const bool is_steep = std::fabs(edge.y) > std::fabs(way.y);
    const double first = (c.end - p.y) / (is_steep ? edge.y : way.y);
    const DVec3 from = across(p + first * (is_steep ? edge : way));
    const double a = dot(line, line), b = dot(from, line), under = b * b - a * (dot(from, from) - c.radius * c.radius);
    if (!(under > 0)) return std::nullopt;
    const double step = -(b + std::sqrt(under)) / a;
    const DVec3 point = from + step * line;
    const double at = (is_steep ? 0 : first) + step * std::fabs(edge.y);
    const double part = (is_steep ? first : 0) - step * (edge.y < 0 ? -way.y : way.y);
    if (!(part >= 0 && part <= 1)) return std::nullopt;
    DVec3 normal = cross(edge, {-point.z, 0, point.x});
    normal = (1 / math::length(normal)) * normal;
    return CylinderTouch{at, {point.x, c.end, point.z}, dot(normal, way) < 0 ? -normal : normal};
}

std::optional<CylinderTouch> touch_of_edge_and_side(const Rims& c, DVec3 p, DVec3 edge, DVec3 way) {
    DVec3 normal{edge.z, 0, -edge.x};
    const double square = dot(normal, normal);
    normal = (1 / std::sqrt(square)) * normal;
    double speed = dot(normal, way);
    if (speed < 0) normal = -normal, speed = -speed;
    const double at = (-c.radius - dot(normal, p)) / speed;
    const DVec3 here = p + at * way;
    const double part = -dot(across(here), edge) / square;
    const DVec3 point = here + part * edge;
    if (!(part >= 0 && part <= 1 && std::fabs(point.y) <= c.half)) return std::nullopt;
    return CylinderTouch{at, point, normal};
}

std::optional<CylinderTouch> touch_of_triangle(const Rims& c, std::span<const DVec3> corners, DVec3 way) {
    const DVec3 p = corners[0];
    DVec3 normal = cross(corners[1] - p, corners[2] - p);
    normal = (1 / math::length(normal)) * normal;
    double speed = dot(normal, way);
    if (speed < 0) normal = -normal, speed = -speed;
    const double out = math::length(across(normal));
    const DVec3 point{-c.radius / out * normal.x, c.end, -c.radius / out * normal.z};
    const double at = dot(normal, point - p) / speed;
    const DVec3 q = point - at * way;
    for (int i = 0; i < 3; ++i) {
        const DVec3 from = corners[i], edge = corners[i == 2 ? 0 : i + 1] - from, third = corners[i == 0 ? 2 : i - 1];
        const double inside = dot(cross(edge, third - from), normal), side = dot(cross(edge, q - from), normal);
        if (!(inside > 0 ? side >= 0 : side <= 0)) return std::nullopt;
    }
    return CylinderTouch{at, point, normal};
}

} // namespace

std::optional<CylinderTouch> touch_cylinder(std::span<const DVec3> corners, DVec3 way, const Convex& cylinder,
                                            DVec3 center, DVec3 toward) {
    DVec3 local[3];
    for (std::size_t i = 0; i < corners.size(); ++i) local[i] = to_local(cylinder, corners[i] - center);
    const DVec3 w = to_local(cylinder, way);
    const DVec3 size = cylinder.size;
    const bool is_high = dot(cylinder.axes.c1, toward) > 0;
    const Rims c{is_high ? size.z : size.x, is_high ? size.y : -size.y, size.x, size.z, size.y, size.x == size.z};
    std::optional<CylinderTouch> r;
    switch (corners.size()) {
    case 1:
        r = touch_of_corner(c, local[0], w);
        break;
    case 2:
        r = touch_of_edge(c, local[0], local[1] - local[0], w);
        if (!r && c.is_straight) r = touch_of_edge_and_side(c, local[0], local[1] - local[0], w);
        break;
    default:
        r = touch_of_triangle(c, {local, 3}, w);
    }
    if (!r) return r;
    return CylinderTouch{r->fraction, center + cylinder.axes * r->point, cylinder.axes * r->normal};
}

} // namespace cairn
