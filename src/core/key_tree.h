// A binary tree of the bounds of items with a few numbers (keys) each, to search one among many.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cairn {

template <std::size_t count> class KeyTree {
  public:
    using Keys = std::array<double, count>;
    // Bounds of at least the items below a node that have not been removed.
    struct Bounds {
        Keys lo, hi;
    };

    // Builds the tree; item i has keys[i]. Nodes are split by the key that spreads farthest, measured in units of 1 /
    // scale.
    void build(std::span<const Keys> keys, const Keys& scale) {
        items_.resize(keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i) items_[i] = static_cast<std::uint32_t>(i);
        leaf_of_.resize(keys.size());
        nodes_.clear();
        if (!keys.empty()) add_node(keys, scale, 0, static_cast<std::uint32_t>(keys.size()), 0);
    }

    // Whether `is_it(item)` holds for any item. Only items below nodes with `may_hold(bounds)` are tested, or all if
    // there are few. Removed items may be tested, too.
    template <class MayHold, class IsIt> bool any(MayHold&& may_hold, IsIt&& is_it) const {
        std::uint32_t stack[64]; // sufficient: the depth is that of a balanced tree
        int depth = 0;
        if (!nodes_.empty()) stack[depth++] = 0;
        while (depth > 0) {
            const std::uint32_t at = stack[--depth];
            const Node& node = nodes_[at];
            const bool is_only = nodes_.size() == 1;
            if (node.left == 0 || !(is_only || may_hold(node.bounds))) continue;
            if (node.second == 0) {
                for (std::uint32_t i = node.first; i < node.end; ++i)
                    if (is_it(items_[i])) return true;
                continue;
            }
            stack[depth++] = node.second;
            stack[depth++] = at + 1;
        }
        return false;
    }

    void remove(std::uint32_t item) {
        for (std::uint32_t at = leaf_of_[item];; at = nodes_[at].parent) {
            --nodes_[at].left;
            if (at == 0) return;
        }
    }

  private:
    static constexpr std::uint32_t leaf_size = 8;
    struct Node {
        Bounds bounds;
        std::uint32_t first, end;     // a range of items_
        std::uint32_t left;           // number of items that have not been removed
        std::uint32_t parent, second; // the first child is the next node; second 0: a leaf
    };

    void add_node(std::span<const Keys> keys, const Keys& scale, std::uint32_t first, std::uint32_t end,
                  std::uint32_t parent) {
        const std::size_t at = nodes_.size();
        Bounds b{keys[items_[first]], keys[items_[first]]};
        for (std::uint32_t i = first + 1; i < end; ++i)
            for (std::size_t k = 0; k < count; ++k) {
                b.lo[k] = std::min(b.lo[k], keys[items_[i]][k]);
                b.hi[k] = std::max(b.hi[k], keys[items_[i]][k]);
            }
        nodes_.push_back({b, first, end, end - first, parent, 0});
        if (end - first <= leaf_size) {
            for (std::uint32_t i = first; i < end; ++i) leaf_of_[items_[i]] = static_cast<std::uint32_t>(at);
            return;
        }
        std::size_t widest = 0;
        const auto spread = [&](std::size_t k) { return scale[k] * (b.hi[k] - b.lo[k]); };
        for (std::size_t k = 1; k < count; ++k)
            if (spread(k) > spread(widest)) widest = k;
        const std::uint32_t middle = first + (end - first) / 2;
        std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + end,
                         [&](std::uint32_t i, std::uint32_t j) {
                             const double x = keys[i][widest], y = keys[j][widest];
                             return x != y ? x < y : i < j;
                         });
        add_node(keys, scale, first, middle, static_cast<std::uint32_t>(at));
        nodes_[at].second = static_cast<std::uint32_t>(nodes_.size());
        add_node(keys, scale, middle, end, static_cast<std::uint32_t>(at));
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_, leaf_of_; // leaf_of_: the leaf of each item
};

} // namespace cairn
