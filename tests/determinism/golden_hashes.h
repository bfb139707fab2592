// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x1f16b85e3c5a8d17;
inline constexpr std::uint64_t pyramid = 0x4d942564e804fda1;
inline constexpr std::uint64_t dominoes = 0xcae104241a20ada1;
inline constexpr std::uint64_t materials = 0x675e4161d36cf847;
inline constexpr std::uint64_t tumbler = 0xc0a4b650d9a0233f;
inline constexpr std::uint64_t sleep_and_wake = 0x3c526d723e61a75d;
inline constexpr std::uint64_t compounds = 0x58ae63993f7c458b;
inline constexpr std::uint64_t free_tops = 0x915af4b40fa0cbe4;
inline constexpr std::uint64_t explicit_euler = 0xebdd018a8e84a5c2;
inline constexpr std::uint64_t whirl = 0xb414d93be37b49cb;
inline constexpr std::uint64_t changes = 0x4dd7bfe3675f864f;
inline constexpr std::uint64_t all_shapes = 0x985fd717bd9a0dfd;
inline constexpr std::uint64_t rounded_shapes = 0xa83be539ef931534;
inline constexpr std::uint64_t surfaces = 0x3f0e818eccd43c05;
inline constexpr std::uint64_t all_joints = 0x622fb1ee5bc9428d;
inline constexpr std::uint64_t chains = 0xcba6ba00a7ed5c89;

} // namespace cairn_test::golden
