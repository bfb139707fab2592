// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x51c2796acc1831b9;
inline constexpr std::uint64_t pyramid = 0xaf6f3a5d42a0ca7d;
inline constexpr std::uint64_t dominoes = 0x2f5ab2b341c981d2;
inline constexpr std::uint64_t materials = 0x6f32e033f1f3f5d7;
inline constexpr std::uint64_t tumbler = 0x812c05f50583d211;
inline constexpr std::uint64_t sleep_and_wake = 0x3c78a647a8119fa5;
inline constexpr std::uint64_t compounds = 0x1b3783557899a278;
inline constexpr std::uint64_t free_tops = 0x64091c87f3dd8008;
inline constexpr std::uint64_t explicit_euler = 0xb394feae8960ce0d;
inline constexpr std::uint64_t whirl = 0xe925ec450b697355;
inline constexpr std::uint64_t changes = 0xec7293e81fdfdcb9;
inline constexpr std::uint64_t all_shapes = 0x735de8b99aa8cb1c;
inline constexpr std::uint64_t rounded_shapes = 0xcd6feee97441c1e4;
inline constexpr std::uint64_t surfaces = 0x19efd775f04388fe;
inline constexpr std::uint64_t all_joints = 0x8e483eb72e2c0f09;
inline constexpr std::uint64_t chains = 0xf403c3f07faeb2a7;
inline constexpr std::uint64_t robots = 0x4102e1e4b5c86958;

} // namespace cairn_test::golden
