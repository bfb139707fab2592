// How far bodies have moved, and so which earlier findings about them still hold: which pairs are still separated,
// whose contact points have moved only little, which fat boxes of the broad phase still contain their shapes.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <algorithm>
#include <cmath>

namespace cairn {

// At the start of a step: adds the motion of awake and kinematic bodies to their travel, and predicts from their
// velocities what it will be after the step.
void count_motion(Bodies& bodies, const Islands& islands, const WorldDef& settings, NarrowScratch& narrow,
                  ThreadPool& thread_pool, float dt);

// Invalidates all that is known about a body that has been changed or teleported.
void spend_budget(Bodies& bodies, std::int32_t body);
// Invalidates what is known about a body that has moved by its velocities: its motion since the last count still
// counts.
void spend_separations(Bodies& bodies, std::int32_t body);

// The squared distance between two unit quaternions.
inline double square_difference(const math::DQuat& p, const math::DQuat& q) {
    return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y) + (q.z - p.z) * (q.z - p.z) +
           (q.w - p.w) * (q.w - p.w);
}

// How far any point of a body is at most from the pose up to which its travel is counted, m. Unit quaternions at a
// distance d differ by an angle of 4 asin(d / 2), which is at most 2.1 d up to d = 1, and never more than pi d.
inline double uncounted(const CountedPose& counted, const BodyMotion& motion, float radius) {
    constexpr double pi = 3.14159265358979;
    const double d = std::sqrt(square_difference(counted.q, motion.q));
    return math::length(motion.x - counted.x) + (d < 1 ? 2.1 : pi) * d * double(radius);
}

// Whether the body is a ball about its center of mass, so that no rotation displaces its surface.
inline bool turns_on_the_spot(const BodyLinks& links) { return !(links.radius > links.inner_radius); }

// The sum of the travels of a pair's bodies.
inline Travel travel_of(const Bodies& bodies, const ContactInfo& c) {
    return bodies.travel[c.body_a] + bodies.travel[c.body_b];
}

// Whether no body of the pair has moved by more than a small part of a micrometer since the pair was tested.
inline bool is_placed(const Bodies& bodies, const ContactInfo& c) { return c.placed_at == travel_of(bodies, c); }

// How far bodies may move after their contacts were found before these are tested again, as a share of their radius; at
// most half of the speculative margin. Contact points that the solver moves along keep their normal, with an error of
// second order, a shift of a millimeter times a rotation of three thousandths; and vertices that approach are found at
// latest when they are that much nearer. Without this, capsules, terrain and convex take 1.71, 1.60 and 1.43 times as
// long (bench scenes).
inline constexpr double nearness = 3e-3;

// For a pair with contact points: whether its bodies are still so near to the poses of the test that the points, which
// the solver moves along, remain valid.
inline bool is_near(const Bodies& bodies, const Contacts& contacts, std::uint32_t id) {
    const ContactInfo& c = contacts.info[id];
    float radius = bodies.links[c.body_a].radius;
    if (c.b_moves) radius = std::min(radius, bodies.links[c.body_b].radius);
    return !is_before(contacts.separation_budgets[id].until +
                          budget_of(std::min(nearness * double(radius), 0.5 * max_margin)),
                      travel_of(bodies, c));
}

// Whether the pair was found so far apart that it cannot touch in this step. `ahead`: Bodies::ahead.
inline bool stays_apart(const Travel* ahead, const SeparationBudget& answer) {
    return is_before(ahead[answer.body_a] + ahead[answer.body_b], answer.until);
}

// Records that the pair has just been tested, and stays separated until its bodies have moved by `length`, m, together;
// 0: it is not separated.
inline void keep_separation(const Bodies& bodies, Contacts& contacts, std::uint32_t id, double length) {
    contacts.info[id].placed_at = travel_of(bodies, contacts.info[id]);
    contacts.separation_budgets[id].until = contacts.info[id].placed_at + budget_of(length);
}
// Marks a pair whose contact points the solver does not move along: it is tested again once a body has moved.
inline void stay_unsolved(const Bodies& bodies, Contacts& contacts, std::uint32_t id) {
    contacts.separation_budgets[id].until = travel_of(bodies, contacts.info[id]) - budget_of(max_margin);
}
// Forces a new test of the pair in the next step.
inline void forget_separation(const Bodies& bodies, Contacts& contacts, std::uint32_t id) {
    contacts.separation_budgets[id].until = contacts.info[id].placed_at = travel_of(bodies, contacts.info[id]) - 1;
}

} // namespace cairn
