// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x5c2a2a1597d41d17;
inline constexpr std::uint64_t pyramid = 0xf05274f31868f22b;
inline constexpr std::uint64_t dominoes = 0x5b9ebf2f7138dd5e;
inline constexpr std::uint64_t materials = 0xdbb7eb0684eddfaf;
inline constexpr std::uint64_t tumbler = 0x0fa7e1635790376a;
inline constexpr std::uint64_t sleep_and_wake = 0x07d7d6cc8b5edda2;
inline constexpr std::uint64_t compounds = 0xfc7046637e384839;
inline constexpr std::uint64_t free_tops = 0x8d56e1b5dc6bb731;
inline constexpr std::uint64_t explicit_euler = 0x1597a5eeb2700378;
inline constexpr std::uint64_t whirl = 0x245566341ef9401e;
inline constexpr std::uint64_t changes = 0xf254e276372bf155;
inline constexpr std::uint64_t all_shapes = 0x787cd064121ad7df;
inline constexpr std::uint64_t rounded_shapes = 0xb2e08e51cfc80fbf;
inline constexpr std::uint64_t surfaces = 0xf3246e9c72657f60;
inline constexpr std::uint64_t all_joints = 0xdbd9b7be58d6601d;
inline constexpr std::uint64_t chains = 0x3be4eecdc65e13b4;

} // namespace cairn_test::golden
