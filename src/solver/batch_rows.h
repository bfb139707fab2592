// The rows and lanes of a bin: bodies and contacts in, and bodies out again.
#pragma once

#include "state/state.h"

namespace cairn {

// Lays out the rows and lanes of a bin, and fills them.
void fill_bin(State& state, const Bin& bin, BinScratch& scratch, Crew* crew, float dt);
// Moves the bodies by what their rows have moved, and finalizes them.
void empty_bin(State& state, BinScratch& scratch, Crew* crew, float dt);

} // namespace cairn
