// Contacts that have nothing to do in a step.
#pragma once

#include "state/state.h"

namespace cairn {

// Lists what moves fast. False if that is so much that no contact is left out in this step.
bool find_fast(State& state, float dt);
// Of a contact that bore nothing: how much farther apart its points are than they may come in the step, m; or 0.
float spare_gap(const State& state, const SortedContact& contact, float dt);
// Marks those of SolverScratch::unsorted that stay apart, however their bodies and those around them move in the step.
void leave_out_idle(State& state, float dt);

} // namespace cairn
