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

// Prefetch distance in lists of contacts, which are scattered in memory.
inline constexpr std::size_t contacts_ahead = 8;

// A batch of pairs for a wide kernel.
struct PairBatch {
    static constexpr int capacity = 256;
    std::uint32_t first[capacity], second[capacity];
    float margin[capacity];
    std::uint32_t kept[capacity]; // features of the last step, for box_box only
};

// A new patch of the mesh contact at this place among the candidates.
struct FreshPatch {
    std::uint32_t place, order; // order: among the new patches of that place
    Manifold manifold;
    bool is_ahead; // the manifold is the one at the touch
    Touch touch;
};

// The order in which new patches are followed up.
inline bool comes_before(const FreshPatch& a, const FreshPatch& b) {
    return a.place != b.place ? a.place < b.place : a.order < b.order;
}

// The data that follow_up needs from the record of a contact that begins.
struct BegunContact {
    math::Vec3 normal;
    bool passes_by; // given the motion of its bodies, it will not touch within the step
};

// A new contact. It gets its color only after the contacts that end in this step have released theirs.
struct Uncolored {
    std::uint64_t key; // shapes A and B; later the place in the coloring order
    std::int32_t island;
    std::uint32_t order; // in which the contacts began
    std::uint32_t contact;
};

// The data that events need from the record of a contact that begins to touch.
struct TouchPoint {
    std::uint32_t contact;
    float approach_speed;
    math::Vec3 normal, arm; // arm: from the center of mass of A to the deepest point
};

// A pair that may meet in free flight (contacts/flight.h), at this place among the candidates, and its test's result.
struct FlightPair {
    std::uint32_t place;
    bool is_free;                       // nothing constrains its bodies
    std::uint32_t first_hit, hit_count; // in FlightPairs::hits: one manifold, none for mesh contacts
};
struct FlightPairs {
    std::vector<FlightPair> pairs;
    std::vector<Manifold> hits;

    void clear() {
        shrink_capacity(pairs), shrink_capacity(hits);
        pairs.clear(), hits.clear();
    }
    void add(std::uint32_t place, const Manifold* first, std::size_t count) {
        pairs.push_back({place, false, std::uint32_t(hits.size()), std::uint32_t(count)});
        hits.insert(hits.end(), first, first + count);
    }
};

// The working memory of a thread.
struct NarrowBatch {
    PairBatch pairs;
    std::vector<std::uint32_t> midway, at_start; // pairs by the time of their test: places among the candidates
    ShapePose poses[2 * PairBatch::capacity];    // of both shapes of each pair, in the middle of the step
    Manifold manifolds[PairBatch::capacity];
    SurfaceScratch surface;
    std::vector<Manifold> hits;          // of one mesh contact
    SurfaceScratch surface_at_touch;     // of one patch of it, at its touch
    std::vector<Manifold> hits_at_touch; // at that touch
    std::vector<std::uint32_t> matched;  // the patch that each of `hits` matches in the middle of the step
    std::vector<std::uint32_t> triangles;
    std::vector<FreshPatch> fresh; // of the mesh contacts that this thread tests
    FlightPairs flights;
};

using KindCounts = std::array<std::uint32_t, std::size_t(tested_kinds)>; // by PairKind

// A contact with a body that does not move by forces, for contacts/internal_edges.cpp.
struct FixedContact {
    std::uint32_t contact;
    std::int32_t before; // the previous contact of the same body
    bool on_several;     // the contacts up to this one are with more than one shape
};

struct DepthOfContact {
    std::uint32_t contact;
    float depth; // m
};

// The motion of a body as a step begins. Pair tests read it for both bodies of each pair, so it is kept small.
struct alignas(32) MotionAhead {
    math::Vec3 v;             // m/s
    float rotation_bound = 0; // m: see bodies.h
    math::Vec3 w;             // rad/s
    bool moves = false;       // by more than a micrometer until the middle of the step
    bool has_joints = false;  // that are solved
    bool is_tested = false;   // a pair of the body is tested
};

struct NarrowScratch {
    // Pairs to test, one list per PairKind: places among the candidates.
    std::vector<std::vector<std::uint32_t>> lists;
    std::vector<NarrowBatch> at_work;         // one per thread
    std::vector<std::int32_t> moving;         // awake bodies, then kinematic bodies
    std::vector<MotionAhead> motion_ahead;    // by body; all zero for bodies that do not move
    std::vector<std::uint32_t> skipped;       // contacts of sleeping bodies with kinematic bodies at rest
    std::vector<std::uint8_t> changes;        // 1 for solved contacts that began or ceased to touch
    std::vector<std::uint32_t> candidates;    // contacts of all pairs; pairs nearby in space are near each other
    std::vector<std::uint8_t> outcomes;       // by candidate: its Outcome (contact_update.h)
    std::vector<std::uint32_t> open;          // places of the candidates that may not stay separated
    std::vector<std::uint32_t> changed;       // of `open`: contacts that begin or end, and mesh contacts
    std::vector<Uncolored> uncolored;         // contacts that begin in the step
    std::vector<ListPart> parts;              // of lists that threads write together
    std::vector<KindCounts> kinds_in_chunk;   // open pairs to be tested, per chunk
    bool any_groups = false;                  // among the open pairs
    std::vector<std::uint8_t> patch_outcomes; // by contact: outcomes of the patches of tested mesh contacts
    std::vector<FreshPatch> fresh;            // of all threads, by place
    std::size_t next_fresh = 0;               // the first one that has not been followed up
    // With several ranks (contacts/shared_tests.h).
    std::vector<std::uint32_t> shared; // places of the candidates that a single rank tests
    std::vector<BegunContact> begun;   // contacts that begin on other ranks, in the order of follow_up
    std::size_t next_begun = 0;        // the first one that has not been followed up
    std::vector<TouchPoint> touches;   // of contacts that begin to touch
    // Poses and arms of the shapes of moving bodies in the middle of the step, by shape (contacts/midway.h).
    std::vector<ShapePose> midway_poses;
    std::vector<math::Vec3> midway_arms; // from the body's center of mass to the shape's origin
    // Free flight (contacts/flight.cpp).
    FlightPairs flights;                   // of all threads, by place
    std::vector<std::int32_t> flight_rows; // by body: its contacts that may be in free flight
    std::vector<std::uint32_t> in_flight;  // contacts of pairs that meet in free flight, if at all
    // Internal edges (contacts/internal_edges.cpp).
    std::vector<std::int32_t> last_of_body; // by body: its last contact, in `fixed`
    std::vector<std::uint32_t> fixed_ids;   // contacts with bodies that do not move by forces, in order
    std::vector<FixedContact> fixed;
    std::vector<std::uint32_t> of_body;
    std::vector<DepthOfContact> by_depth;
    std::vector<std::uint32_t> lines;
    std::vector<KeyTree<6>::Keys> plane_keys;
    std::vector<KeyTree<9>::Keys> line_keys;
    KeyTree<6> plane_tree;
    KeyTree<9> line_tree;
    std::vector<std::uint8_t> is_internal_edge; // by contact, for those in `fixed_ids`
    bool any_internal_edges = false;            // any in `is_internal_edge`
    std::vector<std::uint32_t> dropped;         // contacts that are internal edges
    std::vector<std::uint32_t> lifted;          // contacts that were found anew, for bodies that stand on the ground
};

} // namespace cairn
