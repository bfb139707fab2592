// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x5f14e00da4518f92;
inline constexpr std::uint64_t pyramid = 0x73e2a4e2a1104f77;
inline constexpr std::uint64_t dominoes = 0x6381c269d953dd9c;
inline constexpr std::uint64_t materials = 0x6a15c2d8d68516cc;
inline constexpr std::uint64_t tumbler = 0x6604967dfa91344d;
inline constexpr std::uint64_t sleep_and_wake = 0xb2db0041748aae75;
inline constexpr std::uint64_t compounds = 0x67da66ac0ce59ec0;
inline constexpr std::uint64_t free_tops = 0xde66db06b5189ad2;
inline constexpr std::uint64_t explicit_euler = 0xbbee5ccaf8b08d3c;
inline constexpr std::uint64_t whirl = 0x6e47f0ba035a23c8;
inline constexpr std::uint64_t changes = 0x4623ea3a95025f05;
inline constexpr std::uint64_t all_shapes = 0x465f4ccf0cee9493;
inline constexpr std::uint64_t rounded_shapes = 0xa524d7b885c00ff4;
inline constexpr std::uint64_t surfaces = 0x0fc4636b4b89184a;
inline constexpr std::uint64_t all_joints = 0x8bfd2923f397827d;
inline constexpr std::uint64_t chains = 0x54209e0a4e5874a8;

} // namespace cairn_test::golden
