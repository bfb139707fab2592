// The rows and lanes of a batch: bodies and contacts in, and bodies out again.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Lays out the rows and lanes of a batch, and fills them.
void fill_batch(Bodies& bodies, const Shapes& shapes, const Contacts& contacts, Islands& islands, Joints& joints,
                const WorldDef& settings, SolverScratch& solver, const DirectSets& direct, const IslandBatch& batch,
                BatchScratch& scratch, ThreadPool* thread_pool);
// Moves the bodies by what their rows have moved, and finalizes them.
void empty_batch(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const ForceFields& fields,
                 const WorldDef& settings, SolverScratch& solver, const StepPasses& passes, BatchScratch& scratch,
                 ThreadPool* thread_pool, float dt);

} // namespace cairn
