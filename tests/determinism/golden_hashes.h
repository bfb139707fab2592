// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x623c626adfe30b36;
inline constexpr std::uint64_t pyramid = 0x20a8d6aca3bc9fc7;
inline constexpr std::uint64_t dominoes = 0xa2a83e5d6a367206;
inline constexpr std::uint64_t materials = 0x60af934cd77feec6;
inline constexpr std::uint64_t tumbler = 0x6c53d9f086c4348c;
inline constexpr std::uint64_t sleep_and_wake = 0x50dad7b28f748b25;
inline constexpr std::uint64_t compounds = 0xedf0092d79287357;
inline constexpr std::uint64_t free_tops = 0x7c41d30e52e0c01f;
inline constexpr std::uint64_t explicit_euler = 0xe1e38014524adcd7;
inline constexpr std::uint64_t whirl = 0x3a9b40bab4a8645e;
inline constexpr std::uint64_t changes = 0x231c5c3346aad069;
inline constexpr std::uint64_t all_shapes = 0xe472c08dc9173116;
inline constexpr std::uint64_t rounded_shapes = 0x12ae3a4af57d5968;
inline constexpr std::uint64_t surfaces = 0x199e313369cc90cc;
inline constexpr std::uint64_t all_joints = 0x16e82b53ea2a097b;
inline constexpr std::uint64_t chains = 0xa1fffcacb9d25e75;

} // namespace cairn_test::golden
