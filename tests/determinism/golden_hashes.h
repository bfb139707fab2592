// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x9c907e17da9ebe9a;
inline constexpr std::uint64_t pyramid = 0x1b64c6741fc21ece;
inline constexpr std::uint64_t dominoes = 0x8b46dcfbb7222dac;
inline constexpr std::uint64_t materials = 0xde28eecfe8462a39;
inline constexpr std::uint64_t tumbler = 0xb4d33e4d045e89af;
inline constexpr std::uint64_t sleep_and_wake = 0x809a34d555187646;
inline constexpr std::uint64_t compounds = 0xdd1b2d33bd6a4589;
inline constexpr std::uint64_t free_tops = 0xbee2e2957f98eefe;
inline constexpr std::uint64_t explicit_euler = 0xa503322665c0694e;
inline constexpr std::uint64_t whirl = 0xdac6b57e5d1ad2bf;
inline constexpr std::uint64_t changes = 0x3aca339f1a01ce17;
inline constexpr std::uint64_t all_shapes = 0x78020e1880f67eab;
inline constexpr std::uint64_t rounded_shapes = 0x9ea5e6866c45298d;
inline constexpr std::uint64_t surfaces = 0x0de1b91348830e1b;
inline constexpr std::uint64_t all_joints = 0xf84f070fd4b7d9cd;
inline constexpr std::uint64_t chains = 0x461b668176f89b0a;
inline constexpr std::uint64_t robots = 0xb1fd22b1175b5496;

} // namespace cairn_test::golden
