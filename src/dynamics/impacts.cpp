#include "dynamics/impacts.h"

#include "dynamics/block_runs.h"
#include "dynamics/joints.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace cairn {

namespace {

constexpr int most_passes = 32;
// m/s, rad/s: a group whose bodies change by less in a pass has settled.
constexpr SettledChange settled = {0.02f, 0.08f};

// The types of blocks, as in ImpactWork::blocks: first those of joints, by JointRowType.
constexpr int one_point_type = joint_row_types, four_points_type = joint_row_types + 1;

// Calls f(its blocks in the bin, its struck blocks) for one type of blocks.
template <class F> void with_type(BinScratch& scratch, int type, F&& f) {
    auto& blocks = scratch.impact.blocks;
    switch (type) {
    case int(JointRowType::point):
        return f(scratch.point_blocks, std::get<0>(blocks));
    case int(JointRowType::turn):
        return f(scratch.turn_blocks, std::get<1>(blocks));
    case int(JointRowType::axis):
        return f(scratch.axis_blocks, std::get<2>(blocks));
    case one_point_type:
        return f(scratch.one_blocks, std::get<one_point_type>(blocks));
    default:
        return f(scratch.four_blocks, std::get<four_points_type>(blocks));
    }
}
template <class F> void for_types(BinScratch& scratch, F&& f) {
    for (int type = 0; type <= four_points_type; ++type) with_type(scratch, type, f);
}

// --- which bodies and rows take part

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t row) {
    while (parent[std::size_t(row)] != row) {
        parent[std::size_t(row)] = parent[std::size_t(parent[std::size_t(row)])];
        row = parent[std::size_t(row)];
    }
    return row;
}
void unite(std::vector<std::int32_t>& parent, std::int32_t a, std::int32_t b) {
    const std::int32_t root_a = root_of(parent, a), root_b = root_of(parent, b);
    parent[std::size_t(std::max(root_a, root_b))] = std::min(root_a, root_b);
}

void find_components(const State& s, BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    const JointLayout& layout = *scratch.joint_layout;
    std::vector<std::int32_t>& component = work.component;
    component.resize(scratch.row_count());
    std::iota(component.begin(), component.end(), 0);
    const auto row_of = [&](std::int32_t body) {
        return body != none && s.is_dynamic(body) ? scratch.row_of_body[std::size_t(body)] : none;
    };
    for (const std::uint32_t joint : layout.joints) {
        const std::int32_t a = row_of(s.joints[joint].body_a), b = row_of(s.joints[joint].body_b);
        if (a != none && b != none) unite(component, a, b);
    }
    for (std::size_t row = 0; row < component.size(); ++row) {
        const std::int32_t body = scratch.row_bodies[row];
        const bool moves = body != none && s.is_dynamic(body);
        component[row] = moves ? root_of(component, std::int32_t(row)) : fixed_row;
    }
    for (std::size_t type = 0; type < joint_row_types; ++type)
        work.joint_component[type].assign(8 * std::size_t(layout.blocks[type]), fixed_row);
    for (const JointRow& joint_row : layout.rows) {
        if (joint_row.idle) continue;
        const std::int32_t row = row_of(joint_owner(s, s.joints[joint_row.joint]));
        work.joint_component[std::size_t(joint_row.type)][joint_row.lane] =
            row == none ? fixed_row : component[std::size_t(row)];
    }
    work.has_components = true;
}

// Both bodies of a struck contact.
template <class Block> void mark_struck(BinScratch& scratch, const LaneLists& lanes, const std::vector<Block>& blocks) {
    ImpactWork& work = scratch.impact;
    for (std::size_t k = 0; k < lanes.record.size() / 8; ++k) {
        const unsigned struck = blocks[k].struck;
        for (std::size_t i = 0; struck >> i; ++i) {
            if (!((struck >> i) & 1) || lanes.record[8 * k + i] == none) continue;
            for (const std::int32_t row : {lanes.row_a[8 * k + i], lanes.row_b[8 * k + i]})
                work.is_struck[std::size_t(work.component[std::size_t(row)])] = 1;
        }
    }
    work.is_struck[fixed_row] = 0;
}

