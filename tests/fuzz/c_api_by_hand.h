// The calls of the C API that are not made from the table, or take long, with arguments out of bytes.
#pragma once

#include "c_api_calls.h"

namespace cairn_fuzz {

// What a sequence of calls works with.
struct CState {
    explicit CState(std::span<const std::uint8_t> data);
    ~CState();
    CState(const CState&) = delete;

    CBytes bytes;
    std::array<cairn_world*, 2> worlds{};
    std::vector<cairn_snapshot*> snapshots; // of both, and of what was in their place
    int second_worlds = 0;                  // that there have been
    int steps = 0, scenes = 0, threads = 0; // so far: these take long
};

struct ByHand {
    CCallInfo info;
    cairn_result (*call)(CState& state, cairn_world* world);
};
extern const std::span<const ByHand> calls_by_hand;

} // namespace cairn_fuzz
