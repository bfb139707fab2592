// Which joints are solved directly, and with which others. A set is what hangs together by such joints through bodies
// that move by forces. Sets are found anew when joints or masses change; of those that stay as they are, the symbolic
// part is kept. docs/decisions/direct_joints.md has the rule's measurements.
#pragma once

#include <cstddef>
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

// Three rows of a joint, or one of its axis `axis`: an equation, a drive, friction, or a soft limit.
enum class DirectRows : std::uint8_t { point, turn, axis, drive, friction, soft_limit };
// Rows that give no more than so much.
inline bool is_bounded(DirectRows rows) { return rows >= DirectRows::drive; }
struct DirectNode {
    std::uint32_t joint;
    DirectRows rows;
    std::uint8_t axis;    // of a turn: that of the drive about the axis that it leaves free
    bool is_driven;       // of a turn: it has one
    std::int32_t body[2]; // in DirectSet::bodies
};
inline bool operator==(const DirectNode& a, const DirectNode& b) {
    return a.joint == b.joint && a.rows == b.rows && a.axis == b.axis && a.is_driven == b.is_driven &&
           a.body[0] == b.body[0] && a.body[1] == b.body[1];
}
inline bool has_drive(const DirectNode& node) { return is_bounded(node.rows) || node.is_driven; }

struct DirectSet {
    std::vector<std::uint32_t> joints; // ascending
    std::vector<std::int32_t> bodies;  // the first: none, for all that does not move
    std::vector<DirectNode> found;     // in the order of joints
    std::vector<DirectEnds> ends;      // of those
    std::vector<DirectNode> nodes;     // in their order of elimination
    DirectPlan plan;
    bool has_loops = false;
    float mass_ratio = 1; // of its heaviest to its lightest body
};

struct DirectSets {
    std::vector<DirectSet> sets;
    std::vector<std::int32_t> set_of_joint; // by joint; none: iterative
    std::uint64_t valid_for = ~std::uint64_t(0);
};

} // namespace cairn
