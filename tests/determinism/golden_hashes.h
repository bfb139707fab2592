// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x460691b232779467;
inline constexpr std::uint64_t pyramid = 0x7b06077238366328;
inline constexpr std::uint64_t dominoes = 0x52e6c3e9791e19e2;
inline constexpr std::uint64_t materials = 0x927ec6242cafe39e;
inline constexpr std::uint64_t tumbler = 0xebe4f17459512cc8;
inline constexpr std::uint64_t sleep_and_wake = 0x4b3bc4044e52e175;
inline constexpr std::uint64_t compounds = 0x6f52018cfb7b039f;
inline constexpr std::uint64_t free_tops = 0x9e936f0a070cc8b3;

} // namespace cairn_test::golden