void list_row(ImpactWork& work, std::int32_t row) {
    if (work.component[std::size_t(row)] == fixed_row || work.is_listed[std::size_t(row)]) return;
    work.is_listed[std::size_t(row)] = 1;
    work.rows.push_back(row);
}

// All that joints hold to what was struck, and how fast its bodies are.
void list_joints(BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    work.square_speed.assign(scratch.row_count(), 0);
    for (std::size_t row = 0; row < scratch.row_count(); ++row) {
        const std::int32_t component = work.component[row];
        work.is_struck[row] = work.is_struck[std::size_t(component)];
        const math::Vec3 v = math::to_vec(scratch.velocity[row].v);
        float& greatest = work.square_speed[component == fixed_row ? row : std::size_t(component)];
        greatest = std::max(greatest, math::dot(v, v));
        if (!work.is_struck[row]) continue;
        work.group[row] = component;
        list_row(work, std::int32_t(row));
    }
    for (const JointRun& run : scratch.joint_layout->runs) {
        const std::vector<std::int32_t>& components = work.joint_component[std::size_t(run.type)];
        const std::size_t begin = work.listed.size();
        for (std::size_t lane = 8 * run.first; lane < 8 * (std::size_t(run.first) + run.count); ++lane)
            if (work.is_struck[std::size_t(components[lane])])
                work.listed.push_back({std::uint32_t(lane), components[lane], 0});
        work.listed_runs.push_back({int(run.type), run.first, begin, work.listed.size()});
    }
}

float speed_of(const ImpactWork& work, std::int32_t row) {
    const std::int32_t component = work.component[std::size_t(row)];
    return std::sqrt(work.square_speed[std::size_t(component == fixed_row ? row : component)]);
}

// Contacts are there for what may meet within the whole step; in this substep they close at that speed only.
template <class Block> float closing_speed(const Block& b, std::size_t lane, float h) {
    float least = b.separation[0][lane];
    for (const auto& separation : b.separation) least = std::min(least, separation[lane]);
    return least / h;
}

// And all contacts of that which the impact may close.
template <class Block>
void list_contacts(BinScratch& scratch, const BlockRun& run, const LaneLists& lanes, std::vector<Block>& blocks,
                   float h) {
    ImpactWork& work = scratch.impact;
    const std::size_t begin = work.listed.size();
    for (std::size_t lane = 8 * std::size_t(run.first); lane < 8 * std::size_t(run.first + run.count); ++lane) {
        const std::int32_t a = lanes.row_a[lane], b = lanes.row_b[lane];
        if (!work.is_struck[std::size_t(a)] && !work.is_struck[std::size_t(b)]) continue;
        const Block& block = blocks[lane / 8];
        const bool is_struck = (block.struck >> lane % 8 & 1) != 0;
        if (!is_struck && closing_speed(block, lane % 8, h) > speed_of(work, a) + speed_of(work, b)) continue;
        list_row(work, a);
        list_row(work, b);
        const bool a_moves = work.component[std::size_t(a)] != fixed_row;
        if (a_moves && work.component[std::size_t(b)] != fixed_row) unite(work.group, a, b);
        work.listed.push_back({std::uint32_t(lane), a_moves ? a : b, 0});
    }
    for (std::int32_t k = run.first; k < run.first + run.count; ++k) blocks[std::size_t(k)].struck = 0;
    work.listed_runs.push_back(
        {run.four_points ? four_points_type : one_point_type, std::uint32_t(run.first), begin, work.listed.size()});
}

