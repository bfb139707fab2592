// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x7be4d321d8e9dd00;
inline constexpr std::uint64_t pyramid = 0xce810c5eab562761;
inline constexpr std::uint64_t dominoes = 0x4bb1e31e65e9760f;
inline constexpr std::uint64_t materials = 0x13a8f96d28f686d1;
inline constexpr std::uint64_t tumbler = 0xa35159fed88ca973;
inline constexpr std::uint64_t sleep_and_wake = 0xa8669c91d0a819e9;
inline constexpr std::uint64_t compounds = 0x87b722cf4d895c4d;
inline constexpr std::uint64_t free_tops = 0x91b69810fb9df21e;

} // namespace cairn_test::golden
