// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x8b9afffab986181a;
inline constexpr std::uint64_t pyramid = 0x212cd0354f9feed4;
inline constexpr std::uint64_t dominoes = 0xbf2318c71f473665;
inline constexpr std::uint64_t materials = 0xcba17b511fc67238;
inline constexpr std::uint64_t tumbler = 0x34ca3a1c3533ed82;
inline constexpr std::uint64_t sleep_and_wake = 0x28c34369aba92137;
inline constexpr std::uint64_t compounds = 0xf0c3dfe8b1ca854a;
inline constexpr std::uint64_t free_tops = 0xde66db06b5189ad2;
inline constexpr std::uint64_t explicit_euler = 0xbbee5ccaf8b08d3c;
inline constexpr std::uint64_t whirl = 0xd394efa824ed758e;
inline constexpr std::uint64_t changes = 0x15b04782be71ed98;
inline constexpr std::uint64_t all_shapes = 0x9aedd4b38923d2b0;
inline constexpr std::uint64_t rounded_shapes = 0x925f5a64cf882228;
inline constexpr std::uint64_t surfaces = 0xff30db062b9c857d;
inline constexpr std::uint64_t all_joints = 0x7d83c8cb93e7abb3;
inline constexpr std::uint64_t chains = 0x8cff5d821c98bde6;

} // namespace cairn_test::golden
