// The state of each scene after `golden_steps` steps, as World::state_hash gives it. The numbers are the same for
// every instruction set, compiler and machine; a change of the engine's arithmetic changes them, and then
// `cairn_determinism_test --print-golden-hashes` prints the lines to put here.
#pragma once

#include <cstdint>

namespace cairn_test::golden {

inline constexpr std::uint64_t mixed_pile = 0x8a191727c8a4f9dc;
inline constexpr std::uint64_t pyramid = 0xcc44ecc828ffd6f9;
inline constexpr std::uint64_t dominoes = 0x26f2ed50239c042e;
inline constexpr std::uint64_t materials = 0x82e460346cf5b285;
inline constexpr std::uint64_t tumbler = 0x9675b28b316567fc;
inline constexpr std::uint64_t sleep_and_wake = 0xbccd28213e9e2a43;
inline constexpr std::uint64_t compounds = 0xa53910e67ca29647;
inline constexpr std::uint64_t free_tops = 0xbee2e2957f98eefe;
inline constexpr std::uint64_t explicit_euler = 0x14e9245ff2f0dcb7;
inline constexpr std::uint64_t whirl = 0x048c5c6a72db37b7;
inline constexpr std::uint64_t changes = 0x87f10e66958c2925;
inline constexpr std::uint64_t all_shapes = 0x55d3af84bd15652c;
inline constexpr std::uint64_t rounded_shapes = 0x2a68efaa7be81579;
inline constexpr std::uint64_t surfaces = 0x489212a303c278a5;
inline constexpr std::uint64_t all_joints = 0xd5ab026c103448c2;
inline constexpr std::uint64_t chains = 0x461b668176f89b0a;
inline constexpr std::uint64_t robots = 0xb1fd22b1175b5496;

} // namespace cairn_test::golden
