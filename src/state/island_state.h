// What is known of an island.
#pragma once

#include "state/none.h"

#include <cstdint>

namespace cairn {

inline constexpr float unknown_demand = 1e5f; // high: what joints bear is not known before they are solved
struct Island {
    std::int32_t first_body = none, last_body = none;
    std::int32_t body_count = 0;
    std::int32_t position = none; // in State::awake_islands; none: asleep
    std::int32_t key = none;      // of its tree in the broad phase, if that holds it as sleeping
    std::uint8_t in_use = 0;
    std::uint8_t lost_contact = 0; // may have fallen into parts
    std::uint8_t kept_awake = 0;   // touches something that moves by itself
    std::uint8_t padding = 0;
    std::int32_t substeps = 0;           // in the last step
    std::int32_t wanted_substeps = 0;    // by what it carries (substeps.cpp)
    std::int32_t joint_count = 0;        // that belong to its bodies
    float weight = 0, greatest_load = 0; // N: of all bodies; on one contact
    float greatest_demand = 0;           // m/s^2: load over the reduced mass of the contact that carries it
    float unrest = 0;                    // m/s: mean square of the speeds about that of the whole, its root
    float joint_demand = unknown_demand; // m/s^2: mean square of the joints' forces over the masses, its root
    std::int32_t joint_substeps = 0;     // that its joints ask for in motion
    std::int32_t rest_substeps = 0;      // of a heap at rest; 0: it is none
    std::int32_t was_tossed = 0;         // 1: it is a heap that was stirred up
    float least_quiet_time = 0, greatest_quiet_time = 0;
};

} // namespace cairn
