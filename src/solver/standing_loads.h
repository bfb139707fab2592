// What the contacts of a structure bear by its weights alone, before it has borne anything.
#pragma once

#include "state/solver_scratch.h"
#include "state/state.h"

namespace cairn {

// Gives islands as many substeps as what they bear by their weights asks for, where that is more than they have, and
// scales the impulses of their contacts. Only where the weights alone say what each contact bears: each body stands on
// one other, and one body on what does not move. `contacts`: of all awake islands.
void count_standing_loads(const Bodies& bodies, Contacts& contacts, Islands& islands, const ForceFields& fields,
                          const WorldDef& settings, SolverScratch& scratch, float dt);

} // namespace cairn
