// The state hash of each scene after `golden_steps` steps (World::state_hash). The hashes are the same for every
// instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the new lines.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x94497c3d941a0ff0;
inline constexpr std::uint64_t pyramid = 0xaf6f3a5d42a0ca7d;
inline constexpr std::uint64_t dominoes = 0x2f5ab2b341c981d2;
inline constexpr std::uint64_t materials = 0x466e6fa4c4e3b636;
inline constexpr std::uint64_t tumbler = 0xa27fbc61d3acba29;
inline constexpr std::uint64_t sleep_and_wake = 0x3c78a647a8119fa5;
inline constexpr std::uint64_t compounds = 0x9ea2ffc13f274923;
inline constexpr std::uint64_t free_tops = 0x64091c87f3dd8008;
inline constexpr std::uint64_t explicit_euler = 0x60567e89b5675d6d;
inline constexpr std::uint64_t whirl = 0xe925ec450b697355;
inline constexpr std::uint64_t changes = 0x0ba3333b31286c48;
inline constexpr std::uint64_t all_shapes = 0x9251677d83f79ab8;
inline constexpr std::uint64_t rounded_shapes = 0x4b81c9a9f719d9d0;
inline constexpr std::uint64_t surfaces = 0x682c1286d45ab203;
inline constexpr std::uint64_t all_joints = 0x4cce2f2f867980e7;
inline constexpr std::uint64_t chains = 0xcf91a636f9efc936;
inline constexpr std::uint64_t robots = 0xc38f76b1df814127;

} // namespace cairn_test::golden
