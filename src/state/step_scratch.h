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
    int split = 1;                // passes of the step under way
    std::uint64_t first_pass = 0; // of the step under way: State::passes at its start

    NarrowScratch narrow;
    std::vector<std::uint32_t> solved; // contacts to solve in this pass
    SolverScratch solver;
    DirectSets direct;
    std::unique_ptr<ThreadPool> thread_pool = std::make_unique<ThreadPool>(1);

    // Of the given number in a step, how many a pass takes.
    int in_pass(int substeps) const { return (substeps + split - 1) / split; }
};

} // namespace cairn
