// Calls of the C API that are not generated from the table, or are slow, with arguments from bytes.
#pragma once

#include "c_api_calls.h"

namespace cairn_fuzz {

// The state of a sequence of calls.
struct CState {
    explicit CState(std::span<const std::uint8_t> data);
    ~CState();
    CState(const CState&) = delete;

    CBytes bytes;
    std::array<cairn_world*, 2> worlds{};
    std::vector<cairn_snapshot*> snapshots; // of both worlds, and of those that were replaced
    int second_worlds = 0;                  // number of worlds that have been in the second place
    int steps = 0, scenes = 0, threads = 0; // counters of calls that take long
};

struct ByHand {
    CCallInfo info;
    cairn_result (*call)(CState& state, cairn_world* world);
};
extern const std::span<const ByHand> calls_by_hand;

} // namespace cairn_fuzz
