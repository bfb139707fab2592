// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x673902a81e6ff05e;
inline constexpr std::uint64_t pyramid = 0x3abc59cfa88e5eca;
inline constexpr std::uint64_t dominoes = 0x491a9b2086abe900;
inline constexpr std::uint64_t materials = 0x3ea8c5c6908d0969;
inline constexpr std::uint64_t tumbler = 0x8c6e8e22c6ad524e;
inline constexpr std::uint64_t sleep_and_wake = 0x3f9c6fe2f054c16a;
inline constexpr std::uint64_t compounds = 0x03437665489c2576;
inline constexpr std::uint64_t free_tops = 0xe32cec2b97e2e1ef;
inline constexpr std::uint64_t explicit_euler = 0x430a7a70e30ed48e;
inline constexpr std::uint64_t whirl = 0xb91e3e1943ae4320;
inline constexpr std::uint64_t changes = 0xd0b184f133dc733a;
inline constexpr std::uint64_t all_shapes = 0xa78fc34be501a71c;
inline constexpr std::uint64_t rounded_shapes = 0x01e302131f02f7aa;
inline constexpr std::uint64_t surfaces = 0x3bd5e44f2af84f2c;
inline constexpr std::uint64_t all_joints = 0x9024afcb50e070eb;
inline constexpr std::uint64_t chains = 0x3695dbbfad433b59;

} // namespace cairn_test::golden
