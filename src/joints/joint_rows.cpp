// Transfers joints into the rows of a solver batch, and their results back.

#include "joints/joint_rows.h"

#include "core/cache.h"
#include "joints/direct_joints.h"
#include "joints/joint_layout.h"
#include "joints/joint_placement.h"
#include "state/joint_links.h"
#include "state/substeps.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace cairn {

using math::DQuat;
using math::DVec3;
using math::put;

namespace {

constexpr int joints_per_chunk = 64; // for threads

template <class F> void for_blocks_of(BatchScratch& scratch, JointRowType type, F&& f) {
    switch (type) {
    case JointRowType::point:
        return f(scratch.point_blocks);
    case JointRowType::turn:
        return f(scratch.turn_blocks);
    case JointRowType::axis:
        return f(scratch.axis_blocks);
    }
}

void set_lane(float (*p)[8], std::size_t lane, math::Vec3 v) { p[0][lane] = v.x, p[1][lane] = v.y, p[2][lane] = v.z; }
void set_lane(float (*p)[8], std::size_t lane, const DQuat& q) {
    p[0][lane] = float(q.x), p[1][lane] = float(q.y), p[2][lane] = float(q.z), p[3][lane] = float(q.w);
}
math::Vec3 get_lane(const float (*p)[8], std::size_t lane) { return {p[0][lane], p[1][lane], p[2][lane]}; }

// The body row of a joint's end, as an offset. If forces do not move the body, its row is read at most, not written.
struct JointEnd {
    std::uint32_t row = std::uint32_t(fixed_row) * row_bytes;
    bool is_written = false;
};
JointEnd joint_end(const Bodies& bodies, const BatchScratch& scratch, std::int32_t body) {
    if (body == none) return {};
    const BodyType type = bodies.settings[body].type;
    if (type == BodyType::static_) return {};
    return {std::uint32_t(scratch.row_of_body[body]) * row_bytes, type == BodyType::dynamic};
}

// Whether anything but the point of a joint gives it a torque; otherwise its torque members are never accessed.
bool has_torque(const JointInfo& joint) { return joint.rules.turn != JointLock::none || joint.rules.axis_count > 0; }

// Prefetches the data of the joint at this place of the layout.
void prefetch_joint(const Joints& joints, const JointLayout& layout, std::size_t place) {
    if (place >= layout.joints.size()) return;
    const std::uint32_t joint = layout.joints[place];
    const char* const info = reinterpret_cast<const char*>(&joints.info[joint]);
    prefetch(info), prefetch(info + 64);
    if (layout.only_points) return;
    for (std::size_t at = 128; at < sizeof(JointInfo); at += 64) prefetch(info + at);
    prefetch(&joints.axes[joint].states[0]);
}

// Placement of a joint at the start of the step, for all of its rows: with its frames, or with only its anchors if the
// frames are not needed.
struct FramedPlacement : JointPlacement {
    DQuat turn;
};
template <class Placement> struct PlacedJoint {
    const JointInfo& info;
    JointEnd a, b;
    Placement p;
};

template <class Placement, class Block>
void fill_ends(const PlacedJoint<Placement>& joint, Block& b, std::size_t lane, std::uint32_t discard) {
    b.a[lane] = joint.a.row, b.b[lane] = joint.b.row;
    if (!b.redirects) return;
    b.rest.write_a[lane] = joint.a.is_written ? joint.a.row : discard;
    b.rest.write_b[lane] = joint.b.is_written ? joint.b.row : discard;
}

bool needs_frames(const Joints& joints, const JointRow& row) {
    if (row.type != JointRowType::point) return !row.idle;
    const JointLocks& rules = joints.info[row.joint].rules;
    return rules.point == JointLock::across || rules.turn == JointLock::across;
}

void fill_lane(const Bodies&, const Joints&, const JointRow&, const PlacedJoint<JointAnchors>& joint, PointBlock& b,
               std::size_t lane, float) {
    set_lane(b.arm_a0, lane, math::to_float(joint.p.arm_a));
    set_lane(b.arm_b0, lane, math::to_float(joint.p.arm_b));
    set_lane(b.gap0, lane, math::to_float(joint.p.gap));
    set_lane(b.impulse, lane, joint.info.point_impulse);
    if (b.has_turn) set_lane(b.turn_axis0, lane, math::Vec3{});
}
// The axis that a joint's point or turn leaves free; zero: none.
math::Vec3 free_axis(const JointPlacement& p, JointLock lock, std::uint8_t column) {
    return lock == JointLock::across ? frame_axis(p.frame_a, column) : math::Vec3{};
}
void fill_lane(const Bodies& bodies, const Joints& joints, const JointRow& row,
               const PlacedJoint<FramedPlacement>& joint, PointBlock& b, std::size_t lane, float h) {
    fill_lane(bodies, joints, row, PlacedJoint<JointAnchors>{joint.info, joint.a, joint.b, joint.p}, b, lane, h);
    const JointLocks& rules = joint.info.rules;
    if (b.free_axis) set_lane(b.axis0, lane, frame_axis(joint.p.frame_a, rules.point_column));
    if (b.has_turn) set_lane(b.turn_axis0, lane, free_axis(joint.p, rules.turn, rules.turn_column));
}

void fill_lane(const Bodies&, const Joints&, const JointRow&, const PlacedJoint<FramedPlacement>& joint, TurnBlock& b,
               std::size_t lane, float) {
    set_lane(b.turn0, lane, joint.p.turn);
    set_lane(b.impulse, lane, joint.info.turn_impulse);
    if (!b.free_axis) return;
    set_lane(b.axis_a0, lane, frame_axis(joint.p.frame_a, joint.info.rules.turn_column));
    set_lane(b.axis_b0, lane, frame_axis(joint.p.frame_b, joint.info.rules.turn_column));
}

void fill_axis_rule(AxisBlock& b, std::size_t lane, const JointAxisRule& rule, float h) {
    b.lower[lane] = rule.has_limits ? rule.lower : -unlimited;
    b.upper[lane] = rule.has_limits ? rule.upper : unlimited;
    b.equation[lane] = rule.is_equation;
    b.rigid_limit[lane] = rule.rigid_limit;
    b.max_friction[lane] = std::min(rule.friction * h, unlimited);
    if (b.has_soft_limits) {
        b.limit_stiffness[lane] = rule.limit_stiffness;
        b.limit_damping[lane] = rule.limit_damping;
        b.limit_relative[lane] = rule.limit_relative;
    }
    if (b.has_drive) {
        b.drive_stiffness[lane] = rule.drive_stiffness;
        b.drive_damping[lane] = rule.drive_damping;
        b.target_position[lane] = rule.target_position;
        b.target_velocity[lane] = rule.target_velocity;
        b.rigid_drive[lane] = rule.rigid_drive;
        b.drive_relative[lane] = rule.drive_relative;
        b.max_drive[lane] = rule.has_drive ? std::min(rule.max_drive * h, unlimited) : 0.0f;
    }
    b.ratio_a[lane] = rule.ratio_a;
    b.ratio_b[lane] = rule.ratio_b;
}

void fill_lane(const Bodies& bodies, const Joints& joints, const JointRow& row,
               const PlacedJoint<FramedPlacement>& joint, AxisBlock& b, std::size_t lane, float h) {
    const FramedPlacement& p = joint.p;
    const JointAxisRule& rule = joints.axes[row.joint].rules[row.axis];
    const JointAxisState& state = joints.axes[row.joint].states[row.axis];
    fill_axis_rule(b, lane, rule, h);
    set_lane(b.arm_a0, lane, math::to_float(p.arm_a));
    set_lane(b.arm_b0, lane, math::to_float(p.arm_b));
    set_lane(b.gap0, lane, math::to_float(p.gap));
    set_lane(b.turn0, lane, p.turn);
    const bool is_pulley = rule.kind == AxisKind::pulley;
    set_lane(b.axis_a0, lane,
             is_pulley ? pulley_reach(bodies, joint.info, 0, p) : frame_axis(p.frame_a, rule.column_a));
    set_lane(b.axis_b0, lane,
             is_pulley ? pulley_reach(bodies, joint.info, 1, p) : frame_axis(p.frame_b, rule.column_b));
    const JointLocks& locks = joint.info.rules;
    set_lane(b.point_axis0, lane, free_axis(p, locks.point, locks.point_column));
    set_lane(b.turn_axis0, lane, free_axis(p, locks.turn, locks.turn_column));
    b.position[lane] = b.position0[lane] = state.position;
    b.drive_impulse[lane] = state.drive;
    b.friction_impulse[lane] = state.friction;
    b.lower_impulse[lane] = state.lower;
    b.upper_impulse[lane] = state.upper;
    if (row.is_direct_drive) b.drive_impulse[lane] = b.max_drive[lane] = 0;
    if (row.is_direct_friction) b.friction_impulse[lane] = b.max_friction[lane] = 0;
    if (!row.is_direct_limit && !row.is_direct_range) return;
    b.equation[lane] = 0;
    b.lower[lane] = -unlimited, b.upper[lane] = unlimited;
    b.lower_impulse[lane] = b.upper_impulse[lane] = 0;
}

// Fills the rows of the joint at this place of the layout. `first_discard`: the first discard rows, by JointRowType.
template <class Placement>
void fill_rows_of(const Bodies& bodies, const Joints& joints, BatchScratch& scratch,
                  const std::array<std::int32_t, joint_row_types>& first_discard, std::size_t place,
                  const PlacedJoint<Placement>& joint, float h) {
    const JointLayout& layout = *scratch.joint_layout;
    for (std::uint32_t i = layout.first_row[place]; i < layout.first_row[place + 1]; ++i) {
        const JointRow& row = layout.rows[i];
        if (row.idle) continue;
        const std::uint32_t block = row.lane / 8, lane = row.lane % 8;
        const std::uint32_t discard = (std::uint32_t(first_discard[std::size_t(row.type)]) + block) * row_bytes;
        const auto fill = [&](auto& blocks) {
            fill_ends(joint, blocks[block], lane, discard);
            fill_lane(bodies, joints, row, joint, blocks[block], lane, h);
        };
        if constexpr (std::is_same_v<Placement, JointAnchors>)
            fill(scratch.point_blocks); // only points do without frames
        else
            for_blocks_of(scratch, row.type, fill);
    }
}

// Before lanes are filled: sets the members that all lanes of a block share, and in lanes that stay empty, those that
// fill_lane sets. All other members are set before they are read.
template <class... Members> void clear(Members&... members) { (std::memset(members, 0, sizeof(members)), ...); }
void clear_lanes(PointBlock& b) { clear(b.arm_a0, b.arm_b0, b.gap0, b.impulse, b.axis0, b.turn_axis0); }
void clear_lanes(TurnBlock& b) { clear(b.turn0, b.impulse, b.axis_a0, b.axis_b0); }
void clear_lanes(AxisBlock& b) {
    clear(b.lower, b.upper, b.equation, b.rigid_limit, b.limit_stiffness, b.limit_damping, b.limit_relative);
    clear(b.lower_impulse, b.upper_impulse, b.drive_impulse, b.max_friction, b.friction_impulse);
    clear(b.drive_stiffness, b.drive_damping, b.target_position, b.target_velocity, b.rigid_drive, b.drive_relative,
          b.max_drive);
    clear(b.arm_a0, b.arm_b0, b.gap0, b.turn0, b.axis_a0, b.axis_b0, b.ratio_a, b.ratio_b, b.position, b.position0,
          b.point_axis0, b.turn_axis0);
}
void open_block(PointBlock& b, std::uint32_t form) {
    b.free_axis = JointLock(form & ~form_with_turn) == JointLock::across;
    b.has_turn = (form & form_with_turn) != 0;
}
void open_block(TurnBlock& b, std::uint32_t form) { b.free_axis = JointLock(form) == JointLock::across; }
void open_block(AxisBlock& b, std::uint32_t form) {
    b.kind = AxisKind(form);
    b.has_limits = b.has_soft_limits = b.has_drive = b.has_friction = 0;
    b.points = b.turns = b.direct = 0;
    b.plain_locks = 1;
}
template <class Block> void open_run(const JointRun& run, std::vector<Block>& blocks, std::uint32_t first_discard) {
    if (!opens_blocks(run)) {
        blocks[run.first].redirects |= may_be_fixed(run.key);
        return;
    }
    for (std::uint32_t k = run.first; k < run.first + run.count; ++k) {
        Block& b = blocks[k];
        const bool is_full = k + 1 < run.first + run.count || run.empty_lanes == 0;
        if (!is_full) clear_lanes(b);
        const std::uint32_t discard = (first_discard + k) * row_bytes;
        for (std::size_t lane = is_full ? 8 : 8 - run.empty_lanes; lane < 8; ++lane)
            b.a[lane] = b.b[lane] = b.rest.write_a[lane] = b.rest.write_b[lane] = discard;
        b.redirects = may_be_fixed(run.key);
        open_block(b, joint_form_of(run.key));
    }
}

template <class Block> void extend(std::vector<Block>& blocks, std::size_t count) {
    if (blocks.size() < count) blocks.resize(count);
}

void open_blocks(const Joints& joints, BatchScratch& scratch) {
    extend(scratch.point_blocks, scratch.joint_layout->blocks[0]);
    extend(scratch.turn_blocks, scratch.joint_layout->blocks[1]);
    extend(scratch.axis_blocks, scratch.joint_layout->blocks[2]);
    const auto first_discard = scratch.first_joint_discard_rows();
    for (const JointRun& run : scratch.joint_layout->runs)
        for_blocks_of(scratch, run.type, [&](auto& blocks) {
            open_run(run, blocks, std::uint32_t(first_discard[std::size_t(run.type)]));
        });
    for (const JointRow& row : scratch.joint_layout->rows) {
        if (row.type != JointRowType::axis || row.idle) continue;
        AxisBlock& b = scratch.axis_blocks[row.lane / 8];
        b.has_limits |= row.has_limits;
        b.has_soft_limits |= row.has_soft_limits;
        b.has_drive |= row.has_drive;
        b.has_friction |= row.has_friction;
        const std::uint8_t lane = std::uint8_t(1u << row.lane % 8);
        const JointLocks& locks = joints.info[row.joint].rules;
        if (locks.point != JointLock::none) b.points |= lane;
        if (locks.turn != JointLock::none) b.turns |= lane;
        if (row.is_direct) b.direct |= lane;
        b.plain_locks &= locks.turn == JointLock::none && locks.point != JointLock::across;
    }
}

// Describes a run for the kernels, once its lanes are filled.
template <class Block>
JointCall call_of(BatchScratch& scratch, const JointRun& run, std::vector<Block>& blocks, std::uint32_t first_discard) {
    JointCall call{run.type, sizeof(Block), {blocks.data() + run.first, int(run.count), nullptr}};
    if (run.part == none) return call;
    const std::uint32_t last = run.first + run.count - 1, discard = (first_discard + last) * row_bytes;
    const Block& b = blocks[last];
    const std::uint32_t *const to_a = b.redirects ? b.rest.write_a : b.a, *const to_b =
                                                                              b.redirects ? b.rest.write_b : b.b;
    PartLanes& own = scratch.part_lanes[run.part];
    own.lanes = scratch.joint_layout->parts[run.part];
    for (std::uint32_t lane = 0; lane < 8; ++lane) {
        const bool is_own = (own.lanes >> lane & 1) != 0;
        own.to_a[lane] = is_own ? to_a[lane] : discard, own.to_b[lane] = is_own ? to_b[lane] : discard;
    }
    call.run.part = &own;
    return call;
}
void list_calls(BatchScratch& scratch) {
    const JointLayout& layout = *scratch.joint_layout;
    extend(scratch.part_lanes, layout.parts.size());
    scratch.joint_calls.clear();
    const auto first_discard = scratch.first_joint_discard_rows();
    for (const JointRun& run : layout.runs)
        for_blocks_of(scratch, run.type, [&](auto& blocks) {
            scratch.joint_calls.push_back(
                call_of(scratch, run, blocks, std::uint32_t(first_discard[std::size_t(run.type)])));
        });
}

// Rescales impulses, which are those of one substep, and resets the forces.
void begin_joint(Joints& joints, std::uint32_t index, float h) {
    JointInfo& joint = joints.info[index];
    joint.force = {};
    if (has_torque(joint)) joint.torque = {};
    if (joint.substep_time == h) return;
    const float factor = carried_share(joint.substep_time, h).factor;
    joint.point_impulse = factor * joint.point_impulse;
    joint.turn_impulse = factor * joint.turn_impulse;
    for (int i = 0; i < joint.rules.axis_count; ++i) {
        JointAxisState& axis = joints.axes[index].states[i];
        axis.drive *= factor, axis.friction *= factor, axis.lower *= factor, axis.upper *= factor;
    }
    joint.substep_time = h;
}

// --- results

void take_lane(Joints& joints, const JointRow& row, const PointBlock& b, std::size_t lane) {
    JointInfo& joint = joints.info[row.joint];
    joint.point_impulse = get_lane(b.impulse, lane);
    const math::Vec3 total = get_lane(b.total, lane);
    joint.force += total;
    if (!b.has_turn) return;
    for (int i = 0; i < 3; ++i) joint.torque[i] -= math::dot(get_lane(b.by_turn + 3 * i, lane), total);
}
void take_lane(Joints& joints, const JointRow& row, const TurnBlock& b, std::size_t lane) {
    JointInfo& joint = joints.info[row.joint];
    joint.turn_impulse = get_lane(b.impulse, lane);
    joint.torque += get_lane(b.total, lane);
}
void take_lane(Joints& joints, const JointRow& row, const AxisBlock& b, std::size_t lane) {
    JointInfo& joint = joints.info[row.joint];
    joints.axes[row.joint].states[row.axis] = {b.drive_impulse[lane], b.friction_impulse[lane], b.lower_impulse[lane],
                                               b.upper_impulse[lane], b.position[lane],         0};
    const float total = b.total[lane];
    const math::Vec3 linear = get_lane(b.linear_b, lane), arm = get_lane(b.arm_b0, lane);
    joint.force += total * linear;
    joint.torque += total * (get_lane(b.angular_b, lane) - math::cross(arm, linear));
}

bool is_sound(const Joints& joints, std::uint32_t index) {
    const JointInfo& joint = joints.info[index];
    constexpr math::Vec3 ones{1, 1, 1};
    float sum = math::dot(joint.force, ones) + math::dot(joint.point_impulse, ones);
    if (has_torque(joint)) sum += math::dot(joint.torque, ones) + math::dot(joint.turn_impulse, ones);
    for (int i = 0; i < joint.rules.axis_count; ++i) {
        const JointAxisState& axis = joints.axes[index].states[i];
        sum += axis.drive + axis.friction + axis.lower + axis.upper + axis.position;
    }
    return std::isfinite(sum);
}

// Whether a body exceeds the world's greatest speeds. It will be slowed down, and the impulses that accelerated it must
// not be carried into the next step.
bool is_too_fast(const WorldDef& settings, const SolverVelocity& row) {
    const float v_max = settings.max_linear_speed, w_max = settings.max_angular_speed;
    const math::Vec3 v = math::to_vec(row.v), w = math::to_vec(row.w);
    return !(math::dot(v, v) <= v_max * v_max && math::dot(w, w) <= w_max * w_max);
}
bool is_too_fast(const Joints& joints, const WorldDef& settings, const BatchScratch& scratch, std::uint32_t index) {
    const JointInfo& joint = joints.info[index];
    for (const std::int32_t body : {joint.body_a, joint.body_b}) {
        if (body == none || scratch.row_of_body[body] == none) continue;
        const std::size_t row = std::size_t(scratch.row_of_body[body]);
        if (is_too_fast(settings, scratch.velocity[row])) return true;
    }
    return false;
}
bool any_is_too_fast(const WorldDef& settings, const BatchScratch& scratch) {
    for (std::size_t row = 0; row < scratch.row_count(); ++row)
        if (is_too_fast(settings, scratch.velocity[row])) return true;
    return false;
}

void forget_impulses(Joints& joints, std::uint32_t index) {
    JointInfo& joint = joints.info[index];
    joint.force = joint.torque = joint.point_impulse = joint.turn_impulse = {};
    for (JointAxisState& axis : joints.axes[index].states)
        axis = {0, 0, 0, 0, std::isfinite(axis.position) ? axis.position : 0.0f, 0};
}

// Finishes a joint whose impulses have all been added up. `may_be_fast`: some body of the batch is too fast.
void end_joint(Joints& joints, const WorldDef& settings, BatchScratch& scratch, std::uint32_t index, float rate,
               bool may_be_fast) {
    JointInfo& joint = joints.info[index];
    joint.force = rate * joint.force;
    if (has_torque(joint)) joint.torque = rate * joint.torque;
    if (!is_sound(joints, index) || (may_be_fast && is_too_fast(joints, settings, scratch, index)))
        forget_impulses(joints, index);
    const auto is_more = [](math::Vec3 v, float most) { return math::dot(v, v) > most * most; };
    if (is_more(joint.force, joint.break_force) || (has_torque(joint) && is_more(joint.torque, joint.break_torque)))
        scratch.overloaded.push_back(index);
}

} // namespace

