// Validation of the broad phase in a loaded snapshot, before anything uses it. The conditions checked here hold between
// any two calls of a BroadPhase.
#include "collision/broad_phase.h"
#include "core/sound.h"

#include <cmath>

namespace cairn {

namespace {

bool overlap(const TreeBox& a, const TreeBox& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(a.lo[axis] <= b.hi[axis] && a.hi[axis] >= b.lo[axis])) return false;
    return true;
}

} // namespace

void PairRows::check(const char* name, std::uint32_t leaves) const {
    require_sound(leaves_.size() <= leaves, {name, leaves_.size()}, std::int64_t(leaves_.size()),
                  "must not have more leaves than their tree");
    std::vector<std::uint8_t> taken(pool_.size());
    std::uint64_t used = 0;
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
        const LeafRows& rows = leaves_[i];
        require_sound(std::uint64_t(rows.base) + rows.capacity <= pool_.size(), {name, i, "base"}, rows.base,
                      "must be where the rows lie within the pool");
        std::uint64_t total = 0;
        for (const std::uint32_t count : rows.count) total += count;
        require_sound(total <= rows.capacity, {name, i, "count"}, std::int64_t(total), "must fit the rows' room");
        for (std::uint32_t k = 0; k < rows.capacity; ++k) {
            require_sound(!taken[rows.base + k], {name, i, "base"}, rows.base, "must not be where other rows are");
            taken[rows.base + k] = 1;
        }
        used += rows.capacity;
    }
    require_count(name, used_, used);
}

// Every shape's place refers to an entry that refers back to the shape.
void BroadPhase::check_proxies(std::size_t shapes) const {
    for (const int axis : {0, 1, 2})
        require_sound(std::isfinite(origin_[axis]), {"broad_phase.origin", std::size_t(axis)}, axis,
                      "must be finite along axis");
    require_sound(proxies_.size() <= shapes, {"broad_phase.proxies", proxies_.size()}, std::int64_t(proxies_.size()),
                  "must not be more than there are shapes");
    require_count("broad_phase.fat_boxes", fat_.size(), proxies_.size());
    std::size_t counts[6] = {};
    for (std::uint32_t shape = 0; shape < proxies_.size(); ++shape) {
        const Proxy& proxy = proxies_[shape];
        require_sound(proxy.state <= State::removed, {"broad_phase.proxies", shape, "state"}, int(proxy.state),
                      "must be 0 to 5");
        ++counts[std::size_t(proxy.state)];
        if (proxy.state == State::none || proxy.state == State::removed) continue;
        bool is_there = false;
        if (proxy.state == State::awake)
            is_there = proxy.home < 2 && proxy.place < awake_[proxy.home].slot_count() &&
                       awake_[proxy.home].item(proxy.place) == shape && awake_[proxy.home].alive(proxy.place);
        else if (proxy.state == State::fixed)
            is_there =
                proxy.place < fixed_.slot_count() && fixed_.item(proxy.place) == shape && fixed_.alive(proxy.place);
        else if (proxy.state == State::plane)
            is_there = proxy.place < planes_.size() && planes_[proxy.place].shape == shape;
        else if (proxy.home < islands_.size() && proxy.place < islands_[proxy.home].shape_count) {
            const Island& island = islands_[proxy.home];
            is_there = island_shapes_[island.shape_base + proxy.place] == shape &&
                       !is_empty(box_of_lane(island_nodes_[island.node_base + proxy.place / 8], proxy.place % 8));
        }
        require_sound(is_there, {"broad_phase.proxies", shape, "place"}, proxy.place, "must be where the shape is");
        const DBounds& fat = fat_[shape];
        for (int axis = 0; axis < 3 && proxy.state != State::plane; ++axis)
            require_sound(fat.lo[axis] <= fat.hi[axis], {"broad_phase.fat_boxes", shape}, axis,
                          "must have bounds in order along axis");
    }
    const auto count_of = [&](State state) { return counts[std::size_t(state)]; };
    require_count("broad_phase.awake", count_of(State::awake), awake_[0].alive_count() + awake_[1].alive_count());
    require_count("broad_phase.fixed", count_of(State::fixed), fixed_.alive_count());
    require_count("broad_phase.planes", count_of(State::plane), planes_.size());
    std::size_t sleeping = 0;
    for (const Island& island : islands_) sleeping += island.alive_count;
    require_count("broad_phase.sleeping", count_of(State::sleeping), sleeping);
    require_count("broad_phase.sleeping_count", sleeping_count_, sleeping);
    require_count("broad_phase.shape_count", shape_count_,
                  proxies_.size() - count_of(State::none) - count_of(State::removed));
}

