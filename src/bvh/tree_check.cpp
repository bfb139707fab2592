// Validation of trees loaded from a snapshot.
#include "bvh/slot_tree.h"
#include "core/sound.h"

#include <cmath>

namespace cairn {

namespace {

bool is_of_numbers(const TreeBox& box) {
    bool all = true;
    for (int axis = 0; axis < 3; ++axis)
        all &= box.lo[axis] <= box.hi[axis] && box.lo[axis] >= -largest_bound && box.hi[axis] <= largest_bound;
    return all;
}
bool is_exactly_empty(const TreeBox& box) {
    bool all = true;
    for (int axis = 0; axis < 3; ++axis) all &= box.lo[axis] == empty_bound && box.hi[axis] == -empty_bound;
    return all;
}

} // namespace

void check_leaves(const char* name, const Node8* leaves, std::size_t count, std::size_t& alive) {
    alive = 0;
    for (std::size_t slot = 0; slot < (count + 7) / 8 * 8; ++slot) {
        const TreeBox box = box_of_lane(leaves[slot / 8], std::uint32_t(slot % 8));
        const bool is_alive = slot < count && is_of_numbers(box);
        require_sound(is_alive || is_exactly_empty(box), {name, slot, "box"}, std::int64_t(slot),
                      "must be bounds in order, or empty, in slot");
        alive += is_alive;
    }
}

void check_inner_nodes(const char* name, const Node8* nodes, std::size_t count) {
    for (std::size_t child = count; child % 8 != 0; ++child)
        require_sound(is_exactly_empty(box_of_lane(nodes[child / 8], std::uint32_t(child % 8))), {name, child, "node"},
                      std::int64_t(child), "must be empty, as there is nothing below it, in lane");
}

void SlotTree::check(const char* name, std::size_t items) const {
    std::size_t below = (items_.size() + 7) / 8, alive = 0;
    require_count(name, levels_[0].size(), below);
    check_leaves(name, levels_[0].data(), items_.size(), alive);
    require_count(name, alive_, alive);
    for (int k = 1; k < max_tree_levels; ++k) {
        const std::size_t nodes = below == 0 || (k > 1 && below == 1) ? 0 : (below + 7) / 8;
        require_count(name, levels_[k].size(), nodes);
        if (nodes > 0) check_inner_nodes(name, levels_[k].data(), below);
        below = nodes;
    }
    require_sound(below <= 1, {name, 0, "levels"}, std::int64_t(items_.size()), "must not have so many items");
    for (std::size_t slot = 0; slot < items_.size(); ++slot)
        require_sound(items_[slot] < items, {name, slot, "item"}, items_[slot], "must be there");
}

} // namespace cairn
