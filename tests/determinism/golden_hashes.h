// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xa97064962c36057f;
inline constexpr std::uint64_t pyramid = 0x6e90f2a1106609b2;
inline constexpr std::uint64_t dominoes = 0x474950b1950f158a;
inline constexpr std::uint64_t materials = 0x32c6681e769004c1;
inline constexpr std::uint64_t tumbler = 0x847461940cfb5dad;
inline constexpr std::uint64_t sleep_and_wake = 0x02a5ac89fdfc33d7;
inline constexpr std::uint64_t compounds = 0xd3e1b5658bdfcd79;
inline constexpr std::uint64_t free_tops = 0xbee2e2957f98eefe;
inline constexpr std::uint64_t explicit_euler = 0xe20ab4c948f81c44;
inline constexpr std::uint64_t whirl = 0xdac6b57e5d1ad2bf;
inline constexpr std::uint64_t changes = 0x62769b8eb91acd0d;
inline constexpr std::uint64_t all_shapes = 0xdd741fe5a4441f3d;
inline constexpr std::uint64_t rounded_shapes = 0x1a854e88529e570b;
inline constexpr std::uint64_t surfaces = 0x2af40d88a462886b;
inline constexpr std::uint64_t all_joints = 0x2a162d68e362af14;
inline constexpr std::uint64_t chains = 0x546d6ab7aa268640;
inline constexpr std::uint64_t robots = 0xb1fd22b1175b5496;

} // namespace cairn_test::golden