// What contacts or joints that take part do not connect, even over others, cannot strike each other: it settles each
// for itself. The rows of a group are put side by side.
void find_groups(BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    work.place_of.assign(scratch.row_count(), none);
    const auto place_of = [&](std::int32_t row) -> std::int32_t& {
        return work.place_of[std::size_t(root_of(work.group, row))];
    };
    for (const std::int32_t row : work.rows) {
        std::int32_t& place = place_of(row);
        if (place == none) {
            place = std::int32_t(work.groups.size());
            work.groups.push_back({0, 0, false});
        }
        ++work.groups[std::size_t(place)].end;
    }
    std::size_t begin = 0;
    for (ImpactWork::Group& group : work.groups) {
        const std::size_t count = group.end;
        group.begin = group.end = begin;
        begin += count;
    }
    work.sorted_rows.resize(work.rows.size());
    for (const std::int32_t row : work.rows) work.sorted_rows[work.groups[std::size_t(place_of(row))].end++] = row;
    work.rows.swap(work.sorted_rows);
    for (const std::int32_t row : work.rows) work.before.push_back(scratch.velocity[std::size_t(row)]);
    work.last = work.before;
    for (ImpactWork::ListedLane& lane : work.listed) lane.group = place_of(lane.group);
}

// --- blocks of their own

// Lanes of blocks of one form may lie in one block. What is not in it is the same in the whole run.
std::uint8_t form_of(const PointBlock& b) { return b.even; }
std::uint8_t form_of(const TurnBlock& b) { return b.even; }
std::uint8_t form_of(const AxisBlock& b) { return std::uint8_t(b.even | b.has_limits << 1); }
template <int N> std::uint8_t form_of(const ContactBlock<N>& b) { return b.even; }

// Where a body's velocity goes that does not move by forces: none of its own business, but that of the block.
template <class Block> void redirect(Block& b, std::size_t lane, std::uint32_t first_discard, std::uint32_t discard) {
    const auto move = [&](std::uint32_t& row) {
        if (row >= first_discard) row = discard;
    };
    if constexpr (requires { b.write_b; })
        move(b.write_b[lane]);
    else if (b.redirects)
        move(b.rest.write_a[lane]), move(b.rest.write_b[lane]);
}
template <class Block> void empty_lanes(Block& b, std::uint32_t discard) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
        b.a[lane] = b.b[lane] = discard;
        if constexpr (requires { b.write_b; })
            b.write_b[lane] = discard;
        else
            b.rest.write_a[lane] = b.rest.write_b[lane] = discard;
    }
}

