// The depth of a part below a triangle surface.
#pragma once

#include "bench/overlap.h"

namespace cairn::bench {

// See `penetration` for the definition; far below zero if the part is beside the surface. `surface` must be a mesh.
double surface_depth(const PlacedPart& part, const PlacedPart& surface);

} // namespace cairn::bench
