#include "bvh/slot_tree.h"
#include "core/room.h"

namespace cairn {

Node8 empty_node() {
    Node8 node;
    for (std::uint32_t lane = 0; lane < 8; ++lane) set_lane(node, lane, empty_box);
    return node;
}

TreeBox box_of_lane(const Node8& node, std::uint32_t lane) {
    return {{node.lo[0][lane], node.lo[1][lane], node.lo[2][lane]},
            {node.hi[0][lane], node.hi[1][lane], node.hi[2][lane]}};
}

void set_lane(Node8& node, std::uint32_t lane, const TreeBox& box) {
    for (int axis = 0; axis < 3; ++axis) node.lo[axis][lane] = box.lo[axis], node.hi[axis][lane] = box.hi[axis];
}

void include(TreeBox& box, const TreeBox& other) {
    for (int axis = 0; axis < 3; ++axis) {
        if (other.lo[axis] < box.lo[axis]) box.lo[axis] = other.lo[axis];
        if (other.hi[axis] > box.hi[axis]) box.hi[axis] = other.hi[axis];
    }
}

TreeBox bounds_of(const Node8& node) {
    TreeBox bounds = empty_box;
    for (std::uint32_t lane = 0; lane < 8; ++lane) include(bounds, box_of_lane(node, lane));
    return bounds;
}

TreeBox SlotTree::bounds() const {
    const TreeView tree = view();
    return tree.level_count == 0 ? empty_box : bounds_of(tree.levels[tree.level_count - 1][0]);
}

TreeView SlotTree::view() const {
    TreeView view = {};
    while (view.level_count < std::uint32_t(max_tree_levels) && !levels_[view.level_count].empty()) {
        view.levels[view.level_count] = levels_[view.level_count].data();
        ++view.level_count;
    }
    view.leaf_count = leaf_count();
    return view;
}

// Gives every level the nodes that the level below needs, up to a single root. A new root above the previous one starts
// with its bounds.
void SlotTree::grow_levels() {
    for (int k = 1; k < max_tree_levels; ++k) {
        const std::size_t below = levels_[k - 1].size();
        if (below == 0 || (k > 1 && below == 1)) {
            levels_[k].clear();
            continue;
        }
        const bool is_new = levels_[k].empty();
        levels_[k].resize((below + 7) / 8, empty_node());
        if (!is_new) continue;
        for (std::uint32_t child = 0; child < below; ++child)
            set_lane(levels_[k][child / 8], child % 8, bounds_of(levels_[k - 1][child]));
    }
}

void SlotTree::grow_ancestors(std::uint32_t slot, const TreeBox& box) {
    std::uint32_t child = slot / 8;
    for (int k = 1; k < max_tree_levels && !levels_[k].empty(); ++k, child /= 8) {
        Node8& node = levels_[k][child / 8];
        const std::uint32_t lane = child % 8;
        bool grew = false;
        for (int axis = 0; axis < 3; ++axis) {
            if (box.lo[axis] < node.lo[axis][lane]) node.lo[axis][lane] = box.lo[axis], grew = true;
            if (box.hi[axis] > node.hi[axis][lane]) node.hi[axis][lane] = box.hi[axis], grew = true;
        }
        if (!grew) return;
    }
}

std::uint32_t SlotTree::append(std::uint32_t item, const TreeBox& box) {
    const std::uint32_t slot = slot_count();
    push(items_, item);
    if (slot % 8 == 0) {
        push(levels_[0], empty_node());
        grow_levels();
    }
    ++alive_;
    ++unsorted_;
    set_box(slot, box);
    return slot;
}

void SlotTree::kill(std::uint32_t slot) {
    set_lane(levels_[0][slot / 8], slot % 8, empty_box);
    --alive_;
    ++unsorted_;
    changed_ = 1;
}

void SlotTree::set_box(std::uint32_t slot, const TreeBox& box) {
    set_lane(levels_[0][slot / 8], slot % 8, box);
    grow_ancestors(slot, box);
    changed_ = 1;
}

void SlotTree::refit(const BroadKernels& kernels) {
    if (!changed_) return;
    changed_ = 0;
    for (int k = 1; k < max_tree_levels && !levels_[k].empty(); ++k)
        kernels.refit(levels_[k - 1].data(), std::uint32_t(levels_[k - 1].size()), levels_[k].data());
}

void SlotTree::sort(KdOrder& kd, const BroadKernels& kernels) {
    sort_items_.clear();
    sort_boxes_.clear();
    for (std::uint32_t slot = 0; slot < slot_count(); ++slot) {
        if (!alive(slot)) continue;
        sort_items_.push_back(items_[slot]);
        sort_boxes_.push_back(box(slot));
    }
    assign(sort_items_, sort_boxes_, kd, kernels);
}

void SlotTree::assign(std::span<const std::uint32_t> items, std::span<const TreeBox> boxes, KdOrder& kd,
                      const BroadKernels& kernels) {
    const std::span<const std::uint32_t> order = kd.order(boxes);
    const std::uint32_t count = std::uint32_t(order.size());
    items_.resize(count);
    levels_[0].clear();
    levels_[0].resize((count + 7) / 8, empty_node());
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        items_[slot] = items[order[slot]];
        set_lane(levels_[0][slot / 8], slot % 8, boxes[order[slot]]);
    }
    for (int k = 1; k < max_tree_levels; ++k) levels_[k].clear();
    for (int k = 1; k < max_tree_levels; ++k) {
        const std::size_t below = levels_[k - 1].size();
        if (below == 0 || (k > 1 && below == 1)) break;
        levels_[k].resize((below + 7) / 8, empty_node());
    }
    alive_ = count;
    unsorted_ = 0;
    changed_ = 1;
    refit(kernels);
}

std::size_t SlotTree::bytes() const {
    std::size_t sum = items_.capacity() * sizeof(std::uint32_t) + sort_items_.capacity() * sizeof(std::uint32_t) +
                      sort_boxes_.capacity() * sizeof(TreeBox);
    for (const auto& level : levels_) sum += level.capacity() * sizeof(Node8);
    return sum;
}

} // namespace cairn
