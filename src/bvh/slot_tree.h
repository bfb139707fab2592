// Items in slots of an implicit 8-lane tree (tree.h). A sort puts the items into kd order, by median splits that fit
// the tree exactly; between sorts, items are appended and removed, and their boxes change in place. The tree is always
// valid for queries: bounds of ancestors grow immediately, and shrink at the next refit.
#pragma once

#include "bvh/tree.h"
#include "core/room.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cairn {

inline constexpr TreeBox empty_box = {{empty_bound, empty_bound, empty_bound},
                                      {-empty_bound, -empty_bound, -empty_bound}};

inline bool is_empty(const TreeBox& box) { return box.lo[0] > box.hi[0]; }
Node8 empty_node();
TreeBox box_of_lane(const Node8& node, std::uint32_t lane);
void set_lane(Node8& node, std::uint32_t lane, const TreeBox& box);
void include(TreeBox& box, const TreeBox& other);
TreeBox bounds_of(const Node8& node);

// Computes a permutation of boxes[0 .. n - 1] in kd order: splits at the median of the longest axis of the boxes'
// centers, with the lower half a multiple of 8 x 2^k, so that every node of the implicit tree is one cell. Allocates
// only to grow.
class KdOrder {
  public:
    std::span<const std::uint32_t> order(std::span<const TreeBox> boxes);
    void give_back() { // frees unused memory
        for (std::vector<Item>* part : {&items_, &low_, &middle_, &high_}) release_memory(*part);
        release_memory(order_);
    }
    std::size_t bytes() const;

  private:
    struct Item {
        float center[3];
        std::uint32_t index;
    };
    void split(Item* items, std::uint32_t count);
    void select(Item* items, std::uint32_t count, std::uint32_t middle, int axis, float low, float high);

    std::vector<Item> items_, low_, middle_, high_;
    std::vector<std::uint32_t> order_;
};

// Validates the leaves of a loaded tree: throws Error(invalid_file) unless each of `count` items has a finite or an
// empty box, and the lanes beyond them are empty. `alive`: the number of items with a box.
void check_leaves(const char* name, const Node8* leaves, std::size_t count, std::size_t& alive);
// Validates the level above `count` nodes.
void check_inner_nodes(const char* name, const Node8* nodes, std::size_t count);

class SlotTree {
  public:
    std::uint32_t slot_count() const { return std::uint32_t(items_.size()); }
    std::uint32_t alive_count() const { return alive_; }
    std::uint32_t leaf_count() const { return (slot_count() + 7) / 8; }
    std::uint32_t item(std::uint32_t slot) const { return items_[slot]; } // also of a dead slot, until the next sort
    bool alive(std::uint32_t slot) const { return !is_empty(box(slot)); }
    TreeBox box(std::uint32_t slot) const { return box_of_lane(levels_[0][slot / 8], slot % 8); }
    TreeBox leaf_bounds(std::uint32_t leaf) const { return box_of_lane(levels_[1][leaf / 8], leaf % 8); }
    const Node8& leaf(std::uint32_t leaf) const { return levels_[0][leaf]; }
    const Node8& node(std::uint32_t level, std::uint32_t i) const { return levels_[level][i]; }
    const Node8* leaves() const { return levels_[0].data(); }
    const std::uint32_t* items() const { return items_.data(); } // by slot
    TreeView view() const;
    TreeBox bounds() const; // of all items; may be too large between refits

    std::uint32_t append(std::uint32_t item, const TreeBox& box); // returns the slot
    void kill(std::uint32_t slot);
    void set_box(std::uint32_t slot, const TreeBox& box);
    // set_box for concurrent calls, each thread with slots of its own: the bounds above the leaves are valid again
    // after note_change and a refit.
    void set_leaf_box(std::uint32_t slot, const TreeBox& box) { set_lane(levels_[0][slot / 8], slot % 8, box); }
    void note_change() { changed_ = 1; }
    void refit(const BroadKernels& kernels); // makes all bounds tight, if anything has changed

    // Whether the slots that were appended or died since the last sort are many compared with all.
    bool wants_sort() const { return unsorted_ * 4 > slot_count() + 64; }
    void count_unsorted() { ++unsorted_; } // for an item that has moved far
    // Removes dead slots and puts the rest into kd order.
    void sort(KdOrder& kd, const BroadKernels& kernels);
    // Replaces all items by these, in kd order.
    void assign(std::span<const std::uint32_t> items, std::span<const TreeBox> boxes, KdOrder& kd,
                const BroadKernels& kernels);
    std::size_t bytes() const;

    // Validates a loaded tree: throws Error(invalid_file) unless it is a tree of items with numbers below `items`.
    void check(const char* name, std::size_t items) const;

    template <class Archive> void serialize(Archive& archive) {
        archive(items_);
        for (auto& level : levels_) archive(level);
        archive(alive_), archive(unsorted_), archive(changed_);
    }

  private:
    void grow_levels();
    void grow_ancestors(std::uint32_t slot, const TreeBox& box);

    std::vector<std::uint32_t> items_;           // by slot
    std::vector<Node8> levels_[max_tree_levels]; // [1] exists as soon as [0] does
    std::uint32_t alive_ = 0, unsorted_ = 0, changed_ = 0;
    std::vector<std::uint32_t> sort_items_; // scratch
    std::vector<TreeBox> sort_boxes_;
};

} // namespace cairn
