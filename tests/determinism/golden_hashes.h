// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xbd65906e7f96a0fe;
inline constexpr std::uint64_t pyramid = 0x65cb797131d59ac5;
inline constexpr std::uint64_t dominoes = 0x5b9ebf2f7138dd5e;
inline constexpr std::uint64_t materials = 0x563ddf637cb4c380;
inline constexpr std::uint64_t tumbler = 0x8d4633cdd33786be;
inline constexpr std::uint64_t sleep_and_wake = 0x07d7d6cc8b5edda2;
inline constexpr std::uint64_t compounds = 0x174de35e554c512e;
inline constexpr std::uint64_t free_tops = 0x8d56e1b5dc6bb731;
inline constexpr std::uint64_t explicit_euler = 0x1597a5eeb2700378;
inline constexpr std::uint64_t whirl = 0x6046c2b45536a4b7;
inline constexpr std::uint64_t changes = 0xad522517283b790f;
inline constexpr std::uint64_t all_shapes = 0x9cf8d85e4ccba289;
inline constexpr std::uint64_t rounded_shapes = 0x1f87e9ae088ea038;
inline constexpr std::uint64_t surfaces = 0x914822f3f3799c39;
inline constexpr std::uint64_t all_joints = 0x4513a695e3137b65;
inline constexpr std::uint64_t chains = 0x1bab3716b8a43149;

} // namespace cairn_test::golden
