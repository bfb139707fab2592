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
        std::int32_t island;  // its place in ImpactWork::islands
    };
    std::vector<Block> blocks;
    std::vector<Impact> impacts; // beside them
    std::vector<Lane> lanes;     // 8 for each block; without an island: empty

    void clear() { blocks.clear(), impacts.clear(), lanes.clear(); }
};

// Blocks of one color and type; which: in ImpactWork::blocks.
struct StruckRun {
    int type;
    std::uint32_t first, count;
};

struct ImpactWork {
    // Bodies that joints hold together, by row: the lowest row of them. Found once in a step that has impacts.
    std::vector<std::int32_t> component;
    std::array<std::vector<std::int32_t>, 3> joint_component; // by JointRowType and lane; none where there is no joint
    bool has_components = false;

    std::vector<std::uint8_t> is_struck, is_listed; // by row: the component of that row is struck; the row is in `rows`

    struct StruckIsland {
        std::int32_t island;
        bool is_settled;
        float change; // in the last pass, in units of what counts as settled
    };
    std::vector<StruckIsland> islands;
    std::vector<std::int32_t> place_of;       // by island of the world: its place in `islands`, or none
    std::vector<std::int32_t> rows, places;   // the rows that may change, and the places of their islands
    std::vector<SolverVelocity> before, last; // of those
    std::tuple<StruckBlocks<PointBlock, JointImpact>, StruckBlocks<TurnBlock, JointImpact>,
               StruckBlocks<AxisBlock, JointImpact>, StruckBlocks<ContactBlock<1>, ContactImpact<1>>,
               StruckBlocks<ContactBlock<4>, ContactImpact<4>>>
        blocks;
    std::vector<StruckRun> runs; // in the order of the solver
};

} // namespace cairn
