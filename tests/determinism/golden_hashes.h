// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0xad0e2fc83ffbcf31;
inline constexpr std::uint64_t pyramid = 0xe3b6b9e22a4b3549;
inline constexpr std::uint64_t dominoes = 0xa4d8476c9b3f3bf6;
inline constexpr std::uint64_t materials = 0xd3097c1411b801c9;
inline constexpr std::uint64_t tumbler = 0xaebc6e2cf683c796;
inline constexpr std::uint64_t sleep_and_wake = 0x5f3f2b0879e52e04;
inline constexpr std::uint64_t compounds = 0x75b3c52b1e0df910;
inline constexpr std::uint64_t free_tops = 0xe979e5d25ad7f547;
inline constexpr std::uint64_t explicit_euler = 0x1dd22a513062c8e7;
inline constexpr std::uint64_t whirl = 0x8b873d6b30e1d5de;
inline constexpr std::uint64_t changes = 0x3932a0d64bde1857;
inline constexpr std::uint64_t all_shapes = 0x85e046f4a7e6339e;
inline constexpr std::uint64_t rounded_shapes = 0x71d8c622460f559f;
inline constexpr std::uint64_t surfaces = 0x7c96582b6bf74d44;
inline constexpr std::uint64_t all_joints = 0x7a87235f61da6783;
inline constexpr std::uint64_t chains = 0xd32e615beb7a4359;

} // namespace cairn_test::golden
