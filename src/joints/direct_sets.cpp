#include "joints/direct_sets.h"

#include "joints/direct_plan.h"

#include "state/joint_links.h"

#include <algorithm>

namespace cairn {

namespace {

// Mass ratio of the heaviest body of a set to one between joints, up to which they count as equally heavy.
constexpr float max_equal_mass_ratio = 10;

// Greatest number of nodes, not counting bounded ones, for which the engine chooses the direct solver by itself. Beyond
// these limits the iterative solver is far cheaper.
constexpr std::ptrdiff_t max_nodes = 240;
// Greatest number of blocks of L for a joint with n nodes: the greater of `max_blocks_per_node` n and
// `max_blocks_per_pair` n^2. A set may have the sum over its joints.
constexpr std::size_t max_blocks_per_node = 4, max_blocks_per_pair = 3;
constexpr int min_chain = 8; // joints; longer chains are solved directly
// Greatest numbers of blocks of L, and of products of blocks, for sets that users ask for.
constexpr std::size_t max_blocks = std::size_t(1) << 18, max_products = std::size_t(1) << 22;

bool moves_by_forces(const Bodies& bodies, std::int32_t body) { return body != none && bodies.is_dynamic(body); }
bool moves(const Bodies& bodies, std::int32_t body) {
    return body != none && bodies.settings[body].type != BodyType::static_;
}

bool may_be_direct(const Bodies& bodies, const Joints& joints, std::uint32_t index) {
    const JointInfo& joint = joints.info[index];
    if (!joint.in_use || JointSolver(joint.solver) == JointSolver::iterative || joint_owner(bodies, joint) == none)
        return false;
    bool holds = joint.rules.point != JointLock::none || joint.rules.turn != JointLock::none;
    for (int i = 0; i < joint.rules.axis_count; ++i) {
        const JointAxisRule& rule = joints.axes[index].rules[i];
        const bool is_asked_for = JointSolver(joint.solver) == JointSolver::direct;
        holds |= is_direct_axis(rule) || (is_direct_drive(rule) && (rule.rigid_drive || is_asked_for));
    }
    return holds;
}

// Finds the sets: joints that are connected through bodies that forces move.
class Finder {
  public:
    Finder(const Bodies& bodies, const Joints& joints, DirectSets& direct)
        : bodies_(bodies), joints_(joints), direct_(direct) {}

    void find_all() {
        old_sets_.swap(direct_.sets);
        old_set_of_joint_.swap(direct_.set_of_joint);
        direct_.sets.clear();
        direct_.set_of_joint.assign(joints_.info.size(), none);
        seen_.assign(joints_.info.size(), 0);
        number_.assign(bodies_.links.size(), none);
        for (std::uint32_t joint = 0; joint < joints_.info.size(); ++joint) {
            if (seen_[joint] || !may_be_direct(bodies_, joints_, joint)) continue;
            gather(joint);
            // If the rule rejects the whole set, the joints that users ask for are still solved directly.
            if (rule_takes(set_))
                take();
            else
                for (const std::uint32_t member : set_.joints) rest_.push_back(member);
        }
        only_asked_for_ = true;
        for (const std::uint32_t joint : rest_) seen_[joint] = 0;
        std::sort(rest_.begin(), rest_.end());
        for (const std::uint32_t joint : rest_) {
            if (seen_[joint] || !is_wanted(joint)) continue;
            gather(joint);
            if (plan(max_blocks, max_products)) take();
        }
    }

  private:
    bool is_wanted(std::uint32_t joint) const {
        const bool is_asked_for = JointSolver(joints_.info[joint].solver) == JointSolver::direct;
        return may_be_direct(bodies_, joints_, joint) && (!only_asked_for_ || is_asked_for);
    }

