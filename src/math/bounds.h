#pragma once

#include "math/vec.h"

namespace cairn {

// An axis-aligned box in world space, m.
struct DBounds {
    math::DVec3 lo, hi;
};

inline bool contains(const DBounds& outer, const DBounds& inner) {
    for (int i = 0; i < 3; ++i)
        if (!(inner.lo[i] >= outer.lo[i] && inner.hi[i] <= outer.hi[i])) return false;
    return true;
}

inline bool meet(const DBounds& a, const DBounds& b) {
    for (int i = 0; i < 3; ++i)
        if (a.lo[i] > b.hi[i] || a.hi[i] < b.lo[i]) return false;
    return true;
}

// The box enlarged by `by` on every side, m.
inline DBounds grown(const DBounds& b, double by) {
    const math::DVec3 more{by, by, by};
    return {b.lo - more, b.hi + more};
}

} // namespace cairn
