// The step of the broad phase: sort if due, search, report.
#include "collision/broad_phase.h"
#include "core/room.h"

#include <algorithm>
#include <cmath>

namespace cairn {

void BroadPhase::update(PairSink& sink, ThreadPool* thread_pool) {
    last_ = {};
    last_.moved = std::uint32_t(changes_.size());
    ended_.clear();
    found_.clear();
    sort_if_due();
    fixed_.refit(kernels_);
    top_.refit(kernels_);
    collect_returned_pairs();
    if (search_all_next_) all_dirty_ = 1;
    search_all_next_ = false;
    if (all_dirty_ || !changes_.empty() || !touched_.empty()) {
        for (int home = 0; home < 2; ++home) {
            awake_[home].refit(kernels_);
            rows_[home].compact_if_wasteful();
        }
        mark_leaves();
        mark_crowds();
        for (int home = 0; home < 2; ++home) search(home, thread_pool);
    }
    report(sink);
    for (const Change& change : changes_) proxies_[change.shape].moved = 0;
    for (const std::uint32_t shape : refiltered_) proxies_[shape].refilter = 0;
    for (const std::uint32_t shape : removed_) proxies_[shape] = Proxy{};
    shrink_capacity(changes_), shrink_capacity(ended_), shrink_capacity(found_);
    for (NewRows& rows : new_rows_) shrink_capacity(rows.leaves), shrink_capacity(rows.keys);
    changes_.clear();
    touched_.clear();
    refiltered_.clear();
    removed_.clear();
    all_dirty_ = transfers_ = 0;
}

// --- Sorting.

void BroadPhase::sort_if_due() {
    if (fixed_.wants_sort()) sort_fixed();
    if (top_.wants_sort()) {
        top_.sort(kd_, kernels_);
        for (std::uint32_t slot = 0; slot < top_.slot_count(); ++slot) islands_[top_.item(slot)].top_slot = slot;
    }
    ++steps_since_sort_;
    moved_since_sort_ += changes_.size();
    const bool stirred = moved_since_sort_ >= awake_[0].slot_count() + awake_[1].slot_count() &&
                         moved_since_sort_ > 0 && steps_since_sort_ >= steps_between_sorts;
    if (stirred || awake_[0].wants_sort() || awake_[1].wants_sort()) sort_awake();
}

void BroadPhase::sort_fixed() {
    fixed_.sort(kd_, kernels_);
    for (std::uint32_t slot = 0; slot < fixed_.slot_count(); ++slot) proxies_[fixed_.item(slot)].place = slot;
}

void BroadPhase::sort_awake() {
    flatten_rows();
    if (math::DVec3 origin; origin_is_far(origin)) rebase(origin);
    large_size_ = size_limit();

    items_.clear();
    boxes_.clear();
    for (const bool large : {false, true}) {
        const std::size_t begin = items_.size();
        for (const SlotTree& tree : awake_) {
            for (std::uint32_t slot = 0; slot < tree.slot_count(); ++slot) {
                const TreeBox box = tree.box(slot);
                if (is_empty(box) || (size_of(box) >= large_size_) != large) continue;
                items_.push_back(tree.item(slot));
                boxes_.push_back(box);
            }
        }
        if (!large) small_count_ = std::uint32_t(items_.size() - begin);
    }
    const std::span<const std::uint32_t> items = items_;
    const std::span<const TreeBox> boxes = boxes_;
    awake_[0].assign(items.first(small_count_), boxes.first(small_count_), kd_, kernels_);
    awake_[1].assign(items.subspan(small_count_), boxes.subspan(small_count_), kd_, kernels_);
    for (std::uint32_t home = 0; home < 2; ++home) {
        for (std::uint32_t slot = 0; slot < awake_[home].slot_count(); ++slot) {
            Proxy& proxy = proxies_[awake_[home].item(slot)];
            proxy.place = slot;
            proxy.home = home;
        }
    }
    unflatten_rows();
    release_memory(flat_), release_memory(merged_), release_memory(order_), release_memory(sizes_);
    release_memory(items_), release_memory(boxes_);
    kd_.give_back();
    all_dirty_ = 1;
    steps_since_sort_ = 0;
    moved_since_sort_ = 0;
    last_.sorted = 1;
}

float BroadPhase::size_of(const TreeBox& box) {
    return std::max({box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]});
}

