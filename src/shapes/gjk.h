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

// When a core that moves by `way` without turning first touches another, with a radius around both.
struct GjkCast {
    enum class State : std::uint8_t {
        missed,      // not before `limit`, a fraction of the way
        met,         // at `fraction` they are nearer than the radius and the tolerance
        overlapping, // the cores, from the start
        unsettled,   // not before `fraction`; rounding leaves it open whether then
    };
    State state = State::unsettled;
    double fraction = 0;
    double distance = 0; // met: of the cores, at the fraction; what is below as of GjkResult
    math::DVec3 normal, on_b;
    Simplex simplex; // the points of a where they were at the start
};

// The distance along any direction tells how far the core can move before they touch; GJK finds better and better
// directions on the way (van den Bergen, "Ray Casting against General Convex Objects with Application to Continuous
// Collision Detection", 2004). The shapes stop at half the tolerance, m > 0, so that the normal is known.
// `guess`: as of gjk_distance, where they may touch.
GjkCast gjk_cast(const CorePair& pair, math::DVec3 way, double limit, double tolerance, math::DVec3 guess);

// Cores that are proven farther apart than max_distance are `far`; then `normal` is a direction that proves it. Cores
// closer than a ten billionth of their size overlap. `guess`: a direction from a to b, of any length. The distance of
// round shapes is within about half the relative `tolerance`, the normal within its root; that of polytopes is exact.
GjkResult gjk_distance(const CorePair& pair, math::DVec3 guess, double max_distance, double tolerance = 1e-12);
// Likewise, from one to three corners of the difference, which span no more than their number allows: those of the last
// result, moved along with both shapes, are most of the way where these moved little.
GjkResult gjk_distance_from(const CorePair& pair, const Simplex& start, double max_distance, double tolerance);

} // namespace cairn
