// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xc8da15a310249ef4;
inline constexpr std::uint64_t pyramid = 0x98e3896fa8b94113;
inline constexpr std::uint64_t dominoes = 0xfa7c991704e9bb7d;
inline constexpr std::uint64_t materials = 0x362383b4ed9a0aa8;
inline constexpr std::uint64_t tumbler = 0x681e2c2d8346feb1;
inline constexpr std::uint64_t sleep_and_wake = 0xd76874f0e77b89e6;
inline constexpr std::uint64_t compounds = 0xd295b058675aaaca;
inline constexpr std::uint64_t free_tops = 0xde66db06b5189ad2;
inline constexpr std::uint64_t explicit_euler = 0xe9dd1de7160d4d69;
inline constexpr std::uint64_t whirl = 0x00708b9440b93d38;
inline constexpr std::uint64_t changes = 0x319e843c2930d80a;
inline constexpr std::uint64_t all_shapes = 0x12448fa332a20d3d;
inline constexpr std::uint64_t rounded_shapes = 0xb606e82ce198c398;
inline constexpr std::uint64_t surfaces = 0xdf78f55c28264342;
inline constexpr std::uint64_t all_joints = 0x8bfd2923f397827d;
inline constexpr std::uint64_t chains = 0x54209e0a4e5874a8;

} // namespace cairn_test::golden
