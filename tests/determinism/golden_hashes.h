// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x1b07cc008c441ca3;
inline constexpr std::uint64_t pyramid = 0x8219a911da1b85bc;
inline constexpr std::uint64_t dominoes = 0x6381c269d953dd9c;
inline constexpr std::uint64_t materials = 0xab198a52c1783565;
inline constexpr std::uint64_t tumbler = 0xf177175c706485c2;
inline constexpr std::uint64_t sleep_and_wake = 0xb2db0041748aae75;
inline constexpr std::uint64_t compounds = 0xcbc61c39e58a3464;
inline constexpr std::uint64_t free_tops = 0xde66db06b5189ad2;
inline constexpr std::uint64_t explicit_euler = 0xbd890ef240282a77;
inline constexpr std::uint64_t whirl = 0x00708b9440b93d38;
inline constexpr std::uint64_t changes = 0xc817c776b56cdffd;
inline constexpr std::uint64_t all_shapes = 0x24c95612faa85868;
inline constexpr std::uint64_t rounded_shapes = 0x3c40b53114599263;
inline constexpr std::uint64_t surfaces = 0xd0e22b322de4afc5;
inline constexpr std::uint64_t all_joints = 0x8bfd2923f397827d;
inline constexpr std::uint64_t chains = 0x54209e0a4e5874a8;

} // namespace cairn_test::golden
