// The layout of joint rows: runs of one color, phase and form, in blocks of one form.

#include "joints/joint_layout.h"

#include "islands/coloring.h"
#include "joints/direct_joints.h"
#include "joints/direct_sets.h"
#include "joints/idle_limits.h"
#include "state/joint_links.h"

#include <algorithm>
#include <array>

namespace cairn {

namespace {

// Within a color, the rows of a joint are solved in phases: its axes one after the other, then its turn, and last its
// point, so that no other row disturbs the point. Rows of one phase and form share blocks.
constexpr std::uint32_t turn_phase = max_joint_axes, point_phase = turn_phase + 1, phases = point_phase + 1, forms = 16,
                        keys_per_color = phases * forms;

// Sort key of a row: overflow joints, each of which is solved alone, come first, then the colors.
std::uint32_t row_key(std::uint8_t color, std::uint32_t phase, std::uint32_t form) {
    const std::uint32_t rank = color == overflow_color ? 0u : color + 1u;
    return (rank * phases + phase) * forms + form;
}
bool stands_alone(std::uint32_t key) { return key < keys_per_color; }
// Points of joints that also have a turn are solved together with it.
std::uint32_t point_form(const JointLocks& rules) {
    return std::uint32_t(rules.point) | (rules.turn != JointLock::none ? form_with_turn : 0);
}
JointRowType type_of(std::uint32_t key) {
    const std::uint32_t phase = key / forms % phases;
    return phase == point_phase ? JointRowType::point : phase == turn_phase ? JointRowType::turn : JointRowType::axis;
}

void name_body(const Bodies& bodies, std::int32_t body, JointLayout& layout) {
    if (body != none && bodies.settings[body].type == BodyType::kinematic) layout.kinematic_bodies.push_back(body);
}

// Collects the rows of one joint.
void collect_joint(const Bodies& bodies, const Joints& joints, const DirectSets& direct, std::uint32_t joint,
                   JointLayout& layout) {
    const JointInfo& info = joints.info[joint];
    const JointLocks& rules = info.rules;
    name_body(bodies, info.body_a, layout);
    name_body(bodies, info.body_b, layout);
    auto add = [&](std::uint32_t phase, std::uint32_t form, JointRowType type, std::uint32_t axis) -> JointRow& {
        JointRow row;
        row.joint = joint;
        row.key = std::uint16_t(row_key(info.color, phase, form));
        row.type = type;
        row.axis = axis & 7;
        layout.only_points &= type == JointRowType::point;
        return layout.rows.emplace_back(row);
    };
    const bool is_direct = direct.set_of_joint[joint] != none;
    for (std::uint32_t i = 0; i < rules.axis_count; ++i) {
        const JointAxisRule& rule = joints.axes[joint].rules[i];
        const bool is_equation = is_direct && is_direct_axis(rule);
        if (is_equation && !has_direct_lane(rule.kind)) continue;
        if (!rule.has_limits && !rule.has_drive && !(rule.friction > 0)) continue;
        JointRow& row = add(i, std::uint32_t(rule.kind), JointRowType::axis, i);
        row.is_direct = is_direct;
        row.is_direct_limit = is_direct && is_direct_limit(rule);
        row.is_direct_range = is_equation || (is_direct && is_direct_soft_limit(rule));
        row.has_limits = rule.has_limits != 0 && !row.is_direct_limit && !row.is_direct_range;
        row.has_soft_limits = row.has_limits && !rule.rigid_limit;
        row.is_direct_drive = is_direct && is_direct_drive(rule);
        row.has_drive = rule.has_drive != 0 && !row.is_direct_drive;
        row.is_direct_friction = is_direct && is_direct_friction(rule);
        row.has_friction = rule.friction > 0 && !row.is_direct_friction;
        if (!row.is_direct_range) row.reach_by_turn = reach_by_turn(rules, joints.axes[joint], rule);
        layout.may_idle |= row.reach_by_turn != 0;
    }
    if (is_direct) return;
    if (rules.turn != JointLock::none) add(turn_phase, std::uint32_t(rules.turn), JointRowType::turn, 0);
    if (rules.point != JointLock::none) add(point_phase, point_form(rules), JointRowType::point, 0);
}

void collect_rows(const Bodies& bodies, const Joints& joints, const DirectSets& direct, JointLayout& layout) {
    for (const std::int32_t body : layout.bodies) {
        if (bodies.links[body].joint_count == 0) continue;
        for_each_joint(bodies, joints, body, [&](std::uint32_t joint, int) {
            if (joint_owner(bodies, joints.info[joint]) != body) return;
            layout.joints.push_back(joint);
            layout.first_row.push_back(std::uint32_t(layout.rows.size()));
            collect_joint(bodies, joints, direct, joint, layout);
        });
    }
    layout.first_row.push_back(std::uint32_t(layout.rows.size()));
}

// Numbers the keys that occur, out of many possible ones, in ascending order, and replaces the rows' keys by their
// numbers.
void number_keys(JointLayout& layout, std::vector<std::uint32_t>& numbers) {
    layout.keys.clear();
    std::uint32_t least = ~0u, most = 0;
    for (const JointRow& row : layout.rows) {
        least = std::min(least, std::uint32_t(row.key));
        most = std::max(most, std::uint32_t(row.key));
    }
    if (least > most) return;
    numbers.assign(most - least + 1, 0);
    for (const JointRow& row : layout.rows) numbers[row.key - least] = 1;
    for (std::uint32_t key = least; key <= most; ++key) {
        std::uint32_t& number = numbers[key - least];
        if (number == 0) continue;
        number = std::uint32_t(layout.keys.size());
        layout.keys.push_back(std::uint16_t(key));
    }
    for (JointRow& row : layout.rows) row.key = std::uint16_t(numbers[row.key - least]);
}

// By type and form: the lane after the last one assigned. If it is the first of a block, no block is open.
using OpenLanes = std::array<std::uint32_t, joint_row_types * forms>;

// Returns the first of the lanes for a number of rows. They begin a new block unless all of them fit into the open one,
// so that they are not spread over more blocks than necessary.
std::uint32_t take_lanes(JointLayout& layout, std::uint32_t& open, JointRowType type, std::uint32_t rows) {
    const bool fits = open % 8 != 0 && open % 8 + rows <= 8;
    std::uint32_t& blocks = layout.blocks[std::size_t(type)];
    const std::uint32_t first = fits ? open : 8 * blocks;
    if (!fits) blocks += (rows + 7) / 8;
    open = first + rows;
    return first;
}

void add_run(JointLayout& layout, std::uint32_t key, std::uint32_t lane, std::uint32_t rows) {
    const std::uint32_t first_lane = lane % 8, count = (rows + 7) / 8, end = first_lane + rows - 8 * (count - 1);
    std::int32_t part = none;
    if (end - first_lane < 8) {
        part = std::int32_t(layout.parts.size());
        layout.parts.push_back(std::uint8_t((1u << end) - (1u << first_lane)));
    }
    layout.runs.push_back(
        {type_of(key), std::uint8_t(8 * count - rows), std::uint16_t(key), lane / 8, count, first_lane, part});
}

// Assigns lanes to the rows, sorted by their keys (a stable counting sort). This is done whenever a limit comes within
// reach or leaves it, so it must not take longer than solving the rows.
void lay_out_rows(JointLayout& layout, std::vector<std::uint32_t>& lanes) {
    layout.runs.clear(), layout.parts.clear();
    layout.blocks = {};
    lanes.assign(layout.keys.size(), 0);
    for (const JointRow& row : layout.rows)
        if (!row.idle) ++lanes[row.key];
    OpenLanes open_lanes{};
    for (std::size_t number = 0; number < lanes.size(); ++number) {
        const std::uint32_t key = layout.keys[number], count = lanes[number];
        if (count == 0) continue;
        std::uint32_t& open = open_lanes[std::size_t(type_of(key)) * forms + joint_form_of(key)];
        const std::uint32_t first = take_lanes(layout, open, type_of(key), count);
        lanes[number] = first; // from now on: the next free lane
        if (stands_alone(key)) // overflow rows may share bodies
            for (std::uint32_t k = 0; k < count; ++k) add_run(layout, key, first + k, 1);
        else
            add_run(layout, key, first, count);
    }
    for (JointRow& row : layout.rows)
        if (!row.idle) row.lane = lanes[row.key]++;
}

} // namespace

bool may_be_fixed(std::uint32_t key) { return stands_alone(key) || key / keys_per_color > first_fixed_color; }
std::uint32_t joint_form_of(std::uint32_t key) { return key % forms; }

void fill_joint_lanes(const Bodies& bodies, Joints& joints, SolverScratch& solver, const DirectSets& direct,
                      const IslandBatch& batch, BatchScratch& scratch, ThreadPool* thread_pool, float h) {
    JointLayout& layout = solver.joint_layouts[&batch - solver.batches.data()];
    scratch.joint_layout = &layout;
    bool is_new = false;
    if (batch.joint_count == 0) {
        if (!layout.joints.empty()) layout = {};
    } else if (layout.valid_for != joints.changes || layout.bodies != scratch.touching_bodies) {
        layout.bodies = scratch.touching_bodies;
        layout.kinematic_bodies.clear(), layout.joints.clear(), layout.first_row.clear(), layout.rows.clear();
        layout.may_idle = false, layout.only_points = true;
        collect_rows(bodies, joints, direct, layout);
        number_keys(layout, scratch.joint_key_counts);
        layout.valid_for = joints.changes;
        is_new = true;
    }
    if (update_idle_rows(bodies, joints, layout, thread_pool) || is_new) lay_out_rows(layout, scratch.joint_key_counts);
    for (const std::int32_t body : layout.kinematic_bodies) row_of_body(scratch, body);
    list_direct_sets(joints, direct, scratch, h);
    list_direct_limits(joints, direct, scratch);
}

} // namespace cairn
