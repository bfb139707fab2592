// Jointed bodies that fall side by side without turning, as a ragdoll that was dropped: where nothing pulls at a joint
// there is nothing to solve, and each body moves as if it were free.
#include "joints/free_fall.h"

#include "bodies/integrators.h"
#include "islands/islands.h"
#include "state/state.h"

#include <algorithm>

namespace cairn {

namespace {

// What joints may have borne in the last pass, m/s^2: the rounding of their gaps. More shows in the velocities.
constexpr float least_bearing = 0.1f;
// m/s, of bodies against each other, and rad/s: what rounding leaves. Joints are solved again after `most_passes`, so
// that their anchors drift apart by some micrometers at most.
constexpr float least_drift = 1e-5f, least_turn = 2e-4f;
constexpr std::int32_t most_passes = 16;

float inverse_mass_of(const State& s, std::int32_t body) { return s.mass[std::size_t(body)].inverse_mass; }

// That its torque gives to points of the body, at most, m/s^2.
float torque_demand(const State& s, const JointInfo& joint, std::int32_t body) {
    const math::Vec3 i = s.mass[std::size_t(body)].inverse_inertia;
    return math::length(joint.torque) * std::max({i.x, i.y, i.z}) * s.bodies[std::size_t(body)].radius;
}

bool bears_nothing(const State& s, const JointInfo& joint) {
    float demand = 0;
    for (const std::int32_t body : {joint.body_a, joint.body_b}) {
        if (body == none || !s.is_dynamic(body)) return false; // that may be moved from outside
        demand += math::length(joint.force) * inverse_mass_of(s, body) + torque_demand(s, joint, body);
    }
    return demand < least_bearing;
}

// Whether a body, left to itself, stays beside another.
bool stays_beside(const State& s, std::int32_t body, std::int32_t other) {
    const BodyMotion &a = s.motion[std::size_t(body)], &b = s.motion[std::size_t(other)];
    const BodySettings &of_a = s.body_settings[std::size_t(body)], &of_b = s.body_settings[std::size_t(other)];
    const math::Vec3 dv = a.v - b.v;
    return math::dot(dv, dv) < least_drift * least_drift && math::dot(a.w, a.w) < least_turn * least_turn &&
           of_a.gravity_scale == of_b.gravity_scale && of_a.linear_damping == of_b.linear_damping &&
           (inverse_mass_of(s, body) > 0) == (inverse_mass_of(s, other) > 0) && !s.is_pushed(body);
}

} // namespace

void note_flight(const State& s, Island& island, const std::uint32_t* joints) {
    island.flight = 1;
    for (std::int32_t k = 0; k < island.joint_count; ++k) {
        if (s.direct.set_of_joint[joints[k]] == none && bears_nothing(s, s.joints[joints[k]])) continue;
        island.flight = 0;
        return;
    }
}

bool flies(const State& s, const Island& island, std::int32_t contacts) {
    if (island.flight == 0 || island.flight >= most_passes || contacts > 0 || any_field(s)) return false;
    for (std::int32_t b = island.first_body; b != none; b = s.bodies[std::size_t(b)].next_in_island)
        if (!stays_beside(s, b, island.first_body)) return false;
    return true;
}

void end_flight(State& s, std::int32_t body) {
    const std::int32_t island = s.bodies[std::size_t(body)].island;
    if (island != none) s.islands[std::size_t(island)].flight = 0;
}

} // namespace cairn
