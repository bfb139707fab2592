// Transfers joints into the rows of a solver batch, and their results back.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Fills positions, axes and impulses of the lanes; `h`: the substep.
void fill_joint_blocks(const Bodies& bodies, Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                       ThreadPool* thread_pool, float h);
// After the last substep: stores impulses and forces in the joints.
void store_joints(Joints& joints, const WorldDef& settings, const DirectSets& direct, BatchScratch& scratch, float dt);

} // namespace cairn
