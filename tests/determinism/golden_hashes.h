// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xc2414d717ca2f496;
inline constexpr std::uint64_t pyramid = 0xbb77e3688ab43e2e;
inline constexpr std::uint64_t dominoes = 0xad975767a5720996;
inline constexpr std::uint64_t materials = 0x2c4ef27e68afc928;
inline constexpr std::uint64_t tumbler = 0x558ab3cd80e95708;
inline constexpr std::uint64_t sleep_and_wake = 0x4f3ba895eadb07bc;
inline constexpr std::uint64_t compounds = 0x9f06617651368f93;
inline constexpr std::uint64_t free_tops = 0x7424415fa1add17c;
inline constexpr std::uint64_t explicit_euler = 0x5175db0019a7b88b;
inline constexpr std::uint64_t whirl = 0xc155cfa21ea31c4f;
inline constexpr std::uint64_t changes = 0x1cd45b5b0ed08cce;
inline constexpr std::uint64_t all_shapes = 0xbe4181e03aa0a28d;
inline constexpr std::uint64_t rounded_shapes = 0xfff1ba2a1e355cd7;
inline constexpr std::uint64_t surfaces = 0x7eaf74e1d69f9b76;
inline constexpr std::uint64_t all_joints = 0x94accbab7e7e0204;
inline constexpr std::uint64_t chains = 0x7dd17dda5b414ee9;

} // namespace cairn_test::golden