// What `strike` reads of a lane.
template <class T> void take_row(T (&to)[8], std::size_t lane, const T (&from)[8], std::size_t from_lane) {
    to[lane] = from[from_lane];
}
template <std::size_t N>
void take_rows(float (&to)[N][8], std::size_t lane, const float (&from)[N][8], std::size_t from_lane) {
    for (std::size_t i = 0; i < N; ++i) to[i][lane] = from[i][from_lane];
}
template <class Block> void copy_bodies(Block& to, std::size_t lane, const Block& from, std::size_t from_lane) {
    take_row(to.a, lane, from.a, from_lane);
    take_row(to.b, lane, from.b, from_lane);
    take_row(to.mass_a, lane, from.mass_a, from_lane);
    take_row(to.mass_b, lane, from.mass_b, from_lane);
}
template <class Block> void copy_ends(Block& to, std::size_t lane, const Block& from, std::size_t from_lane) {
    copy_bodies(to, lane, from, from_lane);
    take_row(to.even_a, lane, from.even_a, from_lane);
    take_row(to.even_b, lane, from.even_b, from_lane);
    take_row(to.rest.write_a, lane, from.rest.write_a, from_lane);
    take_row(to.rest.write_b, lane, from.rest.write_b, from_lane);
    if (from.even) return;
    take_rows(to.rest.inertia_a, lane, from.rest.inertia_a, from_lane);
    take_rows(to.rest.inertia_b, lane, from.rest.inertia_b, from_lane);
}
void copy_lane(PointBlock& to, std::size_t lane, const PointBlock& from, std::size_t from_lane) {
    copy_ends(to, lane, from, from_lane);
    take_rows(to.arm_a, lane, from.arm_a, from_lane);
    take_rows(to.arm_b, lane, from.arm_b, from_lane);
    take_rows(to.response, lane, from.response, from_lane);
    take_rows(to.total, lane, from.total, from_lane);
}
void copy_lane(TurnBlock& to, std::size_t lane, const TurnBlock& from, std::size_t from_lane) {
    copy_ends(to, lane, from, from_lane);
    take_rows(to.response, lane, from.response, from_lane);
    take_rows(to.total, lane, from.total, from_lane);
}
void copy_lane(AxisBlock& to, std::size_t lane, const AxisBlock& from, std::size_t from_lane) {
    copy_ends(to, lane, from, from_lane);
    take_rows(to.linear_a, lane, from.linear_a, from_lane);
    take_rows(to.linear_b, lane, from.linear_b, from_lane);
    take_rows(to.angular_a, lane, from.angular_a, from_lane);
    take_rows(to.angular_b, lane, from.angular_b, from_lane);
    take_row(to.mass, lane, from.mass, from_lane);
    take_row(to.position, lane, from.position, from_lane);
    take_row(to.lower, lane, from.lower, from_lane);
    take_row(to.upper, lane, from.upper, from_lane);
    take_row(to.equation, lane, from.equation, from_lane);
    take_row(to.rigid_limit, lane, from.rigid_limit, from_lane);
    take_row(to.total, lane, from.total, from_lane);
}
template <int N>
void copy_lane(ContactBlock<N>& to, std::size_t lane, const ContactBlock<N>& from, std::size_t from_lane) {
    copy_bodies(to, lane, from, from_lane);
    take_row(to.write_b, lane, from.write_b, from_lane);
    take_rows(to.inertia_a, lane, from.inertia_a, from_lane);
    take_rows(to.inertia_b, lane, from.inertia_b, from_lane);
    if constexpr (N > 1) {
        for (std::size_t i = 0; i < N; ++i) take_rows(to.arm[i], lane, from.arm[i], from_lane);
        take_rows(to.share, lane, from.share, from_lane);
    }
    take_rows(to.effective_mass, lane, from.effective_mass, from_lane);
    take_rows(to.impulse, lane, from.impulse, from_lane);
    take_rows(to.separation, lane, from.separation, from_lane);
    take_rows(to.total_impulse, lane, from.total_impulse, from_lane);
    take_rows(to.center, lane, from.center, from_lane);
    take_rows(to.normal, lane, from.normal, from_lane);
    take_rows(to.d, lane, from.d, from_lane);
    take_rows(to.tangent, lane, from.tangent, from_lane);
    take_rows(to.tangent_mass, lane, from.tangent_mass, from_lane);
    take_row(to.friction, lane, from.friction, from_lane);
    take_row(to.restitution, lane, from.restitution, from_lane);
    take_rows(to.total_tangent, lane, from.total_tangent, from_lane);
}

