// What contacts that begin will bear by the weights of a structure, before they have borne anything.
#pragma once

#include "state/solver_scratch.h"
#include "state/state.h"

namespace cairn {

// Why an island is weighed: one of its contacts begins; it took more substeps than usual in the last step.
enum WeighedFor : std::uint8_t { for_begun_contact = 1, for_its_substeps = 2 };

// Gives contacts that begin their part of the weights above them, and their islands as many substeps as that asks for,
// where it is more than they have. Not in islands with joints, and not where things fly about.
void count_standing_loads(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                          const WorldDef& settings, SolverScratch& scratch, Communicator* ranks, float dt);

} // namespace cairn
