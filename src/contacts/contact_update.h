// Updates a contact by the result of its pair's test: record, events, islands, graph colors, sleep.
#pragma once

#include "bodies/motion_budget.h"
#include "contacts/contact_record.h"
#include "contacts/contexts.h"

#include <algorithm>

namespace cairn {

// The action for a pair, or the result of its test, besides the contact record.
enum Outcome : std::uint8_t {
    apart,                 // separated as before; or not tested, with no need to solve it
    ended,                 // separated now, was near
    begun,                 // near now, was separated
    persists,              // near as before
    may_wake,              // near as before, but a body sleeps or B is kinematic and moves: follow_up must look at it
    skipped,               // the bodies sleep
    tested_patches,        // of a mesh contact
    entered,               // a shape has entered a trigger
    left,                  // a shape has left a trigger
    may_be_in_free_flight, // may meet in free flight: contacts/flight.h decides
    to_test,               // + PairKind
};

inline bool moves(const Bodies& bodies, std::int32_t body) {
    const BodyMotion& m = bodies.motion[body];
    return !(m.v == math::Vec3{} && m.w == math::Vec3{});
}

// The separation up to which a pair has contact points, m: what the next step can close. Triggers have no such margin.
inline float contact_margin(const NarrowScratch& narrow, const ContactInfo& c, float dt) {
    if (c.is_trigger) return 0;
    const MotionAhead &a = narrow.motion_ahead[std::size_t(c.body_a)], &b = narrow.motion_ahead[std::size_t(c.body_b)];
    return c.base_margin + dt * math::length(b.v - a.v) + (a.rotation_bound + b.rotation_bound);
}
// The smallest separation of a manifold that has points, m.
inline float least_separation(const Manifold& m) {
    float least = m.points[0][3];
    for (int i = 1; i < m.count; ++i) least = std::min(least, m.points[i][3]);
    return least;
}
// Whether a pair stays separated: its manifold has no points, or all points are beyond the margin of the contact and,
// at the present velocities, do not come near each other in the next step either.
bool stays_apart(const Bodies& bodies, const Shapes& shapes, const ContactInfo& contact, const Manifold& manifold,
                 float dt);
// The greatest approach speed of the points of a manifold, m/s; negative if all of them separate.
float approach_of(const Bodies& bodies, const Shapes& shapes, const ContactInfo& contact, const Manifold& manifold);
// Turns the manifold of a pair into its contact record, and returns an Outcome. Other threads may update other contacts
// meanwhile. `touch`: the moment of the manifold, if that is not the start of the step.
std::uint8_t take_manifold(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, const Islands& islands,
                           std::uint32_t contact, const Manifold& manifold, const Touch* touch = nullptr);
// The same for a pair that has no points or stays separated.
std::uint8_t take_apart(const Bodies& bodies, Contacts& contacts, std::uint32_t contact, const Manifold& manifold);
// The same for a pair that is found separated, by at least `distance` meters if that is known.
std::uint8_t take_distance(const Bodies& bodies, Contacts& contacts, std::uint32_t contact, float distance);
std::uint8_t trigger_outcome(const ContactInfo& contact, bool inside);
// How a contact begins whose record was written in this step and that had no points before.
BegunContact how_it_begins(const Contacts& contacts, std::uint32_t contact, float dt);
// Applies an outcome to what contacts share: islands, graph colors, sleep. Called for one contact after the other, in
// order.
void follow_up(const FollowUpContext& context, std::uint32_t contact, std::uint8_t outcome, float dt);
// Assigns graph colors to the contacts that follow_up has begun and that have not ended since. Their order depends on
// the island alone, not on the rest of the world, and prefers no direction: docs/decisions/colors.md.
void color_begun(Bodies& bodies, Contacts& contacts, NarrowScratch& narrow);

// Takes a contact out of the solver: gives an end event if it touched, and marks its island as one that may split.
void end_contact(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands, StepEvents& events,
                 std::uint32_t contact);

// The greatest approach speed of the points of a record, m/s; 0 if all of them separate.
float approach_speed(const Bodies& bodies, const ContactInfo& contact, const ContactRecord& record);

// Where a contact that begins to touch does so, for hit events.
TouchPoint touch_point_of(const Contacts& contacts, std::uint32_t contact);

// After the solver: gives begin, end and hit events, and updates sustained loads. Returns the deepest penetration, m.
float report_contacts(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands,
                      StepEvents& events, const WorldDef& settings, const SolverScratch& solver, NarrowScratch& narrow,
                      ThreadPool& thread_pool, Communicator* ranks, float dt);

inline bool is_asleep(const Bodies& bodies, const Islands& islands, const ContactInfo& c) {
    return !is_awake(bodies, islands, c.body_a) || (c.b_moves && !is_awake(bodies, islands, c.body_b));
}
// The outcome of a contact that still has points.
inline std::uint8_t persisting_outcome(const Bodies& bodies, const Islands& islands, const ContactInfo& c) {
    return is_asleep(bodies, islands, c) || (!c.b_moves && moves(bodies, c.body_b)) ? may_wake : persists;
}
// The moment of a manifold that was found at the start of the step.
inline Moment moment_of_start(const Bodies& bodies, const Shapes& shapes, const ContactInfo& c) {
    return {0, shapes.links[c.flipped ? c.shape_b : c.shape_a].arm,
            math::to_float(bodies.motion[c.body_a].x - bodies.motion[c.body_b].x), &shapes.poses[c.shape_a],
            &shapes.poses[c.shape_b]};
}
// The part of take_manifold for points that are solved: it writes the record without further checks of the manifold.
inline std::uint8_t take_points(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, const Islands& islands,
                                std::uint32_t id, const Manifold& m, const Moment& at) {
    ContactInfo& c = contacts.info[id];
    ContactRecord& r = contacts.records[id];
    const bool is_new = c.point_count == 0;
    write_record(shapes, c, r, m, at);
    if (!c.touching) r.approach_speed = approach_speed(bodies, c, r);
    return is_new ? std::uint8_t(begun) : persisting_outcome(bodies, islands, c);
}

} // namespace cairn
