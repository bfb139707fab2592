// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x7a109504b7a45bca;
inline constexpr std::uint64_t pyramid = 0x1653a0881627606a;
inline constexpr std::uint64_t dominoes = 0x660b8a2cf2cf492c;
inline constexpr std::uint64_t materials = 0xd6a76f9d4039e887;
inline constexpr std::uint64_t tumbler = 0x168372e4b7b41b97;
inline constexpr std::uint64_t sleep_and_wake = 0xf13bddf3c9ff719c;
inline constexpr std::uint64_t compounds = 0xa916654bbbe0713a;
inline constexpr std::uint64_t free_tops = 0xe32cec2b97e2e1ef;
inline constexpr std::uint64_t explicit_euler = 0xe2cd6c9df9c272fd;
inline constexpr std::uint64_t whirl = 0x3b47a1e425b1c37d;
inline constexpr std::uint64_t changes = 0x61c7e7fb24970cde;
inline constexpr std::uint64_t all_shapes = 0x9307ee1d4bcb4c16;
inline constexpr std::uint64_t rounded_shapes = 0x28a53850527d99d1;
inline constexpr std::uint64_t surfaces = 0x634ff48d57469bf5;
inline constexpr std::uint64_t all_joints = 0xaa60958c112b09c1;
inline constexpr std::uint64_t chains = 0x47bdd95226212591;

} // namespace cairn_test::golden
