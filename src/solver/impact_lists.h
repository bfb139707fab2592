// Lists of the bodies, contacts and joints that take part in an impact.
#pragma once

#include "jobs/thread_pool.h"
#include "state/direct_sets.h"
#include "state/solver_scratch.h"
#include "state/state.h"

#include <cairn/communicator.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cairn {

// Called once per impact: lists the contacts that the solver has marked as struck. A body that a penetration pushes out
// faster than `impact_speed` has no approach velocity of its own, so its hits are ignored. `ranks`: for a batch that is
// cut.
void begin_impact_lists(const Bodies& bodies, const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                        Communicator* ranks, const ContactSoftness& softness);

// Lists the rows, groups and lanes of one round of an impact in scratch.impact.
void list_impact(BatchScratch& scratch, float h);

// Returns whether a body that took part is driven into one that did not, which then takes part in the next round.
bool spread_impact(BatchScratch& scratch, Communicator* ranks, const ContactSoftness& softness);

// Clears the `in_impact` marks of the blocks.
void end_impact_lists(ImpactWork& work);

// --- union-find over rows; the root of a tree represents its set

inline std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t row) {
    while (parent[row] != row) {
        parent[row] = parent[parent[row]];
        row = parent[row];
    }
    return row;
}
inline void unite(std::vector<std::int32_t>& parent, std::int32_t a, std::int32_t b) {
    const std::int32_t root_a = root_of(parent, a), root_b = root_of(parent, b);
    parent[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

// Groups the items by part (a stable counting sort).
template <class Part, class Item, class F>
void group_by_part(std::vector<Part>& parts, std::vector<Item>& items, std::vector<Item>& sorted, F&& part_of) {
    for (Part& part : parts) part.end = 0;
    for (const Item& item : items) ++parts[part_of(item)].end;
    std::size_t begin = 0;
    for (Part& part : parts) {
        const std::size_t count = part.end;
        part.begin = part.end = begin;
        begin += count;
    }
    sorted.resize(items.size());
    for (const Item& item : items) sorted[parts[part_of(item)].end++] = item;
    items.swap(sorted);
}

// Index of a participating body in the row list of all ranks.
inline std::ptrdiff_t row_of_shared(const ImpactWork::Shared& shared, std::int32_t body) {
    return std::lower_bound(shared.bodies.begin(), shared.bodies.end(), body) - shared.bodies.begin();
}

} // namespace cairn
