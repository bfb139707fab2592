// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x4eb37a9a596a444c;
inline constexpr std::uint64_t pyramid = 0xd7462c6c98986464;
inline constexpr std::uint64_t dominoes = 0x881db247de271a07;
inline constexpr std::uint64_t materials = 0x7b4a5ef5951f28b1;
inline constexpr std::uint64_t tumbler = 0xda6e4bbcadae6e19;
inline constexpr std::uint64_t sleep_and_wake = 0x6364b3d9347f40a0;
inline constexpr std::uint64_t compounds = 0x9ca98c464fbaf2bf;
inline constexpr std::uint64_t free_tops = 0x933037c6b55a4905;
inline constexpr std::uint64_t explicit_euler = 0x768db265e3e2170a;
inline constexpr std::uint64_t whirl = 0x5e4851f33f51795d;
inline constexpr std::uint64_t changes = 0xb9ac52b34d24f0ed;
inline constexpr std::uint64_t all_shapes = 0x96080f128f2f0467;
inline constexpr std::uint64_t rounded_shapes = 0x9ab93343fd77a02f;
inline constexpr std::uint64_t surfaces = 0x5be21204358d977a;
inline constexpr std::uint64_t all_joints = 0xa02753c3c067af2d;
inline constexpr std::uint64_t chains = 0x83d10172be71e710;

} // namespace cairn_test::golden
