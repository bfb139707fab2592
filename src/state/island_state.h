// What is known of islands.
#pragma once

#include "state/body_state.h"
#include "state/none.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace cairn {

struct Island {
    std::int32_t first_body = none, last_body = none;
    std::int32_t body_count = 0;
    std::int32_t position = none; // in Islands::awake; none: asleep
    std::int32_t key = none;      // of its tree in the broad phase, if that holds it as sleeping
    std::uint8_t in_use = 0;
    std::uint8_t lost_contact = 0; // may have fallen into parts
    std::uint8_t kept_awake = 0;   // touches something that moves by itself
    std::uint8_t padding = 0;
    std::int32_t substeps = 0;           // in the last step
    std::int32_t joint_count = 0;        // that belong to its bodies
    float weight = 0, greatest_load = 0; // N: of all bodies; on one contact
    float greatest_demand = 0;           // m/s^2: load over the reduced mass of the contact that carries it
    float least_stable_sinking = 1;      // m: see slenderness.h
    float pull_by_width = 0;             // 1/s^2: of gravity and fields, over the mean width of its bodies
    float agitation = 0;                 // m/s: root of the mean square of the speeds about that of the whole
    float min_quiet_time = 0, greatest_quiet_time = 0;
};

// As BodyLinks::quiet_time: the body was told to sleep, and nothing has moved it since then.
inline constexpr float told_to_sleep = std::numeric_limits<float>::max();

struct Islands {
    std::vector<Island> all;
    std::vector<std::int32_t> free; // those that are not in use
    std::vector<std::int32_t> awake;
    std::vector<std::int32_t> falling_asleep; // islands that the broad phase still holds as awake
    std::vector<std::int32_t> waking;         // keys that it still holds as sleeping
    std::vector<std::int32_t> told;           // bodies that were told to sleep since the last step
};

inline bool is_awake(const Bodies& bodies, const Islands& islands, std::int32_t body) {
    const std::int32_t island = bodies.links[body].island;
    return island != none && islands.all[island].position != none;
}

// Whether a dynamic body moves by itself in this step when something strikes it. What sleeps on something does so in
// the next one, by the solver.
inline bool is_on_its_own(const Bodies& bodies, const Islands& islands, std::int32_t body) {
    return is_awake(bodies, islands, body) || bodies.links[body].contact_count == 0;
}

} // namespace cairn
