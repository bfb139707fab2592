#pragma once

#include "math/vec.h"

namespace cairn {

// An axis-aligned box in world space, m.
struct DBounds {
    math::DVec3 lo, hi;
};

// With so much more on every side, m.
inline DBounds grown(const DBounds& b, double by) {
    const math::DVec3 more{by, by, by};
    return {b.lo - more, b.hi + more};
}

} // namespace cairn
