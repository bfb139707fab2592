// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xdf7735f534368b68;
inline constexpr std::uint64_t pyramid = 0xc3f21216ca53644e;
inline constexpr std::uint64_t dominoes = 0xbf2318c71f473665;
inline constexpr std::uint64_t materials = 0x84d5840264440ef8;
inline constexpr std::uint64_t tumbler = 0x301f3c90505b20b7;
inline constexpr std::uint64_t sleep_and_wake = 0x28c34369aba92137;
inline constexpr std::uint64_t compounds = 0xff0af2835470645c;
inline constexpr std::uint64_t free_tops = 0xde66db06b5189ad2;
inline constexpr std::uint64_t explicit_euler = 0xbbee5ccaf8b08d3c;
inline constexpr std::uint64_t whirl = 0xd394efa824ed758e;
inline constexpr std::uint64_t changes = 0x522618e75540099c;
inline constexpr std::uint64_t all_shapes = 0x75783e23771c02e6;
inline constexpr std::uint64_t rounded_shapes = 0x39255e593076cea9;
inline constexpr std::uint64_t surfaces = 0xde7fe47393b19b8f;
inline constexpr std::uint64_t all_joints = 0x7d83c8cb93e7abb3;
inline constexpr std::uint64_t chains = 0x8cea44b54521bcb9;

} // namespace cairn_test::golden
