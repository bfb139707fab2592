// The body rows and contact lanes of a batch: gathers bodies and contacts, and scatters bodies after solving.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Lists the bodies of the batch's islands, and updates the weight and agitation of these islands.
void gather_bodies(const Bodies& bodies, Islands& islands, const ForceFields& fields, const WorldDef& settings,
                   const SolverScratch& solver, const IslandBatch& batch, BatchScratch& scratch,
                   ThreadPool* thread_pool);

// Lays out and fills the rows and lanes of a batch, for substeps of h seconds. For a batch that is cut
// (BatchScratch::border), only the rows and lanes that this rank needs.
void gather_batch(Bodies& bodies, const Shapes& shapes, const Contacts& contacts, Islands& islands, Joints& joints,
                  const ForceFields& fields, const WorldDef& settings, SolverScratch& solver, const DirectSets& direct,
                  const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool, float h);
// Subtracts the motion of moving surfaces (belts) from the poses of their rows, after the last substep.
void leave_belts_in_place(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, BatchScratch& scratch,
                          float dt);
// Moves the bodies of a batch by the displacements of their rows, and finalizes them.
void scatter_batch(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const ForceFields& fields,
                   const WorldDef& settings, SolverScratch& solver, BatchScratch& scratch, ThreadPool* thread_pool,
                   float dt);

// Moves and finalizes bodies that nothing touches.
void move_free_bodies(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const ForceFields& fields,
                      const WorldDef& settings, SolverScratch& solver, const std::vector<std::int32_t>& list,
                      BatchScratch& scratch, ThreadPool* thread_pool, float dt);

} // namespace cairn
