// What a step works with and leaves nothing in that a later one depends on: no part of the state, nor of snapshots.
#pragma once

#include "jobs/thread_pool.h"
#include "state/direct_sets.h"
#include "state/narrow_scratch.h"
#include "state/solver_scratch.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace cairn {

struct StepScratch {
    NarrowScratch narrow;
    std::vector<std::uint32_t> solved; // contacts to solve in this step
    SolverScratch solver;
    DirectSets direct;
    std::unique_ptr<ThreadPool> thread_pool = std::make_unique<ThreadPool>(1);

    // Before a step of another state: the memory is good for any, but what was laid out for joints holds for the
    // changes of one world alone.
    void forget_world() {
        direct.valid_for = ~std::uint64_t(0);
        for (JointLayout& layout : solver.joint_layouts) layout.valid_for = ~std::uint64_t(0);
    }
};

} // namespace cairn
