// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xafdf0b4e757c9551;
inline constexpr std::uint64_t pyramid = 0x8e86437d344e7e10;
inline constexpr std::uint64_t dominoes = 0xbca67639460ae24d;
inline constexpr std::uint64_t materials = 0x6fafb4bb3ec53598;
inline constexpr std::uint64_t tumbler = 0x05e032ccde0c87f5;
inline constexpr std::uint64_t sleep_and_wake = 0x675441bbeb90bf7f;
inline constexpr std::uint64_t compounds = 0xde2aa375159179e9;
inline constexpr std::uint64_t free_tops = 0xb24367e1cad9c950;

} // namespace cairn_test::golden
