// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x6ef9b91074c33c32;
inline constexpr std::uint64_t pyramid = 0xc01cffd7eb0bdcb1;
inline constexpr std::uint64_t dominoes = 0xe7afdbe03c47de2f;
inline constexpr std::uint64_t materials = 0x9da459070efb239c;
inline constexpr std::uint64_t tumbler = 0xba4bac4d72ef619a;
inline constexpr std::uint64_t sleep_and_wake = 0x4f3ba895eadb07bc;
inline constexpr std::uint64_t compounds = 0xbb633410814032ef;
inline constexpr std::uint64_t free_tops = 0x7424415fa1add17c;
inline constexpr std::uint64_t explicit_euler = 0x5175db0019a7b88b;
inline constexpr std::uint64_t whirl = 0x38568c28613c446b;
inline constexpr std::uint64_t changes = 0x4dd7815a1c9e96e0;
inline constexpr std::uint64_t all_shapes = 0x6ea045514257036f;
inline constexpr std::uint64_t rounded_shapes = 0x5f1c941e1ad183dc;
inline constexpr std::uint64_t surfaces = 0xa3e8fcc63cf1b004;
inline constexpr std::uint64_t all_joints = 0xab80c6d734f64c66;
inline constexpr std::uint64_t chains = 0x58d1cf9021e844eb;

} // namespace cairn_test::golden
