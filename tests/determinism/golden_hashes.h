// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x9ae765d0e33684f8;
inline constexpr std::uint64_t pyramid = 0xcc44ecc828ffd6f9;
inline constexpr std::uint64_t dominoes = 0x26f2ed50239c042e;
inline constexpr std::uint64_t materials = 0x8cd1b6aa273470e8;
inline constexpr std::uint64_t tumbler = 0x538e8e5698219733;
inline constexpr std::uint64_t sleep_and_wake = 0x7aef54faa73b4fc1;
inline constexpr std::uint64_t compounds = 0xa53910e67ca29647;
inline constexpr std::uint64_t free_tops = 0xbee2e2957f98eefe;
inline constexpr std::uint64_t explicit_euler = 0x895088332d3afe5e;
inline constexpr std::uint64_t whirl = 0xe41c42ee053abc06;
inline constexpr std::uint64_t changes = 0x2ca5861c3932a1b4;
inline constexpr std::uint64_t all_shapes = 0x93a35c651afbb568;
inline constexpr std::uint64_t rounded_shapes = 0x523031c019c36b70;
inline constexpr std::uint64_t surfaces = 0xcbbe18fc5bcfd521;
inline constexpr std::uint64_t all_joints = 0xd5ab026c103448c2;
inline constexpr std::uint64_t chains = 0x77c219d77d516f9c;
inline constexpr std::uint64_t robots = 0xb1fd22b1175b5496;

} // namespace cairn_test::golden
