// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x5de328c2f2b5121e;
inline constexpr std::uint64_t pyramid = 0x6ca3f13a2ad00f3a;
inline constexpr std::uint64_t dominoes = 0x3c11551e6e7ff79b;
inline constexpr std::uint64_t materials = 0x0a468cdc68ca7a5b;
inline constexpr std::uint64_t tumbler = 0x528cda1f00002b73;
inline constexpr std::uint64_t sleep_and_wake = 0x742ce017bdf8ef89;
inline constexpr std::uint64_t compounds = 0x92480b56b5314adc;
inline constexpr std::uint64_t free_tops = 0x9643f3537bf3534d;
inline constexpr std::uint64_t explicit_euler = 0x2ff2eaad6f7aa06a;
inline constexpr std::uint64_t whirl = 0xaf85ac0f1dbc2141;
inline constexpr std::uint64_t changes = 0x207a11967b28638f;
inline constexpr std::uint64_t all_shapes = 0xd088cd89359730fe;
inline constexpr std::uint64_t rounded_shapes = 0x0727b3caca239c68;
inline constexpr std::uint64_t surfaces = 0x301a7db05b26bd2a;
inline constexpr std::uint64_t all_joints = 0x2bf20d16f5c2f5af;
inline constexpr std::uint64_t chains = 0x90ce7ba86715fa7c;

} // namespace cairn_test::golden
