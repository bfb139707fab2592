#include "impacts/rebounds.h"

#include "bodies/bodies.h"
#include "contacts/round_touch.h"

#include <algorithm>
#include <cmath>

namespace cairn {

using math::cross;
using math::dot;
using math::DVec3;
using math::to_double;

namespace {

DVec3 velocity_of(const TouchingBody& body) { return body.now.v + cross(body.now.w, body.middle - body.now.x); }

// Acceleration of the height of the body's surface along `outward`, the normal out of the body. The height of a rim is
// that of its middle plus R sqrt(1 - s^2), with s the cosine between axis and normal; the normal rotates with the other
// body.
double acceleration_along(const TouchingBody& body, DVec3 outward, const TouchingBody& other) {
    const DVec3 arm = body.middle - body.now.x, w = body.now.w;
    const double middle = dot(outward, body.pull + cross(body.spin_change, arm) + cross(w, cross(w, arm)));
    const double cosine = dot(body.axis, outward), square = 1 - cosine * cosine;
    if (!(body.radius > 0) || !(square > 0)) return middle;
    const DVec3 seen = w - other.now.w, change = body.spin_change - other.spin_change - cross(other.now.w, w);
    const double rate = dot(outward, cross(seen, body.axis)),
                 growth = dot(outward, cross(change, body.axis) + cross(seen, cross(seen, body.axis)));
    return middle - body.radius / std::sqrt(square) * (rate * rate / square + cosine * growth);
}

// The feature of a shape that touches at a point; `outward`: normal out of the shape.
TouchingBody touching_body(const Movers& movers, const Shapes& shapes, std::int32_t mover, std::uint32_t shape,
                           const MovingState& now, DVec3 point, DVec3 outward) {
    const Geometry& g = shapes.geometry[shape];
    const math::DQuat q = now.q * to_double(g.rotation);
    const DVec3 center = now.x + movers.arm_of(shape, now.q);
    TouchingBody body{now, point - double(g.rounding) * outward};
    ShapePose pose{};
    pose_shape(pose, g, {}, math::to_float(now.q));
    body.is_flat = is_flat(g, pose, math::to_float(outward));
    if (mover != none) movers.go_on_freely(mover, now, body.pull, body.spin_change);
    if (g.type == ShapeType::sphere) body.middle = center;
    if (g.type != ShapeType::capsule && g.type != ShapeType::cylinder) return body;
    body.axis = math::rotate(q, DVec3{0, 1, 0});
    const double half = double(g.size.y), along = std::clamp(dot(body.axis, body.middle - center), -half, half);
    if (g.type == ShapeType::cylinder) {
        const DVec3 middle = center + along * body.axis;
        body.radius = math::length(body.middle - middle), body.middle = middle;
    } else {
        const double upper = half > 0 ? 0.5 * (1 + along / half) : 0;
        body.middle = point - ((1 - upper) * double(g.size.x) + upper * double(g.size.z)) * outward;
    }
    return body;
}

} // namespace

double closing_acceleration(const TouchingBody& a, const TouchingBody& b, DVec3 normal) {
    const DVec3 slip = velocity_of(b) - velocity_of(a);
    const auto followed = [&](const TouchingBody& body) { return 2 * dot(normal, cross(body.now.w, slip)); };
    const double faces = a.is_flat == b.is_flat ? std::max(followed(a), followed(b)) : followed(a.is_flat ? a : b);
    return acceleration_along(a, normal, b) + acceleration_along(b, -normal, a) + faces;
}

void set_rebounds(const Movers& movers, const Shapes& shapes, const SweptPair& pair, const MovingState& now_a,
                  const MovingState& now_b, std::span<ImpactPoint> points) {
    for (ImpactPoint& point : points) {
        if (!(point.depth > 0)) continue;
        const DVec3 n = point.normal;
        const TouchingBody a = touching_body(movers, shapes, pair.first, pair.shape, now_a, point.position, n),
                           b = touching_body(movers, shapes, pair.second, pair.other, now_b, point.position, -n);
        const double approach = std::max(dot(velocity_of(a) - velocity_of(b), n), 0.0);
        const auto gain = [&](double acceleration) { return 2 * std::max(acceleration, 0.0) * point.depth; };
        point.rebound = std::sqrt(
            std::min(gain(closing_acceleration(a, b, n)), approach * approach + gain(dot(a.pull - b.pull, n))));
    }
}

} // namespace cairn
