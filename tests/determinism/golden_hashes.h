// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xabd963793bfcae63;
inline constexpr std::uint64_t pyramid = 0x0d9a025798bb1721;
inline constexpr std::uint64_t dominoes = 0xeee8eae10c6ba5f1;
inline constexpr std::uint64_t materials = 0x9e1481cb98b7aaa7;
inline constexpr std::uint64_t tumbler = 0xc112cad745dc80b7;
inline constexpr std::uint64_t sleep_and_wake = 0x370e9c9b621a435e;
inline constexpr std::uint64_t compounds = 0x027c405812d8b02a;
inline constexpr std::uint64_t free_tops = 0xbb76e390fd67d031;
inline constexpr std::uint64_t explicit_euler = 0x55c2f474356f770f;
inline constexpr std::uint64_t whirl = 0xaf08dfe2623c0a26;
inline constexpr std::uint64_t changes = 0xa49d27e8e870ca71;
inline constexpr std::uint64_t all_shapes = 0x4de5b34ab3e5070f;
inline constexpr std::uint64_t rounded_shapes = 0xd5bebeefce6c9d7b;
inline constexpr std::uint64_t surfaces = 0x45e59f01d066c1f6;
inline constexpr std::uint64_t all_joints = 0x104b90ae57cd21be;
inline constexpr std::uint64_t chains = 0x9b8724a500f081f7;

} // namespace cairn_test::golden
