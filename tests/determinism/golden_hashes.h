// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x29a1f8be15a591de;
inline constexpr std::uint64_t pyramid = 0xc42794979fa7c2ee;
inline constexpr std::uint64_t dominoes = 0x2721529906af45aa;
inline constexpr std::uint64_t materials = 0xfa834f1b2491629c;
inline constexpr std::uint64_t tumbler = 0xbac0f9945c67aeea;
inline constexpr std::uint64_t sleep_and_wake = 0x45e968ef148d337e;
inline constexpr std::uint64_t compounds = 0x06b5cf2e4c84e076;
inline constexpr std::uint64_t free_tops = 0xc4fbd81687eeba94;
inline constexpr std::uint64_t explicit_euler = 0xa8eff6a4eb508a1d;
inline constexpr std::uint64_t whirl = 0xe0dc3c6aade8bba5;
inline constexpr std::uint64_t changes = 0x9a5a526dd4213d75;
inline constexpr std::uint64_t all_shapes = 0x00b53c99afb42830;
inline constexpr std::uint64_t rounded_shapes = 0xcfbd22c9ac2f727c;
inline constexpr std::uint64_t surfaces = 0x0bc312f35232a332;
inline constexpr std::uint64_t all_joints = 0xb4c1e042b90e929c;
inline constexpr std::uint64_t chains = 0xff89c14a77e00e13;

} // namespace cairn_test::golden
