// One world on several ranks (cairn/communicator.h). Each rank has all bodies; the records of contacts are with the
// rank that owns their body A, which tests the pairs (contacts/shared_tests.h) and solves the contacts of it, and tells
// the others what came of that. docs/scale.md explains why that gives the bits of one process on any number of ranks,
// and what it costs.
//
// A batch with joints is solved by every rank for itself: its bodies are every rank's. A small one is solved by one
// rank, which owns its bodies. One with more than its rank's share of all contacts is cut: its bodies are put in order
// along a space-filling curve, and each rank owns a piece of that. Owners stay for many steps: until some rank has a
// tenth more than the mean, or batches become others.
//
// Colors are what keeps the order. Within a color no two contacts share a body that moves, so that it does not matter
// who solves which when; after each color, ranks tell each other the velocities of bodies that both need
// (solver/rank_border.h). How bodies are shared out can matter as little, and may change from step to step.
#pragma once

#include "state/rank_work.h"
#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

#include <span>

namespace cairn {

// Before a step: each rank keeps the records of its bodies alone. Before the first one, the bodies are shared out.
void share_out_records(const Bodies& bodies, Contacts& contacts, SolverScratch& solver, Communicator& ranks);

// Shares out the batches, and weighs the islands of those that another rank solves. The same on all ranks. Records go
// to where bodies have gone.
void cut_batches(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                 const WorldDef& settings, Communicator& ranks, SolverScratch& solver);

// The bodies of a batch, those that are touched.
inline std::span<const std::int32_t> touching_of(const RankCut& cut, std::size_t batch) {
    const BatchBodies& list = cut.bodies_of_batch[batch];
    return std::span(cut.touching).subspan(std::size_t(list.first), std::size_t(list.count));
}
inline bool is_own(const RankCut& cut, std::int32_t body) { return cut.owner[body] == cut.rank; }

} // namespace cairn
