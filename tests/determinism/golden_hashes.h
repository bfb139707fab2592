// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xe6c60468b7c56ba2;
inline constexpr std::uint64_t pyramid = 0x5896dc293dddde3b;
inline constexpr std::uint64_t dominoes = 0xbe5956b1433834d2;
inline constexpr std::uint64_t materials = 0xff7b65a91c2aa23b;
inline constexpr std::uint64_t tumbler = 0x945e468b55706b6c;
inline constexpr std::uint64_t sleep_and_wake = 0x9b8076cfae7eac20;
inline constexpr std::uint64_t compounds = 0x92d9f0170120b28d;
inline constexpr std::uint64_t free_tops = 0x53d8984f9884ebaa;
inline constexpr std::uint64_t explicit_euler = 0x50505e7c7d53b559;
inline constexpr std::uint64_t whirl = 0x959e4e89cc1098f7;
inline constexpr std::uint64_t changes = 0xa346a9f8f2fefb2d;
inline constexpr std::uint64_t all_shapes = 0xbd4f8779e9f17286;
inline constexpr std::uint64_t rounded_shapes = 0xc00077740329efce;
inline constexpr std::uint64_t surfaces = 0x3b08fab86793be44;
inline constexpr std::uint64_t all_joints = 0x355c7a0c5eeb8b33;
inline constexpr std::uint64_t chains = 0xa0b759c901e793e8;

} // namespace cairn_test::golden
