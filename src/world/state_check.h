// Snapshots come from files, and from who would like to harm: whatever a later step or query follows is checked before
// a world takes it. What holds between any two calls of a World stands here in one place.
#pragma once

#include "state/state.h"

#include <cairn/joint.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cairn {

// What users define, as a snapshot's definitions have it, beside the state.
struct CheckedDefinitions {
    const std::vector<std::string>& names;
    const std::vector<std::uint64_t>& user_data;
    const std::vector<ShapeDef>& shape_defs;
    const std::vector<JointDef>& joint_defs;
};

// Both throw Error(invalid_file), naming what it is, its value and what was expected. The first goes before anything is
// read by what is defined; the second needs definitions that have been checked.
void check_definitions(const State& state, const CheckedDefinitions& definitions);
void check_state(State& state);

} // namespace cairn
