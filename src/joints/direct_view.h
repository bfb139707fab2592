// What the parts of the direct solver share: one set, and the numbers of it.
#pragma once

#include "kernels/solve/joint_data.h"
#include "state/direct_sets.h"
#include "state/direct_work.h"
#include "state/joint_state.h"

namespace cairn {

// m/s or rad/s. What a blow has torn apart comes together no faster than that, or a heavy mass that falls into a slack
// chain would set it whirling without end.
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

// Impulses that take the velocities of the rows to -rate x error, and drives to where they yield; their bodies gain
// what they give. They are `given` beside the rows' impulses, until those are to have them.
void seek_impulses(const SetView& v, double rate);
void keep_given(const SetView& v);

// Jacobian and error of a node by the poses now; of a drive, how it yields.
void refresh_row(const Joints& joints, const SetView& v, std::size_t node, double h);
// Of one whose Jacobian is that of its axis block; returns the position.
double refresh_from_lane(const SetView& v, std::size_t node);
void refresh_drive(const SetView& v, std::size_t node, double h);
// The speed that the row of a drive lacks.
double lack_of_drive(const DirectDrive& drive, double velocity);
// A drive that gives more than it can is held at that bound; one that is held and would give less is set free. Returns
// whether that changed; `change`: of its impulse.
bool bound_drive(DirectDrive& drive, double velocity, double& change);
// Of a turn that is driven: it holds the axis that it leaves free, too, unless the drive is at its bound.
void aim_driven_turn(DirectRow& row);

// At the start of a substep: the impulses of the last one.
void begin_limits(const SetView& v);
void forget_limits(const SetView& v);
// After the rows: what else the limits need, each with all that hangs together.
void hold_limits(const SetView& v, double rate, double h);
// Likewise, but impulses stay as they are.
void hold_limits_for_now(const SetView& v, double rate, double h);
// At the end: what they gave goes to the totals of their blocks.
void count_limits(const SetView& v);

} // namespace cairn
