// After the solver: no core of a shape passes another, or a surface, on its way from one step to the next.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Bodies that moved farther in the pass than their cores may (State::solver.fast) go back along their ways to where
// they would meet something, and lose the rest of the pass; the next step finds the impact. Their velocities keep their
// directions, and give back the work that their forces have not done.
void hold_cores(State& state, StepScratch& step, float dt);

} // namespace cairn
