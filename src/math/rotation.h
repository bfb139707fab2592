// Conversions between rotation vectors (axis times angle) and quaternions in double, without trigonometric functions:
// bit-identical on every machine. Errors are below 1e-9 for rotations up to two radians.
#pragma once

#include "math/vec.h"

namespace cairn::math {

// With x an eighth of the angle: tan x = x (1 + x^2/3 + 2 x^4/15 + 17 x^6/315 + ...); the quaternion is squared twice.
inline DQuat from_rotation_vector(DVec3 u) {
    DVec3 half = 0.125 * u;
    double x2 = dot(half, half);
    if (!(x2 <= 1)) { // more than a full rotation: clamped, about the same axis
        half = std::isfinite(x2) ? (1 / std::sqrt(x2)) * half : DVec3{};
        x2 = dot(half, half);
    }
    const DVec3 t = (1 + x2 * (1.0 / 3 + x2 * (2.0 / 15 + x2 * (17.0 / 315 + x2 * (62.0 / 2835))))) * half;
    const DQuat quarter = normalized(DQuat{t.x, t.y, t.z, 1});
    const DQuat middle = quarter * quarter;
    return normalized(middle * middle);
}

// The shorter way around. The angle is 2 atan(|v| / w), by halving: atan t = 2 atan(t / (1 + sqrt(1 + t^2))).
inline DVec3 to_rotation_vector(DQuat q) {
    if (q.w < 0) q = {-q.x, -q.y, -q.z, -q.w};
    const double sine = length(q.vector());
    if (!(sine > 0)) return {};
    double t = sine / (q.w > 1e-9 ? q.w : 1e-9), factor = 2;
    for (int i = 0; i < 6; ++i) {
        t = t / (1 + std::sqrt(1 + t * t));
        factor *= 2;
    }
    const double angle = factor * t * (1 - t * t * (1.0 / 3 - t * t / 5));
    return (angle / sine) * q.vector();
}

} // namespace cairn::math
