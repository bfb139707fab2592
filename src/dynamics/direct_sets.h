// Which joints are solved directly, and with which others. A set is what hangs together by such joints through bodies
// that move by forces. Sets are found anew when joints or masses change; of those that stay as they are, the symbolic
// part is kept. docs/decisions/direct_joints.md has the rule's measurements.
#pragma once

#include "dynamics/direct_plan.h"
#include "dynamics/joint_state.h"

#include <cstdint>
#include <vector>

namespace cairn {

struct State;

enum class DirectRows : std::uint8_t { point, turn, axis };

// Three rows of a joint, or its axis row `axis` alone.
struct DirectNode {
    std::uint32_t joint;
    DirectRows rows;
    std::uint8_t axis;
    std::int32_t body[2]; // in DirectSet::bodies
};
inline bool operator==(const DirectNode& a, const DirectNode& b) {
    return a.joint == b.joint && a.rows == b.rows && a.axis == b.axis && a.body[0] == b.body[0] &&
           a.body[1] == b.body[1];
}

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

// Brings State::direct up to date.
void update_direct_sets(State& state);

// Whether an axis row of a joint belongs to what a direct solver holds: it is a rigid equation, and linear enough.
bool is_direct_axis(const JointAxisRule& rule);

} // namespace cairn
