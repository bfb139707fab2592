// A shape that moves past another, with its time of impact by conservative advancement, for tests of sweeps.
#pragma once

#include "convex_test_support.h"
#include "shapes/convex_query.h"

#include <algorithm>
#include <optional>

namespace convex_test {

inline constexpr double sweep_tolerance = 1e-6; // relative to the smaller shape

struct Cast {
    Solid moving, still;
    DVec3 from, way;
    DQuat turn_moving, turn_still;
    Convex a(double fraction = 0) const { return moving.at(from + fraction * way, turn_moving); }
    Convex b() const { return still.at({}, turn_still); }
    double tolerance() const { return sweep_tolerance * std::min(a().extent, b().extent); }
};

// Conservative advancement: Newton's method on the distance, which is a convex function of the fraction.
inline std::optional<cairn::ConvexHit> advance(const Cast& cast) {
    double fraction = 0;
    for (int round = 0; round < 1000; ++round) {
        const auto c = closest_points(cast.a(fraction), cast.b());
        const double speed = dot(cast.way, c.normal);
        if (fraction == 0 && c.distance < -cast.tolerance()) return cairn::ConvexHit{0, {}, {}};
        if (!(speed > 0)) return std::nullopt;
        if (c.distance <= cast.tolerance()) return cairn::ConvexHit{fraction, c.on_b, -c.normal};
        fraction += (c.distance - 0.5 * cast.tolerance()) / speed;
        if (fraction > 1) return std::nullopt;
    }
    return std::nullopt;
}

} // namespace convex_test
