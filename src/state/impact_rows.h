// What an impact is computed from (impacts/impact_law.h).
#pragma once

#include "math/vec.h"

namespace cairn {

struct ImpactPoint {
    math::DVec3 position, normal; // normal: from the first body to the second
    double depth = 0;             // m: by which the shapes overlap there
    double rebound = 0;           // m/s: as fast as that it leaves, at least
};

struct ImpactRow {
    math::DVec3 direction, arm_a, arm_b; // arms: r x direction; of a couple, no direction, and its axis
    math::DVec3 turn_a, turn_b;          // inverse inertia times arm
    double inverse_effective_mass, target, impulse;
};

} // namespace cairn
