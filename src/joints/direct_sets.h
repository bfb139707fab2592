// Which joints are solved directly.
#pragma once

#include "state/state.h"

namespace cairn {

// Brings State::direct up to date.
void update_direct_sets(State& state);

// Whether an axis row of a joint belongs to what a direct solver holds: it is a rigid equation, and linear enough.
bool is_direct_axis(const JointAxisRule& rule);

} // namespace cairn
