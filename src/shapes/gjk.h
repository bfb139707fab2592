// The distance of two convex cores (Gilbert, Johnson and Keerthi 1988; van den Bergen, "Collision Detection in
// Interactive 3D Environments", 2003).
#pragma once

#include "shapes/convex.h"

namespace cairn {

// A corner of the Minkowski difference a - b.
struct DifferencePoint {
    math::DVec3 a, b, w; // w = a - b
};

struct CorePair {
    Core a, b;
    DifferencePoint support(math::DVec3 d) const {
        const math::DVec3 p = core_support(a, d), q = core_support(b, -d);
        return {p, q, p - q};
    }
};

// Up to four corners of the difference, and the point nearest to the origin of what they span.
struct Simplex {
    int count = 0;
    DifferencePoint points[4];
    double weights[4] = {};
    math::DVec3 nearest;
};

struct GjkResult {
    enum class State : std::uint8_t { apart, overlapping, far };
    State state = State::far;
    double distance = 0; // of the cores
    math::DVec3 normal;  // apart: unit, from a to b
    math::DVec3 on_a, on_b;
    Simplex simplex;
};

// Cores that are proven farther apart than max_distance are `far`; then `normal` is a direction that proves it. Cores
// closer than a ten billionth of their size overlap. `guess`: a direction from a to b, of any length. The distance of
// round shapes is within about half the relative `tolerance`, the normal within its root; that of polytopes is exact.
GjkResult gjk_distance(const CorePair& pair, math::DVec3 guess, double max_distance, double tolerance = 1e-12);

} // namespace cairn
