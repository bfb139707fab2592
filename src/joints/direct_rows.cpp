// Fills the direct solver at the start of a step, and stores its results at the end.
#include "bodies/bodies.h"
#include "bodies/integrators.h"
#include "joints/direct_joints.h"
#include "joints/direct_sets.h"
#include "joints/joint_placement.h"
#include "state/state.h"
#include "state/substeps.h"

#include <algorithm>
#include <limits>

namespace cairn {

using math::DVec3;

namespace {

void fill_body(const Bodies& bodies, const BatchScratch& scratch, std::int32_t body, DirectBody& b) {
    b = {};
    if (body == none) return;
    b.row = scratch.row_of_body[body];
    b.by_forces = bodies.is_dynamic(body);
    if (!b.by_forces) return;
    const BodyMass& mass = bodies.mass[body];
    b.inverse_mass = double(mass.inverse_mass);
    b.axes0 = math::normalized(bodies.motion[body].q * math::to_double(mass.principal));
    const float greatest = std::max({mass.inertia.x, mass.inertia.y, mass.inertia.z});
    for (int i = 0; i < 3; ++i) {
        b.moments[i] = double(std::max(mass.inertia[i], min_contact_moment * greatest));
        b.inverse_moments[i] = mass.inverse_inertia[i] > 0 ? 1 / b.moments[i] : 0.0;
    }
}

void fill_row(const Bodies& bodies, const Joints& joints, const DirectNode& node, DirectRow& r) {
    const JointInfo& joint = joints.info[node.joint];
    const JointPlacement p = place_joint(bodies, joint);
    r = {};
    r.arm_a0 = p.arm_a, r.arm_b0 = p.arm_b, r.gap0 = p.gap;
    r.turn0 = turn_of(p);
    int column_a = 0, column_b = 0;
    switch (node.rows) {
    case DirectRows::point:
        column_a = column_b = joint.rules.point_column;
        r.impulse = math::to_double(joint.point_impulse);
        break;
    case DirectRows::turn:
        column_a = column_b = joint.rules.turn_column;
        r.impulse = math::to_double(joint.turn_impulse);
        break;
    case DirectRows::axis:
        column_a = joints.axes[node.joint].rules[node.axis].column_a,
        column_b = joints.axes[node.joint].rules[node.axis].column_b;
        r.at = double(joints.axes[node.joint].rules[node.axis].lower);
        r.impulse.x = double(joints.axes[node.joint].states[node.axis].lower);
        break;
    default: // see fill_drive
        break;
    }
    r.axis_a0 = exact_frame_axis(p.frame_a, column_a);
    r.axis_b0 = exact_frame_axis(p.frame_b, column_b);
}

bool is_along(AxisKind kind) { return kind == AxisKind::linear || kind == AxisKind::distance; }
bool has_lane(const Joints& joints, const DirectNode& node) {
    return has_drive(node) ||
           (node.rows == DirectRows::axis && has_direct_lane(joints.axes[node.joint].rules[node.axis].kind));
}
bool comes_first(const DriveLane& a, const DriveLane& b) {
    return a.joint != b.joint ? a.joint < b.joint : a.axis < b.axis;
}

void fill_drive(const Joints& joints, const DirectWork& work, const DirectNode& node, float h, DirectRow& r) {
    const JointAxisRule& rule = joints.axes[node.joint].rules[node.axis];
    DirectDrive& d = r.drive;
    const DriveLane sought{node.joint, node.axis, 0};
    d.lane = std::lower_bound(work.drive_lanes.begin(), work.drive_lanes.end(), sought, comes_first)->lane;
    if (node.rows == DirectRows::axis) return;
    const JointAxisState& state = joints.axes[node.joint].states[node.axis];
    const double all = std::numeric_limits<double>::infinity();
    d.least_position = -all, d.most_position = all;
    switch (node.rows) {
    case DirectRows::turn:
    case DirectRows::drive:
        d.impulse = double(state.drive);
        d.stiffness = double(rule.drive_stiffness), d.damping = double(rule.drive_damping);
        d.target_position = double(rule.target_position), d.target_velocity = double(rule.target_velocity);
        d.most = double(rule.max_drive) * double(h), d.least = -d.most;
        d.is_rigid = rule.rigid_drive, d.is_relative = rule.drive_relative;
        if (is_direct_limit(rule)) d.least_position = double(rule.lower), d.most_position = double(rule.upper);
        break;
    case DirectRows::friction:
        d.impulse = double(state.friction);
        d.is_rigid = true;
        d.most = double(rule.friction) * double(h), d.least = -d.most;
        break;
    default:
        d.impulse = double(state.lower) - double(state.upper);
        d.stiffness = double(rule.limit_stiffness), d.damping = double(rule.limit_damping);
        d.is_relative = rule.limit_relative;
        d.lower = double(rule.lower), d.upper = double(rule.upper);
        d.target_position = d.lower;
        d.most = all, d.least = -all;
    }
    if (node.rows != DirectRows::soft_limit) d.bound = d.impulse >= d.most ? 1 : d.impulse <= d.least ? -1 : 0;
}

} // namespace

void list_direct_sets(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, float h) {
    DirectWork& work = scratch.direct;
    work.sets.clear();
    std::size_t bodies = 0, rows = 0, blocks = 0;
    for (const std::uint32_t joint : scratch.joint_layout->joints) {
        const std::int32_t index = direct.set_of_joint[joint];
        if (index == none || direct.sets[index].joints[0] != joint) continue;
        const DirectSet& set = direct.sets[index];
        bool is_new = false;
        for (const std::uint32_t member : set.joints)
            is_new |= !carried_share(joints.info[member].substep_time, h).is_known;
        work.sets.push_back({index, bodies, rows, blocks, is_new});
        for (std::size_t i = 1; i < set.bodies.size(); ++i) row_of_body(scratch, set.bodies[i]);
        bodies += set.bodies.size(), rows += set.nodes.size(), blocks += set.plan.block_count();
    }
    if (work.bodies.size() < bodies) work.bodies.resize(bodies);
    if (work.rows.size() < rows) work.rows.resize(rows);
    if (work.diagonal.size() < rows) work.diagonal.resize(rows), work.sought.resize(rows);
    if (work.lower.size() < blocks) work.lower.resize(blocks);
}

void list_direct_limits(const Joints& joints, const DirectSets& direct, BatchScratch& scratch) {
    DirectWork& work = scratch.direct;
    const JointLayout& layout = *scratch.joint_layout;
    work.limits.clear(), work.drive_lanes.clear();
    if (work.sets.empty()) return;
    for (const JointRow& row : layout.rows) {
        if (row.is_direct_drive || row.is_direct_friction || row.is_direct_range)
            work.drive_lanes.push_back({row.joint, row.axis, row.lane});
        if (!row.is_direct_limit || row.idle) continue;
        const std::int32_t index = direct.set_of_joint[row.joint];
        const std::vector<DirectNode>& nodes = direct.sets[index].found; // in the order of joints
        const auto node = std::lower_bound(nodes.begin(), nodes.end(), row.joint,
                                           [](const DirectNode& n, std::uint32_t joint) { return n.joint < joint; });
        const JointAxisRule& rule = joints.axes[row.joint].rules[row.axis];
        DirectLimit& limit = work.limits.emplace_back();
        limit.set = index;
        limit.joint = row.joint, limit.axis = row.axis, limit.lane = row.lane;
        limit.body[0] = node->body[0], limit.body[1] = node->body[1];
        limit.bounds[0] = double(rule.lower), limit.bounds[1] = double(rule.upper);
    }
    std::sort(work.drive_lanes.begin(), work.drive_lanes.end(), comes_first);
    std::stable_sort(work.limits.begin(), work.limits.end(),
                     [](const DirectLimit& a, const DirectLimit& b) { return a.set < b.set; });
    for (DirectSolve& solve : work.sets) {
        const auto begin = std::partition_point(work.limits.begin(), work.limits.end(),
                                                [&](const DirectLimit& l) { return l.set < solve.set; });
        const auto end =
            std::partition_point(begin, work.limits.end(), [&](const DirectLimit& l) { return l.set == solve.set; });
        solve.first_limit = std::size_t(begin - work.limits.begin());
        solve.limit_count = std::size_t(end - begin);
    }
}

void fill_direct_rows(const Bodies& bodies, const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                      ThreadPool* thread_pool, float h) {
    DirectWork& work = scratch.direct;
    for_chunks(thread_pool, int(work.sets.size()), 1, [&](int begin, int end, int) {
        for (int k = begin; k < end; ++k) {
            DirectSolve& solve = work.sets[k];
            const DirectSet& set = direct.sets[solve.set];
            solve.is_touched = std::any_of(set.bodies.begin() + 1, set.bodies.end(),
                                           [&](std::uint32_t body) { return bodies.links[body].contact_count > 0; });
            for (std::size_t i = 0; i < set.bodies.size(); ++i)
                fill_body(bodies, scratch, set.bodies[i], work.bodies[solve.first_body + i]);
            for (std::size_t i = 0; i < set.nodes.size(); ++i)
                fill_row(bodies, joints, set.nodes[i], work.rows[solve.first_row + i]);
            for (std::size_t i = 0; i < set.nodes.size(); ++i)
                if (has_lane(joints, set.nodes[i]))
                    fill_drive(joints, work, set.nodes[i], h, work.rows[solve.first_row + i]);
            for (std::size_t i = 0; i < solve.limit_count; ++i) {
                DirectLimit& limit = work.limits[solve.first_limit + i];
                const JointAxisState& state = joints.axes[limit.joint].states[limit.axis];
                limit.impulse[0] = double(state.lower), limit.impulse[1] = double(state.upper);
            }
        }
    });
}

void store_direct_rows(Joints& joints, const DirectSets& direct, BatchScratch& scratch) {
    for (const DirectSolve& solve : scratch.direct.sets) {
        const DirectSet& set = direct.sets[solve.set];
        for (std::size_t i = 0; i < set.nodes.size(); ++i) {
            const DirectRow& row = scratch.direct.rows[solve.first_row + i];
            const DirectNode& node = set.nodes[i];
            JointInfo& joint = joints.info[node.joint];
            const math::Vec3 impulse = math::to_float(row.impulse), total = math::to_float(row.total);
            bool is_force = true;
            const float given = float(row.drive.impulse);
            JointAxisState* const state = has_drive(node) ? &joints.axes[node.joint].states[node.axis] : nullptr;
            switch (node.rows) {
            case DirectRows::point:
                joint.point_impulse = impulse;
                break;
            case DirectRows::turn:
                joint.turn_impulse = impulse;
                is_force = false;
                break;
            case DirectRows::axis:
                joints.axes[node.joint].states[node.axis].lower = impulse.x;
                joints.axes[node.joint].states[node.axis].upper = 0;
                is_force = is_along(joints.axes[node.joint].rules[node.axis].kind);
                break;
            case DirectRows::drive:
                state->drive = given;
                break;
            case DirectRows::friction:
                state->friction = given;
                break;
            case DirectRows::soft_limit:
                state->lower = std::max(given, 0.0f), state->upper = std::max(-given, 0.0f);
                break;
            }
            if (node.is_driven) state->drive = given;
            if (is_bounded(node.rows)) is_force = is_along(joints.axes[node.joint].rules[node.axis].kind);
            (is_force ? joint.force : joint.torque) += total;
        }
        for (std::size_t i = 0; i < solve.limit_count; ++i) {
            const DirectLimit& limit = scratch.direct.limits[solve.first_limit + i];
            JointAxisState& state = joints.axes[limit.joint].states[limit.axis];
            state.lower = float(limit.impulse[0]), state.upper = float(limit.impulse[1]);
        }
    }
}

} // namespace cairn
