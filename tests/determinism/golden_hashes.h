// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x558956c120688a4b;
inline constexpr std::uint64_t pyramid = 0x7b4ec3feeb2d4eed;
inline constexpr std::uint64_t dominoes = 0x8b46dcfbb7222dac;
inline constexpr std::uint64_t materials = 0x19acac05c2459d42;
inline constexpr std::uint64_t tumbler = 0x932c3d3673384601;
inline constexpr std::uint64_t sleep_and_wake = 0x809a34d555187646;
inline constexpr std::uint64_t compounds = 0x83588062e5a5e697;
inline constexpr std::uint64_t free_tops = 0xbee2e2957f98eefe;
inline constexpr std::uint64_t explicit_euler = 0x51324ee441ac2ba4;
inline constexpr std::uint64_t whirl = 0xdac6b57e5d1ad2bf;
inline constexpr std::uint64_t changes = 0x4a7bcc612d033767;
inline constexpr std::uint64_t all_shapes = 0x6a0a04a36687c73e;
inline constexpr std::uint64_t rounded_shapes = 0xbfbe321c2eb0f7ca;
inline constexpr std::uint64_t surfaces = 0xc569ac6ef746e34b;
inline constexpr std::uint64_t all_joints = 0xf2c4a32a1122e604;
inline constexpr std::uint64_t chains = 0x461b668176f89b0a;
inline constexpr std::uint64_t robots = 0xb1fd22b1175b5496;

} // namespace cairn_test::golden
