// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x1229d69d62f86523;
inline constexpr std::uint64_t pyramid = 0x134ec5da58749192;
inline constexpr std::uint64_t dominoes = 0xee983dc18107f7d1;
inline constexpr std::uint64_t materials = 0xed21755ec714ecf6;
inline constexpr std::uint64_t tumbler = 0x170baf2a912ecac7;
inline constexpr std::uint64_t sleep_and_wake = 0x9b8076cfae7eac20;
inline constexpr std::uint64_t compounds = 0x4e71183dbd51dac5;
inline constexpr std::uint64_t free_tops = 0xc8fbb831a0fe0e3f;
inline constexpr std::uint64_t explicit_euler = 0x19598b82f26ca40e;
inline constexpr std::uint64_t whirl = 0x9c8420cc1386492f;
inline constexpr std::uint64_t changes = 0x5c9b6873abbb22c7;
inline constexpr std::uint64_t all_shapes = 0xd9ddf4639fd08046;
inline constexpr std::uint64_t rounded_shapes = 0x6bb38622a7370512;
inline constexpr std::uint64_t surfaces = 0xb958cf1b813bec3e;
inline constexpr std::uint64_t all_joints = 0x2c8329081a3c7252;
inline constexpr std::uint64_t chains = 0xa0b759c901e793e8;

} // namespace cairn_test::golden
