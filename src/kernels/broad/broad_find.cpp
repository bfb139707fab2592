// Broad-phase kernels that find the partners of the 8 items of a leaf.
#include "kernels/broad/broad_wide.h"

namespace cairn::CAIRN_ISA {

namespace {

// lanes[m]: the numbers of the bits that are set in m, ascending.
struct BitLists {
    std::uint8_t lanes[256][8] = {};
    constexpr BitLists() {
        for (int m = 0; m < 256; ++m) {
            int count = 0;
            for (int lane = 0; lane < 8; ++lane)
                if (m >> lane & 1) lanes[m][count++] = std::uint8_t(lane);
        }
    }
};
constexpr BitLists bit_lists;

// Appends the keys of the lanes in the mask: always writes 8 keys, but advances the count only by the lanes that are
// set.
CAIRN_INLINE void append(RowBuffer& rows, unsigned row, int mask, std::uint32_t key) {
    std::uint32_t* out = rows.keys + std::size_t(row) * rows.capacity + rows.count[row];
    const std::uint8_t* lane = bit_lists.lanes[mask];
    for (int k = 0; k < 8; ++k) out[k] = key + lane[k];
    rows.count[row] += std::uint32_t(__builtin_popcount(unsigned(mask)));
}

} // namespace

void find_rows(const Node8& a, const TreeBox& bounds_a, std::uint32_t leaf_a, bool forward, const Node8* leaves,
               const LeafList& list, std::uint32_t list_count, std::uint32_t key_base, RowBuffer& rows) {
    const WideBox wide_a = splat(bounds_a);
    for (std::uint32_t first = 0; first < list_count; first += 8) {
        const float* const* bounds = list.bounds;
        const Vec3x8 lo = {load_unaligned(bounds[0] + first), load_unaligned(bounds[1] + first),
                           load_unaligned(bounds[2] + first)};
        const Vec3x8 hi = {load_unaligned(bounds[3] + first), load_unaligned(bounds[4] + first),
                           load_unaligned(bounds[5] + first)};
        for (unsigned listed = unsigned(hits(lo, hi, wide_a)); listed; listed &= listed - 1) {
            const std::uint32_t at = first + std::uint32_t(__builtin_ctz(listed)), leaf_b = list.leaf[at];
            if (forward && leaf_b < leaf_a) continue;
            const Node8& b = leaves[leaf_b];
            const std::uint32_t key = key_base | leaf_b * 8;
            if (forward && leaf_b == leaf_a) {
                for (unsigned row = 0; row < 7; ++row)
                    append(rows, row, hits(b, splat_lane(a, row)) & int(0xfeu << row & 0xffu), key);
                continue;
            }
            const WideBox bounds_b = {{splat(bounds[0][at]), splat(bounds[1][at]), splat(bounds[2][at])},
                                      {splat(bounds[3][at]), splat(bounds[4][at]), splat(bounds[5][at])}};
            for (unsigned row_mask = unsigned(hits(a, bounds_b)); row_mask; row_mask &= row_mask - 1) {
                const unsigned row = unsigned(__builtin_ctz(row_mask));
                append(rows, row, hits(b, splat_lane(a, row)), key);
            }
        }
    }
}

std::uint32_t list_met(const Node8& a, const TreeBox& bounds_a, const TreeView& tree, MetLeaf* out) {
    if (tree.level_count < 2) return 0;
    const WideBox wide_a = splat(bounds_a);
    std::uint32_t node[max_tree_levels];
    unsigned lanes[max_tree_levels];
    std::uint8_t rows[max_tree_levels][8];
    std::uint32_t level = tree.level_count - 1, count = 0;
    node[level] = 0;
    lanes[level] = meeting_rows(a, wide_a, 255u, tree.levels[level][0], rows[level]);
    for (;;) {
        if (lanes[level] == 0) {
            if (++level == tree.level_count) return count;
            continue;
        }
        const auto lane = std::uint32_t(__builtin_ctz(lanes[level])), child = node[level] * 8 + lane;
        const unsigned rows_of_child = rows[level][lane];
        lanes[level] &= lanes[level] - 1;
        if (level == 1) {
            out[count++] = {&tree.levels[0][child], child, rows_of_child};
            continue;
        }
        --level;
        node[level] = child;
        lanes[level] = meeting_rows(a, wide_a, rows_of_child, tree.levels[level][child], rows[level]);
    }
}

std::uint32_t find_others(const Node8& a, const TreeBox& bounds_a, const MetLeaf* leaves, std::uint32_t leaf_count,
                          std::uint32_t* out) {
    const WideBox wide_a = splat(bounds_a);
    std::uint32_t count = 0;
    for (std::uint32_t place = 0; place < leaf_count; ++place) {
        std::uint8_t rows_of_lane[8];
        unsigned lanes = meeting_rows(a, wide_a, leaves[place].rows, *leaves[place].leaf, rows_of_lane);
        for (; lanes; lanes &= lanes - 1) {
            const auto lane = unsigned(__builtin_ctz(lanes));
            for (unsigned rows = rows_of_lane[lane]; rows; rows &= rows - 1)
                out[count++] = std::uint32_t(__builtin_ctz(rows)) | lane << 3 | place << 6;
        }
    }
    return count;
}

} // namespace cairn::CAIRN_ISA
