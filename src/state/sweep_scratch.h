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

// A body on its path through the step. Times are fractions of the step.
struct Mover {
    std::int32_t body;
    bool is_free = false;       // neither contacts nor joints have moved it: it is in free flight
    bool gyrates = false;       // it also changes its angular velocity by itself too fast for the solver
    bool is_guided = false;     // joints make it rotate about an axis, or a kinematic body carries it along
    bool is_fast = false;       // it moves so far that its core may pass another
    bool turns_over = false;    // it turns by more than half a revolution, so its poses do not define the rotation
    bool is_changed = false;    // it is not where the solver has put it
    bool has_strayed = false;   // its path is not within the bounds that the broad phase expected
    bool is_straight = false;   // it goes on at a constant velocity, without turning, until joints act again
    bool is_redirected = false; // its path differs from that of the solver
    int impacts = 0;
    double until = 1;               // the time when it stops
    std::int32_t first_pair = none; // head of its list in SweepScratch::pairs
    RigidPath path;                 // the current path
    // Bounds that contain the rest of a redirected mover's path, and in which all shapes near it have been found; and
    // the number of this search, 0: none yet.
    DBounds searched;
    std::int32_t search = 0;
    // For a body with is_guided: its motion relative to what leads it; the kinematic body that carries it, or none.
    RigidPath lead;
    math::DVec3 arm;
    math::DQuat turned;
    std::int32_t carrier = none;
    // For a body in free flight, at the beginning of the path:
    math::DVec3 velocity, spin; // m/s as the path begins, rad/s
    math::DVec3 acceleration;   // m/s^2: by the forces along the path, without those of its supports
    bool has_stopped() const { return until < 1; }
};

// The shapes of a mover and of another body. `first`, `second`: indices of movers; `second`: none if the other body
// is no mover.
struct SweptPair {
    std::int32_t first, second;
    std::uint32_t shape, other;
    std::int32_t contact = none; // of the pair, if there is one
    bool flies = false;          // the pair may meet in free flight, and has no contact in the solver
    bool is_known = false;       // the solver has moved the bodies with this contact
    bool touches = false;        // the shapes have met in this step
    bool has_stayed = false;     // the shapes have met, and did not approach each other
    bool rests = false;          // one lies on the other: forces that press them together do not move them
    bool has_begun = false;      // the shapes began to touch in this step
    bool was_carried = false;    // the first body was carried by the other: a body between two moving ones is crushed
    bool is_asked = false;       // the time of their meeting is not known at present
    double time = never;         // of their meeting
    Separation known{};          // from the shape to the other
    std::int32_t next_of_first = none, next_of_second = none; // in the lists of both movers
};

struct Meeting {
    double time;
    std::uint32_t shape, other;
    std::int32_t pair;
    bool operator<(const Meeting& m) const { // reversed, so that a heap has the earliest first
        return std::tie(m.time, m.shape, m.other, m.pair) < std::tie(time, shape, other, pair);
    }
};

// The bounds of a mover's path.
struct SweptBounds {
    double begin; // along x
    std::int32_t mover;
    DBounds bounds;
    std::int32_t search = 0; // Mover::search
    bool operator<(const SweptBounds& w) const { return std::tie(begin, mover) < std::tie(w.begin, w.mover); }
};

struct KnownContact {
    std::uint32_t contact;
    std::int32_t next; // the next contact of the same body, or none
};

// A shape near the path of a mover.
struct NearShape {
    std::int32_t mover;
    std::uint32_t shape;
};

// Bodies connected by joints: a range of SweepScratch::members, and the inverse of their total mass, 1/kg; 0 if one of
// them has a joint with a body that forces do not move.
struct Assembly {
    std::int32_t begin, end;
    double inverse_mass;
};

// A pair of the broad phase that may meet: the mover, its shape, the other shape, and their contact.
struct PassingPair {
    std::int32_t mover;
    std::uint32_t shape, other, contact;
};

// A trigger, and a shape of another body that may pass through it.
struct NearTrigger {
    std::uint32_t trigger, other;
};

// A path that a mover followed until some time, when it changed its path.
struct PathPiece {
    std::int32_t mover;
    RigidPath path;
    double until;
};

struct SweepScratch {
    std::vector<std::int32_t> bodies; // bodies that become movers
    std::vector<PassingPair> passing;
    std::vector<ListPart> parts;
    std::vector<std::int32_t> place; // by body: its index in `movers`, or none
    std::vector<Mover> movers;
    std::vector<SweptPair> pairs;
    std::vector<std::int32_t> first_waiting; // by body: if it is no mover, the first pair with it, or none
    std::vector<Meeting> meetings;           // a heap, earliest first
    std::vector<std::int32_t> asked;         // pairs to search again after an impact
    std::vector<DBounds> swept_bounds;       // by mover: bounds of the path by the solver
    // The paths of movers that are outside of their bounds in the broad phase: those by the solver, sorted by x; and
    // those changed since then, in sorted runs, as many as there are 1 bits in their number.
    std::vector<SweptBounds> strayed, redirected;
    double widest_strayed = 0, widest_redirected = 0; // m, along x
    // Contacts whose points are in the solver: lists by body A.
    std::vector<std::int32_t> first_known; // by body, in `known`, or none
    std::vector<KnownContact> known;
    bool has_swept_bounds = false, has_known = false;
    std::vector<std::int32_t> assembly_of; // by body: index in `assemblies`, or none: not searched yet
    std::vector<std::int32_t> members;
    std::vector<Assembly> assemblies;
    std::vector<std::uint32_t> near;                   // shapes near a path
    std::vector<std::uint64_t> listed;                 // pairs of one mover, by both shapes, its own first; sorted
    std::vector<std::vector<NearShape>> near_in_chunk; // by chunk of a parallel loop
    std::vector<ImpactPoint> points;                   // of one impact
    std::vector<StruckBody> struck;                    // of one impact, as are the following
    std::vector<ImpactBody> struck_motions;
    std::vector<ImpactPair> touching;
    ImpactBuffer impact;
    std::vector<NearTrigger> near_triggers;
    std::vector<PathPiece> pieces;
    std::vector<std::int32_t> changed; // movers
};

} // namespace cairn
