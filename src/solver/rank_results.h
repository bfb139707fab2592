// Exchange of results after each rank has solved its part (solver/rank_cut.h).
#pragma once

#include "solver/rank_cut.h"

namespace cairn {

// Broadcasts from each rank the moved bodies that have contacts, and the contact reports. The receiving ranks finalize
// these bodies like their own.
void exchange_results(Communicator& ranks, Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase,
                      const WorldDef& settings, SolverScratch& solver, ThreadPool& thread_pool, float dt);

} // namespace cairn
