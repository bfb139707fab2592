// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x8b451c4c46926067;
inline constexpr std::uint64_t pyramid = 0x622171f7839713c0;
inline constexpr std::uint64_t dominoes = 0x6da29d0137ee39d2;
inline constexpr std::uint64_t materials = 0xc1726963f5b59409;
inline constexpr std::uint64_t tumbler = 0xc947257d5bbd32db;
inline constexpr std::uint64_t sleep_and_wake = 0x4f3ba895eadb07bc;
inline constexpr std::uint64_t compounds = 0x1f8ea36a6f9fc089;
inline constexpr std::uint64_t free_tops = 0x56053d00d645845a;
inline constexpr std::uint64_t explicit_euler = 0x0cc1f769a04e7678;
inline constexpr std::uint64_t whirl = 0x7449a8bb9e9a78a8;
inline constexpr std::uint64_t changes = 0x4b0548f18c422042;
inline constexpr std::uint64_t all_shapes = 0x73a04e3b5bb4bb72;
inline constexpr std::uint64_t rounded_shapes = 0xc240ed2a29e530be;
inline constexpr std::uint64_t surfaces = 0x0ecf13e13aa3b89f;
inline constexpr std::uint64_t all_joints = 0x819b98f0a37b3c64;
inline constexpr std::uint64_t chains = 0x64e968fbd3901f54;

} // namespace cairn_test::golden
