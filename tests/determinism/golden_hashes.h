// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xd0b9dc948785c8b7;
inline constexpr std::uint64_t pyramid = 0xa24b30d71c1634e0;
inline constexpr std::uint64_t dominoes = 0x6381c269d953dd9c;
inline constexpr std::uint64_t materials = 0xb6862439d0025b11;
inline constexpr std::uint64_t tumbler = 0xf432b50380617fea;
inline constexpr std::uint64_t sleep_and_wake = 0xb2db0041748aae75;
inline constexpr std::uint64_t compounds = 0x605ebdd3bb780357;
inline constexpr std::uint64_t free_tops = 0xde66db06b5189ad2;
inline constexpr std::uint64_t explicit_euler = 0xbbee5ccaf8b08d3c;
inline constexpr std::uint64_t whirl = 0x968929b5f18701dd;
inline constexpr std::uint64_t changes = 0x3607af2cb52312c4;
inline constexpr std::uint64_t all_shapes = 0x3b2a36edc5d0739d;
inline constexpr std::uint64_t rounded_shapes = 0xcf2b8607b1467f37;
inline constexpr std::uint64_t surfaces = 0xdc14388944c3b479;
inline constexpr std::uint64_t all_joints = 0x86ec8aa10bbef30b;
inline constexpr std::uint64_t chains = 0x54209e0a4e5874a8;

} // namespace cairn_test::golden
