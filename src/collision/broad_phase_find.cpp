// The search for pairs. The rows of a leaf depend on the boxes, and on what they were before, alone: leaves in which
// nothing can have changed are skipped, and the others may be searched in any order, by any number of threads.
#include "collision/broad_phase.h"

#include <algorithm>

namespace cairn {

// Marks the leaves whose rows may have changed: those of shapes that changed their boxes, those of shapes listed
// before them that meet the old box but not the new one or the other way round, and those that meet a box of a shape
// that is not awake and has changed.
void BroadPhase::mark_leaves() {
    for (int home = 0; home < 2; ++home) {
        const std::uint32_t leaves = awake_[home].leaf_count();
        rows_[home].set_leaf_count(leaves);
        dirty_[home].assign(leaves, std::uint8_t(all_dirty_ != 0));
    }
    // Above so many, asking for each is dearer than searching everything.
    const std::size_t asked = changes_.size() + touched_.size(),
                      slots = awake_[0].slot_count() + awake_[1].slot_count();
    if (!all_dirty_ && search_all_ && asked > 0) all_dirty_ = 1;
    if (!all_dirty_ && asked * 7 > slots + 64) all_dirty_ = 1;
    if (all_dirty_) {
        for (auto& flags : dirty_) std::fill(flags.begin(), flags.end(), std::uint8_t(1));
        return;
    }
    for (const Change& change : changes_) {
        const SlotTree& tree = awake_[change.home];
        const std::uint32_t leaf = change.slot / 8;
        const TreeBox after = tree.box(change.slot);
        dirty_[change.home][leaf] = 1;
        kernels_.mark_changed(tree.view(), change.before, after, leaf, dirty_[change.home].data());
        if (change.home == 1) mark_everywhere(0, change.before, after);
    }
    for (const TreeBox& box : touched_)
        for (int home = 0; home < 2; ++home) mark_everywhere(home, empty_box, box);
}

void BroadPhase::mark_everywhere(int home, const TreeBox& before, const TreeBox& after) {
    const SlotTree& tree = awake_[home];
    if (tree.slot_count() > 0)
        kernels_.mark_changed(tree.view(), before, after, tree.leaf_count() - 1, dirty_[home].data());
}

// Leaves of a tree that meet the box, into list `which`.
std::uint32_t BroadPhase::list_leaves(int which, const TreeView& tree, const TreeBox& box, std::uint32_t first_leaf) {
    if (tree.level_count == 0) return 0;
    const std::size_t room = tree.leaf_count + 8;
    if (list_[which].size() < room) list_[which].resize(room);
    if (list_bounds_[which].size() < 6 * room) list_bounds_[which].resize(6 * room);
    return kernels_.list_leaves(tree, box, first_leaf, leaf_list(which));
}

LeafList BroadPhase::leaf_list(int which) {
    LeafList list = {list_[which].data(), {}};
    const std::size_t room = list_bounds_[which].size() / 6;
    for (std::size_t k = 0; k < 6; ++k) list.bounds[k] = list_bounds_[which].data() + k * room;
    return list;
}

// The leaves of fixed and sleeping shapes that meet the box.
void BroadPhase::list_others(const TreeBox& box) {
    other_leaves_.clear();
    other_shapes_.clear();
    const auto take = [&](const TreeView& tree, const std::uint32_t* shapes) {
        if (tree.level_count == 1) {
            other_leaves_.push_back(tree.levels[0]);
            other_shapes_.push_back(shapes);
            return;
        }
        const std::uint32_t count = list_leaves(0, tree, box, 0);
        for (std::uint32_t k = 0; k < count; ++k) {
            other_leaves_.push_back(tree.levels[0] + list_[0][k]);
            other_shapes_.push_back(shapes + std::size_t(list_[0][k]) * 8);
        }
    };
    take(fixed_.view(), fixed_.items());
    if (top_.alive_count() == 0) return;
    islands_hit_.clear();
    visit_box(kernels_, top_.view(), box, [&](std::uint32_t slot) { islands_hit_.push_back(top_.item(slot)); });
    for (const std::uint32_t index : islands_hit_) {
        const Island& island = islands_[index];
        take(island_view(island), &island_shapes_[island.shape_base]);
    }
}

void BroadPhase::mark_kinematic_leaves() {
    if (!has_kinematic_) return;
    for (int home = 0; home < 2; ++home) {
        const SlotTree& tree = awake_[home];
        kinematic_leaf_[home].assign(tree.leaf_count(), 1);
        for (std::uint32_t slot = 0; slot < tree.slot_count(); ++slot)
            if (tree.alive(slot) && !proxies_[tree.item(slot)].kinematic) kinematic_leaf_[home][slot / 8] = 0;
    }
}

// Takes the leaves that are kinematic throughout out of list `which`, so that a crowd of n kinematic shapes in one
// place is not n^2 pairs to look at. Returns how many are left; the boxes are padded as the kernels want it.
std::uint32_t BroadPhase::drop_kinematic_leaves(int which, int home, std::uint32_t count) {
    if (count == 0) return 0;
    const LeafList list = leaf_list(which);
    std::uint32_t left = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        if (kinematic_leaf_[home][list.leaf[k]]) continue;
        list.leaf[left] = list.leaf[k];
        for (float* bounds : list.bounds) bounds[left] = bounds[k];
        ++left;
    }
    for (std::uint32_t k = left; k < left + 8; ++k)
        for (int axis = 0; axis < 3; ++axis)
            list.bounds[axis][k] = empty_bound, list.bounds[axis + 3][k] = -empty_bound;
    return left;
}

