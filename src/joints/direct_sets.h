// Which joints are solved directly.
#pragma once

#include "state/body_state.h"
#include "state/direct_sets.h"
#include "state/joint_state.h"

namespace cairn {

// Of a body to a lighter one that hangs between others: up to that they count as equally heavy.
inline constexpr float max_equal_mass_ratio = 10;

// Finds them anew where joints, or the masses of what is jointed, have changed.
void update_direct_sets(const Bodies& bodies, const Joints& joints, DirectSets& direct);

// Whether an axis row of a joint belongs to what a direct solver holds: it is a rigid equation, and linear enough.
bool is_direct_axis(const JointAxisRule& rule);
// Whether its Jacobian and position are those of its axis block.
bool has_direct_lane(AxisKind kind);
// Whether its drive does, and its friction.
bool is_direct_drive(const JointAxisRule& rule);
bool is_direct_friction(const JointAxisRule& rule);
bool is_direct_soft_limit(const JointAxisRule& rule);
// Whether the limits of an axis row do: they are rigid.
bool is_direct_limit(const JointAxisRule& rule);

} // namespace cairn
