// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xa8125643baef7d1c;
inline constexpr std::uint64_t pyramid = 0x637e301f15ca3dca;
inline constexpr std::uint64_t dominoes = 0xe07b02311dbe3c64;
inline constexpr std::uint64_t materials = 0xbbfaa8caa6a8e20c;
inline constexpr std::uint64_t tumbler = 0x282bee566e79e6c1;
inline constexpr std::uint64_t sleep_and_wake = 0x4f3ba895eadb07bc;
inline constexpr std::uint64_t compounds = 0xa153603c69ef5261;
inline constexpr std::uint64_t free_tops = 0x246ba73d00d3c8e6;
inline constexpr std::uint64_t explicit_euler = 0x0cc1f769a04e7678;
inline constexpr std::uint64_t whirl = 0x7cb5409bfa324e78;
inline constexpr std::uint64_t changes = 0x08c7ab6e049243a4;
inline constexpr std::uint64_t all_shapes = 0xedf523eac01eac17;
inline constexpr std::uint64_t rounded_shapes = 0x19727e27ef314f0a;
inline constexpr std::uint64_t surfaces = 0xfc77848c8216c103;
inline constexpr std::uint64_t all_joints = 0x311eb2f2fd4db665;
inline constexpr std::uint64_t chains = 0x9c36db1896dbd2d5;

} // namespace cairn_test::golden