void BroadPhase::check_trees() const {
    awake_[0].check("broad_phase.awake", proxies_.size());
    awake_[1].check("broad_phase.large", proxies_.size());
    fixed_.check("broad_phase.fixed", proxies_.size());
    top_.check("broad_phase.islands", islands_.size());
    rows_[0].check("broad_phase.rows", awake_[0].leaf_count());
    rows_[1].check("broad_phase.large_rows", awake_[1].leaf_count());
    for (std::size_t i = 0; i < planes_.size(); ++i)
        require_sound(planes_[i].shape < proxies_.size(), {"broad_phase.planes", i, "shape"}, planes_[i].shape,
                      "must be a shape");
}

// Sleeping islands: their trees share no nodes, and each island is listed once in the tree of islands and under its
// key.
void BroadPhase::check_islands() const {
    const char* const name = "broad_phase.islands";
    std::vector<std::uint8_t> node_taken(island_nodes_.size()), is_free(islands_.size());
    std::size_t in_use = 0, with_key = 0;
    for (std::size_t i = 0; i < islands_.size(); ++i) {
        const Island& island = islands_[i];
        if (island.shape_count == 0) {
            require_count("broad_phase.islands.alive_count", island.alive_count, 0);
            continue;
        }
        ++in_use;
        require_sound(std::uint64_t(island.shape_base) + island.shape_count <= island_shapes_.size(),
                      {name, i, "shape_base"}, island.shape_base, "must be where its shapes are");
        require_sound(std::uint64_t(island.node_base) + island.node_count <= island_nodes_.size(),
                      {name, i, "node_base"}, island.node_base, "must be where its nodes are");
        std::uint32_t nodes = (island.shape_count + 7) / 8, sum = nodes;
        for (std::uint32_t level = nodes; level > 1; sum += level) level = (level + 7) / 8;
        require_count("broad_phase.islands.node_count", island.node_count, sum);
        for (std::uint32_t k = 0; k < sum; ++k) {
            require_sound(!node_taken[island.node_base + k], {name, i, "node_base"}, island.node_base,
                          "must not be where other nodes are");
            node_taken[island.node_base + k] = 1;
        }
        std::size_t alive = 0;
        const Node8* level = &island_nodes_[island.node_base];
        check_leaves(name, level, island.shape_count, alive);
        for (; nodes > 1; nodes = (nodes + 7) / 8) check_inner_nodes(name, level += nodes, nodes);
        require_sound(alive > 0, {name, i, "alive_count"}, std::int64_t(alive), "must be at least 1");
        require_count("broad_phase.islands.alive_count", island.alive_count, alive);
        for (std::uint32_t k = 0; k < island.shape_count; ++k)
            require_sound(island_shapes_[island.shape_base + k] < proxies_.size(), {name, i, "shapes"},
                          island_shapes_[island.shape_base + k], "must be a shape");
        require_sound(island.top_slot < top_.slot_count() && top_.item(island.top_slot) == i &&
                          top_.alive(island.top_slot),
                      {name, i, "top_slot"}, island.top_slot, "must be its slot");
        require_sound(island.key < island_of_key_.size() && island_of_key_[island.key] == i, {name, i, "key"},
                      island.key, "must be its key");
    }
    require_count("broad_phase.islands.slots", top_.alive_count(), in_use);
    for (const std::uint32_t island : island_of_key_) with_key += island != none;
    require_count("broad_phase.islands.keys", with_key, in_use);
    require_count("broad_phase.free_islands", free_islands_.size(), islands_.size() - in_use);
    for (std::size_t k = 0; k < free_islands_.size(); ++k) {
        const std::uint32_t i = free_islands_[k];
        require_sound(i < islands_.size() && islands_[i].shape_count == 0 && !is_free[i],
                      {"broad_phase.free_islands", k}, i, "must be an island that is not in use");
        is_free[i] = 1;
    }
}

