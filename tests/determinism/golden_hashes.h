// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xc06e90e4c51c7949;
inline constexpr std::uint64_t pyramid = 0x99acdf905d2e6c27;
inline constexpr std::uint64_t dominoes = 0xca1e1bc90cff3c32;
inline constexpr std::uint64_t materials = 0x072a502fa474d954;
inline constexpr std::uint64_t tumbler = 0xfb8a2e280a89dfbb;
inline constexpr std::uint64_t sleep_and_wake = 0xf8ee3c0ec5b85fcb;
inline constexpr std::uint64_t compounds = 0x2fefb04d5781c181;
inline constexpr std::uint64_t free_tops = 0x7424415fa1add17c;
inline constexpr std::uint64_t explicit_euler = 0x55a88828db5c3519;
inline constexpr std::uint64_t whirl = 0x38568c28613c446b;
inline constexpr std::uint64_t changes = 0xb3774d38bad2931b;
inline constexpr std::uint64_t all_shapes = 0x7c47d1fc8ca25c42;
inline constexpr std::uint64_t rounded_shapes = 0x15255c29227276e3;
inline constexpr std::uint64_t surfaces = 0x0df8dd4f66084169;
inline constexpr std::uint64_t all_joints = 0x54bbd5aad4bf9a06;
inline constexpr std::uint64_t chains = 0x911914e8eb2d30c1;

} // namespace cairn_test::golden
