// Which bodies have not moved, and so which pairs need not be tested again. In a heap that has come to rest without
// sleeping, finding contacts anew would cost a quarter of the step and change nothing.
#pragma once

#include "state/state.h"

#include <cmath>

namespace cairn {

// Notes, at the start of a pass, which awake and kinematic bodies have left the pose they rested in or are about to,
// and which ones whirl.
void update_resting(State& state, float dt);

// The greatest angular speed of a body that turns by more than a radian in the step, has unequal moments of inertia and
// touches something; 0 if none does. The inertia and the arms of its contacts are then wrong before the step ends, and
// would give it energy without end. Not of bodies in joints: their inertia is renewed in each substep, and a hand that
// whirls in a heap of ragdolls would have all contacts of the world found anew.
float whirl_in_contact(const State& state);

// Of two unit quaternions: the square of how far they are apart.
inline double square_difference(const math::DQuat& p, const math::DQuat& q) {
    return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y) + (q.z - p.z) * (q.z - p.z) +
           (q.w - p.w) * (q.w - p.w);
}

// How far any point of a body is from where it was in that pose, at most. Unit quaternions that are d apart differ by
// an angle of 4 asin(d / 2), which is not more than pi d.
inline double way_from(const RestingPose& pose, const BodyMotion& motion, float radius) {
    constexpr double pi = 3.14159265358979;
    return math::length(motion.x - pose.x) + pi * std::sqrt(square_difference(pose.q, motion.q)) * double(radius);
}

// Neither body has moved by more than a small part of a micrometer (rest.cpp) since the pair was tested.
inline bool is_tested(const State& state, const ContactInfo& c) {
    return c.tested_at >= state.left_at[c.body_a] && c.tested_at >= state.left_at[c.body_b];
}

// Both bodies are nearly where they were when the pair was tested (rest.cpp): its points may be moved along with them.
inline bool is_near(const State& s, const ContactInfo& c) {
    return c.tested_at >= s.strayed_at[c.body_a] && c.tested_at >= s.strayed_at[c.body_b];
}

// The pair was found so far apart that it cannot come near in this pass. (`until` is 0 if it was not: no way is less.)
// `ahead`: State::ahead.
inline bool stays_apart(const double* ahead, const ApartPair& pair) {
    return ahead[pair.body_a] + ahead[pair.body_b] < pair.until;
}

// Adds to the way of a body how far it is from its resting pose, which then is the pose it has. update_resting does so
// for all that move; to be called for a static body that is put elsewhere.
void count_way(State& state, std::int32_t body);

} // namespace cairn