void BroadPhase::search(int home) {
    const std::uint32_t leaves = awake_[home].leaf_count();
    for (std::uint32_t first = 0; first < leaves; first += 8) search_group(home, first, std::min(first + 8, leaves));
}

// The leaves first .. end - 1, 64 slots, share one walk through the trees.
void BroadPhase::search_group(int home, std::uint32_t first, std::uint32_t end) {
    const std::vector<std::uint8_t>& dirty = dirty_[home];
    while (first < end && !dirty[first]) ++first;
    if (first == end) return;
    TreeBox bounds = empty_box;
    for (std::uint32_t leaf = first; leaf < end; ++leaf)
        if (dirty[leaf]) include(bounds, awake_[home].leaf_bounds(leaf));
    list_others(bounds);
    std::uint32_t own_count = list_leaves(0, awake_[home].view(), bounds, first);
    std::uint32_t large_count = home == 0 ? list_leaves(1, awake_[1].view(), bounds, 0) : 0;
    if (has_kinematic_ && std::all_of(&kinematic_leaf_[home][first], &kinematic_leaf_[home][first] + (end - first),
                                      [](std::uint8_t all) { return all != 0; })) {
        own_count = drop_kinematic_leaves(0, home, own_count);
        large_count = drop_kinematic_leaves(1, 1, large_count);
    }
    row_buffer_.capacity = 8 * (own_count + large_count) + 8;
    if (row_keys_.size() < 8 * std::size_t(row_buffer_.capacity))
        row_keys_.resize(8 * std::size_t(row_buffer_.capacity));
    row_buffer_.keys = row_keys_.data();
    for (std::uint32_t leaf = first; leaf < end; ++leaf) {
        if (!dirty[leaf]) continue;
        ++last_.leaves_searched;
        search_leaf(home, leaf, own_count, large_count);
        merge_leaf(home, leaf);
    }
}

