// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xfd68c2c597036b54;
inline constexpr std::uint64_t pyramid = 0x17b3ea3853e8da2a;
inline constexpr std::uint64_t dominoes = 0x474950b1950f158a;
inline constexpr std::uint64_t materials = 0x525037b1188c0f7a;
inline constexpr std::uint64_t tumbler = 0xecd65560f3f4c5f4;
inline constexpr std::uint64_t sleep_and_wake = 0x02a5ac89fdfc33d7;
inline constexpr std::uint64_t compounds = 0x0988708f6a830bad;
inline constexpr std::uint64_t free_tops = 0x35b7f756fff5cf55;
inline constexpr std::uint64_t explicit_euler = 0xf8002371152a8e5d;
inline constexpr std::uint64_t whirl = 0x845d962cf1348d32;
inline constexpr std::uint64_t changes = 0x7bd70741f95b6cfb;
inline constexpr std::uint64_t all_shapes = 0xb6c80864d331ba5a;
inline constexpr std::uint64_t rounded_shapes = 0xcd97ea40249f2d91;
inline constexpr std::uint64_t surfaces = 0x433a71e31a8aae70;
inline constexpr std::uint64_t all_joints = 0xf871fbd091d743e0;
inline constexpr std::uint64_t chains = 0x17d1fa1082d31c94;

} // namespace cairn_test::golden
