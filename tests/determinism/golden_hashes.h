// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x5b3f85e23296a5bf;
inline constexpr std::uint64_t pyramid = 0xb2aef54353e1eb20;
inline constexpr std::uint64_t dominoes = 0xf97cc4f6197090c9;
inline constexpr std::uint64_t materials = 0xeb4f1497299d4e83;
inline constexpr std::uint64_t tumbler = 0xffa671115e95c131;
inline constexpr std::uint64_t sleep_and_wake = 0xf48f996c6fcf4a18;
inline constexpr std::uint64_t compounds = 0x84ed12a17ea21219;
inline constexpr std::uint64_t free_tops = 0x9643f3537bf3534d;
inline constexpr std::uint64_t explicit_euler = 0xe2bda8bf52f11753;
inline constexpr std::uint64_t whirl = 0xbeb2e33bcdc22343;
inline constexpr std::uint64_t changes = 0xdd1e57a0ad8d1429;
inline constexpr std::uint64_t all_shapes = 0x79c81cb64495d672;
inline constexpr std::uint64_t rounded_shapes = 0xcbd37ed2076ff334;
inline constexpr std::uint64_t surfaces = 0x8778e80e77e8606f;
inline constexpr std::uint64_t all_joints = 0xed8302a89d652bee;
inline constexpr std::uint64_t chains = 0xc664ace8d3c7d786;

} // namespace cairn_test::golden
