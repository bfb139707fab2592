// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x8107d92632987a98;
inline constexpr std::uint64_t pyramid = 0xd12b9eb5a147330c;
inline constexpr std::uint64_t dominoes = 0xcb825b95987176fe;
inline constexpr std::uint64_t materials = 0x201953bcaa3742c8;
inline constexpr std::uint64_t tumbler = 0xb184287c851e44e9;
inline constexpr std::uint64_t sleep_and_wake = 0x7706459c4a49304c;
inline constexpr std::uint64_t compounds = 0x6fa086a56eb5858e;
inline constexpr std::uint64_t free_tops = 0xef3ee25acec88d1c;

} // namespace cairn_test::golden
