// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x6ef9b91074c33c32;
inline constexpr std::uint64_t pyramid = 0xc01cffd7eb0bdcb1;
inline constexpr std::uint64_t dominoes = 0xe7afdbe03c47de2f;
inline constexpr std::uint64_t materials = 0x28e146d0173c5573;
inline constexpr std::uint64_t tumbler = 0xfb8a2e280a89dfbb;
inline constexpr std::uint64_t sleep_and_wake = 0xf8ee3c0ec5b85fcb;
inline constexpr std::uint64_t compounds = 0x0bf2010dedc7ecfd;
inline constexpr std::uint64_t free_tops = 0x7424415fa1add17c;
inline constexpr std::uint64_t explicit_euler = 0x55a88828db5c3519;
inline constexpr std::uint64_t whirl = 0x38568c28613c446b;
inline constexpr std::uint64_t changes = 0xb3774d38bad2931b;
inline constexpr std::uint64_t all_shapes = 0xa6bb27c6b2c74b7f;
inline constexpr std::uint64_t rounded_shapes = 0xe9f35804f330e5f8;
inline constexpr std::uint64_t surfaces = 0x0df8dd4f66084169;
inline constexpr std::uint64_t all_joints = 0xab80c6d734f64c66;
inline constexpr std::uint64_t chains = 0x911914e8eb2d30c1;

} // namespace cairn_test::golden
