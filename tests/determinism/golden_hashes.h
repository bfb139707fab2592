// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x89424f810e3bac60;
inline constexpr std::uint64_t pyramid = 0xe57e86bacf665f9b;
inline constexpr std::uint64_t dominoes = 0xeee8eae10c6ba5f1;
inline constexpr std::uint64_t materials = 0xa0342a0263266e64;
inline constexpr std::uint64_t tumbler = 0x4ef9097059fdefdc;
inline constexpr std::uint64_t sleep_and_wake = 0x3c526d723e61a75d;
inline constexpr std::uint64_t compounds = 0x861187a091e97eed;
inline constexpr std::uint64_t free_tops = 0xf5c622a5d71064b4;
inline constexpr std::uint64_t explicit_euler = 0xf058e3e63e42374a;
inline constexpr std::uint64_t whirl = 0xc5d146c6393c1104;
inline constexpr std::uint64_t changes = 0xcca0bcb6aae3e00a;
inline constexpr std::uint64_t all_shapes = 0x4054c4590688b736;
inline constexpr std::uint64_t rounded_shapes = 0xd2d2868ed2ab4a8f;
inline constexpr std::uint64_t surfaces = 0x2d7b8b42fb5c732f;
inline constexpr std::uint64_t all_joints = 0xa091c07b03b372d4;
inline constexpr std::uint64_t chains = 0x7a4c4291557c2b4a;

} // namespace cairn_test::golden
