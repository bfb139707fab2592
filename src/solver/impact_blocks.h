// Separate blocks into which the rows of an impact are copied.
#pragma once

#include "solver/impact_lists.h"

#include <tuple>

namespace cairn {

// Calls f(the batch's blocks, the impact's blocks) for one type of blocks.
template <class F> void with_type(BatchScratch& scratch, int type, F&& f) {
    auto& blocks = scratch.impact.blocks;
    switch (type) {
    case int(JointRowType::point):
        return f(scratch.point_blocks, std::get<0>(blocks));
    case int(JointRowType::turn):
        return f(scratch.turn_blocks, std::get<1>(blocks));
    case int(JointRowType::axis):
        return f(scratch.axis_blocks, std::get<2>(blocks));
    case one_point_type:
        return f(scratch.one_blocks, std::get<one_point_type>(blocks));
    default:
        return f(scratch.four_blocks, std::get<four_points_type>(blocks));
    }
}
template <class F> void for_types(BatchScratch& scratch, F&& f) {
    for (int type = 0; type <= four_points_type; ++type) with_type(scratch, type, f);
}

// Copies the lanes that list_impact has listed, sorted by run, form and group, and recomputes effective masses from the
// current inertia.
void copy_listed(BatchScratch& scratch);

// Adds the impulses of one round of an impact to the totals that the batch's blocks keep over the step.
void add_totals(BatchScratch& scratch);

} // namespace cairn
