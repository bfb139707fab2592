// An impact that a bin has at work (impacts.cpp). Few lanes of a large bin take part: they are copied into blocks of
// their own, side by side, as they are gone over many times.
#pragma once

#include "kernels/joint_data.h"
#include "kernels/solver_data.h"

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace cairn {

template <class Block, class Impact> struct StruckBlocks {
    struct Lane {
        std::uint32_t source; // the lane of the bin that it is a copy of
        std::int32_t group;   // its place in ImpactWork::groups
    };
    std::vector<Block> blocks;
    std::vector<Impact> impacts; // beside them
    std::vector<Lane> lanes;     // 8 for each block; without a group: empty

    void clear() { blocks.clear(), impacts.clear(), lanes.clear(); }
};

// Blocks of one color and type; which: in ImpactWork::blocks.
struct StruckRun {
    int type;
    std::uint32_t first, count;
};

struct ImpactWork {
    // Bodies that joints hold together, by row: the lowest row of them; fixed_row for what does not move by forces.
    // Found once in a step that has impacts.
    std::vector<std::int32_t> component;
    // By JointRowType and lane; fixed_row where there is no joint.
    std::array<std::vector<std::int32_t>, 3> joint_component;
    bool has_components = false;

    std::vector<float> square_speed; // by component, m^2/s^2: of its fastest body; by row, of what no force moves
    std::vector<std::uint8_t> is_struck, is_listed; // by row: its component is struck; it is in `rows`

    // Rows that contacts and joints of this impact connect.
    struct Group {
        std::size_t begin, end; // in `rows`
        bool is_settled;
    };
    std::vector<Group> groups;
    std::vector<std::int32_t> group, place_of;   // by row: parents, of which the roots stand for groups; their places
    std::vector<std::int32_t> rows, sorted_rows; // the rows that may change
    std::vector<SolverVelocity> before, last;    // of those

    // The lanes that take part, run by run.
    struct ListedLane {
        std::uint32_t source; // the lane of the bin
        std::int32_t group;   // any of its rows, then its place in `groups`
        std::uint8_t form;
    };
    struct ListedRun {
        int type;
        std::uint32_t first;    // block of the bin
        std::size_t begin, end; // in `listed`
    };
    std::vector<ListedLane> listed;
    std::vector<ListedRun> listed_runs;

    std::tuple<StruckBlocks<PointBlock, JointImpact>, StruckBlocks<TurnBlock, JointImpact>,
               StruckBlocks<AxisBlock, JointImpact>, StruckBlocks<ContactBlock<1>, ContactImpact<1>>,
               StruckBlocks<ContactBlock<4>, ContactImpact<4>>>
        blocks;
    std::vector<StruckRun> runs; // in the order of the solver
};

} // namespace cairn
