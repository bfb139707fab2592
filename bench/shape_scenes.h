// Scenes of convex polyhedra, triangle meshes, compounds, capsules and cylinders.
#pragma once

#include "bench/builder.h"

namespace cairn::bench {

void convex(Builder& b, int size);
void terrain(Builder& b, int size);
void props(Builder& b, int size);
void capsules(Builder& b, int size);

} // namespace cairn::bench
