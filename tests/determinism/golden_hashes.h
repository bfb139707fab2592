// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xec25a9dbe99ae89b;
inline constexpr std::uint64_t pyramid = 0x90f5c625fa958a00;
inline constexpr std::uint64_t dominoes = 0xeee8eae10c6ba5f1;
inline constexpr std::uint64_t materials = 0x86328996a0608146;
inline constexpr std::uint64_t tumbler = 0xc50ceb5431240b5b;
inline constexpr std::uint64_t sleep_and_wake = 0x370e9c9b621a435e;
inline constexpr std::uint64_t compounds = 0x46cc14b011e311da;
inline constexpr std::uint64_t free_tops = 0xbb76e390fd67d031;
inline constexpr std::uint64_t explicit_euler = 0x55c2f474356f770f;
inline constexpr std::uint64_t whirl = 0xaf08dfe2623c0a26;
inline constexpr std::uint64_t changes = 0x0e0b086b26337ed1;
inline constexpr std::uint64_t all_shapes = 0x01c7d58b1b8cf83a;
inline constexpr std::uint64_t rounded_shapes = 0xeaefac33a62a86d7;
inline constexpr std::uint64_t surfaces = 0xd58fc0af3051eb07;
inline constexpr std::uint64_t all_joints = 0xb8414822ca3718b5;
inline constexpr std::uint64_t chains = 0x07cbdbadf0292ff9;

} // namespace cairn_test::golden
