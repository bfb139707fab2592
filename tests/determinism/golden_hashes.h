// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x7e107eff26676756;
inline constexpr std::uint64_t pyramid = 0xe3660f19c2a3abab;
inline constexpr std::uint64_t dominoes = 0xe77695fc42455b09;
inline constexpr std::uint64_t materials = 0x00e3c147674856fb;
inline constexpr std::uint64_t tumbler = 0x15355198e2b4bba5;
inline constexpr std::uint64_t sleep_and_wake = 0x9c8824115a697d0e;
inline constexpr std::uint64_t compounds = 0x342ec2febfe087c4;
inline constexpr std::uint64_t free_tops = 0xe5d1c0db6b79d188;
inline constexpr std::uint64_t all_shapes = 0xa5b68acad659779f;
inline constexpr std::uint64_t rounded_shapes = 0xeb898c0b94ab8cb6;
inline constexpr std::uint64_t all_joints = 0x2a3435821705c9d0;

} // namespace cairn_test::golden
