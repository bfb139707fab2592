#include "collision/broad_phase_rows.h"
#include "core/room.h"

#include <algorithm>

namespace cairn {

namespace {

// A capacity with room for a few more pairs, so that most changes need no reallocation.
std::uint32_t roomy(std::uint32_t count) { return count == 0 ? 0 : count + count / 4 + 8; }

} // namespace

void PairRows::set_leaf_count(std::uint32_t count) { leaves_.resize(count, LeafRows{}); }

std::uint32_t PairRows::replace(std::uint32_t leaf, const std::uint32_t (&count)[8], const PairEntry* entries) {
    LeafRows& rows = leaves_[leaf];
    std::copy(count, count + 8, rows.count);
    const std::uint32_t total = rows.total();
    if (total > rows.capacity) {
        used_ -= rows.capacity;
        rows.base = std::uint32_t(pool_.size());
        rows.capacity = roomy(total);
        used_ += rows.capacity;
        set_size(pool_, pool_.size() + rows.capacity);
    }
    std::copy(entries, entries + total, pool_.begin() + rows.base);
    return rows.base;
}

void PairRows::compact_if_wasteful() {
    if (pool_.size() <= 2 * std::size_t(used_) + 4096) return;
    scratch_.clear();
    scratch_.reserve(2 * std::size_t(used_) + 4096);
    for (LeafRows& rows : leaves_) {
        const std::uint32_t total = rows.total(), base = std::uint32_t(scratch_.size());
        scratch_.insert(scratch_.end(), pool_.begin() + rows.base, pool_.begin() + rows.base + total);
        rows.base = base;
        rows.capacity = roomy(total);
        scratch_.resize(base + rows.capacity, PairEntry{});
    }
    pool_.swap(scratch_);
    used_ = std::uint32_t(pool_.size());
}

void PairRows::clear() {
    leaves_.clear();
    pool_.clear();
    used_ = 0;
}

std::size_t PairRows::bytes() const {
    return leaves_.capacity() * sizeof(LeafRows) + (pool_.capacity() + scratch_.capacity()) * sizeof(PairEntry);
}

} // namespace cairn
