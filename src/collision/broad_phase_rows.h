// The pairs of the items of one slot tree, in rows: the row of a slot lists its partners, in ascending order of keys.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cairn {

// Flags of the key of a partner in a row. The key of an awake partner is its slot, with large_key if it is in the tree
// of large items; such a pair is listed only in the row of the lower key. The key of any other partner is its shape
// index, with other_key.
inline constexpr std::uint32_t large_key = 0x40000000u, other_key = 0x80000000u;

inline constexpr std::uint32_t filtered_contact = 0xffffffffu; // a pair that the sink filtered out

struct PairEntry {
    std::uint32_t key, contact;
};

// The rows of 8 slots, one after another in one chunk of the pool.
struct LeafRows {
    std::uint32_t base, capacity;
    std::uint32_t count[8];
    std::uint32_t total() const {
        return count[0] + count[1] + count[2] + count[3] + count[4] + count[5] + count[6] + count[7];
    }
};

class PairRows {
  public:
    std::uint32_t leaf_count() const { return std::uint32_t(leaves_.size()); }
    const LeafRows& leaf(std::uint32_t leaf) const { return leaves_[leaf]; }
    const PairEntry* entries(std::uint32_t leaf) const { return pool_.data() + leaves_[leaf].base; }
    PairEntry& entry(std::uint32_t index) { return pool_[index]; } // index in the pool

    void set_leaf_count(std::uint32_t count); // new leaves have empty rows
    // Replaces the rows of a leaf; returns the index of the first entry in the pool.
    std::uint32_t replace(std::uint32_t leaf, const std::uint32_t (&count)[8], const PairEntry* entries);
    void compact_if_wasteful();
    void clear();
    std::size_t bytes() const;

    // Validates rows loaded from a snapshot: throws Error(invalid_file) unless they are rows of at most `leaves`
    // leaves.
    void check(const char* name, std::uint32_t leaves) const;

    template <class Archive> void serialize(Archive& archive) { archive(leaves_), archive(pool_), archive(used_); }

  private:
    std::vector<LeafRows> leaves_;
    std::vector<PairEntry> pool_, scratch_;
    std::uint32_t used_ = 0; // entries in chunks that belong to a leaf
};

} // namespace cairn
