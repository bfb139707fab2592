// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xdaaee2519b74a508;
inline constexpr std::uint64_t pyramid = 0xc01cffd7eb0bdcb1;
inline constexpr std::uint64_t dominoes = 0xf5fe54280498e513;
inline constexpr std::uint64_t materials = 0x9e5e24199f0319c5;
inline constexpr std::uint64_t tumbler = 0x70c467a97c2f51bf;
inline constexpr std::uint64_t sleep_and_wake = 0x4f3ba895eadb07bc;
inline constexpr std::uint64_t compounds = 0xbb633410814032ef;
inline constexpr std::uint64_t free_tops = 0x7424415fa1add17c;
inline constexpr std::uint64_t explicit_euler = 0x5175db0019a7b88b;
inline constexpr std::uint64_t whirl = 0x38568c28613c446b;
inline constexpr std::uint64_t changes = 0x4dd7815a1c9e96e0;
inline constexpr std::uint64_t all_shapes = 0x17eca17732715878;
inline constexpr std::uint64_t rounded_shapes = 0xbf1c77e44ccb42cf;
inline constexpr std::uint64_t surfaces = 0xa3e8fcc63cf1b004;
inline constexpr std::uint64_t all_joints = 0xab80c6d734f64c66;
inline constexpr std::uint64_t chains = 0x7dd17dda5b414ee9;

} // namespace cairn_test::golden
