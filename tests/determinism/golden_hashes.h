// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xe6c149ad3221c184;
inline constexpr std::uint64_t pyramid = 0x1090e3dbcd084f0d;
inline constexpr std::uint64_t dominoes = 0xe6302be585d5c86c;
inline constexpr std::uint64_t materials = 0xd2a132daf7944e59;
inline constexpr std::uint64_t tumbler = 0x85b2f50808d41e29;
inline constexpr std::uint64_t sleep_and_wake = 0x9b8076cfae7eac20;
inline constexpr std::uint64_t compounds = 0xeba4896e2355b944;
inline constexpr std::uint64_t free_tops = 0xd0c12798af561e5e;
inline constexpr std::uint64_t explicit_euler = 0x5b9b8a372a8e463c;
inline constexpr std::uint64_t whirl = 0x8c609bbef155294a;
inline constexpr std::uint64_t changes = 0x0b37b6021765f9e0;
inline constexpr std::uint64_t all_shapes = 0x547d2606a319dc7c;
inline constexpr std::uint64_t rounded_shapes = 0xa15f862095558cfb;
inline constexpr std::uint64_t surfaces = 0xcb4dc5feca63e4b2;
inline constexpr std::uint64_t all_joints = 0x39ffb2d05c938159;
inline constexpr std::uint64_t chains = 0xa0b759c901e793e8;

} // namespace cairn_test::golden
