// The narrow phase: from pairs of bounds to contact records.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// The narrow phase: tests all pairs that may have moved, writes their records, begins and ends contacts in the
// islands and colors, wakes what is hit, and lists in StepScratch::solved what the solver has to do.
void update_contacts(State& state, StepScratch& step, float dt);

} // namespace cairn
