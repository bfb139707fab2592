// Impacts in a batch that is cut among ranks. Each rank knows only the contacts of its own bodies. Everything that
// takes part in an impact is therefore sent to all ranks, and each rank solves the groups that contain a body it
// needs: the arithmetic of a group is the same for any number of ranks.
#pragma once

#include "state/solver_scratch.h"

#include <cairn/communicator.h>

namespace cairn {

// Replaces the hits of this rank by those of all ranks.
void share_hits(Communicator& ranks, std::vector<ImpactWork::Hit>& hits);
// Replaces the bodies of this rank by those of all ranks.
void share_bodies(Communicator& ranks, std::vector<std::int32_t>& bodies);

// Replaces the blocks, rows and groups that this rank has listed and copied by those of all ranks. Groups without a
// body that this rank needs count as settled.
void share_impact(BatchScratch& scratch, Communicator& ranks);

// Copies the velocities of all participating bodies to this rank's rows, and replaces the list of all ranks' rows by
// these rows.
void return_shared_velocities(BatchScratch& scratch);

} // namespace cairn
