// The rows and lanes of a batch: bodies and contacts in, and bodies out again.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Lists the bodies of the batch's islands; what the islands weigh, and how they move.
void gather_bodies(const Bodies& bodies, Islands& islands, const ForceFields& fields, const WorldDef& settings,
                   const SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch,
                   ThreadPool* thread_pool);

// Lays out the rows and lanes of a batch, and fills them, for substeps of h: of one that is cut (BatchScratch::border),
// those that this rank needs.
void fill_batch(Bodies& bodies, const Shapes& shapes, const Contacts& contacts, Islands& islands, Joints& joints,
                const ForceFields& fields, const WorldDef& settings, SolverScratch& solver, const DirectSets& direct,
                const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool, float h);
// Takes the motion of moving surfaces off the poses of their rows, once the substeps are done.
void leave_belts_in_place(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, BatchScratch& scratch,
                          float dt);
// Moves the bodies by what their rows have moved, and finalizes them.
void empty_batch(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const ForceFields& fields,
                 const WorldDef& settings, SolverScratch& solver, BatchScratch& scratch, ThreadPool* thread_pool,
                 float dt);

// Moves and finalizes bodies that nothing touches.
void move_free_bodies(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const ForceFields& fields,
                      const WorldDef& settings, SolverScratch& solver, const std::vector<std::int32_t>& list,
                      BatchScratch& scratch, ThreadPool* thread_pool, float dt);

} // namespace cairn
