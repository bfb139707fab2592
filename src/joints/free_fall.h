// Jointed bodies that fall side by side: where nothing pulls at a joint there is nothing to solve.
#pragma once

#include "state/joint_links.h"

namespace cairn {

// After a pass in which the joints of an island were solved: whether they bore anything.
void note_flight(const State& state, Island& island, const std::uint32_t* joints);
// Whether an island with so many contacts can do without its joints in this pass.
bool flies(const State& state, const Island& island, std::int32_t contacts);
// A joint in the island of that body has changed, or what it holds has been put elsewhere.
void end_flight(State& state, std::int32_t body);

} // namespace cairn
