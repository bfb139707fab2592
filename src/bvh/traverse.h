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
// bytes). Returns the last max.
template <class Enter, class F> float visit_by_distance(const TreeView& tree, float max, Enter&& enter, F&& visit) {
    struct Entry {
        float distance;
        std::uint32_t level, index;
    };
    Entry stack[7 * max_tree_levels + 8];
    int count = 0;
    if (tree.level_count == 0) return max;
    stack[count++] = {0.0f, tree.level_count, 0};
    while (count > 0) {
        const Entry top = stack[--count];
        if (top.distance > max) continue;
        if (top.level == 0) {
            max = visit(top.index, max);
            if (max < 0.0f) return max;
            continue;
        }
        alignas(32) float distance[8];
        int mask = enter(tree.levels[top.level - 1][top.index], max, distance);
        const int first = count;
        for (; mask; mask &= mask - 1) { // farthest first, nearest on top
            const int lane = __builtin_ctz(unsigned(mask));
            int at = count++;
            for (; at > first && stack[at - 1].distance < distance[lane]; --at) stack[at] = stack[at - 1];
            stack[at] = {distance[lane], top.level - 1, top.index * 8 + std::uint32_t(lane)};
        }
    }
    return max;
}

} // namespace cairn
