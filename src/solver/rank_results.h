// What the ranks tell each other when each has solved its part (solver/rank_cut.h).
#pragma once

#include "solver/rank_cut.h"

namespace cairn {

// Touched bodies as they have moved, and the reports of contacts, of each rank for all others, which finalize the
// bodies as their own.
void exchange_results(Communicator& ranks, Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase,
                      const WorldDef& settings, SolverScratch& solver, ThreadPool& thread_pool, float dt);

} // namespace cairn
