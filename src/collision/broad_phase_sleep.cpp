// Sleeping islands of the broad phase: each has a small tree, and a list of the pairs that are kept while it sleeps.
#include "bvh/traverse.h"
#include "collision/broad_phase.h"

namespace cairn {

namespace {

bool overlap(const DBounds& a, const DBounds& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.lo[axis] > b.hi[axis] || a.hi[axis] < b.lo[axis]) return false;
    return true;
}

} // namespace

// The levels of an island's tree follow one another in island_nodes_, leaves first, up to a single node.
TreeView BroadPhase::island_view(const Island& island) const {
    TreeView view = {};
    view.leaf_count = (island.shape_count + 7) / 8;
    std::uint32_t base = island.node_base;
    for (std::uint32_t nodes = view.leaf_count;; nodes = (nodes + 7) / 8) {
        view.levels[view.level_count++] = island_nodes_.data() + base;
        if (nodes == 1) return view;
        base += nodes;
    }
}

std::uint32_t BroadPhase::new_island() {
    if (free_islands_.empty()) {
        islands_.push_back({});
        return std::uint32_t(islands_.size() - 1);
    }
    const std::uint32_t island = free_islands_.back();
    free_islands_.pop_back();
    return island;
}

// Recomputes the nodes above the leaves; returns the bounds of the island.
TreeBox BroadPhase::refit_island(const Island& island) {
    std::uint32_t base = island.node_base;
    for (std::uint32_t nodes = (island.shape_count + 7) / 8; nodes > 1; nodes = (nodes + 7) / 8) {
        kernels_.refit(&island_nodes_[base], nodes, &island_nodes_[base + nodes]);
        base += nodes;
    }
    return bounds_of(island_nodes_[base]);
}

void BroadPhase::put_to_sleep(std::uint32_t island_key, std::span<const std::uint32_t> shapes) {
    if (shapes.empty()) return;
    compact_islands();
    boxes_.clear();
    for (const std::uint32_t shape : shapes) {
        const Proxy& proxy = proxies_[shape];
        const TreeBox box = awake_[proxy.home].box(proxy.place);
        note_change(shape, box);
        note_touched(box);
        awake_[proxy.home].kill(proxy.place);
        boxes_.push_back(box);
    }
    const std::uint32_t index = new_island();
    Island& island = islands_[index];
    island = {};
    island.key = island_key;
    island.shape_base = std::uint32_t(island_shapes_.size());
    island.shape_count = island.alive_count = std::uint32_t(shapes.size());
    island.first_pair = none;
    island.node_base = std::uint32_t(island_nodes_.size());
    std::uint32_t nodes = (island.shape_count + 7) / 8;
    for (island.node_count = nodes; nodes > 1; island.node_count += nodes) nodes = (nodes + 7) / 8;
    island_nodes_.resize(island_nodes_.size() + island.node_count, empty_node());
    const std::span<const std::uint32_t> order = kd_.order(boxes_);
    for (std::uint32_t slot = 0; slot < island.shape_count; ++slot) {
        const std::uint32_t shape = shapes[order[slot]];
        island_shapes_.push_back(shape);
        set_lane(island_nodes_[island.node_base + slot / 8], slot % 8, boxes_[order[slot]]);
        Proxy& proxy = proxies_[shape];
        proxy.state = State::sleeping;
        proxy.home = index;
        proxy.place = slot;
    }
    island.top_slot = top_.append(index, refit_island(island));
    if (island_key >= island_of_key_.size()) island_of_key_.resize(island_key + 1, none);
    island_of_key_[island_key] = index;
    sleeping_count_ += island.shape_count;
    transfers_ = 1;
}

void BroadPhase::wake(std::uint32_t island_key) {
    if (!is_asleep(island_key)) return;
    const std::uint32_t index = island_of_key_[island_key];
    const Island island = islands_[index];
    for (std::uint32_t slot = 0; slot < island.shape_count; ++slot) {
        const TreeBox box = box_of_lane(island_nodes_[island.node_base + slot / 8], slot % 8);
        if (is_empty(box)) continue; // removed while it slept
        note_touched(box);
        place_awake(island_shapes_[island.shape_base + slot]);
    }
    sleeping_count_ -= island.alive_count;
    release_island(index);
}

void BroadPhase::release_island(std::uint32_t index) {
    Island& island = islands_[index];
    release_kept(island.first_pair, true);
    top_.kill(island.top_slot);
    island_of_key_[island.key] = none;
    dead_island_nodes_ += island.node_count;
    dead_island_shapes_ += island.shape_count;
    island = {};
    island.key = none;
    island.first_pair = none;
    free_islands_.push_back(index);
    transfers_ = 1;
}