float BroadPhase::median(std::vector<float>& values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// The size from which on an awake shape goes to the tree of large shapes: a shape far larger than its neighbors would
// enlarge the bounds of its leaf and of all nodes above.
float BroadPhase::size_limit() {
    sizes_.clear();
    for (const SlotTree& tree : awake_)
        for (std::uint32_t slot = 0; slot < tree.slot_count(); ++slot)
            if (tree.alive(slot)) sizes_.push_back(size_of(tree.box(slot)));
    return sizes_.size() < 64 ? empty_bound : large_ratio * median(sizes_);
}

// Whether the median position of the awake shapes is so far from the origin that floats lose precision; `wanted` is a
// better origin.
bool BroadPhase::origin_is_far(math::DVec3& wanted) {
    bool is_far = false;
    for (const SlotTree& tree : awake_) { // quick test: all shapes are near
        const TreeBox bounds = tree.bounds();
        for (int axis = 0; axis < 3 && tree.alive_count() > 0; ++axis)
            is_far |= -bounds.lo[axis] > float(origin_distance) || bounds.hi[axis] > float(origin_distance);
    }
    if (!is_far) return false;
    is_far = false;
    for (int axis = 0; axis < 3; ++axis) {
        sizes_.clear();
        for (const SlotTree& tree : awake_)
            for (std::uint32_t slot = 0; slot < tree.slot_count(); ++slot)
                if (const TreeBox box = tree.box(slot); !is_empty(box))
                    sizes_.push_back(0.5f * (box.lo[axis] + box.hi[axis]));
        if (sizes_.empty()) return false;
        const double middle = median(sizes_);
        is_far |= std::fabs(middle) > origin_distance;
        wanted[axis] = std::floor((origin_[axis] + middle) / 1024.0 + 0.5) * 1024.0;
    }
    return is_far;
}

// Recomputes all boxes relative to a new origin.
void BroadPhase::rebase(math::DVec3 origin) {
    origin_ = origin;
    for (SlotTree* tree : {&awake_[0], &awake_[1], &fixed_}) {
        for (std::uint32_t slot = 0; slot < tree->slot_count(); ++slot)
            if (tree->alive(slot)) tree->set_box(slot, relative(fat_[tree->item(slot)]));
        tree->refit(kernels_);
    }
    for (Island& island : islands_) {
        if (island.shape_count == 0) continue;
        for (std::uint32_t slot = 0; slot < island.shape_count; ++slot) {
            Node8& leaf = island_nodes_[island.node_base + slot / 8];
            if (!is_empty(box_of_lane(leaf, slot % 8)))
                set_lane(leaf, slot % 8, relative(fat_[island_shapes_[island.shape_base + slot]]));
        }
        top_.set_box(island.top_slot, refit_island(island));
    }
    all_dirty_ = 1;
}

// Collects all pairs as (shape, partner, contact, whether the partner is not awake); pairs with a dead slot end.
void BroadPhase::flatten_rows() {
    flat_.clear();
    for (std::uint32_t home = 0; home < 2; ++home) {
        for (std::uint32_t leaf = 0; leaf < rows_[home].leaf_count(); ++leaf) {
            const LeafRows& rows = rows_[home].leaf(leaf);
            const PairEntry* entry = rows_[home].entries(leaf);
            for (std::uint32_t row = 0; row < 8; ++row) {
                for (std::uint32_t k = 0; k < rows.count[row]; ++k, ++entry) {
                    const std::uint32_t shape = awake_[home].item(leaf * 8 + row), partner = partner_shape(entry->key);
                    const bool other = entry->key & other_key;
                    const bool ends = !awake_[home].alive(leaf * 8 + row) || (!other && !slot_alive(entry->key));
                    if (ends)
                        ended_.push_back({shape, partner, entry->contact, 0});
                    else
                        flat_.push_back({shape, partner, entry->contact, other});
                }
            }
        }
    }
}

// Rebuilds the rows from the flat list and the new slots: a counting sort by slot, then a sort of each row by key.
void BroadPhase::unflatten_rows() {
    const std::uint32_t small_slots = awake_[0].leaf_count() * 8;
    order_.assign(small_slots + awake_[1].leaf_count() * 8 + 1, 0); // by slot, large ones last: the begin of each row
    const auto key_of = [&](std::uint32_t shape) {
        return proxies_[shape].place | (proxies_[shape].home ? large_key : 0u);
    };
    const auto index_of = [&](std::uint32_t key) { return key & large_key ? small_slots + (key & ~large_key) : key; };
    for (EndedPair& pair : flat_) { // shape_a: index of the row, shape_b: key
        std::uint32_t own = key_of(pair.shape_a),
                      partner = pair.matched ? pair.shape_b | other_key : key_of(pair.shape_b);
        if (partner < own) std::swap(own, partner);
        pair.shape_a = index_of(own);
        pair.shape_b = partner;
        ++order_[pair.shape_a + 1];
    }
    for (std::size_t i = 1; i < order_.size(); ++i) order_[i] += order_[i - 1];
    set_size_anew(merged_, flat_.size());
    for (const EndedPair& pair : flat_) merged_[order_[pair.shape_a]++] = {pair.shape_b, pair.contact};
    // order_[i] is now the end of row i.
    std::uint32_t begin = 0, index = 0;
    for (int home = 0; home < 2; ++home) {
        rows_[home].clear();
        rows_[home].set_leaf_count(awake_[home].leaf_count());
        for (std::uint32_t leaf = 0; leaf < awake_[home].leaf_count(); ++leaf) {
            const std::uint32_t first = begin;
            std::uint32_t counts[8];
            for (std::uint32_t& count : counts) {
                const std::uint32_t end = order_[index++];
                std::sort(merged_.data() + begin, merged_.data() + end,
                          [](const PairEntry& a, const PairEntry& b) { return a.key < b.key; });
                count = end - begin;
                begin = end;
            }
            rows_[home].replace(leaf, counts, merged_.data() + first);
        }
    }
}

// --- Reporting.

void BroadPhase::report(PairSink& sink) {
    ended_.insert(ended_.end(), returned_.begin(), returned_.end());
    const bool transfers = transfers_ || !returned_.empty();
    returned_.clear();
    if (transfers) match_transfers();
    for (const EndedPair& pair : ended_) {
        if (pair.matched) continue;
        if (transfers && !proxies_[pair.shape_a].refilter && !proxies_[pair.shape_b].refilter &&
            may_keep(pair.shape_a, pair.shape_b)) {
            keep_pair(pair);
            continue;
        }
        ++last_.lost;
        if (pair.contact != filtered_contact) sink.pair_lost(pair.shape_a, pair.shape_b, pair.contact);
    }
    for (const FoundPair& pair : found_) {
        if (pair.shape_a == none) continue;
        PairEntry& entry = rows_[pair.home].entry(rows_[pair.home].leaf(pair.leaf).base + pair.offset);
        std::uint32_t contact = 0;
        entry.contact = sink.pair_found(pair.shape_a, pair.shape_b, contact) ? contact : filtered_contact;
        ++last_.found;
    }
}

// A shape that falls asleep or wakes gets another key in the rows: a pair that ends under one key and is found under
// another one continues with its contact.
void BroadPhase::match_transfers() {
    const auto name = [](std::uint32_t a, std::uint32_t b) {
        return a < b ? std::uint64_t(a) << 32 | b : std::uint64_t(b) << 32 | a;
    };
    const auto name_of = [&](std::uint32_t i) { return name(ended_[i].shape_a, ended_[i].shape_b); };
    order_.clear();
    for (std::uint32_t i = 0; i < ended_.size(); ++i)
        if (!proxies_[ended_[i].shape_a].refilter && !proxies_[ended_[i].shape_b].refilter) order_.push_back(i);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) { return name_of(a) < name_of(b); });
    for (FoundPair& pair : found_) {
        const std::uint64_t wanted = name(pair.shape_a, pair.shape_b);
        const auto at = std::lower_bound(order_.begin(), order_.end(), wanted,
                                         [&](std::uint32_t i, std::uint64_t value) { return name_of(i) < value; });
        if (at == order_.end() || name_of(*at) != wanted) continue;
        ended_[*at].matched = 1;
        rows_[pair.home].entry(rows_[pair.home].leaf(pair.leaf).base + pair.offset).contact = ended_[*at].contact;
        pair.shape_a = none;
    }
}

} // namespace cairn
