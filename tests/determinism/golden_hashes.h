// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x18fe51c66d209ec0;
inline constexpr std::uint64_t pyramid = 0x187beb66fc3fc452;
inline constexpr std::uint64_t dominoes = 0x210e7cea3e2dbce1;
inline constexpr std::uint64_t materials = 0x19ec3bcb15a2d362;
inline constexpr std::uint64_t tumbler = 0x24e88253783d6db4;
inline constexpr std::uint64_t sleep_and_wake = 0x9b8076cfae7eac20;
inline constexpr std::uint64_t compounds = 0x999f253c731b1ce7;
inline constexpr std::uint64_t free_tops = 0xb0ccf7123468c5c7;
inline constexpr std::uint64_t explicit_euler = 0xbe3487da0dc72138;
inline constexpr std::uint64_t whirl = 0x70619c6aaabcce96;
inline constexpr std::uint64_t changes = 0x63600caf5be97791;
inline constexpr std::uint64_t all_shapes = 0x46e7a6f0bdcd0089;
inline constexpr std::uint64_t rounded_shapes = 0x5bfd48eb13d86fc2;
inline constexpr std::uint64_t surfaces = 0xd39da23f9c70cffd;
inline constexpr std::uint64_t all_joints = 0xc61ae52733fcfea8;
inline constexpr std::uint64_t chains = 0xa0b759c901e793e8;

} // namespace cairn_test::golden
