// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x5e25f9267680067b;
inline constexpr std::uint64_t pyramid = 0xdbe4f5d7caec53cc;
inline constexpr std::uint64_t dominoes = 0x20296c21a4fd1249;
inline constexpr std::uint64_t materials = 0xbbd8f237fbcaeaa3;
inline constexpr std::uint64_t tumbler = 0xf432b50380617fea;
inline constexpr std::uint64_t sleep_and_wake = 0x42a4434f99a6d9cd;
inline constexpr std::uint64_t compounds = 0xb1f3ace11f454e5d;
inline constexpr std::uint64_t free_tops = 0xde66db06b5189ad2;
inline constexpr std::uint64_t explicit_euler = 0xff6cd0fc7e3b59b3;
inline constexpr std::uint64_t whirl = 0xaf09639905078018;
inline constexpr std::uint64_t changes = 0xd3a593e01d04adf8;
inline constexpr std::uint64_t all_shapes = 0x2e578ba606c46119;
inline constexpr std::uint64_t rounded_shapes = 0xcc122fc8b56bcbef;
inline constexpr std::uint64_t surfaces = 0x2c9dcfb6915051a2;
inline constexpr std::uint64_t all_joints = 0xb3d953c035587169;
inline constexpr std::uint64_t chains = 0x81b043e10be04322;

} // namespace cairn_test::golden
