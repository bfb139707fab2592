// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xf4557469f0d6595d;
inline constexpr std::uint64_t pyramid = 0x3abc59cfa88e5eca;
inline constexpr std::uint64_t dominoes = 0x491a9b2086abe900;
inline constexpr std::uint64_t materials = 0xbf381d94e0a2eb23;
inline constexpr std::uint64_t tumbler = 0x168372e4b7b41b97;
inline constexpr std::uint64_t sleep_and_wake = 0xfed98d3b7c202027;
inline constexpr std::uint64_t compounds = 0x03437665489c2576;
inline constexpr std::uint64_t free_tops = 0xe32cec2b97e2e1ef;
inline constexpr std::uint64_t explicit_euler = 0x430a7a70e30ed48e;
inline constexpr std::uint64_t whirl = 0x62060ee7acf732fc;
inline constexpr std::uint64_t changes = 0x69be9715cd14e89c;
inline constexpr std::uint64_t all_shapes = 0xb32dd52a5b200f21;
inline constexpr std::uint64_t rounded_shapes = 0x0e7a4e63e024da33;
inline constexpr std::uint64_t surfaces = 0xc209518bc6db6fab;
inline constexpr std::uint64_t all_joints = 0x9024afcb50e070eb;
inline constexpr std::uint64_t chains = 0xd84fa20683fe04d0;

} // namespace cairn_test::golden
