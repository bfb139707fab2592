// What the test of a pair makes of its contact: record, events, islands, colors, sleep.
#pragma once

#include "bodies/motion_budget.h"
#include "contacts/contact_record.h"
#include "contacts/contexts.h"

#include <algorithm>

namespace cairn {

// What is to be done with a pair, and what testing it has said, beside its record.
enum Outcome : std::uint8_t {
    apart,          // and was so; or has not been tested, and need not be solved
    ended,          // apart, and was near
    begun,          // near, and was apart
    goes_on,        // near as before
    may_wake,       // likewise, with something asleep or moved from outside: to be looked at
    skipped,        // asleep
    tested_patches, // of a group
    entered,        // into a trigger
    left,           // out of it
    may_fly_by,     // to be settled by contacts/flight.h
    to_test,        // + PairKind
};

inline bool moves(const Bodies& bodies, std::int32_t body) {
    const BodyMotion& m = bodies.motion[body];
    return !(m.v == math::Vec3{} && m.w == math::Vec3{});
}

// How far apart two shapes may be to count: what the next step can close. Triggers do not look ahead.
inline float contact_margin(const Bodies& bodies, const NarrowScratch& narrow, const ContactInfo& c, float dt) {
    if (c.is_trigger) return 0;
    const BodyMotion &a = bodies.motion[c.body_a], &b = bodies.motion[c.body_b];
    return c.base_margin + dt * math::length(b.v - a.v) + (narrow.turn_reach[c.body_a] + narrow.turn_reach[c.body_b]);
}
// Of the points of a manifold that has any, m.
inline float least_separation(const Manifold& m) {
    float least = m.points[0][3];
    for (int i = 1; i < m.count; ++i) least = std::min(least, m.points[i][3]);
    return least;
}
// Whether there are no points, or points that are beyond where contacts begin do not come near each other in the next
// step either, as the bodies move now.
bool stays_apart(const Bodies& bodies, const Shapes& shapes, const ContactInfo& contact, const Manifold& manifold,
                 float dt);
// The greatest speed at which points of a manifold approach, m/s; negative if all part.
float approach_of(const Bodies& bodies, const Shapes& shapes, const ContactInfo& contact, const Manifold& manifold);
// One result of a test becomes the record of the contact; others may be at work on other contacts. An Outcome.
// `touch`: what the manifold is of, if it is not of the start of the step.
std::uint8_t take_manifold(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, const Islands& islands,
                           std::uint32_t contact, const Manifold& manifold, const Touch* touch = nullptr);
// Likewise of a pair that has no points, or stays apart.
std::uint8_t take_apart(const Bodies& bodies, Contacts& contacts, std::uint32_t contact, const Manifold& manifold);
// Likewise of a pair that is found apart, by so many meters at least if that is known.
std::uint8_t take_distance(const Bodies& bodies, Contacts& contacts, std::uint32_t contact, float distance);
std::uint8_t trigger_outcome(const ContactInfo& contact, bool inside);
// Of a contact whose record was written in this step, and which had no points before.
BegunContact how_it_begins(const Contacts& contacts, std::uint32_t contact, float dt);
// What changes more than the contact itself: islands, colors, sleep. One after the other, in order.
void follow_up(const FollowUpContext& context, std::uint32_t contact, std::uint8_t outcome, float dt);
// Colors for the contacts that follow_up let begin and that have not ended since, in an order that an island has of
// itself, whatever else is in the world, and that prefers no direction: docs/decisions/colors.md.
void color_begun(Bodies& bodies, Contacts& contacts, NarrowScratch& narrow);

// A contact is no longer solved: an end event if it touched, and its island may fall apart.
void end_contact(Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands, StepEvents& events,
                 std::uint32_t contact);

// Of the points of a record, the greatest speed at which they approach.
float approach_speed(const Bodies& bodies, const ContactInfo& contact, const ContactRecord& record);

// Where a contact that begins to touch does so, for hit events.
TouchPoint touch_point_of(const Contacts& contacts, std::uint32_t contact);

// After the solver: begin, end and hit events, sustained loads. Returns the deepest overlap, m.
float report_contacts(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, Islands& islands,
                      StepEvents& events, const WorldDef& settings, const SolverScratch& solver, NarrowScratch& narrow,
                      ThreadPool& thread_pool, Communicator* ranks, float dt);

inline bool is_asleep(const Bodies& bodies, const Islands& islands, const ContactInfo& c) {
    return !is_awake(bodies, islands, c.body_a) || (c.b_moves && !is_awake(bodies, islands, c.body_b));
}
// The outcome of a contact that stays.
inline std::uint8_t going_on(const Bodies& bodies, const Islands& islands, const ContactInfo& c) {
    return is_asleep(bodies, islands, c) || (!c.b_moves && moves(bodies, c.body_b)) ? may_wake : goes_on;
}
// The start of the step.
inline Moment moment_of_start(const Bodies& bodies, const Shapes& shapes, const ContactInfo& c) {
    return {0, shapes.links[c.flipped ? c.shape_b : c.shape_a].arm,
            math::to_float(bodies.motion[c.body_a].x - bodies.motion[c.body_b].x), &shapes.poses[c.shape_a],
            &shapes.poses[c.shape_b]};
}
// What take_manifold does with points that are solved: nothing more is asked of the manifold.
inline std::uint8_t take_points(const Bodies& bodies, const Shapes& shapes, Contacts& contacts, const Islands& islands,
                                std::uint32_t id, const Manifold& m, const Moment& at) {
    ContactInfo& c = contacts.info[id];
    ContactRecord& r = contacts.records[id];
    const bool is_new = c.point_count == 0;
    write_record(shapes, c, r, m, at);
    if (!c.touching) r.approach_speed = approach_speed(bodies, c, r);
    return is_new ? std::uint8_t(begun) : going_on(bodies, islands, c);
}

} // namespace cairn
