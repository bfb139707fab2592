// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xc86a7bfc554bcba0;
inline constexpr std::uint64_t pyramid = 0x67d0f6781e2b4cfb;
inline constexpr std::uint64_t dominoes = 0x50079dfbe31d2ae7;
inline constexpr std::uint64_t materials = 0x94af92f0b2f079d3;
inline constexpr std::uint64_t tumbler = 0xf8844f02dd2e4a1a;
inline constexpr std::uint64_t sleep_and_wake = 0x45e968ef148d337e;
inline constexpr std::uint64_t compounds = 0x4fa352565a2d7833;
inline constexpr std::uint64_t free_tops = 0xc4fbd81687eeba94;
inline constexpr std::uint64_t explicit_euler = 0xa8eff6a4eb508a1d;
inline constexpr std::uint64_t whirl = 0xe0dc3c6aade8bba5;
inline constexpr std::uint64_t changes = 0xdc30e9935c3217ec;
inline constexpr std::uint64_t all_shapes = 0x77c2acc93f7789fc;
inline constexpr std::uint64_t rounded_shapes = 0x7049bc8509a54a59;
inline constexpr std::uint64_t surfaces = 0x3f25fe073ba357fa;
inline constexpr std::uint64_t all_joints = 0x92259a84e55ebfa8;
inline constexpr std::uint64_t chains = 0xff89c14a77e00e13;

} // namespace cairn_test::golden
