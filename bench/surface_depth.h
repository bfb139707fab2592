// How deep a part is in a surface of triangles.
#pragma once

#include "bench/overlap.h"

namespace cairn::bench {

// See `penetration` for what it measures; far below zero where the part is beside the surface. `surface` is a mesh.
double surface_depth(const PlacedPart& part, const PlacedPart& surface);

} // namespace cairn::bench
