// The solver: islands packed into batches, each batch gathered into dense rows and blocks and solved through all of its
// substeps. docs/solver.md explains the method.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Solves all batches: velocities, poses, impulses; moves kinematic bodies. Finalizes all bodies (finalize.h).
void solve_batches(State& state, StepScratch& step, float dt);

} // namespace cairn