void BroadPhase::check_changes() const {
    for (std::size_t k = 0; k < changes_.size(); ++k) {
        const Change& change = changes_[k];
        require_sound(change.shape < proxies_.size(), {"broad_phase.changes", k, "shape"}, change.shape,
                      "must be a shape");
        require_sound(change.home < 2 && change.slot < awake_[change.home].slot_count(),
                      {"broad_phase.changes", k, "slot"}, change.slot, "must be a slot of its tree");
    }
    for (const auto* list : {&removed_, &refiltered_})
        for (std::size_t k = 0; k < list->size(); ++k)
            require_sound((*list)[k] < proxies_.size(),
                          {list == &removed_ ? "broad_phase.removed" : "broad_phase.refiltered", k}, (*list)[k],
                          "must be a shape");
    for (std::size_t k = 0; k < removed_.size(); ++k)
        require_sound(proxies_[removed_[k]].state == State::removed, {"broad_phase.removed", k}, removed_[k],
                      "must be a shape that was removed");
}

// --- Pairs.

// The changes of slots since the last update, by slot.
struct BroadPhase::Noticed {
    explicit Noticed(const BroadPhase& b) : changes(b.changes_) {
        if (changes.empty()) return;
        for (const int home : {0, 1}) of_slot[home].assign(b.awake_[home].slot_count(), none);
        for (std::uint32_t k = 0; k < changes.size(); ++k) of_slot[changes[k].home][changes[k].slot] = k;
    }
    const Change* of(std::uint32_t home, std::uint32_t slot) const {
        const std::uint32_t k = changes.empty() ? none : of_slot[home][slot];
        return k == none ? nullptr : &changes[k];
    }
    const std::vector<Change>& changes;
    std::vector<std::uint32_t> of_slot[2];
};

// Whether the pair's boxes overlap, or the next update will notice that it has ended.
bool BroadPhase::ends_or_goes_on(const Noticed& noticed, int home, std::uint32_t slot, std::uint32_t key) const {
    if (noticed.of(std::uint32_t(home), slot)) return true;
    const TreeBox own = awake_[home].box(slot);
    if (is_empty(own)) return false;
    if (!(key & other_key)) {
        const std::uint32_t other_home = key & large_key ? 1 : 0, other = key & ~large_key;
        if (overlap(own, awake_[other_home].box(other))) return true;
        const Change* const change = noticed.of(other_home, other);
        return change && overlap(own, change->before);
    }
    const std::uint32_t shape = key & ~other_key;
    const Proxy& proxy = proxies_[shape];
    if (proxy.state == State::fixed) return overlap(own, fixed_.box(proxy.place));
    if (proxy.state == State::plane) return crosses(planes_[proxy.place], own);
    if (proxy.state != State::sleeping) return false;
    return overlap(own, box_of_lane(island_nodes_[islands_[proxy.home].node_base + proxy.place / 8], proxy.place % 8));
}

void BroadPhase::check_rows(PairReader& reader) {
    const Noticed noticed(*this);
    const char* const names[] = {"broad_phase.rows", "broad_phase.large_rows"};
    for (int home = 0; home < 2; ++home) {
        for (std::uint32_t leaf = 0; leaf < rows_[home].leaf_count(); ++leaf) {
            const LeafRows& rows = rows_[home].leaf(leaf);
            const PairEntry* entry = rows_[home].entries(leaf);
            for (std::uint32_t row = 0; row < 8; ++row) {
                const std::uint32_t slot = 8 * leaf + row;
                require_sound(rows.count[row] == 0 || slot < awake_[home].slot_count(), {names[home], leaf, "count"},
                              rows.count[row], "must be 0 beyond the last slot");
                for (std::uint32_t k = 0; k < rows.count[row]; ++k, ++entry) {
                    const std::uint32_t key = entry->key, other = key & ~(large_key | other_key);
                    const std::size_t room =
                        key & other_key ? proxies_.size() : awake_[key & large_key ? 1 : 0].slot_count();
                    require_sound(other < room && !((key & other_key) && (key & large_key)), {names[home], slot, "key"},
                                  key, "must name a shape or a slot");
                    require_sound(k == 0 || entry[-1].key < key, {names[home], slot, "key"}, key,
                                  "must be above the one before it");
                    if (entry->contact == filtered_contact) continue;
                    reader.pair(awake_[home].item(slot), partner_shape(key), entry->contact);
                    if (!search_all_next_ && !all_dirty_) search_all_next_ = !ends_or_goes_on(noticed, home, slot, key);
                }
            }
        }
    }
}