void BroadPhase::search_leaf(int home, std::uint32_t leaf, std::uint32_t own_count, std::uint32_t large_count) {
    const Node8& items = awake_[home].leaf(leaf);
    const TreeBox bounds = awake_[home].leaf_bounds(leaf);
    std::fill(row_buffer_.count, row_buffer_.count + 8, 0u);
    kernels_.find_rows(items, bounds, leaf, true, awake_[home].leaves(), leaf_list(0), own_count,
                       home == 0 ? 0u : large_key, row_buffer_);
    if (large_count > 0)
        kernels_.find_rows(items, bounds, leaf, false, awake_[1].leaves(), leaf_list(1), large_count, large_key,
                           row_buffer_);
    find_others(home, leaf, bounds);
    new_keys_.clear();
    std::size_t other = 0;
    for (std::uint32_t row = 0; row < 8; ++row) {
        const std::size_t begin = new_keys_.size();
        const std::uint32_t* keys = row_buffer_.keys + std::size_t(row) * row_buffer_.capacity;
        new_keys_.insert(new_keys_.end(), keys, keys + row_buffer_.count[row]);
        for (; other < others_.size() && others_[other] >> 32 == row; ++other)
            new_keys_.push_back(std::uint32_t(others_[other]));
        if (new_keys_.size() > begin && proxies_[awake_[home].item(leaf * 8 + row)].kinematic) {
            const auto keep =
                std::remove_if(new_keys_.begin() + std::ptrdiff_t(begin), new_keys_.end(), [&](std::uint32_t key) {
                    const Proxy& partner = proxies_[partner_shape(key)];
                    return partner.kinematic || partner.state == State::fixed || partner.state == State::plane;
                });
            new_keys_.erase(keep, new_keys_.end());
        }
        new_count_[row] = std::uint32_t(new_keys_.size() - begin);
    }
}

// Partners that are not awake, as row << 32 | key, sorted.
void BroadPhase::find_others(int home, std::uint32_t leaf, const TreeBox& bounds) {
    constexpr std::size_t chunk = 64; // leaves at a time, so that the buffer stays small
    const Node8& items = awake_[home].leaf(leaf);
    others_.clear();
    hits_.resize(64 * chunk);
    for (std::size_t first = 0; first < other_leaves_.size(); first += chunk) {
        const std::uint32_t leaves = std::uint32_t(std::min(chunk, other_leaves_.size() - first));
        const std::uint32_t count = kernels_.find_others(items, bounds, &other_leaves_[first], leaves, hits_.data());
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t hit = hits_[k];
            const std::uint32_t shape = other_shapes_[first + (hit >> 6)][hit >> 3 & 7];
            others_.push_back(std::uint64_t(hit & 7) << 32 | other_key | shape);
        }
    }
    for (const Plane& plane : planes_) {
        if (!crosses(plane, bounds)) continue;
        for (std::uint32_t row = 0; row < 8; ++row)
            if (crosses(plane, box_of_lane(items, row)))
                others_.push_back(std::uint64_t(row) << 32 | other_key | plane.shape);
    }
    std::sort(others_.begin(), others_.end());
}

// Replaces the rows of a leaf by the new ones: pairs in both keep their contacts.
void BroadPhase::merge_leaf(int home, std::uint32_t leaf) {
    const LeafRows& old_rows = rows_[home].leaf(leaf);
    const PairEntry* old = rows_[home].entries(leaf);
    const std::uint32_t* key = new_keys_.data();
    const bool asks_again = !refiltered_.empty();
    bool changed = asks_again;
    for (std::uint32_t row = 0; row < 8; ++row) changed |= new_count_[row] != old_rows.count[row];
    for (std::uint32_t k = 0; !changed && k < std::uint32_t(new_keys_.size()); ++k) changed = key[k] != old[k].key;
    if (!changed) return;

    merged_.clear();
    for (std::uint32_t row = 0; row < 8; ++row) {
        const std::uint32_t* const key_end = key + new_count_[row];
        const PairEntry* const old_end = old + old_rows.count[row];
        const std::uint32_t shape =
            awake_[home].slot_count() > leaf * 8 + row ? awake_[home].item(leaf * 8 + row) : none;
        while (key < key_end || old < old_end) {
            const bool is_old = old < old_end && (key == key_end || old->key <= *key);
            const bool is_new = key < key_end && (old == old_end || *key <= old->key);
            bool kept = is_old && is_new;
            if (!kept || asks_again) {
                const std::uint32_t partner = partner_shape(is_old ? old->key : *key);
                kept &= !proxies_[shape].refilter && !proxies_[partner].refilter;
                const std::uint32_t offset = std::uint32_t(merged_.size());
                if (is_old && !kept) ended_.push_back({shape, partner, old->contact, 0});
                if (is_new && !kept) found_.push_back({std::uint32_t(home), leaf, offset, shape, partner});
            }
            if (is_new) merged_.push_back({*key, kept ? old->contact : filtered_contact});
            key += is_new;
            old += is_old;
        }
    }
    rows_[home].replace(leaf, new_count_, merged_.data());
}

} // namespace cairn
