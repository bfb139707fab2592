#include "collision/far_apart.h"

#include <algorithm>

namespace cairn {

using math::dot;

namespace {

// Share of the sizes: the error of the distance due to rounding and to nearly parallel segments.
constexpr float slack_part = 4e-3f;

// A capsule around a shape: a segment, and a radius around it.
struct Bar {
    math::Vec3 center, half;
    float radius;
};

Bar bar_around(const Geometry& g, const ShapePose& pose, math::Vec3 center) {
    const math::Quat q{pose.q[0], pose.q[1], pose.q[2], pose.q[3]};
    if (g.type == ShapeType::capsule || g.type == ShapeType::cylinder)
        return {center, math::rotate(q, math::Vec3{0, g.size.y, 0}), std::max(g.size.x, g.size.z) + g.rounding};
    if (g.type == ShapeType::box) { // the segment is along its longest axis
        const math::Vec3 h = g.size;
        const int i = h.x >= h.y && h.x >= h.z ? 0 : h.y >= h.z ? 1 : 2;
        math::Vec3 half, rest = h;
        half[i] = h[i], rest[i] = 0;
        return {center, math::rotate(q, half), math::length(rest) + g.rounding};
    }
    if (g.type == ShapeType::sphere) return {center, {}, g.size.x};
    return {center + math::rotate(q, g.middle), {}, g.bounding_radius};
}

float within(float t) { return std::min(std::max(t, -1.0f), 1.0f); }

// The squared distance of two segments (as in Ericson, "Real-Time Collision Detection", 2005, section 5.1.9, but with
// parameters from -1 to 1 about their middles).
float square_distance(const Bar& a, const Bar& b) {
    const math::Vec3 r = a.center - b.center;
    const float uu = dot(a.half, a.half), vv = dot(b.half, b.half), uv = dot(a.half, b.half);
    const float ur = dot(a.half, r), vr = dot(b.half, r);
    float s = 0, t = 0;
    if (const float determinant = uu * vv - uv * uv; determinant > 1e-6f * uu * vv)
        s = within((uv * vr - ur * vv) / determinant);
    if (vv > 0) t = within((uv * s + vr) / vv);
    if (uu > 0) s = within((uv * t - ur) / uu);
    const math::Vec3 between = r + s * a.half - t * b.half;
    return dot(between, between);
}

} // namespace

float gap_lower_bound(const Geometry& a, const ShapePose& pose_a, const Geometry& b, const ShapePose& pose_b) {
    const math::Vec3 offset =
        (math::to_vec(pose_b.high) - math::to_vec(pose_a.high)) + (math::to_vec(pose_b.low) - math::to_vec(pose_a.low));
    const Bar first = bar_around(a, pose_a, {}), second = bar_around(b, pose_b, offset);
    const float reach = first.radius + second.radius;
    const float sizes = reach + math::length(first.half) + math::length(second.half);
    return std::sqrt(square_distance(first, second)) - (reach + slack_part * sizes);
}

} // namespace cairn