// Checks a linked list of kept pairs, or without a reader the list of free entries. Returns its length.
std::uint32_t BroadPhase::check_kept(std::uint32_t island, std::uint32_t first, std::vector<std::uint8_t>& seen,
                                     PairReader* reader) const {
    std::uint32_t count = 0;
    for (std::uint32_t i = first; i != none; i = kept_[i].next, ++count) {
        require_sound(i < kept_.size() && !seen[i], {"broad_phase.kept", count, "next"}, i,
                      "must be a place that no other list has, and this one once");
        seen[i] = 1;
        if (!reader) continue;
        const KeptPair& pair = kept_[i];
        require_sound(pair.shape_a < proxies_.size(), {"broad_phase.kept", i, "shape_a"}, pair.shape_a,
                      "must be a shape");
        require_sound(pair.shape_b < proxies_.size(), {"broad_phase.kept", i, "shape_b"}, pair.shape_b,
                      "must be a shape");
        const Proxy &a = proxies_[pair.shape_a], &b = proxies_[pair.shape_b];
        bool is_noticed = false, is_here = false;
        if (island == none) {
            is_noticed = removals_ || transfers_;
            is_here = a.state == State::sleeping && b.state == State::sleeping && a.home != b.home;
        } else {
            is_noticed = removals_ && islands_[island].removal;
            const bool a_is = a.state == State::sleeping && a.home == island,
                       b_is = b.state == State::sleeping && b.home == island;
            is_here = (a_is || a.state != State::sleeping) && (b_is || b.state != State::sleeping);
        }
        require_sound(is_noticed || (is_here && may_keep(pair.shape_a, pair.shape_b)), {"broad_phase.kept", i}, i,
                      "must be a pair that waits for the island whose list it is in, at place");
        if (pair.contact != filtered_contact) reader->pair(pair.shape_a, pair.shape_b, pair.contact);
    }
    return count;
}

void BroadPhase::check_kept(PairReader& reader) const {
    std::vector<std::uint8_t> seen(kept_.size());
    std::uint32_t count = check_kept(none, first_cross_pair_, seen, &reader);
    for (std::uint32_t i = 0; i < islands_.size(); ++i) {
        require_sound(islands_[i].shape_count > 0 || islands_[i].first_pair == none,
                      {"broad_phase.islands", i, "first_pair"}, islands_[i].first_pair,
                      "must be none of an island that is not in use");
        count += check_kept(i, islands_[i].first_pair, seen, &reader);
    }
    require_count("broad_phase.kept_count", kept_count_, count);
    require_count("broad_phase.kept", kept_.size(), count + check_kept(none, first_free_kept_, seen, nullptr));
    for (std::size_t k = 0; k < returned_.size(); ++k) {
        const EndedPair& pair = returned_[k];
        require_sound(pair.shape_a < proxies_.size() && pair.shape_b < proxies_.size(), {"broad_phase.returned", k},
                      pair.shape_a, "must be a pair of shapes");
        require_sound(pair.matched == 0, {"broad_phase.returned", k, "matched"}, pair.matched, "must be 0");
        if (pair.contact != filtered_contact) reader.pair(pair.shape_a, pair.shape_b, pair.contact);
    }
}

void BroadPhase::check(std::size_t shapes, PairReader& reader) {
    search_all_next_ = false;
    check_trees();
    check_islands();
    check_proxies(shapes);
    check_changes();
    check_rows(reader);
    check_kept(reader);
}

} // namespace cairn
