// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xbb3036a141c8f9d4;
inline constexpr std::uint64_t pyramid = 0xaf6f3a5d42a0ca7d;
inline constexpr std::uint64_t dominoes = 0x2f5ab2b341c981d2;
inline constexpr std::uint64_t materials = 0x6becfda28d8de24e;
inline constexpr std::uint64_t tumbler = 0x953968bdbe01fe77;
inline constexpr std::uint64_t sleep_and_wake = 0x3c78a647a8119fa5;
inline constexpr std::uint64_t compounds = 0x357fa7e00cc1f571;
inline constexpr std::uint64_t free_tops = 0x64091c87f3dd8008;
inline constexpr std::uint64_t explicit_euler = 0x785bbb59fd1755a6;
inline constexpr std::uint64_t whirl = 0xe925ec450b697355;
inline constexpr std::uint64_t changes = 0x93e0d21e4181ba99;
inline constexpr std::uint64_t all_shapes = 0x1638ef5386325c87;
inline constexpr std::uint64_t rounded_shapes = 0xcd6feee97441c1e4;
inline constexpr std::uint64_t surfaces = 0x341f079a4af7c9f5;
inline constexpr std::uint64_t all_joints = 0x8e483eb72e2c0f09;
inline constexpr std::uint64_t chains = 0x04d6f57b5165ed74;
inline constexpr std::uint64_t robots = 0x4102e1e4b5c86958;

} // namespace cairn_test::golden
