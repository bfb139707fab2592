// Walks through the implicit tree for queries.
#pragma once

#include "bvh/tree.h"

#include <algorithm>
#include <cstdint>

namespace cairn {

// visit(slot) for all items that meet the box, in slot order.
template <class F> void visit_box(const BroadKernels& kernels, const TreeView& tree, const TreeBox& box, F&& visit) {
    if (tree.level_count == 0) return;
    std::uint32_t node[max_tree_levels];
    int mask[max_tree_levels];
    std::uint32_t level = tree.level_count - 1;
    node[level] = 0;
    mask[level] = kernels.hit_box(tree.levels[level][0], box);
    for (;;) {
        if (mask[level] == 0) {
            if (++level == tree.level_count) return;
            continue;
        }
        const std::uint32_t child = node[level] * 8 + std::uint32_t(__builtin_ctz(unsigned(mask[level])));
        mask[level] &= mask[level] - 1;
        if (level == 0) {
            visit(child);
            continue;
        }
        --level;
        node[level] = child;
        mask[level] = kernels.hit_box(tree.levels[level][child], box);
    }
}

// max = visit(slot, max) for all items that lie at a distance up to `max`, about in the order of these; less than 0
// ends the walk. `enter(node, max, distances)`: which lanes of a node do, as bits, and where (8 floats, aligned to 32
// bytes); of those that are nowhere farther than the start, less than 0 says which come first. Returns the last max.
template <class Enter, class F> float visit_by_distance(const TreeView& tree, float max, Enter&& enter, F&& visit) {
    constexpr std::uint32_t index_bits = 3 * max_tree_levels, first_level = 1u << index_bits;
    struct Entry { // of 8 bytes, which move as one
        float distance;
        std::uint32_t place; // level, and index there
    };
    Entry stack[7 * max_tree_levels + 8];
    int count = 0;
    if (tree.level_count == 0) return max;
    stack[count++] = {-largest_bound, tree.level_count * first_level};
    while (count > 0) {
        const Entry top = stack[--count];
        if (top.distance > max) continue;
        const std::uint32_t index = top.place % first_level;
        if (top.place < first_level) {
            max = visit(index, max);
            if (max < 0.0f) return max;
            continue;
        }
        const std::uint32_t below = top.place / first_level - 1, children = below * first_level + index * 8;
        alignas(32) float distance[8];
        int mask = enter(tree.levels[below][index], max, distance);
        Entry* const first = stack + count;
        for (; mask; mask &= mask - 1) { // farthest first, nearest on top
            const std::uint32_t lane = std::uint32_t(__builtin_ctz(unsigned(mask)));
            Entry* at = stack + count++;
            for (; at > first && at[-1].distance < distance[lane]; --at) *at = at[-1];
            *at = {distance[lane], children + lane};
        }
    }
    return max;
}

} // namespace cairn
