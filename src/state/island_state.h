// The state of islands.
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
    std::uint8_t lost_contact = 0; // a contact was lost, so the island may be split
    std::uint8_t kept_awake = 0;   // touches a moving kinematic body, or was woken in this step
    std::uint8_t padding = 0;
    std::int32_t substeps = 0;           // in the last step
    std::int32_t joint_count = 0;        // joints that belong to its bodies
    float weight = 0, greatest_load = 0; // N: of all bodies; greatest on one contact
    float greatest_demand = 0;           // m/s^2: greatest ratio of load to reduced mass of a contact
    float min_buckling_penetration = 1;  // m: see slenderness.h
    float pull_by_width = 0;             // 1/s^2: acceleration by gravity and fields / mean width of its bodies
    float agitation = 0;                 // m/s: rms speed of its bodies relative to their common motion
    float min_quiet_time = 0, greatest_quiet_time = 0;
};

// Value of BodyLinks::quiet_time for a body that was told to sleep and that nothing has moved since.
inline constexpr float sleep_requested = std::numeric_limits<float>::max();

struct Islands {
    std::vector<Island> all;
    std::vector<std::int32_t> free; // unused islands
    std::vector<std::int32_t> awake;
    std::vector<std::int32_t> falling_asleep; // islands that the broad phase still holds as awake
    std::vector<std::int32_t> waking;         // keys of awake islands that the broad phase still holds as sleeping
    std::vector<std::int32_t> sleep_requests; // bodies that were told to sleep since the last step
};

inline bool is_awake(const Bodies& bodies, const Islands& islands, std::int32_t body) {
    const std::int32_t island = bodies.links[body].island;
    return island != none && islands.all[island].position != none;
}

// Whether a dynamic body can respond to an impact in this step on its own. A sleeping body that has contacts responds
// in the next step, by the solver.
inline bool is_on_its_own(const Bodies& bodies, const Islands& islands, std::int32_t body) {
    return is_awake(bodies, islands, body) || bodies.links[body].contact_count == 0;
}

} // namespace cairn
