// The penetration depth of a box and another shape: the least translation that separates them.
#pragma once

#include "shapes/convex.h"

#include <optional>

namespace cairn {

struct BoxDepth {
    // a translation of the other core by depth * normal separates the cores; negative: the cores are separated
    double depth;
    math::DVec3 normal; // unit, from the box to the other shape
    math::DVec3 on_box, on_other;
};

// The penetration depth between the exact cores of a box and another shape, within a relative 1e-6; after 64 support
// points the least depth found so far, which still separates the cores. Returns nothing if the cores are separated
// (except for capsules, whose depth is then negative), if more than one point is deepest, or for a capsule with two
// different radii.
std::optional<BoxDepth> box_depth(const Convex& box, const Convex& other);

} // namespace cairn
