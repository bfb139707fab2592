// Angles of joints, 8 lanes at a time, without trigonometry.
#pragma once

#include "simd/f32x8.h"

#include <initializer_list>

namespace cairn::CAIRN_ISA {

inline constexpr float pi = 3.14159265358979f;

// The angle of (x, y), -pi to pi: one halving, tan(a / 2) = t / (1 + sqrt(1 + t^2)), then the arctangent series; the
// error is below 2e-7.
CAIRN_INLINE f32x8 angle_of(f32x8 y, f32x8 x) {
    const f32x8 ax = abs(x), ay = abs(y);
    const mask8 steep = ay > ax;
    const f32x8 t = select(steep, ax, ay) / (select(steep, ay, ax) + splat(1e-20f));
    const f32x8 u = t / (one() + sqrt(one() + t * t)), u2 = u * u;
    f32x8 series = splat(-1.0f / 15.0f);
    for (const float c : {1.0f / 13, -1.0f / 11, 1.0f / 9, -1.0f / 7, 1.0f / 5, -1.0f / 3})
        series = splat(c) + u2 * series;
    f32x8 angle = (u + u) * (one() + u2 * series);
    angle = select(steep, splat(0.5f * pi) - angle, angle);
    angle = select(x < zero(), splat(pi) - angle, angle);
    return select(y < zero(), -angle, angle);
}
// The nearest integer: adding 1.5 * 2^23 drops the fraction, as floats beyond 2^23 have none.
CAIRN_INLINE f32x8 rounded(f32x8 x) {
    const f32x8 big = splat(12582912.0f); // 1.5 * 2^23
    return (clamp(x, splat(-1e6f), splat(1e6f)) + big) - big;
}

} // namespace cairn::CAIRN_ISA
