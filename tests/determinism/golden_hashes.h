// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x678ad0fd135f52a3;
inline constexpr std::uint64_t pyramid = 0x13d5d83fbcd6d020;
inline constexpr std::uint64_t dominoes = 0x1b51a781dc056b0c;
inline constexpr std::uint64_t materials = 0x955da53a0e4a511a;
inline constexpr std::uint64_t tumbler = 0xa3f37289c9999f2c;
inline constexpr std::uint64_t sleep_and_wake = 0x26f7f8af85db36ab;
inline constexpr std::uint64_t compounds = 0x66c2dc3bd82e5250;
inline constexpr std::uint64_t free_tops = 0xc6834910e320c0d0;
inline constexpr std::uint64_t explicit_euler = 0xfb8b0a4af32eebe7;
inline constexpr std::uint64_t whirl = 0xed6e5fa050fb2e85;
inline constexpr std::uint64_t changes = 0xd72d9316af2ed252;
inline constexpr std::uint64_t all_shapes = 0x9358c3eddf34c4aa;
inline constexpr std::uint64_t rounded_shapes = 0xb21744d0eaa0b347;
inline constexpr std::uint64_t surfaces = 0x0e7e1ec5491d8c23;
inline constexpr std::uint64_t all_joints = 0x0f5184bdbb50d817;
inline constexpr std::uint64_t chains = 0xdae47382ab5a2654;
inline constexpr std::uint64_t robots = 0xd9b94822bae67d6a;

} // namespace cairn_test::golden
