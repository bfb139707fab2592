// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xd8a89bb32c48022e;
inline constexpr std::uint64_t pyramid = 0xe7a20ef6ea15710f;
inline constexpr std::uint64_t dominoes = 0x474950b1950f158a;
inline constexpr std::uint64_t materials = 0xb8befe36f30515ca;
inline constexpr std::uint64_t tumbler = 0x1283ca93d9506d27;
inline constexpr std::uint64_t sleep_and_wake = 0x838a3e4e524c5e10;
inline constexpr std::uint64_t compounds = 0x07a559166e6191cf;
inline constexpr std::uint64_t free_tops = 0x35b7f756fff5cf55;
inline constexpr std::uint64_t explicit_euler = 0x7b28615f9029809b;
inline constexpr std::uint64_t whirl = 0xde159a9da0b4f88b;
inline constexpr std::uint64_t changes = 0xf0e959b6389f802b;
inline constexpr std::uint64_t all_shapes = 0x167b4d0303e9602a;
inline constexpr std::uint64_t rounded_shapes = 0xf021dcd3590f2a8e;
inline constexpr std::uint64_t surfaces = 0x52a3394764c0c765;
inline constexpr std::uint64_t all_joints = 0x5b26606b0e7da098;
inline constexpr std::uint64_t chains = 0x9980589138cc41f7;

} // namespace cairn_test::golden
