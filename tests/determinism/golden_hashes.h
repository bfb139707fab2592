// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xe53bea2b6994c431;
inline constexpr std::uint64_t pyramid = 0x46b1de1215919f35;
inline constexpr std::uint64_t dominoes = 0x4977e58794c6f4fd;
inline constexpr std::uint64_t materials = 0x0ad4e75f6957c837;
inline constexpr std::uint64_t tumbler = 0x845fc9e5778c8946;
inline constexpr std::uint64_t sleep_and_wake = 0x6364b3d9347f40a0;
inline constexpr std::uint64_t compounds = 0x67a6a414bc5843ad;
inline constexpr std::uint64_t free_tops = 0xd857a0fed7a1b364;
inline constexpr std::uint64_t explicit_euler = 0xc321eef158b833da;
inline constexpr std::uint64_t whirl = 0x89efd9f180a8d32e;
inline constexpr std::uint64_t changes = 0xf47d6039d2d72bd1;
inline constexpr std::uint64_t all_shapes = 0x65872fd59675c92f;
inline constexpr std::uint64_t rounded_shapes = 0xfae4317d27642506;
inline constexpr std::uint64_t surfaces = 0x631a66fa28196948;
inline constexpr std::uint64_t all_joints = 0x14ea7f57e5ac9253;
inline constexpr std::uint64_t chains = 0x4d55b4aec339c7e2;

} // namespace cairn_test::golden
