// One world on several ranks (cairn/communicator.h). Every rank holds all bodies. The record of a contact is held by
// the rank that owns its body A; this rank tests the pair (contacts/shared_tests.h), solves the contact and sends the
// results to the other ranks. docs/scale.md explains why the result has the same bits as that of one process, for any
// number of ranks, and what this costs.
//
// A batch with joints is solved by every rank redundantly: its bodies belong to every rank. A small batch is solved by
// one rank, which owns its bodies. A batch with more than one rank's share of all contacts is cut: its bodies are
// sorted along a space-filling curve, and each rank owns a segment of it. Owners stay the same for many steps, until
// some rank has a tenth more than the mean load, or the batches change.
//
// Graph colors fix the order of the contacts. Within a color no two contacts share a moving body, so the result does
// not depend on which rank solves which contact, or when; after each color, ranks exchange the velocities of the bodies
// that several of them need (solver/rank_border.h). Nor does the result depend on how bodies are distributed, which may
// change from step to step.
#pragma once

#include "state/rank_work.h"
#include "state/state.h"
#include "state/step_scratch.h"

#include <cairn/communicator.h>

#include <span>

namespace cairn {

// Called before a step: each rank drops the records of bodies that it does not own. Before the first step, the bodies
// are distributed.
void share_out_records(const Bodies& bodies, Contacts& contacts, SolverScratch& solver, Communicator& ranks);

// Distributes the batches among the ranks, and computes the weights of the islands that another rank solves. The result
// is the same on all ranks. Contact records are sent to the new owners of their bodies.
void cut_batches(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                 const WorldDef& settings, Communicator& ranks, SolverScratch& solver);

// The bodies of a batch that have contacts or joints.
inline std::span<const std::int32_t> touching_of(const RankCut& cut, std::size_t batch) {
    const BatchBodies& list = cut.bodies_of_batch[batch];
    return std::span(cut.touching).subspan(std::size_t(list.first), std::size_t(list.count));
}
inline bool is_own(const RankCut& cut, std::int32_t body) { return cut.owner[body] == cut.rank; }

} // namespace cairn
