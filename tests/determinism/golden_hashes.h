// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xf7bb80766a315291;
inline constexpr std::uint64_t pyramid = 0xc03116dec05b4ed7;
inline constexpr std::uint64_t dominoes = 0xe6302be585d5c86c;
inline constexpr std::uint64_t materials = 0xfa36d19a62e6eca8;
inline constexpr std::uint64_t tumbler = 0x2857538c7c2dcace;
inline constexpr std::uint64_t sleep_and_wake = 0x9b8076cfae7eac20;
inline constexpr std::uint64_t compounds = 0x11a274a503b00f8e;
inline constexpr std::uint64_t free_tops = 0xd0c12798af561e5e;
inline constexpr std::uint64_t explicit_euler = 0x92cbc9c43cc5f76a;
inline constexpr std::uint64_t whirl = 0x8c609bbef155294a;
inline constexpr std::uint64_t changes = 0x501adadbeb8d3d24;
inline constexpr std::uint64_t all_shapes = 0x547d2606a319dc7c;
inline constexpr std::uint64_t rounded_shapes = 0xc721dd4508275f34;
inline constexpr std::uint64_t surfaces = 0xa6663cebd2a6dae2;
inline constexpr std::uint64_t all_joints = 0xc93305064c019971;
inline constexpr std::uint64_t chains = 0xa0b759c901e793e8;

} // namespace cairn_test::golden
