// Angles without trigonometric functions: bit-identical on every machine.
#pragma once

#include <cmath>

namespace cairn::math {

inline constexpr double pi = 3.14159265358979323846;

// The angle of a direction of any length in the upper half plane, from 0 to pi. Accurate to a few roundings.
inline double angle_of(double cosine, double sine) {
    if (!(sine > 0)) return cosine < 0 ? pi : 0;
    const double c = std::fabs(cosine);
    const bool is_steep = sine > c;
    // atan t = 2 atan(t / (1 + sqrt(1 + t^2))), applied four times; then the power series.
    double t = is_steep ? c / sine : sine / c;
    for (int i = 0; i < 4; ++i) t = t / (1 + std::sqrt(1 + t * t));
    const double t2 = t * t;
    double series = 0;
    for (int k = 15; k > 0; k -= 2) series = 1.0 / k - t2 * series;
    const double angle = 16 * t * series, sharp = is_steep ? pi / 2 - angle : angle;
    return cosine < 0 ? pi - sharp : sharp;
}

} // namespace cairn::math
