// Shared by the parts of the direct solver: a view of one set and of its data.
#pragma once

#include "kernels/solve/joint_data.h"
#include "state/direct_sets.h"
#include "state/direct_work.h"
#include "state/joint_state.h"

namespace cairn {

// Greatest speed (m/s or rad/s) at which an error is corrected. Without it, a heavy mass that falls into a slack chain
// sets the chain spinning without end, as its joints are torn apart and return too fast.
inline constexpr double fastest_return = 4;

struct SetView {
    const DirectSet& set;
    DirectBody* bodies;
    DirectRow* rows;
    math::Block *diagonal, *lower;
    math::DVec3* sought;
    bool is_new, is_touched;
    DirectLimit* limits;
    std::size_t limit_count;
    AxisBlock* axes;
};

// Finds the impulses that take the velocities of the rows to -rate x error, and those of drives to their softened
// targets, and applies them to the bodies. They are kept as `given`, apart from the rows' impulses, until
// commit_increments adds them.
void solve_impulse_increments(const SetView& v, double rate);
void commit_increments(const SetView& v);

// Computes the Jacobian and error of a node at the present poses; for a drive, also its softness and target.
void refresh_row(const Joints& joints, const SetView& v, std::size_t node, double h);
// Copies the Jacobian of a node from its axis block; returns the position.
double refresh_from_lane(const SetView& v, std::size_t node);
void refresh_drive(const SetView& v, std::size_t node, double h);
// The speed that the row of a drive is short of.
double lack_of_drive(const DirectDrive& drive, double velocity);
// Fixes a drive that exceeds one of its bounds at that bound, or frees one that would give less than its bound. Returns
// whether that changed; `change`: of its impulse.
bool bound_drive(DirectDrive& drive, double velocity, double& change);
// Jacobian of a driven turn: it includes the axis that the turn leaves free, unless the drive is at its bound.
void aim_driven_turn(DirectRow& row);

// At the start of a substep: applies the limits' impulses of the last one.
void begin_limits(const SetView& v);
void forget_limits(const SetView& v);
// After the rows: solves for the missing impulses of limits, each with its effect on all connected bodies.
void hold_limits(const SetView& v, double rate, double h);
// Solves the limits in the same way, but leaves the stored impulses unchanged.
void hold_limits_for_now(const SetView& v, double rate, double h);
// At the end of a substep: adds the limits' impulses to the totals of their blocks.
void count_limits(const SetView& v);

} // namespace cairn
