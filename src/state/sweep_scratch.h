// Working memory of impacts within a step (impacts/resolve_impacts.h).
#pragma once

#include "collision/core_sweep.h"
#include "collision/manifold.h"
#include "jobs/ordered_list.h"
#include "math/bounds.h"
#include "state/impact_rows.h"
#include "state/none.h"

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace cairn {

// A body on its way through the step. Times are parts of the step.
struct Mover {
    std::int32_t body;
    bool is_free = false;       // neither contacts nor joints have moved it: it flies
    bool gyrates = false;       // and changes its turn by itself so fast that the solver could not hold it
    bool is_led = false;        // joints lead it about an axis, or something kinematic takes it along
    bool is_fast = false;       // so far that its core may pass another
    bool turns_over = false;    // more than half a turn: its poses do not tell how
    bool is_changed = false;    // it is not where the solver has put it
    bool has_strayed = false;   // its way is not where the broad phase expected it
    bool is_redirected = false; // its way is not that which the solver has made
    int impacts = 0;
    double until = 1;               // when it stops
    std::int32_t first_pair = none; // of its list in SweepScratch::pairs
    RigidPath path;                 // under way
    // Of what is led: where it is beside what leads it, and the kinematic body that this is, or none.
    RigidPath lead;
    math::DVec3 arm;
    math::DQuat turned;
    std::int32_t carrier = none;
    // Of what is free, at the beginning of the path:
    math::DVec3 velocity, spin; // m/s as the path begins, rad/s
    math::DVec3 acceleration;   // m/s^2 of the forces along the path, but for what it lies on
    bool has_stopped() const { return until < 1; }
};

// Shapes of a mover and of another body, by their places among the movers; none: the other is none.
struct SweptPair {
    std::int32_t first, second;
    std::uint32_t shape, other;
    std::int32_t contact = none; // of the pair, if it is known
    bool flies = false;          // it may meet in flight: the solver was not told of it
    bool is_known = false;       // the solver has moved the two by this contact
    bool touches = false;        // they have met in this step
    bool has_stayed = false;     // they met, and nothing approached
    bool rests = false;          // they lie on each other: forces that press them together do not move them
    bool has_begun = false;      // to touch, in this step
    bool was_carried = false;    // the first went along with the other: what is between two that move is crushed
    double time = never;         // of their meeting
    math::DVec3 axis{};          // from the shape to the other, where they were nearest last; or 0
    std::int32_t next_of_first = none, next_of_second = none; // in the lists of both
};

struct Meeting {
    double time;
    std::uint32_t shape, other;
    std::int32_t pair;
    bool operator<(const Meeting& m) const { // least first
        return std::tie(m.time, m.shape, m.other, m.pair) < std::tie(time, shape, other, pair);
    }
};

// The bounds of a mover's way.
struct SweptBounds {
    double begin; // along x
    std::int32_t mover;
    DBounds bounds;
    bool operator<(const SweptBounds& w) const { return std::tie(begin, mover) < std::tie(w.begin, w.mover); }
};

struct KnownContact {
    std::uint32_t contact;
    std::int32_t next; // of the same body, or none
};

// A shape near the way of a mover.
struct NearShape {
    std::int32_t mover;
    std::uint32_t shape;
};

// Bodies that joints hold together: a range of SweepScratch::members.
struct Assembly {
    std::int32_t begin, end;
};

// A pair of the broad phase that may meet: the mover, its shape, and the other.
struct PassingPair {
    std::int32_t mover;
    std::uint32_t shape, other, contact;
};

// A trigger and a shape of another body that may fly through it; when that comes in.
struct NearTrigger {
    std::uint32_t trigger, other;
};

// A path that a mover took up to a time, as it went another way from then on.
struct PathPiece {
    std::int32_t mover;
    RigidPath path;
    double until;
};

struct SweepScratch {
    std::vector<std::int32_t> bodies; // that become movers
    std::vector<PassingPair> passing;
    std::vector<ListPart> parts;
    std::vector<std::int32_t> place; // by body, among `movers`, or none
    std::vector<Mover> movers;
    std::vector<SweptPair> pairs;
    std::vector<std::int32_t> first_waiting; // by body that is no mover, the first of the pairs with it, or none
    std::vector<Meeting> meetings;           // a heap
    std::vector<std::int32_t> asked;         // pairs, after an impact
    std::vector<DBounds> bounds_of_ways;     // by mover, of those that the solver has made
    // The ways of movers that are not where the broad phase has them: those that the solver has made, by x; those since
    // then, as many runs as their number has binary digits of 1, each of them by x.
    std::vector<SweptBounds> strayed, redirected;
    double widest_strayed = 0, widest_redirected = 0; // m, along x
    // Contacts with points in the solver: lists by the body A.
    std::vector<std::int32_t> first_known; // by body, in `known`, or none
    std::vector<KnownContact> known;
    bool has_ways = false, has_known = false;
    std::vector<std::int32_t> assembly_of; // by body, in `assemblies`, or none: not looked for
    std::vector<std::int32_t> members;
    std::vector<Assembly> assemblies;
    std::vector<std::uint32_t> near;                   // shapes near a way
    std::vector<std::uint64_t> listed;                 // pairs of one mover, by both shapes, its own first; sorted
    std::vector<std::vector<NearShape>> near_in_chunk; // of bodies that are looked at side by side
    std::vector<ImpactPoint> points;                   // of one impact
    std::vector<StruckBody> struck;                    // and all else of it
    std::vector<ImpactBody> struck_motions;
    std::vector<ImpactPair> touching;
    ImpactBuffer impact;
    std::vector<NearTrigger> near_triggers;
    std::vector<PathPiece> pieces;
    std::vector<std::int32_t> changed; // movers
};

} // namespace cairn
