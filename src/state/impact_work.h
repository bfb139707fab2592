// An impact that a batch has at work (impacts.cpp, impact_lists.cpp). Few lanes of a large batch take part: they are
// copied into blocks of their own, side by side, as they are gone over many times.
#pragma once

#include "kernels/solve/joint_data.h"
#include "kernels/solve/solver_data.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace cairn {

template <class Block, class Impact> struct StruckBlocks {
    struct Lane {
        std::uint32_t source; // the lane of the batch that it is a copy of
        std::int32_t group;   // its place in ImpactWork::groups; none: an empty lane
        bool is_own;          // not another rank's
    };
    struct alignas(32) Lanes {
        float value[8];
    };
    std::vector<Block> blocks;
    std::vector<Impact> impacts; // beside them
    std::vector<Lane> lanes;     // 8 for each block; without a group: empty
    // Of contacts that bounce, for each point of a block (AimedSpeeds); empty: none do.
    std::vector<Lanes> leave, meets;

    void clear() { blocks.clear(), impacts.clear(), lanes.clear(), leave.clear(), meets.clear(); }
};

// Blocks of one color and type; which: in ImpactWork::blocks.
struct StruckRun {
    int type;
    std::uint32_t listed; // its place in ImpactWork::listed_runs
    std::uint32_t first, count;
};

// The types of blocks, as in ImpactWork::blocks: first those of joints, by JointRowType.
inline constexpr int one_point_type = 3, four_points_type = 4, block_types = 5;

// Things that rows have, a list for each row. Linked, as they are found in one go and most of them are never asked for.
struct RowLists {
    std::vector<std::int32_t> first, next; // by row, by thing; -1: no more

    void reset(std::size_t rows, std::size_t things) { first.assign(rows, -1), next.resize(things); }
    void add(std::int32_t row, std::size_t thing) {
        next[thing] = first[row];
        first[row] = std::int32_t(thing);
    }
    template <class F> void for_each(std::int32_t row, F&& f) const { // the last one first
        for (std::int32_t i = first[row]; i >= 0; i = next[i]) f(std::size_t(i));
    }
};

struct ImpactWork {
    // Found once in a step that has impacts.
    bool has_components = false;
    // Bodies that joints hold together, by row: the lowest row of them; fixed_row for what does not move by forces.
    std::vector<std::int32_t> component;
    RowLists rows_of;                     // by component
    RowLists joints_of;                   // by row of one of their bodies; their places in JointLayout::joints
    RowLists one_sides_of, four_sides_of; // by row: lanes of contacts where it is A, x 2; where it is B, x 2 + 1
    std::array<std::vector<std::uint32_t>, block_types> run_of_lane; // its place in `listed_runs`

    // What is known of components in this impact; the next one takes it back.
    std::vector<std::uint8_t> struck_when;         // by component: not, in this round of it, or in one before
    std::vector<std::int32_t> struck, ever_struck; // those of this round, and of all
    // Bodies that strike each other: the first one is of a group that took part, or about to.
    struct Hit {
        std::int32_t first, other;
    };
    std::vector<Hit> hits;
    std::vector<std::int32_t> pushed; // bodies that are pushed out of something, of those
    // m/s: of its fastest body, or by row: of what no force moves; negative where it has not been measured.
    std::vector<float> speed;
    std::vector<std::int32_t> measured;      // those where it has
    std::vector<std::uint8_t*> struck_lanes; // ContactBlock::struck of the blocks where it is not 0

    // Rows that contacts and joints of this impact connect.
    struct Group {
        std::size_t begin, end; // in `rows`
        bool is_settled;
        bool goes_on;                   // something in it is driven into what did not take part
        double impulse = 0, moment = 0; // of what bounced in it: N s, and times when it did (AimedSpeeds::meets)
    };
    std::vector<Group> groups;
    // By row: parents, of which the roots stand for groups, and -1 for rows that take no part; the places of the
    // groups.
    std::vector<std::int32_t> group, place_of;
    std::vector<std::int32_t> rows, sorted_rows; // the rows that may change, those of a group side by side
    std::vector<SolverVelocity> before, last;    // of those

    // Of joints that are solved directly: places in DirectWork::sets.
    std::vector<std::int32_t> set_of_row; // none: of no set; empty: the batch has none
    std::vector<std::int32_t> sets;       // those that take part

    // The lanes that take part, run by run.
    struct ListedLane {
        std::uint32_t source; // the lane of the batch
        std::int32_t group;   // any of its rows, then its place in `groups`
        std::uint32_t run;    // in `listed_runs`
        std::uint8_t form;
    };
    struct ListedRun { // each of the batch's, in the order of the solver
        int type;
        std::uint32_t first;    // block of the batch
        std::size_t begin, end; // in `listed`
    };
    std::vector<ListedLane> listed, sorted_lanes;
    std::vector<ListedRun> listed_runs;

    std::tuple<StruckBlocks<PointBlock, JointImpact>, StruckBlocks<TurnBlock, JointImpact>,
               StruckBlocks<AxisBlock, JointImpact>, StruckBlocks<ContactBlock<1>, ContactImpact<1>>,
               StruckBlocks<ContactBlock<4>, ContactImpact<4>>>
        blocks;
    std::vector<StruckRun> runs; // in the order of the solver

    // Of a batch that is cut, in place of the batch's rows: those of all ranks that take part (rank_impacts.h).
    struct Shared {
        std::vector<SolverVelocity> velocity; // of bodies that move, of what does not, and rows to discard
        std::vector<std::int32_t> bodies;     // of the first rows: ascending
        std::vector<std::int32_t> groups;     // of those: places in ImpactWork::groups
    } shared;
};

} // namespace cairn
