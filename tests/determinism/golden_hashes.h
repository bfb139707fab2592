// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x13fd94d0ceaee9bc;
inline constexpr std::uint64_t pyramid = 0xc8683e287f3e75f7;
inline constexpr std::uint64_t dominoes = 0x2721529906af45aa;
inline constexpr std::uint64_t materials = 0x03ed89d91f0ce22c;
inline constexpr std::uint64_t tumbler = 0x979aa61996a9c106;
inline constexpr std::uint64_t sleep_and_wake = 0x45e968ef148d337e;
inline constexpr std::uint64_t compounds = 0x2d5315dc21bf66b7;
inline constexpr std::uint64_t free_tops = 0xc4fbd81687eeba94;
inline constexpr std::uint64_t explicit_euler = 0xa8eff6a4eb508a1d;
inline constexpr std::uint64_t whirl = 0xe0dc3c6aade8bba5;
inline constexpr std::uint64_t changes = 0xc07c4ea9efac5c85;
inline constexpr std::uint64_t all_shapes = 0xd4b3c8fd513dae67;
inline constexpr std::uint64_t rounded_shapes = 0x7049bc8509a54a59;
inline constexpr std::uint64_t surfaces = 0x659da6ba5a0347a4;
inline constexpr std::uint64_t all_joints = 0xb4c1e042b90e929c;
inline constexpr std::uint64_t chains = 0xff89c14a77e00e13;

} // namespace cairn_test::golden
