// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x5234645c74329a3b;
inline constexpr std::uint64_t pyramid = 0xd3b45c388f79b5c4;
inline constexpr std::uint64_t dominoes = 0xffaf9b70d53156eb;
inline constexpr std::uint64_t materials = 0xa8e0272280c5b6c1;
inline constexpr std::uint64_t tumbler = 0xf0581a98dae50489;
inline constexpr std::uint64_t sleep_and_wake = 0x60522e1f7dd866cb;
inline constexpr std::uint64_t compounds = 0x976745ba7f36e8fb;
inline constexpr std::uint64_t free_tops = 0x03e040806a0b28c3;

} // namespace cairn_test::golden
