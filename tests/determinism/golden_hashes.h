// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x709bf6f6693fa5ca;
inline constexpr std::uint64_t pyramid = 0x00eabec38f0cb036;
inline constexpr std::uint64_t dominoes = 0x2721529906af45aa;
inline constexpr std::uint64_t materials = 0xdcc32fa9ff6d5ad1;
inline constexpr std::uint64_t tumbler = 0xd9a5080801a78d49;
inline constexpr std::uint64_t sleep_and_wake = 0x45e968ef148d337e;
inline constexpr std::uint64_t compounds = 0x8cd4e726e3c55eed;
inline constexpr std::uint64_t free_tops = 0xc4fbd81687eeba94;
inline constexpr std::uint64_t explicit_euler = 0xa8eff6a4eb508a1d;
inline constexpr std::uint64_t whirl = 0xe0dc3c6aade8bba5;
inline constexpr std::uint64_t changes = 0xfbb3b75d64ceeeba;
inline constexpr std::uint64_t all_shapes = 0xa2ee8ea0876c51e8;
inline constexpr std::uint64_t rounded_shapes = 0x0218e459c6adc6cb;
inline constexpr std::uint64_t surfaces = 0x97bbe548687db0da;
inline constexpr std::uint64_t all_joints = 0xb4c1e042b90e929c;
inline constexpr std::uint64_t chains = 0xff89c14a77e00e13;

} // namespace cairn_test::golden
