// The rows of joints in a solver batch: what is put into them, and what comes out.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

namespace cairn {

// Positions, axes and impulses of the lanes; `h`: the substep.
void fill_joint_blocks(const Bodies& bodies, Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                       ThreadPool* thread_pool, float h);
// After the last substep: impulses and forces back to the joints.
void store_joints(Joints& joints, const WorldDef& settings, const DirectSets& direct, BatchScratch& scratch, float dt);

} // namespace cairn
