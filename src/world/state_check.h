// Validation of snapshots, which come from files and may be malicious: everything that a later step or query relies on
// is checked before a world accepts it. This is also the one list of invariants that hold between any two calls of a
// World.
#pragma once

#include "state/state.h"

#include <cairn/joint.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cairn {

// User definitions from a snapshot that are not part of the state.
struct CheckedDefinitions {
    const std::vector<std::string>& names;
    const std::vector<std::uint64_t>& user_data;
    const std::vector<ShapeDef>& shape_defs;
    const std::vector<JointDef>& joint_defs;
};

// Both throw Error(invalid_file), naming the member, its value and the expected value. check_definitions must run
// before any data is read whose layout depends on definitions; check_state requires checked definitions.
void check_definitions(const State& state, const CheckedDefinitions& definitions);
void check_state(State& state);

} // namespace cairn
