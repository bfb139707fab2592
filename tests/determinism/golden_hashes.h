// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xedbcbcf129bf734a;
inline constexpr std::uint64_t pyramid = 0xc01cffd7eb0bdcb1;
inline constexpr std::uint64_t dominoes = 0xad975767a5720996;
inline constexpr std::uint64_t materials = 0x3eaa62a61924b7e4;
inline constexpr std::uint64_t tumbler = 0x165e6b4ee32f3a7c;
inline constexpr std::uint64_t sleep_and_wake = 0x4f3ba895eadb07bc;
inline constexpr std::uint64_t compounds = 0x9f06617651368f93;
inline constexpr std::uint64_t free_tops = 0x7424415fa1add17c;
inline constexpr std::uint64_t explicit_euler = 0x5175db0019a7b88b;
inline constexpr std::uint64_t whirl = 0xc155cfa21ea31c4f;
inline constexpr std::uint64_t changes = 0x92d45a30a780be77;
inline constexpr std::uint64_t all_shapes = 0x368c0c27d14f2142;
inline constexpr std::uint64_t rounded_shapes = 0x2f3eeb0a4dfc59c8;
inline constexpr std::uint64_t surfaces = 0x7eaf74e1d69f9b76;
inline constexpr std::uint64_t all_joints = 0xdb1b9ddcb4fa5b41;
inline constexpr std::uint64_t chains = 0x7dd17dda5b414ee9;

} // namespace cairn_test::golden
