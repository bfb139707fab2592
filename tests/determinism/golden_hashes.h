// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x2ebc2c3fe8e8a1da;
inline constexpr std::uint64_t pyramid = 0x155266d479567d63;
inline constexpr std::uint64_t dominoes = 0x97334989773cf72a;
inline constexpr std::uint64_t materials = 0xce649fb76bbc2dfa;
inline constexpr std::uint64_t tumbler = 0x2c0ea843b004fbe8;
inline constexpr std::uint64_t sleep_and_wake = 0x73191160fe3aa97c;
inline constexpr std::uint64_t compounds = 0x51d242d576ec67fe;
inline constexpr std::uint64_t free_tops = 0xa9b1abede3e83de8;
inline constexpr std::uint64_t explicit_euler = 0xd6b6457adf051290;
inline constexpr std::uint64_t whirl = 0xa2bf401245613807;
inline constexpr std::uint64_t changes = 0x7b31cde483ccc93f;
inline constexpr std::uint64_t all_shapes = 0x38c34960808e054b;
inline constexpr std::uint64_t rounded_shapes = 0xc94fd5bab4e7d10e;
inline constexpr std::uint64_t surfaces = 0xb98747d52d4f36b0;
inline constexpr std::uint64_t all_joints = 0x6da33ba49c8ecf31;
inline constexpr std::uint64_t chains = 0xd32e615beb7a4359;

} // namespace cairn_test::golden
