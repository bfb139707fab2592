// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x795ee8dd1bfeb956;
inline constexpr std::uint64_t pyramid = 0x88a2203e17dd17ff;
inline constexpr std::uint64_t dominoes = 0xe3ed3d49f0de8bc1;
inline constexpr std::uint64_t materials = 0xc1a0b72e123e2798;
inline constexpr std::uint64_t tumbler = 0xf432b50380617fea;
inline constexpr std::uint64_t sleep_and_wake = 0xd60f4fa0dc1ee0d7;
inline constexpr std::uint64_t compounds = 0x6f604f912e70d286;
inline constexpr std::uint64_t free_tops = 0xde66db06b5189ad2;
inline constexpr std::uint64_t explicit_euler = 0xbbee5ccaf8b08d3c;
inline constexpr std::uint64_t whirl = 0x34be048744c6da52;
inline constexpr std::uint64_t changes = 0xcfc0043ebf7974f5;
inline constexpr std::uint64_t all_shapes = 0xafdf5e8922b93ece;
inline constexpr std::uint64_t rounded_shapes = 0x30999ba3d9511863;
inline constexpr std::uint64_t surfaces = 0x9d5420b7dcf8f96e;
inline constexpr std::uint64_t all_joints = 0x57a542b4973beea5;
inline constexpr std::uint64_t chains = 0x6ec8c090b08b8344;

} // namespace cairn_test::golden
