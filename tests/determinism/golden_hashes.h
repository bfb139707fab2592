// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x6beb340de0931a48;
inline constexpr std::uint64_t pyramid = 0x7b06077238366328;
inline constexpr std::uint64_t dominoes = 0x720b15198de9ab6c;
inline constexpr std::uint64_t materials = 0x0c9dcba9c8816984;
inline constexpr std::uint64_t tumbler = 0x1fb5e6edb99c3e36;
inline constexpr std::uint64_t sleep_and_wake = 0x4b3bc4044e52e175;
inline constexpr std::uint64_t compounds = 0xf474a7f87d2adcf6;
inline constexpr std::uint64_t free_tops = 0x1066144aac47b8e5;

} // namespace cairn_test::golden
