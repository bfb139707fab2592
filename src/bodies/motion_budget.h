// How far bodies have moved, and so what is still known about them: which pairs are still apart, whose contact points
// have moved along but little, which boxes of the broad phase still hold their shapes.
#pragma once

#include "state/state.h"
#include "state/step_scratch.h"

#include <algorithm>
#include <cmath>

namespace cairn {

// At the start of a step: counts how far awake and kinematic bodies have moved, and how far they will have after it, by
// their velocities.
void count_motion(Bodies& bodies, const Islands& islands, const WorldDef& settings, NarrowScratch& narrow,
                  ThreadPool& thread_pool, float dt);

// The body has been changed or put elsewhere: nothing that was found out about it holds.
void spend_budget(Bodies& bodies, std::int32_t body);
// What was found out about it does not hold, but it has come by its own way: that is still looked at.
void spend_answers(Bodies& bodies, std::int32_t body);

// Of two unit quaternions: the square of how far they are apart.
inline double square_difference(const math::DQuat& p, const math::DQuat& q) {
    return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y) + (q.z - p.z) * (q.z - p.z) +
           (q.w - p.w) * (q.w - p.w);
}

// How far any point of a body is from the pose up to which its travel is counted, m, at most. Unit quaternions that are
// d apart differ by an angle of 4 asin(d / 2), which is not more than 2.1 d up to d = 1, and never more than pi d.
inline double uncounted(const CountedPose& counted, const BodyMotion& motion, float radius) {
    constexpr double pi = 3.14159265358979;
    const double d = std::sqrt(square_difference(counted.q, motion.q));
    return math::length(motion.x - counted.x) + (d < 1 ? 2.1 : pi) * d * double(radius);
}

// A ball about its center of mass: no turn brings its surface anywhere.
inline bool turns_on_the_spot(const BodyLinks& links) { return !(links.radius > links.inner_radius); }

// Of the bodies of a pair together.
inline Travel travel_of(const Bodies& bodies, const ContactInfo& c) {
    return bodies.travel[c.body_a] + bodies.travel[c.body_b];
}

// The pair was tested, and no body has moved since by more than a small part of a micrometer.
inline bool is_placed(const Bodies& bodies, const ContactInfo& c) { return c.placed_at == travel_of(bodies, c); }

// How far bodies may move after their contacts were found, as a share of their radius, but no more than half of the
// margin of contacts. Points that go along keep their normal: what they miss is of second order, a shift of a
// millimeter times a turn of three thousandths; and corners that come near are found at latest when they are that much
// nearer. Without this, capsules, terrain and convex take 1.71, 1.60 and 1.43 times as long (bench scenes).
inline constexpr double nearness = 3e-3;

// A pair with points: whether its bodies are still so near to where it was tested that its points, which the solver
// moves along, hold.
inline bool is_near(const Bodies& bodies, const Contacts& contacts, std::uint32_t id) {
    const ContactInfo& c = contacts.info[id];
    float radius = bodies.links[c.body_a].radius;
    if (c.b_moves) radius = std::min(radius, bodies.links[c.body_b].radius);
    return !is_before(contacts.answers[id].until + budget_of(std::min(nearness * double(radius), 0.5 * max_margin)),
                      travel_of(bodies, c));
}

// The pair was found so far apart that it cannot come near in this step. `ahead`: Bodies::ahead.
inline bool stays_apart(const Travel* ahead, const PairAnswer& answer) {
    return is_before(ahead[answer.body_a] + ahead[answer.body_b], answer.until);
}

// The pair was tested just now, and found to stay apart until its bodies have moved by that length, m; 0: no such
// thing.
inline void keep_answer(const Bodies& bodies, Contacts& contacts, std::uint32_t id, double length) {
    contacts.info[id].placed_at = travel_of(bodies, contacts.info[id]);
    contacts.answers[id].until = contacts.info[id].placed_at + budget_of(length);
}
// The solver does not move its points along: it is tested once a body has moved.
inline void stay_behind(const Bodies& bodies, Contacts& contacts, std::uint32_t id) {
    contacts.answers[id].until = travel_of(bodies, contacts.info[id]) - budget_of(max_margin);
}
// It is not worth keeping.
inline void drop_answer(const Bodies& bodies, Contacts& contacts, std::uint32_t id) {
    contacts.answers[id].until = contacts.info[id].placed_at = travel_of(bodies, contacts.info[id]) - 1;
}

} // namespace cairn