    // Gathers the set of a joint into set_.
    void gather(std::uint32_t first) {
        set_ = {};
        std::vector<std::int32_t> open;
        auto reach = [&](std::uint32_t joint) {
            if (seen_[joint] || !is_wanted(joint)) return;
            seen_[joint] = 1;
            set_.joints.push_back(joint);
            for (const std::int32_t body : {joints_.info[joint].body_a, joints_.info[joint].body_b}) {
                if (!moves(bodies_, body) || number_[body] != none) continue;
                number_[body] = 0;
                set_.bodies.push_back(body);
                if (moves_by_forces(bodies_, body)) open.push_back(body);
            }
        };
        reach(first);
        while (!open.empty()) {
            const std::int32_t body = open.back();
            open.pop_back();
            for_each_joint(bodies_, joints_, body, [&](std::uint32_t joint, int) { reach(joint); });
        }
        std::sort(set_.joints.begin(), set_.joints.end());
        std::sort(set_.bodies.begin(), set_.bodies.end());
        set_.bodies.insert(set_.bodies.begin(), none);
        for (std::size_t i = 1; i < set_.bodies.size(); ++i) number_[set_.bodies[i]] = std::int32_t(i);
        list_nodes();
        find_loops();
        for (std::size_t i = 1; i < set_.bodies.size(); ++i) number_[set_.bodies[i]] = none;
    }

    std::int32_t number_of(std::int32_t body) const { return moves(bodies_, body) ? number_[body] : 0; }

    void list_nodes() {
        for (const std::uint32_t joint : set_.joints) {
            const JointInfo& info = joints_.info[joint];
            DirectNode node{joint, DirectRows::point, 0, false, {number_of(info.body_a), number_of(info.body_b)}};
            if (info.rules.point != JointLock::none) set_.found.push_back(node);
            const std::int32_t driven = axis_of_driven_turn(joint);
            node.rows = DirectRows::turn;
            node.is_driven = driven != none;
            node.axis = std::uint8_t(driven != none ? driven : 0);
            if (info.rules.turn != JointLock::none) set_.found.push_back(node);
            node.is_driven = false;
            for (std::uint8_t i = 0; i < info.rules.axis_count; ++i) {
                const JointAxisRule& rule = joints_.axes[joint].rules[i];
                node.axis = i;
                node.rows = DirectRows::axis;
                if (is_direct_axis(rule)) set_.found.push_back(node);
                node.rows = DirectRows::drive;
                if (is_direct_drive(rule) && i != driven) set_.found.push_back(node);
                node.rows = DirectRows::friction;
                if (is_direct_friction(rule)) set_.found.push_back(node);
                node.rows = DirectRows::soft_limit;
                if (is_direct_soft_limit(rule)) set_.found.push_back(node);
            }
        }
        for (const DirectNode& node : set_.found) {
            DirectEnds& ends = set_.ends.emplace_back();
            for (int side = 0; side < 2; ++side)
                ends.body[side] = moves_by_forces(bodies_, set_.bodies[node.body[side]]) ? node.body[side] : none;
        }
    }

    // The axis of the drive about the axis that a hinge leaves free; it needs no row of its own. None: no such drive.
    std::int32_t axis_of_driven_turn(std::uint32_t joint) const {
        const JointLocks& rules = joints_.info[joint].rules;
        for (std::int32_t i = 0; rules.turn == JointLock::across && i < rules.axis_count; ++i) {
            const JointAxisRule& rule = joints_.axes[joint].rules[i];
            if (rule.kind == AxisKind::twist && rule.column_a == rules.turn_column && is_direct_drive(rule)) return i;
        }
        return none;
    }

    // All bodies that forces do not move count as one.
    void find_loops() {
        std::size_t moving = 0;
        bool is_held = false;
        for (std::size_t i = 1; i < set_.bodies.size(); ++i) moving += moves_by_forces(bodies_, set_.bodies[i]);
        for (const std::uint32_t joint : set_.joints)
            is_held |= !moves_by_forces(bodies_, joints_.info[joint].body_a) ||
                       !moves_by_forces(bodies_, joints_.info[joint].body_b);
        set_.has_loops = set_.joints.size() >= moving + std::size_t(is_held);
    }

