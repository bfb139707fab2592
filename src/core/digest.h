// Sums over all bodies from which one can tell that two states differ, and in which one or two bodies: the syndromes of
// a Reed-Solomon code over the numbers modulo 2^61 - 1, with the hash of a body as its symbol.
#pragma once

#include <cairn/commands.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

void add_to_digest(StateDigest& digest, std::uint32_t slot, const void* state, std::size_t size);

// The slots below `slots` in which two states differ; empty if they do not, or cannot be told from the sums.
std::vector<std::uint32_t> differing_slots(const StateDigest& a, const StateDigest& b, std::uint32_t slots);

} // namespace cairn
