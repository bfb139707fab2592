// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xc1c76409f141e77f;
inline constexpr std::uint64_t pyramid = 0x57f11eee08c3a296;
inline constexpr std::uint64_t dominoes = 0x6f005bfea483c550;
inline constexpr std::uint64_t materials = 0xba5bfe886ece5147;
inline constexpr std::uint64_t tumbler = 0x9fe66962884c0ce1;
inline constexpr std::uint64_t sleep_and_wake = 0x50dad7b28f748b25;
inline constexpr std::uint64_t compounds = 0xeb584e3dce23892b;
inline constexpr std::uint64_t free_tops = 0x4c84fe26826d73cd;
inline constexpr std::uint64_t explicit_euler = 0x75f56d0fdae1ffe5;
inline constexpr std::uint64_t whirl = 0x3a9b40bab4a8645e;
inline constexpr std::uint64_t changes = 0xd250cd315b1a4a04;
inline constexpr std::uint64_t all_shapes = 0xc6fee70fa57c282c;
inline constexpr std::uint64_t rounded_shapes = 0xc11dc4a5f883f9b0;
inline constexpr std::uint64_t surfaces = 0x31a74fdec6e71473;
inline constexpr std::uint64_t all_joints = 0x621d3546192919a7;
inline constexpr std::uint64_t chains = 0xa1fffcacb9d25e75;

} // namespace cairn_test::golden
