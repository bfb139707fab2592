// Translates the definition of a joint into the constraint rows of the solver.
#pragma once

#include "state/joint_state.h"

#include <cairn/world.h>

namespace cairn {

// Throws Error(invalid_value) naming the field, its value and what was expected.
void validate(const Joint& joint);
void validate(const JointDef& def); // everything except the handles

// The constraint rows of a valid joint. `pulley_length`: used for a pulley that does not specify its length.
JointRules make_rules(const Joint& joint, float pulley_length);

} // namespace cairn
