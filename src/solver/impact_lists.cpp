// An impact goes over what joints hold to the struck bodies, and over the contacts of that. A large batch has several
// impacts in a step, each of which strikes few of its bodies. So what each row has is found once in a step, and an
// impact looks only at what it strikes.

#include "solver/impact_lists.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace cairn {

namespace {

constexpr float unknown_speed = -1;

// --- once in a step

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t row) {
    while (parent[row] != row) {
        parent[row] = parent[parent[row]];
        row = parent[row];
    }
    return row;
}
void unite(std::vector<std::int32_t>& parent, std::int32_t a, std::int32_t b) {
    const std::int32_t root_a = root_of(parent, a), root_b = root_of(parent, b);
    parent[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

void find_components(const Bodies& bodies, const Joints& joints, BatchScratch& scratch) {
    ImpactWork& work = scratch.impact;
    const std::vector<std::uint32_t>& listed = scratch.joint_layout->joints;
    const std::size_t rows = scratch.row_count();
    const auto row_of = [&](std::int32_t body) {
        return body != none && bodies.is_dynamic(body) ? scratch.row_of_body[body] : none;
    };
    std::vector<std::int32_t>& component = work.component;
    component.resize(rows);
    std::iota(component.begin(), component.end(), 0);
    work.joints_of.reset(rows, listed.size());
    for (std::size_t i = 0; i < listed.size(); ++i) {
        const JointInfo& joint = joints.info[listed[i]];
        const std::int32_t a = row_of(joint.body_a), b = row_of(joint.body_b);
        if (a != none && b != none) unite(component, a, b);
        if (a != none || b != none) work.joints_of.add(a != none ? a : b, i);
    }
    work.rows_of.reset(rows, rows);
    for (std::size_t row = rows; row-- > 0;) {
        const std::int32_t body = scratch.row_bodies[row];
        const bool moves = body != none && bodies.is_dynamic(body);
        component[row] = moves ? root_of(component, std::int32_t(row)) : fixed_row;
        work.rows_of.add(component[row], row);
    }
    work.is_struck.assign(rows, 0);
    work.speed.assign(rows, unknown_speed);
    work.group.assign(rows, none);
    work.place_of.resize(rows);
}

void find_sides(const LaneLists& lanes, std::size_t rows, RowLists& sides) {
    sides.reset(rows, 2 * lanes.record.size());
    for (std::size_t lane = 0; lane < lanes.record.size(); ++lane) {
        sides.add(lanes.row_a[lane], 2 * lane);
        sides.add(lanes.row_b[lane], 2 * lane + 1);
    }
}

// Blocks from `first` on; the first of their lanes may be those of runs before it.
void add_run(ImpactWork& work, int type, std::size_t first, std::size_t count, std::size_t first_lane = 0) {
    std::vector<std::uint32_t>& run_of_lane = work.run_of_lane[std::size_t(type)];
    const std::size_t begin = 8 * first + first_lane, end = 8 * (first + count);
    if (run_of_lane.size() < end) run_of_lane.resize(end);
    std::fill(run_of_lane.begin() + std::ptrdiff_t(begin), run_of_lane.begin() + std::ptrdiff_t(end),
              std::uint32_t(work.listed_runs.size()));
    work.listed_runs.push_back({type, std::uint32_t(first), 0, 0});
}
void find_runs(BatchScratch& scratch) {
    ImpactWork& work = scratch.impact;
    work.listed_runs.clear();
    for (const JointRun& run : scratch.joint_layout->runs)
        add_run(work, int(run.type), run.first, run.count, run.first_lane);
    for (const ColorRun& color : scratch.colors) {
        add_run(work, four_points_type, std::size_t(color.four_points.first), std::size_t(color.four_points.count));
        add_run(work, one_point_type, std::size_t(color.one_point.first), std::size_t(color.one_point.count));
    }
}

void begin_lists(const Bodies& bodies, const Joints& joints, BatchScratch& scratch) {
    ImpactWork& work = scratch.impact;
    if (work.has_components) {
        for (const std::int32_t row : work.rows) work.group[row] = none;
        for (const std::int32_t component : work.struck) work.is_struck[component] = 0;
        for (const std::int32_t row : work.measured) work.speed[row] = unknown_speed;
    } else {
        find_components(bodies, joints, scratch);
        find_sides(scratch.one_lanes, scratch.row_count(), work.one_sides_of);
        find_sides(scratch.four_lanes, scratch.row_count(), work.four_sides_of);
        find_runs(scratch);
        work.has_components = true;
    }
    work.struck.clear(), work.measured.clear(), work.struck_lanes.clear();
    work.groups.clear(), work.rows.clear(), work.before.clear(), work.listed.clear();
}

// --- what is struck

// Both bodies of a struck contact.
template <class Block> void mark_struck(BatchScratch& scratch, const LaneLists& lanes, std::vector<Block>& blocks) {
    ImpactWork& work = scratch.impact;
    for (std::size_t k = 0; k < lanes.record.size() / 8; ++k) {
        if (blocks[k].struck == 0) continue;
        work.struck_lanes.push_back(&blocks[k].struck);
        for (unsigned left = blocks[k].struck; left != 0; left &= left - 1) {
            const std::size_t lane = 8 * k + std::size_t(std::countr_zero(left));
            for (const std::int32_t row : {lanes.row_a[lane], lanes.row_b[lane]}) {
                const std::int32_t component = work.component[row];
                if (component == fixed_row || work.is_struck[component]) continue;
                work.is_struck[component] = 1;
                work.struck.push_back(component);
            }
        }
    }
}

void list_row(ImpactWork& work, std::int32_t row, std::int32_t group) {
    if (work.group[row] != none) return;
    work.group[row] = group;
    work.place_of[row] = none;
    work.rows.push_back(row);
}

void list_lane(ImpactWork& work, int type, std::size_t lane, std::int32_t row) {
    const std::uint32_t run = work.run_of_lane[std::size_t(type)][lane];
    work.listed.push_back({std::uint32_t(lane), row, run, 0});
}

void list_joints(BatchScratch& scratch, std::int32_t row) {
    const JointLayout& layout = *scratch.joint_layout;
    scratch.impact.joints_of.for_each(row, [&](std::size_t joint) {
        for (std::uint32_t k = layout.first_row[joint]; k < layout.first_row[joint + 1]; ++k)
            if (const JointRow& r = layout.rows[k]; !r.idle) list_lane(scratch.impact, int(r.type), r.lane, row);
    });
}

float square_speed(const BatchScratch& scratch, std::size_t row) {
    const math::Vec3 v = math::to_vec(scratch.velocity[row].v);
    return math::dot(v, v);
}
float measured_speed(BatchScratch& scratch, std::int32_t holder) {
    ImpactWork& work = scratch.impact;
    work.measured.push_back(holder);
    float greatest = 0;
    if (work.component[holder] == fixed_row)
        greatest = std::max(greatest, square_speed(scratch, std::size_t(holder)));
    else
        work.rows_of.for_each(holder,
                              [&](std::size_t row) { greatest = std::max(greatest, square_speed(scratch, row)); });
    return std::sqrt(greatest);
}
// Of the fastest body of its component, or of what no force moves.
float speed_of(BatchScratch& scratch, std::int32_t row) {
    const std::int32_t component = scratch.impact.component[row];
    const std::int32_t holder = component == fixed_row ? row : component;
    float& speed = scratch.impact.speed[holder];
    if (speed == unknown_speed) speed = measured_speed(scratch, holder);
    return speed;
}

// Contacts are there for what may meet within the whole step; in this substep they close at that speed only.
template <class Block> float closing_speed(const Block& b, std::size_t lane, float h) {
    float least = b.separation[0][lane];
    for (const auto& separation : b.separation) least = std::min(least, separation[lane]);
    return least / h;
}

// The contacts of a row that the impact may close.
template <class Block>
void list_contacts(BatchScratch& scratch, int type, std::int32_t row, const RowLists& sides, const LaneLists& lanes,
                   const std::vector<Block>& blocks, float h) {
    ImpactWork& work = scratch.impact;
    sides.for_each(row, [&](std::size_t side) {
        const std::size_t lane = side / 2;
        const bool is_b = side % 2 != 0;
        const std::int32_t other = is_b ? lanes.row_a[lane] : lanes.row_b[lane];
        const std::int32_t component = work.component[other];
        if (is_b && work.is_struck[component]) return; // A lists it
        const Block& block = blocks[lane / 8];
        const bool is_struck = (block.struck >> lane % 8 & 1) != 0;
        if (!is_struck && closing_speed(block, lane % 8, h) > speed_of(scratch, row) + speed_of(scratch, other)) return;
        if (component != fixed_row) {
            list_row(work, other, other);
            unite(work.group, row, other);
        }
        list_lane(work, type, lane, row);
    });
}

// --- side by side

// Puts the items of each part side by side, in the order in which they are listed.
template <class Part, class Item, class F>
void put_together(std::vector<Part>& parts, std::vector<Item>& items, std::vector<Item>& sorted, F&& part_of) {
    for (Part& part : parts) part.end = 0;
    for (const Item& item : items) ++parts[part_of(item)].end;
    std::size_t begin = 0;
    for (Part& part : parts) {
        const std::size_t count = part.end;
        part.begin = part.end = begin;
        begin += count;
    }
    sorted.resize(items.size());
    for (const Item& item : items) sorted[parts[part_of(item)].end++] = item;
    items.swap(sorted);
}

// What contacts or joints that take part do not connect, even over others, cannot strike each other: it settles each
// for itself.
void find_groups(BatchScratch& scratch) {
    ImpactWork& work = scratch.impact;
    for (const std::int32_t row : work.rows) {
        std::int32_t& place = work.place_of[root_of(work.group, row)];
        if (place == none) {
            place = std::int32_t(work.groups.size());
            work.groups.push_back({0, 0, false});
        }
        work.place_of[row] = place;
    }
    const auto place_of = [&](std::int32_t row) { return work.place_of[row]; };
    put_together(work.groups, work.rows, work.sorted_rows, place_of);
    for (const std::int32_t row : work.rows) work.before.push_back(scratch.velocity[row]);
    work.last = work.before;
    for (ImpactWork::ListedLane& lane : work.listed) lane.group = place_of(lane.group);
}

} // namespace

void list_impact(const Bodies& bodies, const Joints& joints, BatchScratch& scratch, float h) {
    ImpactWork& work = scratch.impact;
    begin_lists(bodies, joints, scratch);
    mark_struck(scratch, scratch.one_lanes, scratch.one_blocks);
    mark_struck(scratch, scratch.four_lanes, scratch.four_blocks);
    std::sort(work.struck.begin(), work.struck.end());
    const auto for_struck_rows = [&](auto&& f) {
        for (const std::int32_t component : work.struck)
            work.rows_of.for_each(component, [&](std::size_t row) { f(std::int32_t(row), component); });
    };
    for_struck_rows([&](std::int32_t row, std::int32_t component) { list_row(work, row, component); });
    for_struck_rows([&](std::int32_t row, std::int32_t) {
        list_joints(scratch, row);
        list_contacts(scratch, four_points_type, row, work.four_sides_of, scratch.four_lanes, scratch.four_blocks, h);
        list_contacts(scratch, one_point_type, row, work.one_sides_of, scratch.one_lanes, scratch.one_blocks, h);
    });
    for (std::uint8_t* const lanes : work.struck_lanes) *lanes = 0;
    find_groups(scratch);
    put_together(work.listed_runs, work.listed, work.sorted_lanes,
                 [](const ImpactWork::ListedLane& lane) { return lane.run; });
}

} // namespace cairn
