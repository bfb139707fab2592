// Sums over all bodies that tell whether two states differ, and if only one or two bodies do, which: the syndromes of a
// Reed-Solomon code over the integers modulo 2^61 - 1, with the hash of a body as its symbol.
#pragma once

#include <cairn/commands.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

void add_to_digest(StateDigest& digest, std::uint32_t slot, const void* state, std::size_t size);

// The slots below `slots` in which two states differ; empty if they do not, or if the sums do not determine them.
std::vector<std::uint32_t> differing_slots(const StateDigest& a, const StateDigest& b, std::uint32_t slots);

} // namespace cairn
