// The distance of two convex cores (Gilbert, Johnson and Keerthi 1988; van den Bergen, "Collision Detection in
// Interactive 3D Environments", 2003).
#pragma once

#include "shapes/convex.h"

namespace cairn {

// A vertex of the Minkowski difference a - b, with its support points on both shapes.
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

// Up to four vertices of the Minkowski difference, and the point of their convex hull that is nearest to the origin.
struct Simplex {
    int count = 0;
    DifferencePoint points[4];
    double weights[4] = {};
    math::DVec3 nearest;
};

struct GjkResult {
    enum class State : std::uint8_t { apart, overlapping, far };
    State state = State::far;
    double distance = 0; // between the cores
    math::DVec3 normal;  // if apart: unit, from a to b
    math::DVec3 on_a, on_b;
    Simplex simplex;
};

// The time of impact of a core that moves by `way` without rotating, with a radius around both cores.
struct GjkCast {
    enum class State : std::uint8_t {
        missed,      // no touch before `limit`, a fraction of the translation
        met,         // at `fraction` the distance is within the radius plus the tolerance
        overlapping, // of the cores, from the start
        unsettled,   // no touch before `fraction`; rounding leaves open whether they touch there
    };
    State state = State::unsettled;
    double fraction = 0;
    double distance = 0; // if met: between the cores at `fraction`; the members below are as in GjkResult
    math::DVec3 normal, on_b;
    Simplex simplex; // the points of a are those at the start of the translation
};

// A separation along any direction bounds how far the core can move before contact, and GJK improves the direction as
// the core advances (van den Bergen, "Ray Casting against General Convex Objects with Application to Continuous
// Collision Detection", 2004). The shapes stop at half the tolerance, m > 0, so that the normal is defined. `guess`: a
// direction as for gjk_distance, at the expected time of impact.
GjkCast gjk_cast(const CorePair& pair, math::DVec3 way, double limit, double tolerance, math::DVec3 guess);

// Cores proven to be farther apart than max_distance are `far`, and `normal` is then a direction that proves it. Cores
// closer than a ten-billionth of their size count as overlapping. `guess`: a direction from a to b, of any length. For
// round shapes the error of the distance is about half the relative `tolerance`, and that of the normal its square
// root; for polytopes the distance is exact.
GjkResult gjk_distance(const CorePair& pair, math::DVec3 guess, double max_distance, double tolerance = 1e-12);
// As gjk_distance, but starts from one to three affinely independent vertices of the Minkowski difference: those of the
// last result, moved along with both shapes, are close to the solution if the shapes moved little.
GjkResult gjk_distance_from(const CorePair& pair, const Simplex& start, double max_distance, double tolerance);

} // namespace cairn
