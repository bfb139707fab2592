// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x0597b5f15f739d97;
inline constexpr std::uint64_t pyramid = 0x6e90f2a1106609b2;
inline constexpr std::uint64_t dominoes = 0x474950b1950f158a;
inline constexpr std::uint64_t materials = 0xcd52a1e0badc60ac;
inline constexpr std::uint64_t tumbler = 0x7ac952db44986f3d;
inline constexpr std::uint64_t sleep_and_wake = 0x02a5ac89fdfc33d7;
inline constexpr std::uint64_t compounds = 0xa9bfdbcc47a5cf2e;
inline constexpr std::uint64_t free_tops = 0x7028295f6bba04c8;
inline constexpr std::uint64_t explicit_euler = 0xf5c7ef31df71c55b;
inline constexpr std::uint64_t whirl = 0x04fc008e8fa71da3;
inline constexpr std::uint64_t changes = 0x63032b78994cfc62;
inline constexpr std::uint64_t all_shapes = 0xe7a0fb90cff21ecd;
inline constexpr std::uint64_t rounded_shapes = 0xc3e77ff75171fed2;
inline constexpr std::uint64_t surfaces = 0xf9eb6d24372de749;
inline constexpr std::uint64_t all_joints = 0x609c4b0c4f6f72f1;
inline constexpr std::uint64_t chains = 0x17d1fa1082d31c94;

} // namespace cairn_test::golden
