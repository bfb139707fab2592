// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x1c6f263d3ebe4920;
inline constexpr std::uint64_t pyramid = 0xd3c40ebf4b1a30d7;
inline constexpr std::uint64_t dominoes = 0xca0ade746b4b74c9;
inline constexpr std::uint64_t materials = 0x16f8a9ab1efebe79;
inline constexpr std::uint64_t tumbler = 0x62f6a57e33f3fa3b;
inline constexpr std::uint64_t sleep_and_wake = 0xae263855aec4d6a9;
inline constexpr std::uint64_t compounds = 0x739ac1c30bd78ecc;
inline constexpr std::uint64_t free_tops = 0xc6834910e320c0d0;
inline constexpr std::uint64_t explicit_euler = 0x5683a88cc01b462e;
inline constexpr std::uint64_t whirl = 0x9414b213cf754515;
inline constexpr std::uint64_t changes = 0x168b75e70fb4b896;
inline constexpr std::uint64_t all_shapes = 0xc69f3572ad81dee7;
inline constexpr std::uint64_t rounded_shapes = 0x90dd47c4914b0c55;
inline constexpr std::uint64_t surfaces = 0x5f062ad8a52f8505;
inline constexpr std::uint64_t all_joints = 0x68e0fe86538e8dad;
inline constexpr std::uint64_t chains = 0xe4cb837fd7490b2f;
inline constexpr std::uint64_t robots = 0xd7379ab44fade9ff;

} // namespace cairn_test::golden
