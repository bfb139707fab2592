// Selects the joints that are solved directly.
#pragma once

#include "state/body_state.h"
#include "state/direct_sets.h"
#include "state/joint_state.h"

namespace cairn {

// Finds the sets again if joints, or the masses of jointed bodies, have changed.
void update_direct_sets(const Bodies& bodies, const Joints& joints, DirectSets& direct);

// Whether the direct solver takes an axis row of a joint: a rigid equation that is linear enough.
bool is_direct_axis(const JointAxisRule& rule);
// Whether the Jacobian and position of such a row are those of its axis block.
bool has_direct_lane(AxisKind kind);
// Whether the direct solver takes the drive of an axis row, its friction, or its soft limit.
bool is_direct_drive(const JointAxisRule& rule);
bool is_direct_friction(const JointAxisRule& rule);
bool is_direct_soft_limit(const JointAxisRule& rule);
// Whether the direct solver takes the limits of an axis row, which must be rigid.
bool is_direct_limit(const JointAxisRule& rule);

} // namespace cairn
