// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x475b14a076db589a;
inline constexpr std::uint64_t pyramid = 0x637e301f15ca3dca;
inline constexpr std::uint64_t dominoes = 0xe07b02311dbe3c64;
inline constexpr std::uint64_t materials = 0xbbfaa8caa6a8e20c;
inline constexpr std::uint64_t tumbler = 0x282bee566e79e6c1;
inline constexpr std::uint64_t sleep_and_wake = 0x4f3ba895eadb07bc;
inline constexpr std::uint64_t compounds = 0xa153603c69ef5261;
inline constexpr std::uint64_t free_tops = 0x246ba73d00d3c8e6;
inline constexpr std::uint64_t explicit_euler = 0x0cc1f769a04e7678;
inline constexpr std::uint64_t whirl = 0xc726d30ff634abce;
inline constexpr std::uint64_t changes = 0x81f45c3082613c55;
inline constexpr std::uint64_t all_shapes = 0x2523b9f49ef13b74;
inline constexpr std::uint64_t rounded_shapes = 0x2a968923e519a2af;
inline constexpr std::uint64_t surfaces = 0xc108a3686d71e7bb;
inline constexpr std::uint64_t all_joints = 0x311eb2f2fd4db665;
inline constexpr std::uint64_t chains = 0xd4093da4524c257a;

} // namespace cairn_test::golden