void BroadPhase::remove_sleeping(std::uint32_t shape) {
    const Proxy proxy = proxies_[shape];
    Island& island = islands_[proxy.home];
    note_touched(relative(fat_[shape]));
    island.removal = removals_ = 1;
    --sleeping_count_;
    set_lane(island_nodes_[island.node_base + proxy.place / 8], proxy.place % 8, empty_box);
    if (--island.alive_count == 0)
        release_island(proxy.home);
    else
        top_.set_box(island.top_slot, refit_island(island));
}

void BroadPhase::write_sleeping_box(std::uint32_t shape, const TreeBox& box) {
    const Proxy& proxy = proxies_[shape];
    Island& island = islands_[proxy.home];
    Node8& leaf = island_nodes_[island.node_base + proxy.place / 8];
    note_touched(box_of_lane(leaf, proxy.place % 8));
    note_touched(box);
    island.removal = removals_ = 1;
    set_lane(leaf, proxy.place % 8, box);
    top_.set_box(island.top_slot, refit_island(island));
}

// Compacts the trees of sleeping islands when more than half of the pool is unused.
void BroadPhase::compact_islands() {
    const bool few_nodes = 2 * std::size_t(dead_island_nodes_) <= island_nodes_.size() + 64;
    const bool few_shapes = 2 * std::size_t(dead_island_shapes_) <= island_shapes_.size() + 64;
    if (few_nodes && few_shapes) return;
    node_scratch_.clear();
    shape_scratch_.clear();
    for (Island& island : islands_) {
        if (island.shape_count == 0) continue;
        const auto node = island_nodes_.begin() + island.node_base;
        const auto shape = island_shapes_.begin() + island.shape_base;
        island.node_base = std::uint32_t(node_scratch_.size());
        island.shape_base = std::uint32_t(shape_scratch_.size());
        node_scratch_.insert(node_scratch_.end(), node, node + island.node_count);
        shape_scratch_.insert(shape_scratch_.end(), shape, shape + island.shape_count);
    }
    island_nodes_.swap(node_scratch_);
    island_shapes_.swap(shape_scratch_);
    dead_island_nodes_ = dead_island_shapes_ = 0;
}

// --- Pairs of shapes that do not move.

// Whether a pair of these shapes is kept until one of them wakes.
bool BroadPhase::may_keep(std::uint32_t shape_a, std::uint32_t shape_b) const {
    const State a = proxies_[shape_a].state, b = proxies_[shape_b].state;
    const auto at_rest = [](State s) { return s == State::fixed || s == State::plane || s == State::sleeping; };
    if (!at_rest(a) || !at_rest(b) || (a != State::sleeping && b != State::sleeping)) return false;
    return a == State::plane || b == State::plane || overlap(fat_[shape_a], fat_[shape_b]);
}

void BroadPhase::keep_pair(const EndedPair& pair) {
    const Proxy &a = proxies_[pair.shape_a], &b = proxies_[pair.shape_b];
    const bool both_sleep = a.state == State::sleeping && b.state == State::sleeping;
    const std::uint32_t island = a.state == State::sleeping ? a.home : b.home;
    std::uint32_t& first = both_sleep && a.home != b.home ? first_cross_pair_ : islands_[island].first_pair;
    std::uint32_t index = first_free_kept_;
    if (index == none) {
        index = std::uint32_t(kept_.size());
        kept_.push_back({});
    } else {
        first_free_kept_ = kept_[index].next;
    }
    kept_[index] = {pair.shape_a, pair.shape_b, pair.contact, first};
    first = index;
    ++kept_count_;
}

// Moves the pairs of a list, or only those that may not be kept, to the next report.
void BroadPhase::release_kept(std::uint32_t& first, bool all) {
    std::uint32_t* link = &first;
    while (*link != none) {
        const std::uint32_t index = *link;
        KeptPair& pair = kept_[index];
        if (!all && may_keep(pair.shape_a, pair.shape_b)) {
            link = &pair.next;
            continue;
        }
        returned_.push_back({pair.shape_a, pair.shape_b, pair.contact, 0});
        *link = pair.next;
        pair.next = first_free_kept_;
        first_free_kept_ = index;
        --kept_count_;
    }
}

// Flags the sleeping islands that may keep pairs with a fixed shape whose box is removed or changed.
void BroadPhase::flag_removal(const TreeBox& box) {
    visit_box(kernels_, top_.view(), box, [&](std::uint32_t slot) {
        islands_[top_.item(slot)].removal = 1;
        removals_ = 1;
    });
}

void BroadPhase::collect_returned_pairs() {
    if (removals_)
        for (Island& island : islands_) {
            if (island.removal) release_kept(island.first_pair, false);
            island.removal = 0;
        }
    if (removals_ || transfers_) release_kept(first_cross_pair_, false);
    removals_ = 0;
}

} // namespace cairn
