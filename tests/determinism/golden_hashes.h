// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x1d9165500aa3ede1;
inline constexpr std::uint64_t pyramid = 0xa5c1fd36cfe176fd;
inline constexpr std::uint64_t dominoes = 0xcd6493645981d84e;
inline constexpr std::uint64_t materials = 0xc57bdad6cbf5c4fd;
inline constexpr std::uint64_t tumbler = 0x847f344bae71c7c3;
inline constexpr std::uint64_t sleep_and_wake = 0x806df4e00fd95c36;
inline constexpr std::uint64_t compounds = 0xbea7e3360e3f3745;
inline constexpr std::uint64_t free_tops = 0xe32cec2b97e2e1ef;
inline constexpr std::uint64_t explicit_euler = 0x775513aead366006;
inline constexpr std::uint64_t whirl = 0x2757b41bb2f713a0;
inline constexpr std::uint64_t changes = 0x565b0237097325b7;
inline constexpr std::uint64_t all_shapes = 0x66c55e291b8503f2;
inline constexpr std::uint64_t rounded_shapes = 0x97c4375660ddabe3;
inline constexpr std::uint64_t surfaces = 0x4b1655c1a526dad2;
inline constexpr std::uint64_t all_joints = 0xa130425dcbfac37e;
inline constexpr std::uint64_t chains = 0xab710d6013f45231;

} // namespace cairn_test::golden
