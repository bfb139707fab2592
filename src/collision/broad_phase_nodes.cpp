// The boxes of the broad phase's trees, for debug drawing.
#include "collision/broad_phase.h"

namespace cairn {

std::vector<BroadPhase::Node> BroadPhase::nodes(std::uint32_t max_depth, std::size_t max_count) const {
    // A node whose lanes are children of the box at index `parent` of the list.
    struct Below {
        Node::Tree tree;
        const Island* island; // the island whose tree it is, or null
        TreeView view;
        std::uint32_t level, index, parent;
    };
    std::vector<Node> list;
    std::vector<Below> now, next;
    const auto add = [&](const TreeBox& box, Node::Tree tree, std::uint32_t depth, std::uint32_t parent) {
        const math::DVec3 lo{box.lo[0], box.lo[1], box.lo[2]}, hi{box.hi[0], box.hi[1], box.hi[2]};
        list.push_back({{origin_ + lo, origin_ + hi}, tree, depth, parent, none});
        return std::uint32_t(list.size() - 1);
    };
    const auto look_below = [&](Node::Tree tree, const Island* island, const TreeView& view, std::uint32_t parent) {
        next.push_back({tree, island, view, view.level_count - 1, 0, parent});
    };
    using Tree = Node::Tree;
    const std::pair<const SlotTree*, Tree> trees[] = {
        {&fixed_, Tree::fixed}, {&awake_[0], Tree::awake}, {&awake_[1], Tree::large}, {&top_, Tree::sleeping}};
    for (const auto& [tree, name] : trees)
        if (tree->alive_count() > 0 && list.size() < max_count)
            look_below(name, nullptr, tree->view(), add(tree->bounds(), name, 0, none));
    for (std::uint32_t depth = 1; depth <= max_depth && !next.empty(); ++depth) {
        now.swap(next), next.clear();
        for (const Below& below : now)
            for (std::uint32_t lane = 0; lane < 8; ++lane) {
                const TreeBox box = box_of_lane(below.view.levels[below.level][below.index], lane);
                if (is_empty(box)) continue;
                if (list.size() >= max_count) return list;
                const std::uint32_t place = add(box, below.tree, depth, below.parent), slot = 8 * below.index + lane;
                if (below.level > 0) {
                    next.push_back({below.tree, below.island, below.view, below.level - 1, slot, place});
                } else if (below.tree == Tree::sleeping && !below.island) {
                    const Island& island = islands_[top_.item(slot)];
                    look_below(below.tree, &island, island_view(island), place);
                } else {
                    const SlotTree& tree = *trees[std::size_t(below.tree)].first;
                    list.back().shape =
                        below.island ? island_shapes_[below.island->shape_base + slot] : tree.item(slot);
                    list.back().bounds = fat_[list.back().shape];
                }
            }
    }
    return list;
}

} // namespace cairn
