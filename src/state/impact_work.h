// An impact within a batch (impacts.cpp, impact_lists.cpp). Few lanes of a large batch take part: they are copied into
// compact blocks of their own, as there are many passes over them.
#pragma once

#include "kernels/solve/joint_data.h"
#include "kernels/solve/solver_data.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace cairn {

template <class Block, class Impact> struct ImpactBlocks {
    struct Lane {
        std::uint32_t source; // the lane of the batch that was copied
        std::int32_t group;   // its index in ImpactWork::groups; none: an empty lane
        bool is_own;          // belongs to this rank
    };
    struct alignas(32) Lanes {
        float value[8];
    };
    std::vector<Block> blocks;
    std::vector<Impact> impacts; // one for each block
    std::vector<Lane> lanes;     // 8 for each block; without a group: empty
    // For each point of a block of contacts, if any of them bounces, else empty: see ReboundTargets.
    std::vector<Lanes> rebound_speeds, arrivals;

    void clear() { blocks.clear(), impacts.clear(), lanes.clear(), rebound_speeds.clear(), arrivals.clear(); }
};

// Blocks of one color and type, in ImpactWork::blocks.
struct ImpactRun {
    int type;
    std::uint32_t listed; // index in ImpactWork::listed_runs
    std::uint32_t first, count;
};

// Types of blocks, in the order of ImpactWork::blocks: first those of joints, by JointRowType.
inline constexpr int one_point_type = 3, four_points_type = 4, block_types = 5;

// A list of items for each solver body. The lists are linked, as they are built in one pass, and most are never read.
struct RowLists {
    std::vector<std::int32_t> first, next; // by solver body, by item; -1: the end

    void reset(std::size_t rows, std::size_t things) { first.assign(rows, -1), next.resize(things); }
    void add(std::int32_t row, std::size_t thing) {
        next[thing] = first[row];
        first[row] = std::int32_t(thing);
    }
    template <class F> void for_each(std::int32_t row, F&& f) const { // last added first
        for (std::int32_t i = first[row]; i >= 0; i = next[i]) f(std::size_t(i));
    }
};

struct ImpactWork {
    // Built once in a step that has impacts.
    bool has_components = false;
    // The component of each solver body, i.e. the bodies that joints connect: the lowest row in it; fixed_row for
    // bodies that do not move by forces.
    std::vector<std::int32_t> component;
    RowLists rows_of;                     // by component
    RowLists joints_of;                   // by row of one of the joint's bodies: places in JointLayout::joints
    RowLists one_sides_of, four_sides_of; // by row: lanes of contacts, x 2 where the body is A, x 2 + 1 where it is B
    std::array<std::vector<std::uint32_t>, block_types> run_of_lane; // index in `listed_runs`

    // The state of components in this impact; the next impact resets it.
    std::vector<std::uint8_t> impact_round; // by component: not yet, in this round, or in an earlier one
    std::vector<std::int32_t> in_impact, all_impact_groups; // components of this round, and of all rounds
    // Bodies that meet: the first belongs to a group that took part, or is about to.
    struct Hit {
        std::int32_t first, other;
    };
    std::vector<Hit> hits;
    std::vector<std::int32_t> pushed; // of those bodies, the ones that are pushed out of a penetration
    // m/s: the greatest speed in a component, or by row for bodies that no force moves; negative: not measured yet.
    std::vector<float> speed;
    std::vector<std::int32_t> measured;      // entries of `speed` that were measured
    std::vector<std::uint8_t*> impact_lanes; // nonzero ContactBlock::struck of blocks

    // Solver bodies that contacts and joints of this impact connect.
    struct Group {
        std::size_t begin, end; // in `rows`
        bool is_settled;
        bool continues; // one of its bodies is driven into a body that took no part
        // Impulse of its bouncing contacts, N s; sum of impulse x time of arrival (ReboundTargets::arrival).
        double impulse = 0, moment = 0;
    };
    std::vector<Group> groups;
    // By row, a union-find forest: parents, whose roots represent groups, -1 for rows that take no part; and the index
    // in `groups`.
    std::vector<std::int32_t> group, place_of;
    std::vector<std::int32_t> rows, sorted_rows; // rows whose velocities may change; sorted: by group
    std::vector<SolverVelocity> before, last;    // velocities of `rows`: before the impact, and at the last check

    // Sets of joints that are solved directly: indices in DirectWork::sets.
    std::vector<std::int32_t> set_of_row; // none: in no set; empty: the batch has no sets
    std::vector<std::int32_t> sets;       // sets that take part

    // The lanes that take part, run by run.
    struct ListedLane {
        std::uint32_t source; // lane of the batch
        std::int32_t group;   // a row of one of its bodies, later its index in `groups`
        std::uint32_t run;    // in `listed_runs`
        std::uint8_t form;
    };
    struct ListedRun { // one for each run of the batch, in the order of the solver
        int type;
        std::uint32_t first;    // first block in the batch
        std::size_t begin, end; // in `listed`
    };
    std::vector<ListedLane> listed, sorted_lanes;
    std::vector<ListedRun> listed_runs;

    std::tuple<ImpactBlocks<PointBlock, JointImpact>, ImpactBlocks<TurnBlock, JointImpact>,
               ImpactBlocks<AxisBlock, JointImpact>, ImpactBlocks<ContactBlock<1>, ContactImpact<1>>,
               ImpactBlocks<ContactBlock<4>, ContactImpact<4>>>
        blocks;
    std::vector<ImpactRun> runs; // in the order of the solver

    // For a batch that is cut, instead of the rows of the batch: the bodies of all ranks that take part
    // (rank_impacts.h).
    struct Shared {
        std::vector<SolverVelocity> velocity; // of moving bodies, of the immovable one, and discard rows
        std::vector<std::int32_t> bodies;     // bodies of the first rows, ascending
        std::vector<std::int32_t> groups;     // their indices in ImpactWork::groups
    } shared;
};

} // namespace cairn