    // --- the rule for joints whose solver the engine chooses

    bool rule_takes(const DirectSet& set) {
        // A body with joints that are solved by two methods gets excessive velocities when it is hit: where users ask
        // for the direct solver at one joint, connected joints whose solver the engine chooses are included.
        bool is_asked_for = false;
        for (const std::uint32_t joint : set.joints)
            is_asked_for |= JointSolver(joints_.info[joint].solver) == JointSolver::direct;
        if (is_asked_for && plan(max_blocks, max_products)) return true;
        const auto nodes = std::count_if(set.found.begin(), set.found.end(),
                                         [](const DirectNode& node) { return !is_bounded(node.rows); });
        if (nodes > max_nodes || !pays(set)) return false;
        return plan(most_blocks(set), max_products);
    }

    static std::size_t most_blocks(const DirectSet& set) {
        std::size_t most = 0;
        for (std::size_t begin = 0, end = 0; begin < set.found.size(); begin = end) { // nodes of a joint are adjacent
            while (end < set.found.size() && set.found[end].joint == set.found[begin].joint) ++end;
            const std::size_t nodes = end - begin;
            most += std::max(max_blocks_per_node * nodes, max_blocks_per_pair * nodes * nodes);
        }
        return most;
    }

    bool pays(const DirectSet& set) {
        // The joints at each body that forces move.
        std::vector<std::vector<std::uint32_t>> at(set.bodies.size());
        bool turns = false;
        for (const std::uint32_t joint : set.joints) {
            const JointInfo& info = joints_.info[joint];
            turns |= info.rules.turn != JointLock::none;
            for (const std::int32_t body : {info.body_a, info.body_b})
                if (moves_by_forces(bodies_, body)) at[place_of(set, body)].push_back(joint);
        }
        if (set.has_loops && turns) return true; // a mechanism
        float heaviest = 0;
        for (const std::int32_t body : set.bodies)
            if (moves_by_forces(bodies_, body)) heaviest = std::max(heaviest, bodies_.mass[body].mass);
        for (std::size_t i = 1; i < at.size(); ++i) {
            if (at[i].size() < 2) continue;
            if (heaviest > max_equal_mass_ratio * bodies_.mass[set.bodies[i]].mass) return true;
            const auto holding =
                std::count_if(at[i].begin(), at[i].end(), [&](std::uint32_t joint) { return holds_all(joint); });
            if (holding >= 2) return true; // two in series
        }
        return longest_chain(set, at) > min_chain;
    }

    // Whether a joint allows no motion: it is fixed, or a servo holds the angle that it leaves free.
    bool holds_all(std::uint32_t joint) const {
        const JointLocks& rules = joints_.info[joint].rules;
        if (rules.point != JointLock::full) return false;
        bool turns = rules.turn != JointLock::full;
        for (int i = 0; i < rules.axis_count; ++i) {
            const JointAxisRule& rule = joints_.axes[joint].rules[i];
            if (is_direct_drive(rule) && rule.drive_stiffness > 0) turns = false;
        }
        return !turns;
    }

    static std::size_t place_of(const DirectSet& set, std::int32_t body) {
        return std::size_t(std::lower_bound(set.bodies.begin() + 1, set.bodies.end(), body) - set.bodies.begin());
    }

    // Number of joints between the two bodies farthest from each other, found by two breadth-first searches (exact in
    // trees).
    int longest_chain(const DirectSet& set, const std::vector<std::vector<std::uint32_t>>& at) {
        std::size_t end = 1;
        while (!moves_by_forces(bodies_, set.bodies[end])) ++end;
        int length = 0;
        for (int search = 0; search < 2; ++search) {
            std::vector<int> distance(set.bodies.size(), none);
            std::vector<std::size_t> reached{end};
            distance[end] = 0;
            for (std::size_t k = 0; k < reached.size(); ++k)
                for (const std::uint32_t joint : at[reached[k]])
                    for (const std::int32_t body : {joints_.info[joint].body_a, joints_.info[joint].body_b}) {
                        if (!moves_by_forces(bodies_, body)) continue;
                        const std::size_t other = place_of(set, body);
                        if (distance[other] != none) continue;
                        distance[other] = distance[reached[k]] + 1;
                        reached.push_back(other);
                    }
            end = reached.back();
            length = distance[end];
        }
        return length;
    }

