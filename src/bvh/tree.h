// The implicit 8-lane tree: what it is made of, and the wide loops over it. Plain data, no functions, because kernel
// translation units of every instruction set include it.
//
// Level 0 holds the boxes of the items, 8 to a node (a leaf). Level k holds the bounds of 8 nodes of level k - 1 in
// each node. There are no pointers: the children of lane j of node i are node 8 i + j of the level below.
#pragma once

#include <cstdint>

namespace cairn {

// Bounds relative to the region origin, rounded outward. Empty: lo = empty_bound, hi = -empty_bound.
struct TreeBox {
    float lo[3], hi[3];
};

inline constexpr float largest_bound = 1e30f; // coordinates are clamped to this
inline constexpr float empty_bound = 3e38f;   // beyond every coordinate, so that an empty box meets nothing

// 8 boxes, side by side.
struct alignas(64) Node8 {
    float lo[3][8], hi[3][8];
};

inline constexpr int max_tree_levels = 9; // 8^9 items

struct TreeView {
    const Node8* levels[max_tree_levels]; // [0]: leaves
    std::uint32_t level_count;            // at least 2, or 0 for a tree without items
    std::uint32_t leaf_count;
};

// A ray relative to the region origin, or a box around it that moves along. On each axis it enters boxes at one of
// their sides and leaves them at the other: where the eight of a node are, as floats from its beginning; and how far
// along the ray they lie, (place - side) * rate. The places are the origin, moved out by half the size of the box that
// moves along and by what rounding to float may lose.
struct TreeRay {
    std::uint32_t entered[3], left[3];
    float entered_place[3], left_place[3], rate[3];
};

// A point relative to the region origin; `slack` widens every box by what rounding it to float may have lost.
struct TreePoint {
    float position[3];
    float slack;
};

// Leaves that meet a group of 64 items, ascending, and their boxes side by side. Room for 8 more than leaf_count of
// the tree; the kernel pads the boxes to a multiple of 8 with empty ones.
struct LeafList {
    std::uint32_t* leaf;
    float* bounds[6]; // lo x y z, hi x y z
};

// A leaf of a tree that the items of another leaf may meet, and which of them (its rows), as bits: in all others no
// item is met by any.
struct MetLeaf {
    const Node8* leaf;
    std::uint32_t index, rows;
};

// Partners of the 8 items of one leaf. Row r is keys[r * capacity ...], count[r] of them.
struct RowBuffer {
    std::uint32_t* keys;
    std::uint32_t capacity; // at least 8 x (leaves in the lists searched) + 8
    std::uint32_t count[8];
};

struct BroadKernels {
    // Lanes of the node that meet the box, as bits.
    int (*hit_box)(const Node8& node, const TreeBox& box);
    // Lanes that the ray meets before `max_distance`, and the distances at which it enters them
    // (8 floats, aligned to 32 bytes).
    int (*hit_ray)(const Node8& node, const TreeRay& ray, float max_distance, float* entry);
    // Lanes whose squared distance from the point is at most `max_square`, and these squares (8 floats, likewise).
    int (*hit_near)(const Node8& node, const TreePoint& point, float max_square, float* square);
    // Parent lanes 0 .. child_count - 1 become the bounds of the children; lanes beyond become empty.
    void (*refit)(const Node8* children, std::uint32_t child_count, Node8* parents);
    // Leaves number first_leaf and up that meet the box. Returns their number.
    std::uint32_t (*list_leaves)(const TreeView& tree, const TreeBox& box, std::uint32_t first_leaf,
                                 const LeafList& out);
    // Appends to the rows of leaf a the keys (key_base | slot) of all items of the listed leaves that they meet,
    // ascending. With `forward`, the list is of a's own tree and only later items count.
    void (*find_rows)(const Node8& a, const TreeBox& bounds_a, std::uint32_t leaf_a, bool forward, const Node8* leaves,
                      const LeafList& list, std::uint32_t list_count, std::uint32_t key_base, RowBuffer& rows);
    // Leaves of a tree with a box around them that an item of leaf a meets. Room for leaf_count of the tree. Returns
    // their number.
    std::uint32_t (*list_met)(const Node8& a, const TreeBox& bounds_a, const TreeView& tree, MetLeaf* out);
    // All meeting pairs of an item of leaf a and one of the given leaves, as row | lane << 3 | place among the leaves
    // << 6. Room for 64 x leaf_count in `out`. Returns their number.
    std::uint32_t (*find_others)(const Node8& a, const TreeBox& bounds_a, const MetLeaf* leaves,
                                 std::uint32_t leaf_count, std::uint32_t* out);
    // Sets flags[leaf] for leaves up to last_leaf with an item that meets exactly one of the two boxes.
    void (*mark_changed)(const TreeView& tree, const TreeBox& before, const TreeBox& after, std::uint32_t last_leaf,
                         std::uint8_t* flags);
};

} // namespace cairn
