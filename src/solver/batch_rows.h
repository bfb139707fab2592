// The rows and lanes of a batch: bodies and contacts in, and bodies out again.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Lays out the rows and lanes of a batch, and fills them.
void fill_batch(const State& state, Bodies& bodies, Islands& islands, Joints& joints, SolverScratch& solver,
                const DirectSets& direct, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool);
// Moves the bodies by what their rows have moved, and finalizes them.
void empty_batch(const State& state, Bodies& bodies, Shapes& shapes, SolverScratch& solver, const StepPasses& passes,
                 BatchScratch& scratch, ThreadPool* thread_pool, float dt);

} // namespace cairn