// Copies lanes of one run of the bin's blocks, by form and group. There are never more blocks than in the bin, so that
// each has a discard row there.
template <class Block, class Impact>
void copy_run(BinScratch& scratch, const ImpactWork::ListedRun& run, const std::vector<Block>& from,
              StruckBlocks<Block, Impact>& to, std::int32_t first_discard_row) {
    ImpactWork& work = scratch.impact;
    const auto begin = work.listed.begin() + std::ptrdiff_t(run.begin),
               end = work.listed.begin() + std::ptrdiff_t(run.end);
    for (auto lane = begin; lane != end; ++lane) lane->form = form_of(from[lane->source / 8]);
    std::sort(begin, end, [](const ImpactWork::ListedLane& a, const ImpactWork::ListedLane& b) {
        return std::tie(a.form, a.group, a.source) < std::tie(b.form, b.group, b.source);
    });
    const std::size_t first = to.blocks.size();
    const std::uint32_t first_discard = std::uint32_t(scratch.row_count()) * row_bytes;
    std::uint32_t discard = (std::uint32_t(first_discard_row) + run.first) * row_bytes;
    std::size_t used = 8;
    for (auto lane = begin; lane != end; ++lane, ++used) {
        const Block& block = from[lane->source / 8];
        if (used == 8 || lane->form != std::prev(lane)->form) {
            if (to.blocks.size() > first) discard += row_bytes;
            to.blocks.push_back(block);
            to.impacts.push_back({});
            to.lanes.insert(to.lanes.end(), 8, {0, none});
            empty_lanes(to.blocks.back(), discard);
            used = 0;
        }
        copy_lane(to.blocks.back(), used, block, lane->source % 8);
        redirect(to.blocks.back(), used, first_discard, discard);
        to.lanes[8 * (to.blocks.size() - 1) + used] = {lane->source, lane->group};
        to.impacts.back().active = std::uint8_t(to.impacts.back().active | 1u << used);
    }
    const std::size_t count = to.blocks.size() - first;
    if (count > 0) work.runs.push_back({run.type, std::uint32_t(first), std::uint32_t(count)});
}

void copy_listed(BinScratch& scratch) {
    const std::int32_t ones = scratch.first_discard_row(),
                       fours = ones + std::int32_t(scratch.one_lanes.record.size() / 8);
    const auto joints = scratch.first_joint_discard_rows();
    const std::int32_t discards[] = {joints[0], joints[1], joints[2], ones, fours};
    for (const ImpactWork::ListedRun& run : scratch.impact.listed_runs) {
        const std::int32_t discard = discards[run.type];
        with_type(scratch, run.type, [&](auto& from, auto& to) { copy_run(scratch, run, from, to, discard); });
    }
}

void begin_impact(const State& s, BinScratch& scratch, float h) {
    ImpactWork& work = scratch.impact;
    if (!work.has_components) find_components(s, scratch);
    for_types(scratch, [](auto&, auto& struck) { struck.clear(); });
    work.runs.clear(), work.groups.clear(), work.rows.clear(), work.before.clear();
    work.listed.clear(), work.listed_runs.clear();
    work.is_struck.assign(scratch.row_count(), 0);
    work.is_listed.assign(scratch.row_count(), 0);
    work.group.resize(scratch.row_count());
    std::iota(work.group.begin(), work.group.end(), 0);
    mark_struck(scratch, scratch.one_lanes, scratch.one_blocks);
    mark_struck(scratch, scratch.four_lanes, scratch.four_blocks);
    list_joints(scratch);
    for (const ColorRun& color : scratch.colors) {
        list_contacts(scratch, color.four_points, scratch.four_lanes, scratch.four_blocks, h);
        list_contacts(scratch, color.one_point, scratch.one_lanes, scratch.one_blocks, h);
    }
    find_groups(scratch);
    copy_listed(scratch);
}

// --- passes

void strike_run(BinScratch& scratch, int type, std::size_t first, int count, float h) {
    SolverVelocity* const velocity = scratch.velocity.data();
    with_type(scratch, type, [&](auto&, auto& struck) {
        auto* const blocks = struck.blocks.data() + first;
        auto* const impacts = struck.impacts.data() + first;
        if constexpr (std::is_same_v<std::remove_pointer_t<decltype(impacts)>, JointImpact>) {
            const JointKernels& k = kernels().joints;
            const JointKernels::ForRows* const rows[] = {&k.point, &k.turn, &k.axis};
            rows[type]->strike(blocks, impacts, count, velocity, 1 / h);
        } else {
            const SolverKernels& k = kernels().solver;
            (type == four_points_type ? k.four_points : k.one_point).strike(blocks, impacts, count, velocity, 1 / h);
        }
    });
}

void strike_all(BinScratch& scratch, Crew* crew, float h) {
    for (const StruckRun& run : scratch.impact.runs)
        for_chunks(crew, int(run.count), blocks_per_chunk(crew, int(run.count)), [&](int begin, int end, int) {
            strike_run(scratch, run.type, run.first + std::size_t(begin), end - begin, h);
        });
}

