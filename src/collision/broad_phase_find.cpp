// The search for pairs. The new rows of a leaf depend only on the boxes and on the old rows: leaves that cannot have
// changed are skipped, and the others may be searched in any order, by any number of threads.
#include "collision/broad_phase.h"

#include <algorithm>

namespace cairn {

namespace {

constexpr std::uint32_t leaves_per_group = 8;
constexpr int groups_per_chunk = 4; // groups that a thread takes at a time

} // namespace

// Marks the leaves whose rows may have changed: leaves of shapes whose boxes have changed; leaves of shapes listed
// before these that overlap only the old or only the new box; and leaves that overlap a changed box of a shape that is
// not awake.
void BroadPhase::mark_leaves() {
    for (int home = 0; home < 2; ++home) {
        const std::uint32_t leaves = awake_[home].leaf_count();
        rows_[home].set_leaf_count(leaves);
        dirty_[home].assign(leaves, std::uint8_t(all_dirty_ != 0));
    }
    // Above this number, marking leaves costs more than searching everything.
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

// Lists the leaves of a tree that overlap the box in list `which`; returns their number.
std::uint32_t BroadPhase::list_leaves(Search& own, int which, const TreeView& tree, const TreeBox& box,
                                      std::uint32_t first_leaf) const {
    if (tree.level_count == 0) return 0;
    const std::size_t room = tree.leaf_count + 8;
    if (own.list[which].size() < room) own.list[which].resize(room);
    if (own.list_bounds[which].size() < 6 * room) own.list_bounds[which].resize(6 * room);
    return kernels_.list_leaves(tree, box, first_leaf, leaf_list(own, which));
}

LeafList BroadPhase::leaf_list(Search& own, int which) {
    LeafList list = {own.list[which].data(), {}};
    const std::size_t room = own.list_bounds[which].size() / 6;
    for (std::size_t k = 0; k < 6; ++k) list.bounds[k] = own.list_bounds[which].data() + k * room;
    return list;
}

void BroadPhase::mark_crowds() {
    if (!has_kinematic_) return;
    for (int home = 0; home < 2; ++home) {
        const SlotTree& tree = awake_[home];
        crowd_[home].assign(tree.leaf_count(), solids | triggers);
        for (std::uint32_t slot = 0; slot < tree.slot_count(); ++slot)
            if (tree.alive(slot)) crowd_[home][slot / 8] &= proxies_[tree.item(slot)].crowd;
    }
}

// Removes the leaves that belong to a crowd from list `which`, so that n kinematic shapes in one place do not cause n^2
// tests. Returns how many are left; pads the boxes as the kernels require.
std::uint32_t BroadPhase::drop_immovable_groups(Search& own, int which, int home, std::uint32_t count,
                                                std::uint8_t crowd) const {
    if (count == 0) return 0;
    const LeafList list = leaf_list(own, which);
    std::uint32_t left = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
        if (crowd_[home][list.leaf[k]] & crowd) continue;
        list.leaf[left] = list.leaf[k];
        for (float* bounds : list.bounds) bounds[left] = bounds[k];
        ++left;
    }
    for (std::uint32_t k = left; k < left + 8; ++k)
        for (int axis = 0; axis < 3; ++axis)
            list.bounds[axis][k] = empty_bound, list.bounds[axis + 3][k] = -empty_bound;
    return left;
}

// Searches in chunks, each of which records the changed rows; these are then merged in a fixed order.
void BroadPhase::search(int home, ThreadPool* thread_pool) {
    const std::uint32_t leaves = awake_[home].leaf_count();
    const auto groups = std::size_t(leaves + leaves_per_group - 1) / leaves_per_group;
    searches_.resize(thread_pool ? std::size_t(thread_pool->threads()) : 1);
    for (Search& own : searches_) own.fixed = fixed_.view(), own.top = top_.view();
    new_rows_.resize(std::max(new_rows_.size(), groups / groups_per_chunk + 1));
    for (NewRows& rows : new_rows_) rows.leaves.clear(), rows.keys.clear(), rows.searched = 0;
    for_chunks(thread_pool, int(groups), groups_per_chunk, [&](int begin, int end, int thread) {
        for (auto group = std::uint32_t(begin); group < std::uint32_t(end); ++group) {
            const std::uint32_t first = group * leaves_per_group;
            search_group(home, first, std::min(first + leaves_per_group, leaves), searches_[std::size_t(thread)],
                         new_rows_[std::size_t(begin / groups_per_chunk)]);
        }
    });
    for (const NewRows& rows : new_rows_) {
        last_.leaves_searched += rows.searched;
        for (const NewRows::Leaf& leaf : rows.leaves) merge_leaf(home, leaf, rows.keys.data() + leaf.begin);
    }
}

// Searches for the leaves first .. end - 1, up to 64 slots, which share one tree traversal.
void BroadPhase::search_group(int home, std::uint32_t first, std::uint32_t end, Search& own, NewRows& found) const {
    const std::vector<std::uint8_t>& dirty = dirty_[home];
    while (first < end && !dirty[first]) ++first;
    if (first == end) return;
    TreeBox bounds = empty_box;
    for (std::uint32_t leaf = first; leaf < end; ++leaf)
        if (dirty[leaf]) include(bounds, awake_[home].leaf_bounds(leaf));
    std::uint32_t own_count = list_leaves(own, 0, awake_[home].view(), bounds, first);
    std::uint32_t large_count = home == 0 ? list_leaves(own, 1, awake_[1].view(), bounds, 0) : 0;
    if (has_kinematic_) {
        std::uint8_t crowd = 0xff;
        for (std::uint32_t leaf = first; leaf < end; ++leaf) crowd &= crowd_[home][leaf];
        own_count = drop_immovable_groups(own, 0, home, own_count, crowd);
        large_count = drop_immovable_groups(own, 1, 1, large_count, crowd);
    }
    own.rows.capacity = 8 * (own_count + large_count) + 8;
    if (own.row_keys.size() < 8 * std::size_t(own.rows.capacity))
        own.row_keys.resize(8 * std::size_t(own.rows.capacity));
    own.rows.keys = own.row_keys.data();
    for (std::uint32_t leaf = first; leaf < end; ++leaf) {
        if (!dirty[leaf]) continue;
        ++found.searched;
        search_leaf(home, leaf, own_count, large_count, own, found);
    }
}

void BroadPhase::search_leaf(int home, std::uint32_t leaf, std::uint32_t own_count, std::uint32_t large_count,
                             Search& own, NewRows& found) const {
    const Node8& items = awake_[home].leaf(leaf);
    const TreeBox bounds = awake_[home].leaf_bounds(leaf);
    RowBuffer& rows = own.rows;
    std::fill(rows.count, rows.count + 8, 0u);
    kernels_.find_rows(items, bounds, leaf, true, awake_[home].leaves(), leaf_list(own, 0), own_count,
                       home == 0 ? 0u : large_key, rows);
    if (large_count > 0)
        kernels_.find_rows(items, bounds, leaf, false, awake_[1].leaves(), leaf_list(own, 1), large_count, large_key,
                           rows);
    find_others(home, leaf, bounds, own);
    std::vector<std::uint32_t>& all = found.keys;
    NewRows::Leaf now{leaf, std::uint32_t(all.size()), {}};
    std::size_t other = 0;
    for (std::uint32_t row = 0; row < 8; ++row) {
        const std::size_t begin = all.size();
        const std::uint32_t* keys = rows.keys + std::size_t(row) * rows.capacity;
        all.insert(all.end(), keys, keys + rows.count[row]);
        for (; other < own.others.size() && own.others[other] >> 32 == row; ++other)
            all.push_back(std::uint32_t(own.others[other]));
        // Rows of dead slots have no shape and no keys.
        const std::uint8_t crowd = all.size() > begin ? proxies_[awake_[home].item(leaf * 8 + row)].crowd : 0;
        if (crowd) {
            const auto keep = std::remove_if(all.begin() + std::ptrdiff_t(begin), all.end(), [&](std::uint32_t key) {
                return (proxies_[partner_shape(key)].crowd & crowd) != 0;
            });
            all.erase(keep, all.end());
        }
        now.count[row] = std::uint32_t(all.size() - begin);
    }
    if (is_new(home, now, all.data() + now.begin))
        found.leaves.push_back(now);
    else
        all.resize(now.begin);
}

bool BroadPhase::is_new(int home, const NewRows::Leaf& rows, const std::uint32_t* keys) const {
    if (!refiltered_.empty()) return true; // the sink must be asked again
    const LeafRows& old_rows = rows_[home].leaf(rows.leaf);
    if (!std::equal(rows.count, rows.count + 8, old_rows.count)) return true;
    const PairEntry* const old = rows_[home].entries(rows.leaf);
    for (std::uint32_t k = 0; k < old_rows.total(); ++k)
        if (keys[k] != old[k].key) return true;
    return false;
}

// Lists the leaves of a tree that an item of the given leaf may overlap, with the items in their lanes.
void BroadPhase::list_met(Search& own, const Node8& leaf, const TreeBox& bounds, const TreeView& tree,
                          const std::uint32_t* items) const {
    if (tree.level_count == 0) return;
    const std::size_t first = own.met_count, room = first + tree.leaf_count;
    if (own.met.size() < room) own.met.resize(room), own.met_items.resize(room);
    if (tree.leaf_count > 1)
        own.met_count += kernels_.list_met(leaf, bounds, tree, &own.met[first]);
    else
        own.met[own.met_count++] = {tree.levels[0], 0, 255};
    for (std::size_t k = first; k < own.met_count; ++k) own.met_items[k] = items + std::size_t(own.met[k].index) * 8;
}

// Calls f(row, item) for all overlaps of the leaf's items with items of the listed leaves.
template <class F>
void BroadPhase::for_each_met(Search& own, const Node8& leaf, const TreeBox& bounds, const F& f) const {
    constexpr std::size_t chunk = 64; // leaves at a time, to bound the size of the buffer
    own.hits.resize(64 * chunk);
    for (std::size_t first = 0; first < own.met_count; first += chunk) {
        const auto leaves = std::uint32_t(std::min(chunk, own.met_count - first));
        const std::uint32_t count = kernels_.find_others(leaf, bounds, &own.met[first], leaves, own.hits.data());
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t hit = own.hits[k];
            f(hit & 7, own.met_items[first + (hit >> 6)][hit >> 3 & 7]);
        }
    }
    own.met_count = 0;
}

