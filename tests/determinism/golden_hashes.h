// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x4385bfccc3953962;
inline constexpr std::uint64_t pyramid = 0xa86623708dab2aa2;
inline constexpr std::uint64_t dominoes = 0x4576792fec3a4cbe;
inline constexpr std::uint64_t materials = 0x0701bf7a07dcb866;
inline constexpr std::uint64_t tumbler = 0xf463dd71b4219e2b;
inline constexpr std::uint64_t sleep_and_wake = 0x07d7d6cc8b5edda2;
inline constexpr std::uint64_t compounds = 0x19a4e83df5ae4798;
inline constexpr std::uint64_t free_tops = 0x7c41d30e52e0c01f;
inline constexpr std::uint64_t explicit_euler = 0x3bbf88d26e988c8a;
inline constexpr std::uint64_t whirl = 0x4abd537339a813b6;
inline constexpr std::uint64_t changes = 0xd14d33211729617d;
inline constexpr std::uint64_t all_shapes = 0xbee988e7859064bf;
inline constexpr std::uint64_t rounded_shapes = 0x0f7ad277b777d6d5;
inline constexpr std::uint64_t surfaces = 0x603f4ad36397a7f5;
inline constexpr std::uint64_t all_joints = 0x4513a695e3137b65;
inline constexpr std::uint64_t chains = 0xe72bbdff8998b3b7;

} // namespace cairn_test::golden
