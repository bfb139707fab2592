// What the joints of an island bear, as a mean.
#pragma once

#include "state/state.h"

namespace cairn {

// After a step: takes note of what the joints of the bin's islands bore.
void note_joint_loads(State& state, const Bin& bin, const BinScratch& scratch);

} // namespace cairn
