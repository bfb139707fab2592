// The implicit 8-lane tree: its data, and the wide loops over it. Plain data, no functions, because kernel translation
// units of every instruction set include it.
//
// Level 0 holds the boxes of the items, 8 per node (a leaf). Each node of level k holds the bounds of 8 nodes of level
// k - 1. There are no pointers: the children of lane j of node i are node 8 i + j of the level below.
#pragma once

#include <cstdint>

namespace cairn {

// Bounds relative to the trees' origin, rounded outward. Empty: lo = empty_bound, hi = -empty_bound.
struct TreeBox {
    float lo[3], hi[3];
};

inline constexpr float largest_bound = 1e30f; // m: coordinates are clamped to this
inline constexpr float empty_bound = 3e38f;   // beyond every coordinate, so that an empty box overlaps nothing

// 8 boxes in SIMD layout.
struct alignas(64) Node8 {
    float lo[3][8], hi[3][8];
};

inline constexpr int max_tree_levels = 9; // enough for 8^9 items

struct TreeView {
    const Node8* levels[max_tree_levels]; // [0]: leaves
    std::uint32_t level_count;            // at least 2, or 0 for a tree without items
    std::uint32_t leaf_count;
};

// A ray relative to the trees' origin, or the sweep of a box. On each axis it enters boxes at one of their sides and
// leaves them at the opposite side. `entered` and `left` are the offsets of these eight sides in a node, in floats; the
// distances along the ray are (place - side) * rate. The places are the origin, moved outward by half the size of the
// swept box and by the rounding error of floats.
struct TreeRay {
    std::uint32_t entered[3], left[3];
    float entered_place[3], left_place[3], rate[3];
};

// A point relative to the trees' origin; `slack` widens every box by the error of rounding it to float.
struct TreePoint {
    float position[3];
    float slack;
};

// The leaves that overlap a group of 64 items, ascending, and their boxes in SIMD layout. The capacity is 8 more than
// the tree's leaf_count; the kernel pads the boxes to a multiple of 8 with empty ones.
struct LeafList {
    std::uint32_t* leaf;
    float* bounds[6]; // lo x y z, hi x y z
};

// A leaf of a tree that items of another leaf may overlap, and a bit mask of these items (rows); leaves that are not
// listed overlap no item.
struct MetLeaf {
    const Node8* leaf;
    std::uint32_t index, rows;
};

// The partners of the 8 items of one leaf. Row r is keys[r * capacity ...], count[r] of them.
struct RowBuffer {
    std::uint32_t* keys;
    std::uint32_t capacity; // at least 8 x (leaves in the lists searched) + 8
    std::uint32_t count[8];
};

struct BroadKernels {
    // Returns the lanes of the node that overlap the box, as bits.
    int (*hit_box)(const Node8& node, const TreeBox& box);
    // Returns the lanes that the ray enters before `max_distance`, as bits, and the distances where it enters them (8
    // floats, aligned to 32 bytes).
    int (*hit_ray)(const Node8& node, const TreeRay& ray, float max_distance, float* entry);
    // Returns the lanes whose squared distance from the point is at most `max_square`, as bits, and these squares (8
    // floats, aligned to 32 bytes).
    int (*hit_near)(const Node8& node, const TreePoint& point, float max_square, float* square);
    // Sets parent lanes 0 .. child_count - 1 to the bounds of the children, and the lanes beyond to empty.
    void (*refit)(const Node8* children, std::uint32_t child_count, Node8* parents);
    // Lists the leaves from first_leaf on that overlap the box. Returns their number.
    std::uint32_t (*list_leaves)(const TreeView& tree, const TreeBox& box, std::uint32_t first_leaf,
                                 const LeafList& out);
    // Appends to the rows of leaf a the keys (key_base | slot) of all items of the listed leaves that the items
    // overlap, in ascending order. With `forward`, the list is of a's own tree and only later items count.
    void (*find_rows)(const Node8& a, const TreeBox& bounds_a, std::uint32_t leaf_a, bool forward, const Node8* leaves,
                      const LeafList& list, std::uint32_t list_count, std::uint32_t key_base, RowBuffer& rows);
    // Lists the leaves of a tree whose bounds an item of leaf a overlaps. `out` has room for the tree's leaf_count.
    // Returns their number.
    std::uint32_t (*list_met)(const Node8& a, const TreeBox& bounds_a, const TreeView& tree, MetLeaf* out);
    // Lists all overlapping pairs of an item of leaf a and one of the given leaves, as row | lane << 3 | index of the
    // leaf << 6. `out` has room for 64 x leaf_count. Returns their number.
    std::uint32_t (*find_others)(const Node8& a, const TreeBox& bounds_a, const MetLeaf* leaves,
                                 std::uint32_t leaf_count, std::uint32_t* out);
    // Sets flags[leaf] for leaves up to last_leaf with an item that overlaps exactly one of the two boxes.
    void (*mark_changed)(const TreeView& tree, const TreeBox& before, const TreeBox& after, std::uint32_t last_leaf,
                         std::uint8_t* flags);
};

} // namespace cairn
