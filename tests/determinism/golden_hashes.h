// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x9b7172ed01f1d9ce;
inline constexpr std::uint64_t pyramid = 0x74fad607bc02fab1;
inline constexpr std::uint64_t dominoes = 0x474950b1950f158a;
inline constexpr std::uint64_t materials = 0x533a365284e01ed7;
inline constexpr std::uint64_t tumbler = 0x8fa05e40c3ea60e4;
inline constexpr std::uint64_t sleep_and_wake = 0x415afa711a0c429c;
inline constexpr std::uint64_t compounds = 0x9cb95f7599a5716a;
inline constexpr std::uint64_t free_tops = 0x35b7f756fff5cf55;
inline constexpr std::uint64_t explicit_euler = 0x226e49bfc35ce531;
inline constexpr std::uint64_t whirl = 0x62ebc37010e00f44;
inline constexpr std::uint64_t changes = 0xc7d3d826d97ea612;
inline constexpr std::uint64_t all_shapes = 0x5cd18d6b0dc89873;
inline constexpr std::uint64_t rounded_shapes = 0xccca02564c774ff4;
inline constexpr std::uint64_t surfaces = 0xb6b2751767c9ca56;
inline constexpr std::uint64_t all_joints = 0x123197545f691798;
inline constexpr std::uint64_t chains = 0xcfd55810a403073f;

} // namespace cairn_test::golden
