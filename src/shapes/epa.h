// The penetration depth of two overlapping convex cores by the expanding polytope algorithm (van den Bergen, "Proximity
// Queries and Penetration Depth Computation on 3D Game Objects", 2001).
#pragma once

#include "shapes/gjk.h"

namespace cairn {

struct Penetration {
    double depth;       // of the cores, >= 0: a translation of b by depth * normal separates them
    math::DVec3 normal; // unit, from a to b
    math::DVec3 on_a, on_b;
};

// The penetration depth within a relative 1e-4; after 64 vertices of the polytope the least depth found so far, which
// still separates the cores. `start`: the simplex with which gjk_distance found the overlap.
Penetration epa_depth(const CorePair& pair, const Simplex& start);

} // namespace cairn
