// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xd69dc5d745c59b5e;
inline constexpr std::uint64_t pyramid = 0x5f322d03b06a76d1;
inline constexpr std::uint64_t dominoes = 0xf97cc4f6197090c9;
inline constexpr std::uint64_t materials = 0xf57537261d7fe727;
inline constexpr std::uint64_t tumbler = 0x30471f3738008aae;
inline constexpr std::uint64_t sleep_and_wake = 0xff971506bf9f2120;
inline constexpr std::uint64_t compounds = 0x30a9b71c7154f96b;
inline constexpr std::uint64_t free_tops = 0x9643f3537bf3534d;
inline constexpr std::uint64_t explicit_euler = 0xe55bce5a656490b1;
inline constexpr std::uint64_t whirl = 0x8ffa53341c981185;
inline constexpr std::uint64_t changes = 0x65a1b7ca03bda5b4;
inline constexpr std::uint64_t all_shapes = 0x46717ad78da6d974;
inline constexpr std::uint64_t rounded_shapes = 0x06c7f24b9a132084;
inline constexpr std::uint64_t surfaces = 0x7db5749e65a690fc;
inline constexpr std::uint64_t all_joints = 0x33f85f4a0e770f03;
inline constexpr std::uint64_t chains = 0x25842583d491ddfb;

} // namespace cairn_test::golden
