// The rows of joints in a solver bin: lanes, what is put into them, and what comes out.
#include "dynamics/bodies.h"
#include "dynamics/coloring.h"
#include "dynamics/direct_joints.h"
#include "dynamics/impacts.h"
#include "dynamics/joint_placement.h"
#include "dynamics/joints.h"
#include "dynamics/solver.h"

#include <algorithm>
#include <cstring>

namespace cairn {

using math::DQuat;
using math::DVec3;
using math::put;

namespace {

constexpr int blocks_per_chunk = 4; // for threads

// Within a color, rows of one joint come in phases: its axes one after the other, then its turn, then its point, which
// so has the last word. Rows of one phase and form share blocks.
constexpr std::uint32_t turn_phase = most_joint_axes, point_phase = turn_phase + 1, phases = point_phase + 1,
                        forms = 16;

std::uint32_t row_key(std::uint8_t color, std::uint32_t phase, std::uint32_t form) {
    const std::uint32_t rank = color == overflow_color ? 0u : color + 1u;
    return (rank * phases + phase) * forms + form;
}

std::int32_t joint_row(BinScratch& scratch, const State& s, std::int32_t body) {
    if (body == none || s.body_settings[std::size_t(body)].type == BodyType::static_) return fixed_row;
    return row_of_body(scratch, body);
}

// The rows of one joint, and those of its bodies.
void collect_joint(const State& s, std::uint32_t joint, BinScratch& scratch) {
    const JointInfo& info = s.joints[joint];
    const JointLocks& rules = info.rules;
    const std::int32_t a = joint_row(scratch, s, info.body_a), b = joint_row(scratch, s, info.body_b);
    auto add = [&](std::uint32_t phase, std::uint32_t form, JointRowType type, std::uint32_t axis) {
        scratch.unsorted_joint_rows.push_back({row_key(info.color, phase, form),
                                               type,
                                               info.color == overflow_color,
                                               {std::int32_t(joint), a, b, std::uint8_t(axis)}});
    };
    const bool is_direct = s.direct.set_of_joint[joint] != none;
    for (std::uint32_t i = 0; i < rules.axis_count; ++i) {
        const JointAxisRule& rule = s.joint_axes[joint].rules[i];
        if (is_direct && is_direct_axis(rule)) continue;
        if (rule.has_limits || rule.has_drive || rule.friction > 0)
            add(i, std::uint32_t(rule.kind), JointRowType::axis, i);
    }
    if (is_direct) return;
    if (rules.turn != JointLock::none) add(turn_phase, std::uint32_t(rules.turn), JointRowType::turn, 0);
    if (rules.point != JointLock::none) add(point_phase, std::uint32_t(rules.point), JointRowType::point, 0);
}

void collect_rows(const State& s, BinScratch& scratch) {
    scratch.unsorted_joint_rows.clear();
    scratch.joints.clear();
    for (const std::int32_t body : scratch.touching_bodies) {
        if (s.bodies[std::size_t(body)].joint_count == 0) continue;
        for_each_joint(s, body, [&](std::uint32_t joint, int) {
            if (joint_owner(s, s.joints[joint]) != body) return;
            scratch.joints.push_back(joint);
            collect_joint(s, joint, scratch);
        });
    }
}

// A counting sort, stable. Most bins have few keys of the many that there are.
void sort_rows(BinScratch& scratch) {
    const std::vector<JointRow>& from = scratch.unsorted_joint_rows;
    std::vector<JointRow>& to = scratch.joint_rows;
    to.resize(from.size());
    if (from.empty()) return;
    const auto by_key = [](const JointRow& a, const JointRow& b) { return a.key < b.key; };
    const auto [least, most] = std::minmax_element(from.begin(), from.end(), by_key);
    const std::uint32_t first = least->key, keys = most->key - first + 1;
    std::vector<std::uint32_t>& counts = scratch.joint_key_counts;
    counts.assign(keys + 1, 0);
    for (const JointRow& row : from) ++counts[row.key - first + 1];
    for (std::size_t k = 1; k <= keys; ++k) counts[k] += counts[k - 1];
    for (const JointRow& row : from) to[counts[row.key - first]++] = row;
}

constexpr JointLane no_lane{none, fixed_row, fixed_row, 0};

std::vector<JointLane>& lanes_for(BinScratch& scratch, JointRowType type) {
    return scratch.joint_lanes[std::size_t(type)];
}

void set_lane(float (*p)[8], std::size_t lane, math::Vec3 v) { p[0][lane] = v.x, p[1][lane] = v.y, p[2][lane] = v.z; }
void set_lane(float (*p)[8], std::size_t lane, const DQuat& q) {
    p[0][lane] = float(q.x), p[1][lane] = float(q.y), p[2][lane] = float(q.z), p[3][lane] = float(q.w);
}
math::Vec3 get_lane(const float (*p)[8], std::size_t lane) { return {p[0][lane], p[1][lane], p[2][lane]}; }

void fill_ends(const State& s, const BinScratch& scratch, JointEnds& ends, std::size_t lane, const JointLane& at,
               std::uint32_t discard) {
    auto writes = [&](std::int32_t row) {
        const std::int32_t body = scratch.row_bodies[std::size_t(row)];
        return body != none && s.is_dynamic(body) ? std::uint32_t(row) * row_bytes : discard;
    };
    ends.a[lane] = std::uint32_t(at.row_a) * row_bytes;
    ends.b[lane] = std::uint32_t(at.row_b) * row_bytes;
    ends.write_a[lane] = writes(at.row_a);
    ends.write_b[lane] = writes(at.row_b);
}

void fill_lane(const State& s, const JointLane& at, PointBlock& b, std::size_t lane, float) {
    const JointInfo& joint = s.joints[std::size_t(at.joint)];
    const JointPlacement p = place_anchors(s, joint);
    set_lane(b.arm_a0, lane, math::to_float(p.arm_a));
    set_lane(b.arm_b0, lane, math::to_float(p.arm_b));
    set_lane(b.gap0, lane, math::to_float(p.gap));
    b.free_axis = joint.rules.point == JointLock::across;
    if (b.free_axis) set_lane(b.axis0, lane, frame_axis(place_joint(s, joint).frame_a, joint.rules.point_column));
    set_lane(b.impulse, lane, joint.point_impulse);
}

void fill_lane(const State& s, const JointLane& at, TurnBlock& b, std::size_t lane, float) {
    const JointInfo& joint = s.joints[std::size_t(at.joint)];
    const JointPlacement p = place_joint(s, joint);
    b.free_axis = joint.rules.turn == JointLock::across;
    set_lane(b.turn0, lane, turn_of(p));
    set_lane(b.axis_a0, lane, frame_axis(p.frame_a, joint.rules.turn_column));
    set_lane(b.axis_b0, lane, frame_axis(p.frame_b, joint.rules.turn_column));
    set_lane(b.impulse, lane, joint.turn_impulse);
}

void fill_axis_rule(AxisBlock& b, std::size_t lane, const JointAxisRule& rule, float h) {
    b.lower[lane] = rule.has_limits ? rule.lower : -unlimited;
    b.upper[lane] = rule.has_limits ? rule.upper : unlimited;
    b.equation[lane] = rule.is_equation;
    b.rigid_limit[lane] = rule.rigid_limit;
    b.limit_stiffness[lane] = rule.limit_stiffness;
    b.limit_damping[lane] = rule.limit_damping;
    b.limit_relative[lane] = rule.limit_relative;
    b.drive_stiffness[lane] = rule.drive_stiffness;
    b.drive_damping[lane] = rule.drive_damping;
    b.target_position[lane] = rule.target_position;
    b.target_velocity[lane] = rule.target_velocity;
    b.rigid_drive[lane] = rule.rigid_drive;
    b.drive_relative[lane] = rule.drive_relative;
    b.most_drive[lane] = rule.has_drive ? std::min(rule.most_drive * h, unlimited) : 0.0f;
    b.most_friction[lane] = std::min(rule.friction * h, unlimited);
    b.ratio_a[lane] = rule.ratio_a;
    b.ratio_b[lane] = rule.ratio_b;
    b.has_limits |= rule.has_limits;
    b.has_drive |= rule.has_drive;
    b.has_friction |= rule.friction > 0;
}

void fill_lane(const State& s, const JointLane& at, AxisBlock& b, std::size_t lane, float h) {
    const JointInfo& joint = s.joints[std::size_t(at.joint)];
    const JointPlacement p = place_joint(s, joint);
    const JointAxes& axes = s.joint_axes[std::size_t(at.joint)];
    const JointAxisRule& rule = axes.rules[at.axis];
    const JointAxisState& state = axes.states[at.axis];
    b.kind = rule.kind;
    fill_axis_rule(b, lane, rule, h);
    set_lane(b.arm_a0, lane, math::to_float(p.arm_a));
    set_lane(b.arm_b0, lane, math::to_float(p.arm_b));
    set_lane(b.gap0, lane, math::to_float(p.gap));
    set_lane(b.turn0, lane, turn_of(p));
    const bool is_pulley = rule.kind == AxisKind::pulley;
    set_lane(b.axis_a0, lane, is_pulley ? pulley_reach(s, joint, 0, p) : frame_axis(p.frame_a, rule.column_a));
    set_lane(b.axis_b0, lane, is_pulley ? pulley_reach(s, joint, 1, p) : frame_axis(p.frame_b, rule.column_b));
    b.position[lane] = b.position0[lane] = state.position;
    b.drive_impulse[lane] = state.drive;
    b.friction_impulse[lane] = state.friction;
    b.lower_impulse[lane] = state.lower;
    b.upper_impulse[lane] = state.upper;
}

// Calls f(blocks, lanes, first discard row) for each of the three types of blocks.
template <class F> void for_block_types(BinScratch& scratch, F&& f) {
    const std::vector<JointLane>& points = lanes_for(scratch, JointRowType::point);
    const std::vector<JointLane>& turns = lanes_for(scratch, JointRowType::turn);
    const std::vector<JointLane>& axes = lanes_for(scratch, JointRowType::axis);
    const std::int32_t first = scratch.first_joint_discard_row();
    f(scratch.point_blocks, points, first);
    f(scratch.turn_blocks, turns, first + std::int32_t(points.size() / 8));
    f(scratch.axis_blocks, axes, first + std::int32_t((points.size() + turns.size()) / 8));
}

// Impulses are those of one substep. Forces are counted anew.
void begin_joint(State& s, std::uint32_t index, float h) {
    JointInfo& joint = s.joints[index];
    joint.force = joint.torque = {};
    if (joint.substep_time == h) return;
    const float ratio = joint.substep_time > 0 ? h / joint.substep_time : 0.0f;
    const float factor = ratio > 1e-3f && ratio < 1e3f ? ratio : 0.0f; // too different to say anything
    joint.point_impulse = factor * joint.point_impulse;
    joint.turn_impulse = factor * joint.turn_impulse;
    for (int i = 0; i < joint.rules.axis_count; ++i) {
        JointAxisState& axis = s.joint_axes[index].states[i];
        axis.drive *= factor, axis.friction *= factor, axis.lower *= factor, axis.upper *= factor;
    }
    joint.substep_time = h;
}

// --- and out again

void take_lane(State& s, const JointLane& at, const PointBlock& b, std::size_t lane) {
    JointInfo& joint = s.joints[std::size_t(at.joint)];
    joint.point_impulse = get_lane(b.impulse, lane);
    joint.force += get_lane(b.total, lane);
}
void take_lane(State& s, const JointLane& at, const TurnBlock& b, std::size_t lane) {
    JointInfo& joint = s.joints[std::size_t(at.joint)];
    joint.turn_impulse = get_lane(b.impulse, lane);
    joint.torque += get_lane(b.total, lane);
}
void take_lane(State& s, const JointLane& at, const AxisBlock& b, std::size_t lane) {
    JointInfo& joint = s.joints[std::size_t(at.joint)];
    s.joint_axes[std::size_t(at.joint)].states[at.axis] = {b.drive_impulse[lane], b.friction_impulse[lane],
                                                           b.lower_impulse[lane], b.upper_impulse[lane],
                                                           b.position[lane]};
    const float total = b.total[lane];
    const math::Vec3 linear = get_lane(b.linear_b, lane), arm = get_lane(b.arm_b0, lane);
    joint.force += total * linear;
    joint.torque += total * (get_lane(b.angular_b, lane) - math::cross(arm, linear));
}

bool is_sound(const State& s, std::uint32_t index) {
    const JointInfo& joint = s.joints[index];
    constexpr math::Vec3 ones{1, 1, 1};
    float sum = math::dot(joint.force, ones) + math::dot(joint.torque, ones);
    sum += math::dot(joint.point_impulse, ones) + math::dot(joint.turn_impulse, ones);
    for (int i = 0; i < joint.rules.axis_count; ++i) {
        const JointAxisState& axis = s.joint_axes[index].states[i];
        sum += axis.drive + axis.friction + axis.lower + axis.upper + axis.position;
    }
    return std::isfinite(sum);
}

// Whether a body of the joint has become faster than the world allows. It will be slowed down: what made it so must not
// be carried into the next step.
bool is_too_fast(const State& s, const BinScratch& scratch, std::uint32_t index) {
    const JointInfo& joint = s.joints[index];
    const float v_most = s.settings.max_linear_speed, w_most = s.settings.max_angular_speed;
    for (const std::int32_t body : {joint.body_a, joint.body_b}) {
        if (body == none || scratch.row_of_body[std::size_t(body)] == none) continue;
        const SolverVelocity& row = scratch.velocity[std::size_t(scratch.row_of_body[std::size_t(body)])];
        const math::Vec3 v = math::to_vec(row.v), w = math::to_vec(row.w);
        if (!(math::dot(v, v) <= v_most * v_most && math::dot(w, w) <= w_most * w_most)) return true;
    }
    return false;
}

void forget_impulses(State& s, std::uint32_t index) {
    JointInfo& joint = s.joints[index];
    joint.force = joint.torque = joint.point_impulse = joint.turn_impulse = {};
    for (JointAxisState& axis : s.joint_axes[index].states)
        axis = {0, 0, 0, 0, std::isfinite(axis.position) ? axis.position : 0.0f};
}

} // namespace

JointSoftness joint_softness(float h) {
    // Softer ones lag behind, harder ones gain energy: a hanging net from 0.35 / h on, an arm that servos hold from
    // 0.28 / h on.
    constexpr float pi = 3.14159265358979f, frequency_times_h = 0.25f, damping_ratio = 2.0f;
    const float omega_h = 2 * pi * frequency_times_h, a1 = 2 * damping_ratio + omega_h, a2 = omega_h * a1;
    return {h, 1 / h, a2 / (1 + a2), omega_h / (a1 * h), impact_speed, impact_spin};
}

void fill_joint_lanes(const State& s, BinScratch& scratch) {
    for (std::vector<JointLane>& lanes : scratch.joint_lanes) lanes.clear();
    scratch.joint_runs.clear();
    collect_rows(s, scratch);
    list_direct_sets(s, scratch);
    if (scratch.unsorted_joint_rows.empty()) return;
    sort_rows(scratch);
    const std::vector<JointRow>& rows = scratch.joint_rows;
    for (std::size_t k = 0; k < rows.size();) {
        std::vector<JointLane>& lanes = lanes_for(scratch, rows[k].type);
        JointRun run{rows[k].type, std::int32_t(lanes.size() / 8), 0};
        const std::uint32_t key = rows[k].key;
        for (; k < rows.size() && rows[k].key == key; ++k) {
            lanes.push_back(rows[k].lane);
            if (!rows[k].stands_alone) continue;
            ++k; // alone in its run: it may share bodies with the next
            break;
        }
        while (lanes.size() % 8 != 0) lanes.push_back(no_lane);
        run.count = std::int32_t(lanes.size() / 8) - run.first;
        scratch.joint_runs.push_back(run);
    }
}

void fill_joint_blocks(State& s, BinScratch& scratch, Crew* crew, float h) {
    for (const std::uint32_t joint : scratch.joints) begin_joint(s, joint, h);
    for_block_types(scratch, [&](auto& blocks, const std::vector<JointLane>& lanes, std::int32_t first_discard) {
        const std::size_t count = lanes.size() / 8;
        if (blocks.size() < count) blocks.resize(count);
        for_chunks(crew, int(count), blocks_per_chunk, [&](int begin, int end, int) {
            for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
                auto& block = blocks[k];
                block = {};
                const std::uint32_t discard = (std::uint32_t(first_discard) + std::uint32_t(k)) * row_bytes;
                for (std::size_t lane = 0; lane < 8; ++lane) {
                    const JointLane& at = lanes[8 * k + lane];
                    fill_ends(s, scratch, block, lane, at, discard);
                    if (at.joint == none) continue;
                    fill_lane(s, at, block, lane, h);
                }
            }
        });
    });
    fill_direct_rows(s, scratch, crew);
}

void store_joints(State& s, BinScratch& scratch, float dt) {
    for_block_types(scratch, [&](auto& blocks, const std::vector<JointLane>& lanes, std::int32_t) {
        for (std::size_t k = 0; k < lanes.size(); ++k)
            if (lanes[k].joint != none) take_lane(s, lanes[k], blocks[k / 8], k % 8);
    });
    store_direct_rows(s, scratch);
    const float rate = 1 / dt;
    for (const std::uint32_t index : scratch.joints) {
        JointInfo& joint = s.joints[index];
        joint.force = rate * joint.force;
        joint.torque = rate * joint.torque;
        if (!is_sound(s, index) || is_too_fast(s, scratch, index)) forget_impulses(s, index);
        if (math::dot(joint.force, joint.force) > joint.break_force * joint.break_force ||
            math::dot(joint.torque, joint.torque) > joint.break_torque * joint.break_torque)
            scratch.overloaded.push_back(index);
    }
}

} // namespace cairn
