// Impacts in a batch that is cut among ranks. Each rank knows the contacts of its own bodies; what takes part in an
// impact is told to all of them, and each solves the groups that a body of its own is in: whatever the number of ranks,
// the arithmetic of a group is the same.
#pragma once

#include "state/solver_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// Puts the hits of all ranks in the place of those of this one.
void share_hits(Communicator& ranks, std::vector<ImpactWork::Hit>& hits);
// Likewise for bodies.
void share_bodies(Communicator& ranks, std::vector<std::int32_t>& bodies);

// Puts the blocks, rows and groups of all ranks in the place of those that this one has listed and copied. Groups of
// other ranks' bodies alone count as settled.
void share_impact(BatchScratch& scratch, Communicator& ranks);

// Gives the velocities of all that took part to the rows of this rank's bodies, and puts these in the place of the rows
// of all ranks.
void return_shared_velocities(BatchScratch& scratch);

} // namespace cairn
