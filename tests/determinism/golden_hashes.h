// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x4be9e5ec7f3dffcc;
inline constexpr std::uint64_t pyramid = 0x4c0d28d3916b9a9f;
inline constexpr std::uint64_t dominoes = 0x9e0390e22b77ffc2;
inline constexpr std::uint64_t materials = 0xf385af29aff7a3f5;
inline constexpr std::uint64_t tumbler = 0x38f1623a09c666cd;
inline constexpr std::uint64_t sleep_and_wake = 0xf35a62ff1831a19f;
inline constexpr std::uint64_t compounds = 0xf4a2768ea027dbd1;
inline constexpr std::uint64_t free_tops = 0xde66db06b5189ad2;
inline constexpr std::uint64_t explicit_euler = 0x47449e5c988fdbfd;
inline constexpr std::uint64_t whirl = 0xc5005110e9e2bf21;
inline constexpr std::uint64_t changes = 0x3df897b3794a4d64;
inline constexpr std::uint64_t all_shapes = 0xc1124e52a75dcc21;
inline constexpr std::uint64_t rounded_shapes = 0x796c23a9e762b3df;
inline constexpr std::uint64_t surfaces = 0xfad315f6118ee8f4;
inline constexpr std::uint64_t all_joints = 0xf30fe36861270a00;
inline constexpr std::uint64_t chains = 0x90ce7ba86715fa7c;

} // namespace cairn_test::golden
