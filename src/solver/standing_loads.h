// What contacts that begin will bear by the weights of a structure, before they have borne anything.
#pragma once

#include "state/solver_scratch.h"
#include "state/state.h"

namespace cairn {

// Gives contacts that begin their part of the weights above them, and their islands as many substeps as that asks for,
// where it is more than they have. Not in islands with joints, and not where things fly about.
void count_standing_loads(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                          const WorldDef& settings, SolverScratch& scratch, float dt);

} // namespace cairn
