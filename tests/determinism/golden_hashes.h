// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x76519b9acfba54e0;
inline constexpr std::uint64_t pyramid = 0x16dab291480d431e;
inline constexpr std::uint64_t dominoes = 0x810a7a89a314dc79;
inline constexpr std::uint64_t materials = 0x0c2fd1eb9c3f2787;
inline constexpr std::uint64_t tumbler = 0x5b6a68fb7a1bfc44;
inline constexpr std::uint64_t sleep_and_wake = 0x8060413d9d519c3b;
inline constexpr std::uint64_t compounds = 0xefc658e063bc19e1;
inline constexpr std::uint64_t free_tops = 0xc4db5c593173d6f7;

} // namespace cairn_test::golden
