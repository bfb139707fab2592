#pragma once

#include "math/vec.h"

namespace cairn {

// An axis-aligned box in world space, m.
struct DBounds {
    math::DVec3 lo, hi;
};

} // namespace cairn