// Finds the partners that are not awake, as row << 32 | key, sorted. A sleeping island of one shape is represented by
// its box in the tree of islands; larger islands have trees of their own.
void BroadPhase::find_others(int home, std::uint32_t leaf, const TreeBox& bounds, Search& own) const {
    const Node8& items = awake_[home].leaf(leaf);
    own.others.clear();
    own.islands_hit.clear();
    const auto push = [&](std::uint32_t row, std::uint32_t shape) {
        own.others.push_back(std::uint64_t(row) << 32 | other_key | shape);
    };
    list_met(own, items, bounds, own.top, top_.items());
    for_each_met(own, items, bounds, [&](std::uint32_t row, std::uint32_t index) {
        const Island& island = islands_[index];
        if (island.shape_count == 1)
            push(row, island_shapes_[island.shape_base]);
        else
            own.islands_hit.push_back(index);
    });
    std::sort(own.islands_hit.begin(), own.islands_hit.end());
    own.islands_hit.erase(std::unique(own.islands_hit.begin(), own.islands_hit.end()), own.islands_hit.end());
    list_met(own, items, bounds, own.fixed, fixed_.items());
    for (const std::uint32_t index : own.islands_hit)
        list_met(own, items, bounds, island_view(islands_[index]), &island_shapes_[islands_[index].shape_base]);
    for_each_met(own, items, bounds, push);
    for (const Plane& plane : planes_) {
        if (!crosses(plane, bounds)) continue;
        for (std::uint32_t row = 0; row < 8; ++row)
            if (crosses(plane, box_of_lane(items, row))) push(row, plane.shape);
    }
    std::sort(own.others.begin(), own.others.end());
}

// Replaces the rows of a leaf by new ones: pairs in both keep their contacts.
void BroadPhase::merge_leaf(int home, const NewRows::Leaf& rows, const std::uint32_t* key) {
    const std::uint32_t leaf = rows.leaf;
    const LeafRows& old_rows = rows_[home].leaf(leaf);
    const PairEntry* old = rows_[home].entries(leaf);
    const bool asks_again = !refiltered_.empty();
    merged_.clear();
    for (std::uint32_t row = 0; row < 8; ++row) {
        const std::uint32_t* const key_end = key + rows.count[row];
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
    rows_[home].replace(leaf, rows.count, merged_.data());
}

} // namespace cairn
