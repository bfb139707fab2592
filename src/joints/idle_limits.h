// Limits that are out of reach.
#pragma once

#include "jobs/thread_pool.h"
#include "state/joint_links.h"
#include "state/solver_scratch.h"

namespace cairn {

// By how much the position of an axis changes, at most, by the angle that the bodies turn by against each other. Of
// mere limits of an angle; 0: of all else, that is not looked at.
float reach_by_turn(const JointLocks& locks, const JointAxes& axes, const JointAxisRule& rule);
// Once in a step. True if other rows than before are left out of the solver.
bool update_idle_rows(const Bodies& bodies, Joints& joints, JointLayout& layout, ThreadPool* thread_pool);

} // namespace cairn
