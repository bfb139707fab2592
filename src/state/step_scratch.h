// Working memory of a step. No later step depends on it, so it is part of neither the state nor of snapshots.
#pragma once

#include "core/room.h"
#include "jobs/thread_pool.h"
#include "state/character_work.h"
#include "state/direct_sets.h"
#include "state/fluid_scratch.h"
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
    CharacterScratch characters;
    FluidScratch fluids;
    std::unique_ptr<ThreadPool> thread_pool = std::make_unique<ThreadPool>(1);

    // After a step: releases lists that grew for fast bodies, impacts and escaped fat boxes, if they now need less
    // memory.
    void shrink_capacity() {
        const auto give_back = [](auto&... lists) { (cairn::shrink_capacity(lists), ...); };
        give_back(solver.escaped, solver.fast, solver.strayed);
        for (BatchScratch& own : solver.at_work)
            give_back(own.finalized.escaped, own.finalized.fast, own.finalized.strayed);
        SweepScratch& sweep = solver.sweep;
        give_back(sweep.bodies, sweep.passing, sweep.movers, sweep.pairs, sweep.swept_bounds, sweep.strayed,
                  sweep.redirected, sweep.meetings, sweep.known);
    }

    // Before a step of another state: all working memory may be reused, except the layouts of joints, which are valid
    // for the change counts of one world only.
    void forget_world() {
        direct.valid_for = ~std::uint64_t(0);
        for (JointLayout& layout : solver.joint_layouts) layout.valid_for = ~std::uint64_t(0);
    }
};

} // namespace cairn
