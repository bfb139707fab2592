// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xb23c176f2b1ef6c1;
inline constexpr std::uint64_t pyramid = 0x6c2b004ad0a4049b;
inline constexpr std::uint64_t dominoes = 0xdf520ee2c112db83;
inline constexpr std::uint64_t materials = 0x750f6fd16f0be53f;
inline constexpr std::uint64_t tumbler = 0xffa671115e95c131;
inline constexpr std::uint64_t sleep_and_wake = 0xf48f996c6fcf4a18;
inline constexpr std::uint64_t compounds = 0x12512813fae140b2;
inline constexpr std::uint64_t free_tops = 0x9643f3537bf3534d;
inline constexpr std::uint64_t explicit_euler = 0xb3222149476c696b;
inline constexpr std::uint64_t whirl = 0xbeb2e33bcdc22343;
inline constexpr std::uint64_t changes = 0x7a7c456554f16a73;
inline constexpr std::uint64_t all_shapes = 0x79c81cb64495d672;
inline constexpr std::uint64_t rounded_shapes = 0xbf5d8cfb546b2b8f;
inline constexpr std::uint64_t surfaces = 0x30a89f2ce5868d3e;
inline constexpr std::uint64_t all_joints = 0xed8302a89d652bee;
inline constexpr std::uint64_t chains = 0xc664ace8d3c7d786;

} // namespace cairn_test::golden
