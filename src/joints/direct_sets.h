// Which joints are solved directly.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Brings State::direct up to date.
void update_direct_sets(State& state, StepScratch& step);

// Whether an axis row of a joint belongs to what a direct solver holds: it is a rigid equation, and linear enough.
bool is_direct_axis(const JointAxisRule& rule);

} // namespace cairn
