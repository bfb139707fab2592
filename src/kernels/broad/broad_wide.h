// Helpers shared by the broad-phase kernels.
#pragma once

#include "kernels/broad/broad.h"
#include "simd/wide_math.h"

namespace cairn::CAIRN_ISA {

// One box in all lanes.
struct WideBox {
    Vec3x8 lo, hi;
};

CAIRN_INLINE WideBox splat(const TreeBox& box) {
    return {{splat(box.lo[0]), splat(box.lo[1]), splat(box.lo[2])},
            {splat(box.hi[0]), splat(box.hi[1]), splat(box.hi[2])}};
}
CAIRN_INLINE WideBox splat_lane(const Node8& node, unsigned lane) {
    return {{splat(node.lo[0][lane]), splat(node.lo[1][lane]), splat(node.lo[2][lane])},
            {splat(node.hi[0][lane]), splat(node.hi[1][lane]), splat(node.hi[2][lane])}};
}

// Bit mask of the lanes that overlap the box (touching counts): those that are not separated on any axis.
CAIRN_INLINE int hits(Vec3x8 lo, Vec3x8 hi, const WideBox& box) {
    const mask8 apart = (lo.x > box.hi.x) | (hi.x < box.lo.x) | (lo.y > box.hi.y) | (hi.y < box.lo.y) |
                        (lo.z > box.hi.z) | (hi.z < box.lo.z);
    return 255 ^ bits(apart);
}
CAIRN_INLINE int hits(const Node8& node, const WideBox& box) { return hits(load3(node.lo), load3(node.hi), box); }

// For each lane of b, rows_of_lane is the bit mask of those items of leaf a, among `rows`, that overlap it. Returns the
// lanes that any of them overlaps. Tests each row or each lane, whichever are fewer: items that share a traversal are
// close together.
CAIRN_INLINE unsigned meeting_rows(const Node8& a, const WideBox& bounds_a, unsigned rows, const Node8& b,
                                   std::uint8_t (&rows_of_lane)[8]) {
    const bool is_one_row = (rows & (rows - 1)) == 0;
    const auto lanes = is_one_row ? 255u : unsigned(hits(b, bounds_a));
    unsigned met = 0;
    if (is_one_row || __builtin_popcount(rows) < __builtin_popcount(lanes)) {
        for (std::uint8_t& of_lane : rows_of_lane) of_lane = 0;
        for (unsigned left = rows; left; left &= left - 1) {
            const auto row = unsigned(__builtin_ctz(left)), found = unsigned(hits(b, splat_lane(a, row)));
            met |= found;
            for (unsigned lane = found; lane; lane &= lane - 1)
                rows_of_lane[__builtin_ctz(lane)] |= std::uint8_t(1u << row);
        }
        return met;
    }
    for (unsigned left = lanes; left; left &= left - 1) {
        const auto lane = unsigned(__builtin_ctz(left)), found = unsigned(hits(a, splat_lane(b, lane))) & rows;
        rows_of_lane[lane] = std::uint8_t(found);
        met |= unsigned(found != 0) << lane;
    }
    return met;
}

void find_rows(const Node8& a, const TreeBox& bounds_a, std::uint32_t leaf_a, bool forward, const Node8* leaves,
               const LeafList& list, std::uint32_t list_count, std::uint32_t key_base, RowBuffer& rows);
std::uint32_t list_met(const Node8& a, const TreeBox& bounds_a, const TreeView& tree, MetLeaf* out);
std::uint32_t find_others(const Node8& a, const TreeBox& bounds_a, const MetLeaf* leaves, std::uint32_t leaf_count,
                          std::uint32_t* out);

} // namespace cairn::CAIRN_ISA