    // --- plans

    bool plan(std::size_t blocks, std::size_t products) {
        const std::int32_t old = set_.joints[0] < old_set_of_joint_.size() ? old_set_of_joint_[set_.joints[0]] : none;
        if (old != none && old_sets_[old].found == set_.found && old_sets_[old].ends == set_.ends) {
            set_.nodes = std::move(old_sets_[old].nodes);
            set_.plan = std::move(old_sets_[old].plan);
            old_sets_[old].found.clear();
            return set_.plan.block_count() <= blocks;
        }
        std::vector<std::uint32_t> order;
        if (!make_direct_plan(set_.ends, blocks, products, set_.plan, order)) return false;
        for (const std::uint32_t i : order) set_.nodes.push_back(set_.found[i]);
        return true;
    }

    void take() {
        const std::int32_t index = std::int32_t(direct_.sets.size());
        for (const std::uint32_t joint : set_.joints) direct_.set_of_joint[joint] = index;
        direct_.sets.push_back(std::move(set_));
    }

    const Bodies& bodies_;
    const Joints& joints_;
    DirectSets& direct_;
    DirectSet set_;
    std::vector<DirectSet> old_sets_;
    std::vector<std::int32_t> old_set_of_joint_;
    std::vector<std::uint8_t> seen_;   // by joint
    std::vector<std::int32_t> number_; // by body
    std::vector<std::uint32_t> rest_;
    bool only_asked_for_ = false;
};

} // namespace

namespace {

// Axes of other kinds have no direction where their position is 0, or depend on more than two bodies.
bool is_linear_enough(AxisKind kind) {
    switch (kind) {
    case AxisKind::linear:
    case AxisKind::twist:
    case AxisKind::cross_a:
    case AxisKind::cross_b:
    case AxisKind::rotation:
    case AxisKind::distance:
        return true;
    default:
        return false;
    }
}

} // namespace

bool is_direct_axis(const JointAxisRule& rule) {
    if (!rule.has_limits || !rule.is_equation || !rule.rigid_limit || rule.has_drive || rule.friction > 0) return false;
    return rule.kind == AxisKind::perpendicular || is_linear_enough(rule.kind) ||
           (rule.kind == AxisKind::distance && rule.lower > 0);
}
bool has_direct_lane(AxisKind kind) {
    return kind != AxisKind::perpendicular && kind != AxisKind::linear && kind != AxisKind::distance;
}

bool is_direct_drive(const JointAxisRule& rule) {
    return rule.has_drive && (rule.rigid_drive || rule.drive_stiffness > 0 || rule.drive_damping > 0) &&
           is_linear_enough(rule.kind);
}
bool is_direct_friction(const JointAxisRule& rule) { return rule.friction > 0 && is_linear_enough(rule.kind); }

bool is_direct_soft_limit(const JointAxisRule& rule) {
    return rule.has_limits && !rule.rigid_limit && (rule.limit_stiffness > 0 || rule.limit_damping > 0) &&
           is_linear_enough(rule.kind);
}

bool is_direct_limit(const JointAxisRule& rule) { return rule.has_limits && rule.rigid_limit && !rule.is_equation; }

void update_direct_sets(const Bodies& bodies, const Joints& joints, DirectSets& direct) {
    if (direct.valid_for == joints.changes) return;
    Finder(bodies, joints, direct).find_all();
    direct.valid_for = joints.changes;
}

} // namespace cairn
