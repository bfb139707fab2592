// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xe10906e3e5d26ec6;
inline constexpr std::uint64_t pyramid = 0x5ae339a647eca8ce;
inline constexpr std::uint64_t dominoes = 0x9bbd2143e62785ad;
inline constexpr std::uint64_t materials = 0x8552ed45d3aaa9da;
inline constexpr std::uint64_t tumbler = 0xe0c3afb42964f5bf;
inline constexpr std::uint64_t sleep_and_wake = 0x9b8076cfae7eac20;
inline constexpr std::uint64_t compounds = 0xe4d9c2d48d2570af;
inline constexpr std::uint64_t free_tops = 0x4c84fe26826d73cd;
inline constexpr std::uint64_t explicit_euler = 0x5e8c25f8ffe5c30e;
inline constexpr std::uint64_t whirl = 0xacec7eee12120c47;
inline constexpr std::uint64_t changes = 0x12f9ef9d77b4543e;
inline constexpr std::uint64_t all_shapes = 0xe01919c52f0ae926;
inline constexpr std::uint64_t rounded_shapes = 0x36eaff12b2a74842;
inline constexpr std::uint64_t surfaces = 0x786d123c12944c7e;
inline constexpr std::uint64_t all_joints = 0xe65a095540ed7bca;
inline constexpr std::uint64_t chains = 0xa0b759c901e793e8;

} // namespace cairn_test::golden
