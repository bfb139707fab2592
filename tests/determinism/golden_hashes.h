// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x20c4c07f10411270;
inline constexpr std::uint64_t pyramid = 0x3abc59cfa88e5eca;
inline constexpr std::uint64_t dominoes = 0xb2bb7652249c1d87;
inline constexpr std::uint64_t materials = 0xf99b934f0621619c;
inline constexpr std::uint64_t tumbler = 0xcacafa8484165f09;
inline constexpr std::uint64_t sleep_and_wake = 0x3f9c6fe2f054c16a;
inline constexpr std::uint64_t compounds = 0x63d65e0f1432860c;
inline constexpr std::uint64_t free_tops = 0xe32cec2b97e2e1ef;
inline constexpr std::uint64_t explicit_euler = 0x430a7a70e30ed48e;
inline constexpr std::uint64_t whirl = 0xb0dd5e052c57d9a9;
inline constexpr std::uint64_t changes = 0xb5d94452c5865a96;
inline constexpr std::uint64_t all_shapes = 0xd795434a0f3d7fb1;
inline constexpr std::uint64_t rounded_shapes = 0xecb39865b0089c5d;
inline constexpr std::uint64_t surfaces = 0x760a4abe1a7438e9;
inline constexpr std::uint64_t all_joints = 0x7f414c04741cc86c;
inline constexpr std::uint64_t chains = 0xdff163ae6288959f;

} // namespace cairn_test::golden
