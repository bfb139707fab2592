// What takes part in an impact.
#pragma once

#include "jobs/thread_pool.h"
#include "state/solver_scratch.h"
#include "state/state.h"

namespace cairn {

// Lists the rows, the groups and the lanes of an impact in scratch.impact, and takes the blocks' marks of what was
// struck.
void list_impact(const Bodies& bodies, const Joints& joints, BatchScratch& scratch, float h);

} // namespace cairn
