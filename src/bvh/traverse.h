// Traversals of the implicit tree for queries.
#pragma once

#include "bvh/slot_tree.h"

#include <algorithm>
#include <cstdint>

namespace cairn {

// Calls visit(slot) for all items that overlap the box, in slot order.
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

inline std::uint32_t leaf_count_of(const TreeView& tree) { return tree.leaf_count; }
inline std::uint32_t leaf_count_of(const SlotTree& tree) { return tree.leaf_count(); }
inline const Node8& node_of(const TreeView& tree, std::uint32_t level, std::uint32_t i) {
    return tree.levels[level][i];
}
inline const Node8& node_of(const SlotTree& tree, std::uint32_t level, std::uint32_t i) { return tree.node(level, i); }

// Calls max = visit(tree, slot, max) for all items of several trees at distances up to `max`, roughly in the order of
// distance; a negative result ends the traversal. `enter(node, max, distances)` returns the lanes of a node within
// `max` as bits, and their distances (8 floats, aligned to 32 bytes); lanes that contain the start have negative
// distances, which order them. Returns the last max.
//
// With several trees, the nearest of all remaining nodes comes next, so that hits in one tree limit the search in the
// others, as long as the list of nodes is short. Otherwise, and with a single tree, it is the nearest of the children
// of the last node: then the list grows at most by the depth of a tree, and fewer entries are moved in it.
template <class Tree, std::size_t tree_count, class Enter, class F>
float visit_by_distance(const Tree* const (&trees)[tree_count], float max, Enter&& enter, F&& visit) {
    // A node is encoded as a leading one, followed by three bits for each lane on the path to it from level
    // max_tree_levels.
    constexpr std::uint32_t place_bits = 3 * max_tree_levels + 1, first_item = 1u << (place_bits - 1);
    static_assert(tree_count <= 1u << (32 - place_bits));
    constexpr int sorted_room = 64;
    struct Entry { // 8 bytes, copied as one
        float distance;
        std::uint32_t place; // the bits above place_bits: the index of the tree
    };
    Entry list[sorted_room + 7 * max_tree_levels + 8]; // sorted, the farthest first
    int count = 0;
    const auto add_children = [&](std::uint32_t tree, std::uint32_t place, const Node8& node) {
        alignas(32) float distance[8];
        const Entry* const first = list + (tree_count == 1 || count > sorted_room ? count : 0);
        for (int mask = enter(node, max, distance); mask; mask &= mask - 1) {
            const std::uint32_t lane = std::uint32_t(__builtin_ctz(unsigned(mask)));
            Entry* at = list + count++;
            for (; at > first && at[-1].distance < distance[lane]; --at) *at = at[-1];
            *at = {distance[lane], tree << place_bits | place << 3 | lane};
        }
    };
    for (std::uint32_t tree = 0; tree < tree_count; ++tree) {
        std::uint32_t nodes = leaf_count_of(*trees[tree]), top = 0; // a single leaf needs no node above it
        if (nodes == 0) continue;
        for (; nodes > 1; nodes = (nodes + 7) / 8) ++top;
        add_children(tree, 1u << 3 * (std::uint32_t(max_tree_levels) - 1 - top), node_of(*trees[tree], top, 0));
    }
    while (count > 0) {
        const Entry top = list[--count];
        if (top.distance > max) {
            if (tree_count > 1 && count <= sorted_room) return max; // all others are farther
            continue;
        }
        const std::uint32_t tree = top.place >> place_bits, place = top.place % (1u << place_bits);
        if (place >= first_item) {
            max = visit(tree, place - first_item, max);
            if (max < 0.0f) return max;
            continue;
        }
        const auto depth = std::uint32_t(31 - __builtin_clz(place));
        const std::uint32_t level = std::uint32_t(max_tree_levels) - 1 - depth / 3;
        add_children(tree, place, node_of(*trees[tree], level, place - (1u << depth)));
    }
    return max;
}

} // namespace cairn
