// Which joints are solved directly, and in which sets: a set is connected by such joints through bodies that move by
// forces. Sets are found anew when joints or masses change; sets that stay the same keep their symbolic factorization.
// docs/decisions/direct_joints.md has the measurements behind the rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cairn {

// The coupling of two nodes (of 3 constraint rows each): a body that both act on.
struct DirectCoupling {
    std::uint32_t block;                // index of the block of L
    std::uint32_t row, column;          // numbers of the nodes, row > column
    std::uint8_t row_side, column_side; // which end of each node's joint is at the body
};

// Symbolic factorization. Nodes are numbered in their order of elimination. Column k of L has the later nodes that
// depend on node k.
struct DirectPlan {
    std::vector<std::uint32_t> first; // start of each column in `rows`, and the end of the last
    std::vector<std::uint32_t> rows;  // row of each block of L, column by column, ascending in each
    // For the pairs of blocks a > b of each column in turn, the last a first: the block of L that a D b^T changes.
    std::vector<std::uint32_t> products;
    std::vector<DirectCoupling> couplings;

    std::size_t node_count() const { return first.size() - 1; }
    std::size_t block_count() const { return rows.size(); }
};

struct DirectEnds {
    std::int32_t body[2]; // negative: a body that does not move by forces
};
inline bool operator==(const DirectEnds& a, const DirectEnds& b) {
    return a.body[0] == b.body[0] && a.body[1] == b.body[1];
}

// Three constraint rows of a joint, or one row of its axis `axis`: an equation, a drive, friction, or a soft limit.
enum class DirectRows : std::uint8_t { point, turn, axis, drive, friction, soft_limit };
// Whether the impulse of the rows is bounded.
inline bool is_bounded(DirectRows rows) { return rows >= DirectRows::drive; }
struct DirectNode {
    std::uint32_t joint;
    DirectRows rows;
    std::uint8_t axis;    // of `turn` rows with a drive: the drive's axis, about which the joint may turn
    bool is_driven;       // of `turn` rows: they have a drive
    std::int32_t body[2]; // in DirectSet::bodies
};
inline bool operator==(const DirectNode& a, const DirectNode& b) {
    return a.joint == b.joint && a.rows == b.rows && a.axis == b.axis && a.is_driven == b.is_driven &&
           a.body[0] == b.body[0] && a.body[1] == b.body[1];
}
inline bool has_drive(const DirectNode& node) { return is_bounded(node.rows) || node.is_driven; }

struct DirectSet {
    std::vector<std::uint32_t> joints; // ascending
    std::vector<std::int32_t> bodies;  // bodies[0] is none: it stands for all bodies that do not move by forces
    std::vector<DirectNode> found;     // in the order of joints
    std::vector<DirectEnds> ends;      // of the nodes in `found`
    std::vector<DirectNode> nodes;     // in their order of elimination
    DirectPlan plan;
    bool has_loops = false;
};

struct DirectSets {
    std::vector<DirectSet> sets;
    std::vector<std::int32_t> set_of_joint; // by joint; none: solved iteratively
    std::uint64_t valid_for = ~std::uint64_t(0);
};

} // namespace cairn
