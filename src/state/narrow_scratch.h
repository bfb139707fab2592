// Working memory of the narrow phase. Buffers keep their capacity, so that a steady step allocates nothing.
#pragma once

#include "collision/manifold.h"
#include "collision/surface_contact.h"
#include "core/key_tree.h"
#include "core/room.h"
#include "jobs/ordered_list.h"
#include "state/contact_state.h"
#include "state/touch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

// Contacts lie scattered: so many before one is looked at, the cache is asked for it.
inline constexpr std::size_t contacts_ahead = 8;

// Pairs on their way through a kernel.
struct PairBatch {
    static constexpr int capacity = 256;
    std::uint32_t first[capacity], second[capacity];
    float margin[capacity];
    std::uint32_t kept[capacity]; // features of the last step, for box_box alone
};

// A patch that a group did not have, found at this place among the candidates.
struct FreshPatch {
    std::uint32_t place, order; // order: among those of the place
    Manifold manifold;
    bool is_ahead; // the manifold is of the touch
    Touch touch;
};

// In the order in which they are followed up.
inline bool comes_before(const FreshPatch& a, const FreshPatch& b) {
    return a.place != b.place ? a.place < b.place : a.order < b.order;
}

// What is asked of the record of a contact that begins.
struct BegunContact {
    math::Vec3 normal;
    bool passes_by; // as its bodies move, it will not touch within the step
};

// A contact that gets its color once all that the step ends have given back theirs.
struct Uncolored {
    std::uint64_t key; // the shapes of A and B; then the place in the order of colors
    std::int32_t island;
    std::uint32_t order; // in which they began
    std::uint32_t contact;
};

// What is asked of the record of a contact that begins to touch.
struct TouchPoint {
    std::uint32_t contact;
    float approach_speed;
    math::Vec3 normal, arm; // arm: of the deepest point, from the center of mass of A
};

// A pair that may meet in flight (contacts/flight.h), at this place among the candidates, and what its test has found.
struct FlightPair {
    std::uint32_t place;
    bool is_free;                       // nothing holds its bodies
    std::uint32_t first_hit, hit_count; // in a list of manifolds: one, of a group none
};
struct FlightPairs {
    std::vector<FlightPair> pairs;
    std::vector<Manifold> hits;

    void clear() {
        give_back_room(pairs), give_back_room(hits);
        pairs.clear(), hits.clear();
    }
    void add(std::uint32_t place, const Manifold* first, std::size_t count) {
        pairs.push_back({place, false, std::uint32_t(hits.size()), std::uint32_t(count)});
        hits.insert(hits.end(), first, first + count);
    }
};

// What a thread has at work.
struct NarrowBatch {
    PairBatch pairs;
    std::vector<std::uint32_t> midway, at_start; // of the pairs, by when they are tested: places among the candidates
    ShapePose poses[2 * PairBatch::capacity];    // in the middle of the step, of both of each
    Manifold manifolds[PairBatch::capacity];
    SurfaceScratch surface;
    std::vector<Manifold> hits;          // of one group
    SurfaceScratch surface_at_touch;     // of one of its patches
    std::vector<Manifold> hits_at_touch; // there
    std::vector<std::uint32_t> matched;  // of the patches of a group in the middle of the step, which each of `hits` is
    std::vector<std::uint32_t> triangles;
    std::vector<FreshPatch> fresh; // of the groups of this thread
    FlightPairs flights;
};

using KindCounts = std::array<std::uint32_t, std::size_t(tested_kinds)>; // by PairKind

// A contact with what does not move by forces, for contacts/internal_edges.cpp.
struct FixedContact {
    std::uint32_t contact;
    std::int32_t before; // the one of the same body before it
    bool on_several;     // whether these are with more than one shape
};

struct DepthOfContact {
    std::uint32_t contact;
    float depth; // m
};

struct NarrowScratch {
    // Pairs to be tested, one list per PairKind: their places among the candidates.
    std::vector<std::vector<std::uint32_t>> lists;
    std::vector<NarrowBatch> at_work;         // one per thread
    std::vector<std::int32_t> moving;         // bodies that are awake, and then the kinematic ones
    std::vector<float> turn_reach;            // by body, m: bodies.h
    std::vector<std::uint32_t> skipped;       // contacts of sleeping bodies with kinematic ones at rest
    std::vector<std::uint8_t> changes;        // 1 for each of those that were solved: began or ceased to touch
    std::vector<std::uint32_t> candidates;    // contacts of all pairs, those of neighbors near each other
    std::vector<std::uint8_t> outcomes;       // of each: what is to be done, what has come out (contacts.h)
    std::vector<std::uint32_t> open;          // places among the candidates of those not known to stay apart
    std::vector<std::uint32_t> changed;       // of these, those whose contact begins, ends or is a group
    std::vector<Uncolored> uncolored;         // contacts that begin in the step
    std::vector<ListPart> parts;              // of lists that threads write together
    std::vector<KindCounts> kinds_in_chunk;   // of open pairs that are to be tested
    bool any_groups = false;                  // among those
    std::vector<std::uint8_t> patch_outcomes; // by contact, of patches of groups that were tested
    std::vector<FreshPatch> fresh;            // of all threads, by place
    std::size_t next_fresh = 0;               // the first of those that have not been followed up
    // On several ranks (contacts/shared_tests.h).
    std::vector<std::uint32_t> shared; // places among the candidates of pairs that one rank alone tests
    std::vector<BegunContact> begun;   // contacts that begin on other ranks, in the order in which they are followed up
    std::size_t next_begun = 0;        // the first of those that have not been
    std::vector<TouchPoint> touches;   // of contacts that begin to touch
    // In the middle of the step, by shape, of the bodies that move (contacts/midway.h).
    std::vector<ShapePose> midway_poses;
    std::vector<math::Vec3> midway_arms; // from the body's center of mass to the shape's origin
    // Flight (contacts/flight.cpp).
    FlightPairs flights;                   // of all threads, by place
    std::vector<std::int32_t> flight_rows; // by body: rows of pairs that may be in flight
    std::vector<std::uint32_t> in_flight;  // contacts of pairs that meet in flight, if at all
    // Internal edges (contacts/internal_edges.cpp).
    std::vector<std::int32_t> last_of_body; // in `fixed`
    std::vector<std::uint32_t> fixed_ids;   // in order
    std::vector<FixedContact> fixed;
    std::vector<std::uint32_t> of_body;
    std::vector<DepthOfContact> by_depth;
    std::vector<std::uint32_t> lines;
    std::vector<KeyTree<6>::Keys> plane_keys;
    std::vector<KeyTree<9>::Keys> line_keys;
    KeyTree<6> plane_tree;
    KeyTree<9> line_tree;
    std::vector<std::uint8_t> is_internal_edge; // by contact, of those with what does not move by forces
    bool any_internal_edges = false;            // among those
    std::vector<std::uint32_t> dropped;         // those that are
    std::vector<std::uint32_t> lifted;          // those of which the points are others, of what stands on the ground
};

} // namespace cairn
