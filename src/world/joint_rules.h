// From a joint's definition to the rows that the solver has of it.
#pragma once

#include "state/joint_state.h"

#include <cairn/world.h>

namespace cairn {

// Throws Error(invalid_value) naming the field, its value and what was expected.
void validate(const Joint& joint);
void validate(const JointDef& def); // all but the handles

// The rows of a valid joint. `pulley_length`: that of a pulley which does not say.
JointRules make_rules(const Joint& joint, float pulley_length);

} // namespace cairn
