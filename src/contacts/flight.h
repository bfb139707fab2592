// Pairs that are about to meet, or part, in free flight: the solver is not needed there, as no contact and no joint
// holds either of the two. They meet where and when their real motions say (impacts/resolve_impacts.h).
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Whether the shapes are apart, and no joint or sleep keeps their bodies from flying: by more than the margin of the
// contact, or so that they close or open more than that in the step, or they do not touch, and in the step would not or
// would bounce. What settles down on something is the solver's.
// Whether another contact holds one of the bodies shows when all pairs are known.
bool may_meet_in_flight(const State& state, const StepPasses& passes, const ContactInfo& contact,
                        const Manifold& manifold, float dt);

// All pairs of the step have been tested: of those that may meet in flight, the ones whose bodies nothing holds are
// listed in NarrowScratch::in_flight, and are no contacts; the others are contacts like any.
void settle_flights(State& state, StepScratch& step, float dt);

} // namespace cairn
