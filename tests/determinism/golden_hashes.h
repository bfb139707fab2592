// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xc14face7e81cfdb3;
inline constexpr std::uint64_t pyramid = 0xd78f4b6bee42c8e5;
inline constexpr std::uint64_t dominoes = 0x121d1c3c291b6c36;
inline constexpr std::uint64_t materials = 0x52581e8e2998f5a1;
inline constexpr std::uint64_t tumbler = 0x59ca7ea058309f70;
inline constexpr std::uint64_t sleep_and_wake = 0x3d73d262f12fda8d;
inline constexpr std::uint64_t compounds = 0x5f4fc771a3284ff9;
inline constexpr std::uint64_t free_tops = 0xf0e511b376c7f6cf;

} // namespace cairn_test::golden
