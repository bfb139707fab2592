// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xcc8842f209c114d2;
inline constexpr std::uint64_t pyramid = 0x3e9a710497dbfbae;
inline constexpr std::uint64_t dominoes = 0xbca67639460ae24d;
inline constexpr std::uint64_t materials = 0xca27ea75f93610e5;
inline constexpr std::uint64_t tumbler = 0x243bfeedfad0b0d6;
inline constexpr std::uint64_t sleep_and_wake = 0x675441bbeb90bf7f;
inline constexpr std::uint64_t compounds = 0xf38e80e44fc112f8;
inline constexpr std::uint64_t free_tops = 0xb24367e1cad9c950;

} // namespace cairn_test::golden
