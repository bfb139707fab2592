// Joint limits that are out of reach, and are left out of the solver.
#pragma once

#include "jobs/thread_pool.h"
#include "state/joint_links.h"
#include "state/solver_scratch.h"

namespace cairn {

// Greatest change of an axis position per angle by which the bodies rotate relative to each other. For axes that have
// only limits of an angle; 0 for all others, which are always solved.
float reach_by_turn(const JointLocks& locks, const JointAxes& axes, const JointAxisRule& rule);
// Called once per step. Returns true if the rows that are left out of the solver have changed.
bool update_idle_rows(const Bodies& bodies, Joints& joints, JointLayout& layout, ThreadPool* thread_pool);

} // namespace cairn
