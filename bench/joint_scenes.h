// Scenes of jointed bodies.
#pragma once

#include "bench/builder.h"

namespace cairn::bench {

void chain(Builder& b, int size);
void joint_grid(Builder& b, int size);
void joint_swing(Builder& b, int size);
void ragdolls(Builder& b, int size);

} // namespace cairn::bench