void fill_joint_blocks(const Bodies& bodies, Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                       ThreadPool* thread_pool, float h) {
    open_blocks(joints, scratch);
    const JointLayout& layout = *scratch.joint_layout;
    const auto discard = scratch.first_joint_discard_rows();
    // Joint by joint, as neighboring joints share bodies, and rows go to one block of each color at a time.
    for_chunks(thread_pool, int(layout.joints.size()), joints_per_chunk, [&](int begin, int end, int) {
        for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
            prefetch_joint(joints, layout, k + joints_ahead);
            begin_joint(joints, layout.joints[k], h);
            if (layout.first_row[k] == layout.first_row[k + 1]) continue;
            const JointInfo& info = joints.info[layout.joints[k]];
            const JointEnd a = joint_end(bodies, scratch, info.body_a), b = joint_end(bodies, scratch, info.body_b);
            bool with_frames = false;
            for (std::uint32_t i = layout.first_row[k]; i < layout.first_row[k + 1]; ++i)
                with_frames = with_frames || needs_frames(joints, layout.rows[i]);
            if (with_frames) {
                const JointPlacement p = place_joint(bodies, info);
                fill_rows_of<FramedPlacement>(bodies, joints, scratch, discard, k, {info, a, b, {p, turn_of(p)}}, h);
            } else {
                fill_rows_of<JointAnchors>(bodies, joints, scratch, discard, k,
                                           {info, a, b, place_anchors(bodies, info)}, h);
            }
        }
    });
    list_calls(scratch);
    fill_direct_rows(bodies, joints, direct, scratch, thread_pool, h);
}

void store_joints(Joints& joints, const WorldDef& settings, const DirectSets& direct, BatchScratch& scratch, float dt) {
    const JointLayout& layout = *scratch.joint_layout;
    const float rate = 1 / dt;
    const bool may_be_fast = !layout.joints.empty() && any_is_too_fast(settings, scratch);
    for (std::size_t k = 0; k < layout.joints.size(); ++k) {
        prefetch_joint(joints, layout, k + joints_ahead);
        for (std::uint32_t i = layout.first_row[k]; i < layout.first_row[k + 1]; ++i) {
            const JointRow& row = layout.rows[i];
            if (row.idle) continue;
            for_blocks_of(scratch, row.type,
                          [&](auto& blocks) { take_lane(joints, row, blocks[row.lane / 8], row.lane % 8); });
        }
        if (direct.set_of_joint[layout.joints[k]] != none) continue; // finished below
        end_joint(joints, settings, scratch, layout.joints[k], rate, may_be_fast);
    }
    store_direct_rows(joints, direct, scratch);
    for (const DirectSolve& solve : scratch.direct.sets)
        for (const std::uint32_t joint : direct.sets[solve.set].joints)
            end_joint(joints, settings, scratch, joint, rate, may_be_fast);
}

} // namespace cairn
