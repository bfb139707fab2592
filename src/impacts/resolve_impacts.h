// Impacts within a step, when and where they happen (docs/decisions/impacts_in_flight.md).
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// After the solver has moved all bodies by what holds or touches them. Of what flies, and of what moved so far that its
// core may have passed another, the earliest meeting changes the velocities of both, which go on from there; their
// pairs are asked again, and so on until the end of the pass. Where the solver knew the contact, or nothing approaches,
// both stop: poses at the start were valid, so that stopping cannot fail. No core passes another.
void resolve_impacts(State& state, StepScratch& step, float dt);

} // namespace cairn
