// The symbolic part of the direct solver: in which order the rows of a set of joints are eliminated, and which blocks
// of the factor L that fills.
#pragma once

#include <cstdint>
#include <vector>

namespace cairn {

// What two nodes (3 rows each) have in common: a body that both act on.
struct DirectCoupling {
    std::uint32_t block;                // of L
    std::uint32_t row, column;          // nodes, row > column
    std::uint8_t row_side, column_side; // by which of its two ends each acts on the body
};

// Nodes are numbered in their order of elimination. Column k of L holds the nodes behind k that depend on it.
struct DirectPlan {
    std::vector<std::uint32_t> first; // of each column in `rows`; one more
    std::vector<std::uint32_t> rows;  // ascending in each column: one for each block of L
    // Of the blocks a > b of each column in turn, the last a first: the block of L that a D b^T changes.
    std::vector<std::uint32_t> products;
    std::vector<DirectCoupling> couplings;

    std::size_t node_count() const { return first.size() - 1; }
    std::size_t block_count() const { return rows.size(); }
};

struct DirectEnds {
    std::int32_t body[2]; // < 0: does not move by forces
};
inline bool operator==(const DirectEnds& a, const DirectEnds& b) {
    return a.body[0] == b.body[0] && a.body[1] == b.body[1];
}

// Minimum degree, the lowest number first among equals. Fills `order` with the nodes in their order of elimination.
// Returns false where that takes more than so many blocks or products.
bool make_direct_plan(const std::vector<DirectEnds>& nodes, std::size_t most_blocks, std::size_t most_products,
                      DirectPlan& plan, std::vector<std::uint32_t>& order);

} // namespace cairn
