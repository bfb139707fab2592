// An impact involves the struck bodies, the bodies that joints connect to them, and the contacts of all these. A large
// batch has several impacts in a step, each of which strikes few of its bodies. The joints and contacts of each row are
// therefore listed once per step, and an impact visits only the rows that it involves.

#include "solver/impact_lists.h"

#include "solver/impacts.h"
#include "solver/rank_impacts.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace cairn {

namespace {

constexpr float unknown_speed = -1;
enum StruckWhen : std::uint8_t { untouched, in_this_round, in_an_earlier_round };

// --- once per step

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
    work.impact_round.assign(rows, untouched);
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

// Adds a run of blocks from `first` on. The first `first_lane` of their lanes may belong to earlier runs.
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

void find_sets(const DirectSets& direct, BatchScratch& scratch) {
    std::vector<std::int32_t>& set_of_row = scratch.impact.set_of_row;
    set_of_row.clear();
    if (scratch.direct.sets.empty()) return;
    set_of_row.assign(scratch.row_count(), none);
    for (std::size_t place = 0; place < scratch.direct.sets.size(); ++place) {
        const DirectSolve& solve = scratch.direct.sets[place];
        for (std::size_t i = 1; i < direct.sets[std::size_t(solve.set)].bodies.size(); ++i)
            set_of_row[std::size_t(scratch.direct.bodies[solve.first_body + i].row)] = std::int32_t(place);
    }
}

void begin_lists(const Bodies& bodies, const Joints& joints, const DirectSets& direct, BatchScratch& scratch) {
    ImpactWork& work = scratch.impact;
    if (work.has_components) {
        for (const std::int32_t component : work.all_impact_groups) work.impact_round[component] = untouched;
    } else {
        find_components(bodies, joints, scratch);
        find_sets(direct, scratch);
        find_sides(scratch.one_lanes, scratch.row_count(), work.one_sides_of);
        find_sides(scratch.four_lanes, scratch.row_count(), work.four_sides_of);
        find_runs(scratch);
        work.has_components = true;
    }
    work.in_impact.clear(), work.all_impact_groups.clear(), work.impact_lanes.clear();
}

void empty_lists(ImpactWork& work) {
    for (const std::int32_t row : work.rows) work.group[row] = none;
    for (const std::int32_t row : work.measured) work.speed[row] = unknown_speed;
    work.measured.clear(), work.groups.clear(), work.rows.clear(), work.before.clear(), work.listed.clear();
}

// --- struck bodies

// Row of a body; none if forces do not move the body, or another rank has it.
std::int32_t held_row(const BatchScratch& scratch, std::int32_t body) {
    return body == none ? none : scratch.row_of_body[body];
}

void mark_row(ImpactWork& work, std::int32_t row) {
    const std::int32_t component = work.component[row];
    if (component == fixed_row || work.impact_round[component] == in_this_round) return;
    if (work.impact_round[component] == untouched) work.all_impact_groups.push_back(component);
    work.impact_round[component] = in_this_round;
    work.in_impact.push_back(component);
}

template <class Block> float least_separation(const Block& b, std::size_t lane) {
    float least = b.separation[0][lane];
    for (const auto& separation : b.separation) least = std::min(least, separation[lane]);
    return least;
}

// Whether a contact pushes its bodies apart at more than `impact_speed`.
template <class Block> bool pushes_out(const Block& b, std::size_t lane, const ContactSoftness& softness) {
    const float rate = (b.mass_b[lane] == 0 ? softness.on_immovable : softness.on_movable).push_rate;
    return rate * least_separation(b, lane) < -impact_speed;
}
bool is_pushed_out(const BatchScratch& scratch, std::int32_t row, const ContactSoftness& softness) {
    const ImpactWork& work = scratch.impact;
    if (work.component[row] == fixed_row) return false;
    bool pushed = false;
    work.one_sides_of.for_each(
        row, [&](std::size_t side) { pushed |= pushes_out(scratch.one_blocks[side / 16], side / 2 % 8, softness); });
    work.four_sides_of.for_each(
        row, [&](std::size_t side) { pushed |= pushes_out(scratch.four_blocks[side / 16], side / 2 % 8, softness); });
    return pushed;
}

// Removes the hits of bodies that penetration pushes out.
void keep_real_hits(BatchScratch& scratch, Communicator* ranks, const ContactSoftness& softness) {
    std::vector<ImpactWork::Hit>& hits = scratch.impact.hits;
    if (scratch.border) share_hits(*ranks, hits);
    std::vector<std::int32_t>& pushed = scratch.impact.pushed;
    pushed.clear();
    for (const ImpactWork::Hit& hit : hits)
        for (const std::int32_t body : {hit.first, hit.other})
            if (const std::int32_t row = held_row(scratch, body); row != none && is_pushed_out(scratch, row, softness))
                pushed.push_back(body);
    if (scratch.border) share_bodies(*ranks, pushed);
    std::sort(pushed.begin(), pushed.end());
    const auto is_pushed = [&](std::int32_t body) { return std::binary_search(pushed.begin(), pushed.end(), body); };
    std::erase_if(hits, [&](const ImpactWork::Hit& hit) { return is_pushed(hit.first) || is_pushed(hit.other); });
}

void mark_hits(BatchScratch& scratch) {
    for (const ImpactWork::Hit& hit : scratch.impact.hits)
        for (const std::int32_t body : {hit.first, hit.other})
            if (const std::int32_t row = held_row(scratch, body); row != none) mark_row(scratch.impact, row);
}

// Lists both bodies of each struck contact as a hit.
template <class Block> void list_struck(BatchScratch& scratch, const LaneLists& lanes, std::vector<Block>& blocks) {
    ImpactWork& work = scratch.impact;
    for (std::size_t k = 0; k < lanes.record.size() / 8; ++k) {
        if (blocks[k].in_impact == 0) continue;
        work.impact_lanes.push_back(&blocks[k].in_impact);
        for (unsigned left = blocks[k].in_impact; left != 0; left &= left - 1) {
            const std::size_t lane = 8 * k + std::size_t(std::countr_zero(left));
            work.hits.push_back({scratch.row_bodies[lanes.row_a[lane]], scratch.row_bodies[lanes.row_b[lane]]});
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
    const std::vector<std::int32_t>& set_of_row = scratch.impact.set_of_row;
    if (!set_of_row.empty() && set_of_row[std::size_t(row)] != none) return; // the whole set is solved at once
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
// Speed of the fastest body in the row's component, or of the row itself if forces do not move its body.
float speed_of(BatchScratch& scratch, std::int32_t row) {
    const std::int32_t component = scratch.impact.component[row];
    const std::int32_t holder = component == fixed_row ? row : component;
    float& speed = scratch.impact.speed[holder];
    if (speed == unknown_speed) speed = measured_speed(scratch, holder);
    return speed;
}

// Whether a contact may close within this substep at the present speeds; contacts exist for pairs that may meet within
// the whole step.
template <class Block>
bool may_close(BatchScratch& scratch, const Block& b, std::size_t lane, std::int32_t row, std::int32_t other, float h) {
    const bool is_in_impact = (b.in_impact >> lane & 1) != 0;
    return is_in_impact || least_separation(b, lane) <= h * (speed_of(scratch, row) + speed_of(scratch, other));
}

bool is_in_round(const ImpactWork& work, std::int32_t row) {
    const std::int32_t component = work.component[row];
    return component != fixed_row && work.impact_round[component] == in_this_round;
}

// Lists the contacts of a row that the impact may close.
template <class Block>
void list_contacts(BatchScratch& scratch, int type, std::int32_t row, const RowLists& sides, const LaneLists& lanes,
                   const std::vector<Block>& blocks, float h) {
    ImpactWork& work = scratch.impact;
    sides.for_each(row, [&](std::size_t side) {
        const std::size_t lane = side / 2;
        const bool is_b = side % 2 != 0;
        const std::int32_t other = is_b ? lanes.row_a[lane] : lanes.row_b[lane];
        if (is_b && is_in_round(work, other)) return; // listed by row A
        if (!may_close(scratch, blocks[lane / 8], lane % 8, row, other, h)) return;
        if (work.component[other] != fixed_row) {
            list_row(work, other, other);
            unite(work.group, row, other);
        }
        list_lane(work, type, lane, row);
    });
}

void list_sets(BatchScratch& scratch) {
    ImpactWork& work = scratch.impact;
    work.sets.clear();
    if (work.set_of_row.empty()) return;
    for (const std::int32_t component : work.in_impact)
        work.rows_of.for_each(component, [&](std::size_t row) {
            if (work.set_of_row[row] != none) work.sets.push_back(work.set_of_row[row]);
        });
    std::sort(work.sets.begin(), work.sets.end());
    work.sets.erase(std::unique(work.sets.begin(), work.sets.end()), work.sets.end());
}

// --- spreading of the impact

// Whether the bodies of a contact approach each other so fast that this is an impact.
template <class Block> bool is_hit(const BatchScratch& scratch, const Block& b, std::size_t lane, float h) {
    const auto at = [&](const auto& rows) { return math::Vec3{rows[0][lane], rows[1][lane], rows[2][lane]}; };
    const SolverVelocity& a = scratch.velocity[b.a[lane] / row_bytes];
    const SolverVelocity& other = scratch.velocity[b.b[lane] / row_bytes];
    const math::Vec3 normal = at(b.normal), w = math::to_vec(other.w), turning = w - math::to_vec(a.w);
    const float common =
        math::dot(normal, math::to_vec(other.v) - math::to_vec(a.v)) + math::dot(math::cross(at(b.d), normal), w);
    for (std::size_t i = 0; i < std::size(b.impulse); ++i) {
        if (b.effective_mass[i][lane] == 0) continue;
        math::Vec3 arm;
        if constexpr (requires { b.arm; })
            arm = at(b.arm[i]);
        else
            arm = math::cross(at(b.center), normal);
        const float s = b.separation[i][lane];
        if (s < -impact_speed * h) continue;                                         // the penetration is pushed out
        if (b.restitution[lane] > 0 && s > 0 && !(b.impulse[i][lane] > 0)) continue; // the point will bounce
        if (common + math::dot(arm, turning) + std::max(s, 0.0f) / h < -impact_speed) return true;
    }
    return false;
}

// Whether an impact has driven a body away from the bodies that joints connect to it, because they took no part.
bool is_pulled_from_joints(const BatchScratch& scratch, std::int32_t row, const SolverVelocity& before) {
    const ImpactWork& work = scratch.impact;
    if (is_in_round(work, row) || work.rows_of.next[work.rows_of.first[work.component[row]]] < 0) return false;
    const math::Vec3 change = math::to_vec(scratch.velocity[row].v) - math::to_vec(before.v);
    return math::dot(change, change) > impact_speed * impact_speed;
}

// Lists the bodies that a body is driven into at contacts that took no part.
template <class Block>
void list_hits(BatchScratch& scratch, std::int32_t row, const RowLists& sides, const LaneLists& lanes,
               const std::vector<Block>& blocks, float h) {
    ImpactWork& work = scratch.impact;
    sides.for_each(row, [&](std::size_t side) {
        const std::size_t lane = side / 2;
        const std::int32_t other = side % 2 != 0 ? lanes.row_a[lane] : lanes.row_b[lane];
        const Block& block = blocks[lane / 8];
        if (!is_hit(scratch, block, lane % 8, h)) return;
        if ((is_in_round(work, row) || is_in_round(work, other)) && may_close(scratch, block, lane % 8, row, other, h))
            return;
        work.hits.push_back({scratch.row_bodies[row], scratch.row_bodies[other]});
    });
}

// --- independent groups

// Bodies that the participating contacts and joints do not connect, even indirectly, cannot strike each other: such
// groups settle independently.
void find_groups(BatchScratch& scratch) {
    ImpactWork& work = scratch.impact;
    for (const std::int32_t row : work.rows) {
        std::int32_t& place = work.place_of[root_of(work.group, row)];
        if (place == none) {
            place = std::int32_t(work.groups.size());
            work.groups.push_back({0, 0, false, false});
        }
        work.place_of[row] = place;
    }
    const auto place_of = [&](std::int32_t row) { return work.place_of[row]; };
    group_by_part(work.groups, work.rows, work.sorted_rows, place_of);
    for (const std::int32_t row : work.rows) work.before.push_back(scratch.velocity[row]);
    work.last = work.before;
    for (ImpactWork::ListedLane& lane : work.listed) lane.group = place_of(lane.group);
}

// The group of a body that took part.
std::int32_t place_of_body(const BatchScratch& scratch, std::int32_t body) {
    const ImpactWork& work = scratch.impact;
    if (!scratch.border) return work.place_of[scratch.row_of_body[body]];
    return work.shared.groups[std::size_t(row_of_shared(work.shared, body))];
}

} // namespace

void begin_impact_lists(const Bodies& bodies, const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                        Communicator* ranks, const ContactSoftness& softness) {
    begin_lists(bodies, joints, direct, scratch);
    scratch.impact.hits.clear();
    list_struck(scratch, scratch.one_lanes, scratch.one_blocks);
    list_struck(scratch, scratch.four_lanes, scratch.four_blocks);
    keep_real_hits(scratch, ranks, softness);
    mark_hits(scratch);
}

void list_impact(BatchScratch& scratch, float h) {
    ImpactWork& work = scratch.impact;
    empty_lists(work);
    std::sort(work.in_impact.begin(), work.in_impact.end());
    const auto for_struck_rows = [&](auto&& f) {
        for (const std::int32_t component : work.in_impact)
            work.rows_of.for_each(component, [&](std::size_t row) { f(std::int32_t(row), component); });
    };
    for_struck_rows([&](std::int32_t row, std::int32_t component) { list_row(work, row, component); });
    for_struck_rows([&](std::int32_t row, std::int32_t) {
        list_joints(scratch, row);
        list_contacts(scratch, four_points_type, row, work.four_sides_of, scratch.four_lanes, scratch.four_blocks, h);
        list_contacts(scratch, one_point_type, row, work.one_sides_of, scratch.one_lanes, scratch.one_blocks, h);
    });
    list_sets(scratch);
    find_groups(scratch);
    group_by_part(work.listed_runs, work.listed, work.sorted_lanes,
                  [](const ImpactWork::ListedLane& lane) { return lane.run; });
}

bool spread_impact(BatchScratch& scratch, Communicator* ranks, const ContactSoftness& softness) {
    ImpactWork& work = scratch.impact;
    work.hits.clear();
    for (std::size_t i = 0; i < work.rows.size(); ++i) {
        const std::int32_t row = work.rows[i];
        if (is_pulled_from_joints(scratch, row, work.before[i]))
            work.hits.push_back({scratch.row_bodies[row], scratch.row_bodies[row]});
        list_hits(scratch, row, work.four_sides_of, scratch.four_lanes, scratch.four_blocks, softness.h);
        list_hits(scratch, row, work.one_sides_of, scratch.one_lanes, scratch.one_blocks, softness.h);
    }
    keep_real_hits(scratch, ranks, softness);
    for (ImpactWork::Group& group : work.groups) group.continues = false;
    for (const ImpactWork::Hit& hit : work.hits)
        work.groups[std::size_t(place_of_body(scratch, hit.first))].continues = true;
    work.in_impact.clear();
    for (const ImpactWork::Group& group : work.groups)
        for (std::size_t i = group.begin; i < group.end; ++i) {
            const std::int32_t row = work.rows[i], component = work.component[row];
            if (work.impact_round[component] != in_this_round) continue;
            if (!group.continues)
                work.impact_round[component] = in_an_earlier_round;
            else if (row == component)
                work.in_impact.push_back(component);
        }
    mark_hits(scratch);
    return !work.hits.empty();
}

void end_impact_lists(ImpactWork& work) {
    for (std::uint8_t* const lanes : work.impact_lanes) *lanes = 0;
}

} // namespace cairn
