// The rows and lanes of a batch: bodies and contacts in, and bodies out again.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Lays out the rows and lanes of a batch, and fills them.
void fill_batch(const State& state, Bodies& bodies, Islands& islands, Joints& joints, SolverScratch& solver,
                const DirectSets& direct, const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool);
// What bears more than `max_demand` times its mass takes part in contacts as if it had the mass that this demand
// allows: no number of sweeps would carry the load through a body that yields at once. After the rows have their
// inertia.
void raise_masses(const Bodies& bodies, const Contacts& contacts, const WorldDef& settings,
                  const std::vector<SortedContact>& sorted, const IslandBatch& batch, BatchScratch& scratch);
// Moves the bodies by what their rows have moved, and finalizes them.
void empty_batch(const State& state, Bodies& bodies, Shapes& shapes, SolverScratch& solver, const StepPasses& passes,
                 BatchScratch& scratch, ThreadPool* thread_pool, float dt);

} // namespace cairn
