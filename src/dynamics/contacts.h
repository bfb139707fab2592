// From pairs of bounds to contact records: who touches whom, where, and with which impulses to begin.
#pragma once

#include "collision/contact_memory.h"
#include "dynamics/state.h"

#include <optional>

namespace cairn {

// Runs the broad phase; creates contacts for new pairs, destroys those of pairs that ended.
void update_pairs(State& state);

// The narrow phase: tests all pairs that may have moved, writes their records, begins and ends contacts in the
// islands and colors, wakes what is hit, and lists in State::solved what the solver has to do.
void update_contacts(State& state, float dt);

// After the solver: begin, end and hit events, sustained loads, counts.
void report_contacts(State& state, float dt);

// --- one contact (contact_points.cpp)

// Arm and separation of a point; its normal impulse summed over the last step's substeps.
inline const float* point_of(const ContactRecord& r, int i) { return i == 0 ? r.first_point : r.more_points[i - 1]; }
inline float* point_of(ContactRecord& r, int i) { return i == 0 ? r.first_point : r.more_points[i - 1]; }
inline float total_of(const ContactRecord& r, int i) { return i == 0 ? r.first_total : r.more_totals[i - 1]; }

// Writes the record of a contact from the kernel's manifold, which has points. Impulses go on where points stay.
void write_record(State& state, std::uint32_t contact, const Manifold& manifold);
// Of the points of a contact that has some.
float least_separation(const ContactInfo& contact, const ContactRecord& record);
// Notes the least gap of its points: what bears nothing is told apart without a look at its record.
void note_gap(ContactInfo& contact, const ContactRecord& record);
// The least gap as it was noted, rounded down; 0 where they overlap.
float noted_gap(const ContactInfo& contact);
// `count`: how many points it has.
void forget_impulses(ContactRecord& record, int count);
// Moves a record that was written at the start of the last step to the poses at its end.
void advance_record(const State& state, const ContactInfo& contact, ContactRecord& record);
// That of a contact, so moved.
ContactRecord advanced_record(const State& state, std::uint32_t contact);

// Coefficients of the two materials together, by the rules of KHR_physics_rigid_bodies.
void combine_materials(State& state, std::uint32_t contact);

// How the two are tested; nothing for two surfaces. `swapped`: b is the first shape of the test.
std::optional<PairKind> pair_kind(const Geometry& a, const Geometry& b, bool& swapped);
CollideKernel wide_kernel(PairKind kind);

// An empty contact, in use; and its end.
std::uint32_t new_contact(State& state);
void free_contact(State& state, std::uint32_t contact);

// Pairs of shapes that no wide kernel tests (convex_tests.cpp), with points up to `margin` meters apart. `guess`: the
// normal of the last step, or zero; `memory`: see collide_convex.
struct PosedShape {
    const Geometry& geometry;
    const ShapeData& data;
    const ShapePose& pose;
    math::Vec3 arm; // from the body's center of mass to the shape's origin
};
Manifold test_convex_pair(PairKind kind, const PosedShape& a, const PosedShape& b, math::Vec3 guess, float margin,
                          ContactMemory& memory);
// All directions in which the convex shape `a` touches a mesh or height field, deepest first; `hits` is emptied before.
// Where there are none, returns how far apart they are at least; nothing farther than `reach` is looked at.
float find_patches(const PosedShape& a, const PosedShape& surface, float margin, float reach, SurfaceScratch& scratch,
                   std::vector<Manifold>& hits);

inline PosedShape posed_shape(const State& s, std::uint32_t shape) {
    return {s.geometry[shape], s.shape_data[shape], s.shape_poses[shape], s.shapes[shape].arm};
}

// --- the tests of a step (contacts.cpp)

// What is to be done with a pair, and what testing it has said, beside its record.
enum Outcome : std::uint8_t {
    apart,    // and was so; or has not been tested, and need not be solved
    ended,    // apart, and was near
    begun,    // near, and was apart
    goes_on,  // near as before
    may_wake, // likewise, with something asleep or moved from outside: to be looked at
    skipped,  // asleep
    entered,  // into a trigger
    left,     // out of it
    to_move,  // along with the bodies
    to_test,  // + PairKind
};

// Asks the cache for what the test of a pair of convex shapes, or of one with a surface, begins with.
void prefetch_pair(const State& state, std::uint32_t contact);
void prefetch_record(const State& state, std::uint32_t contact, std::size_t size = sizeof(ContactRecord));
// Likewise for the patch number n of a group, which is found along those before it: each is asked for somewhat later
// than the one before. Nothing for contacts that are no groups.
inline constexpr int patches_at_hand = 3;
inline constexpr std::size_t patch_ahead(int n) { return std::size_t(2 * (patches_at_hand - n)); }
void prefetch_patch(const State& state, std::uint32_t contact, int n, bool with_record);
// How far apart two shapes may be to count: what the next step can close.
float contact_margin(const State& state, const ContactInfo& contact, float dt);
// Whether points that are beyond where contacts begin do not come near each other in the next step either, as the
// bodies move now.
bool stays_apart(const State& state, const ContactInfo& contact, const Manifold& manifold, float dt);
// One result of a test becomes the record of the contact; others may be at work on other contacts. An Outcome.
std::uint8_t take_manifold(State& state, std::uint32_t contact, const Manifold& manifold, float dt);
// Likewise of a pair that is found apart, by so many meters at least if that is known.
std::uint8_t take_distance(State& state, std::uint32_t contact, float distance);
std::uint8_t trigger_outcome(const ContactInfo& contact, bool inside);
// What changes more than the contact itself: islands, colors, sleep. One after the other, in order.
void follow_up(State& state, std::uint32_t contact, std::uint8_t outcome, float dt);

// --- groups (patches.cpp)

// f(contact) for the patches of a group, or for the contact itself if it is none. f may free the contact.
template <class F> void for_each_patch(const State& s, std::uint32_t id, F&& f) {
    if (!is_group(s.contacts[id])) {
        f(id);
        return;
    }
    for (std::int32_t p = s.contacts[id].related; p != none;) {
        const std::int32_t next = s.contacts[std::size_t(p)].next;
        f(std::uint32_t(p));
        p = next;
    }
}

void begin_groups(State& state);
// Tests groups, by their places in the list of groups. Others may be at work on other groups.
void test_groups(State& state, int begin, int end, NarrowBatch& own, float dt);
// Puts the patches that threads have found in the order of the groups.
void collect_fresh_patches(State& state);
// The group at that place among the candidates.
void follow_up_group(State& state, std::uint32_t place, float dt);
// Ends a patch, and takes it out of its group.
void end_patch(State& state, std::uint32_t patch);

// --- seams (seams.cpp)

// A body that slides over several surfaces side by side must not bump into the edges between them: takes out of
// State::solved what is an edge of one in the plane of another.
void drop_seams(State& state);

} // namespace cairn
