// Estimates the loads of beginning contacts from the weights of a structure, before any load has been measured.
#pragma once

#include "state/solver_scratch.h"
#include "state/state.h"

namespace cairn {

// Why an island is examined: one of its contacts begins, or it took more substeps than usual in the last step.
enum WeighedFor : std::uint8_t { for_begun_contact = 1, for_its_substeps = 2 };

// Gives beginning contacts their share of the weights above them, and increases the substeps of their islands to the
// number that these loads require. Islands with joints, and islands with high agitation, are skipped.
void count_standing_loads(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                          const WorldDef& settings, SolverScratch& scratch, Communicator* ranks, float dt);

} // namespace cairn