// Lanes of groups that have settled take part no longer.
void retire_lanes(BinScratch& scratch) {
    const std::vector<ImpactWork::Group>& groups = scratch.impact.groups;
    for_types(scratch, [&](auto&, auto& struck) {
        for (std::size_t k = 0; k < struck.impacts.size(); ++k)
            for (unsigned left = struck.impacts[k].active; left != 0; left &= left - 1) {
                const unsigned i = unsigned(std::countr_zero(left));
                if (!groups[std::size_t(struck.lanes[8 * k + i].group)].is_settled) continue;
                struck.impacts[k].active = std::uint8_t(struck.impacts[k].active & ~(1u << i));
            }
    });
}

// Groups that have settled leave. Whether any is left.
bool settle_groups(BinScratch& scratch) {
    ImpactWork& work = scratch.impact;
    bool any_left = false, any_settled = false;
    for (ImpactWork::Group& group : work.groups) {
        if (group.is_settled) continue;
        const float change =
            kernels().solver.change_since(scratch.velocity.data(), work.rows.data() + group.begin,
                                          int(group.end - group.begin), work.last.data() + group.begin, settled);
        group.is_settled = !(change >= 1);
        (group.is_settled ? any_settled : any_left) = true;
    }
    if (any_left && any_settled) retire_lanes(scratch);
    return any_left;
}

// --- and back

// What an impact has changed goes to the reference too, and is not carried. Likewise what the rounding leaves over.
void add_to_references(BinScratch& scratch) {
    const ImpactWork& work = scratch.impact;
    const auto add = [](const float* before, const float* now, float* reference, float* rounding) {
        for (int i = 0; i < 3; ++i) {
            const double carried = (double(before[i]) - double(reference[i])) + double(rounding[i]);
            reference[i] = float(double(reference[i]) + (double(now[i]) - double(before[i])));
            rounding[i] = float(carried - (double(now[i]) - double(reference[i])));
        }
    };
    for (std::size_t i = 0; i < work.rows.size(); ++i) {
        const std::size_t row = std::size_t(work.rows[i]);
        const SolverVelocity& now = scratch.velocity[row];
        add(work.before[i].v, now.v, scratch.reference[row].v, scratch.rounding[row].v);
        add(work.before[i].w, now.w, scratch.reference[row].w, scratch.rounding[row].w);
    }
}

template <int N>
void take_totals(ContactBlock<N>& to, std::size_t lane, const ContactBlock<N>& from, std::size_t from_lane) {
    take_rows(to.total_impulse, lane, from.total_impulse, from_lane);
    take_rows(to.total_tangent, lane, from.total_tangent, from_lane);
}
template <class Block> void take_totals(Block& to, std::size_t lane, const Block& from, std::size_t from_lane) {
    take_rows(to.total, lane, from.total, from_lane);
}
void take_totals(AxisBlock& to, std::size_t lane, const AxisBlock& from, std::size_t from_lane) {
    to.total[lane] = from.total[from_lane];
}

void take_all_totals(BinScratch& scratch) {
    for_types(scratch, [](auto& blocks, auto& struck) {
        for (std::size_t i = 0; i < struck.lanes.size(); ++i) {
            const std::size_t source = struck.lanes[i].source;
            if (struck.lanes[i].group != none) take_totals(blocks[source / 8], source % 8, struck.blocks[i / 8], i % 8);
        }
    });
}

} // namespace

void solve_impacts(const State& s, BinScratch& scratch, Crew* crew, float h, std::atomic<int>& struck_contacts) {
    if (struck_contacts == 0) return;
    struck_contacts = 0;
    begin_impact(s, scratch, h);
    for (int pass = 0; pass < most_passes; ++pass) {
        strike_all(scratch, crew, h);
        if (!settle_groups(scratch)) break;
    }
    add_to_references(scratch);
    take_all_totals(scratch);
}

} // namespace cairn
