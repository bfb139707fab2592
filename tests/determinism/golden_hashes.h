// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xc84a6914b331627f;
inline constexpr std::uint64_t pyramid = 0x074f526a75c2348b;
inline constexpr std::uint64_t dominoes = 0x5b9ebf2f7138dd5e;
inline constexpr std::uint64_t materials = 0x563ddf637cb4c380;
inline constexpr std::uint64_t tumbler = 0x453778d25514a9e8;
inline constexpr std::uint64_t sleep_and_wake = 0x07d7d6cc8b5edda2;
inline constexpr std::uint64_t compounds = 0x410f62870bcbea5b;
inline constexpr std::uint64_t free_tops = 0x8d56e1b5dc6bb731;
inline constexpr std::uint64_t explicit_euler = 0x1597a5eeb2700378;
inline constexpr std::uint64_t whirl = 0x020aaec7267bf009;
inline constexpr std::uint64_t changes = 0x03d56557d19721c6;
inline constexpr std::uint64_t all_shapes = 0x0e0058fcc609a19c;
inline constexpr std::uint64_t rounded_shapes = 0x8062da4b49f1949e;
inline constexpr std::uint64_t surfaces = 0x2a7c53751ee2938b;
inline constexpr std::uint64_t all_joints = 0x4513a695e3137b65;
inline constexpr std::uint64_t chains = 0x1bab3716b8a43149;

} // namespace cairn_test::golden
