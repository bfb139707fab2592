// Working memory of the sweep of cores (impacts/hold_cores.h).
#pragma once

#include "collision/core_sweep.h"
#include "math/bounds.h"
#include "state/none.h"

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace cairn {

// A body that moved farther in the pass than its core may without a look.
struct FastBody {
    std::int32_t body;
    double moved;             // any point of it, m, at most
    double until = 1;         // when it stops, as part of the pass
    std::int32_t path = none; // among SweepScratch::paths, once it was asked for
    bool has_stopped() const { return until < 1; }
};

// Shapes of a fast body and of another, by their places among the fast ones; none: the other is not fast.
struct FastPair {
    std::int32_t first, second;
    std::uint32_t shape, other;
    double time = never;   // of their meeting
    bool is_known = false; // the contact, to the solver
};

struct Meeting {
    double time;
    std::size_t pair;
    bool operator<(const Meeting& m) const { return std::tie(m.time, m.pair) < std::tie(time, pair); } // least first
};

// The bounds of a fast body's way.
struct FastWay {
    double begin; // along x
    std::int32_t body;
    DBounds bounds;
    bool operator<(const FastWay& w) const { return std::tie(begin, body) < std::tie(w.begin, w.body); }
};

struct SweepScratch {
    std::vector<std::int32_t> place; // by body, among `bodies`, or none
    std::vector<FastBody> bodies;
    std::vector<RigidPath> paths;
    std::vector<FastPair> pairs;
    std::vector<FastWay> ways;
    std::vector<Meeting> meetings;                            // a heap
    std::vector<std::size_t> first_pair, pairs_of, next_pair; // of each fast body
};

} // namespace cairn
