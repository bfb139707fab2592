#include "solver/impacts.h"

#include "kernels/solve/block_fields.h"
#include "solver/block_runs.h"
#include "solver/impact_lists.h"

#include <algorithm>
#include <bit>
#include <tuple>
#include <type_traits>
#include <utility>

namespace cairn {

namespace {

constexpr int max_passes = 48;
// m/s, rad/s: a group whose bodies change by less in a pass has settled.
constexpr SettledChange settled = {0.02f, 0.08f};

// Calls f(its blocks in the batch, its struck blocks) for one type of blocks.
template <class F> void with_type(BatchScratch& scratch, int type, F&& f) {
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
template <class F> void for_types(BatchScratch& scratch, F&& f) {
    for (int type = 0; type <= four_points_type; ++type) with_type(scratch, type, f);
}

// --- blocks of their own

// Lanes of blocks of one form may lie in one block. What is not in it is the same in the whole run.
std::uint8_t form_of(const PointBlock& b) { return b.isotropic; }
std::uint8_t form_of(const TurnBlock& b) { return b.isotropic; }
std::uint8_t form_of(const AxisBlock& b) { return std::uint8_t(b.isotropic | b.has_limits << 1); }
template <int N> std::uint8_t form_of(const ContactBlock<N>& b) { return b.isotropic; }

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

// What `strike` does not read: it is not copied. A new member of a block is, unless it is named here.
template <class Block> struct NotStruck { static constexpr std::tuple<> list{}; };
template <> struct NotStruck<PointBlock> {
    using B = PointBlock;
    static constexpr auto list = std::tuple(&B::gap, &B::impulse, &B::left_a, &B::left_b, &B::arm_a0, &B::arm_b0,
                                            &B::gap0, &B::left_linear, &B::axis0);
};
template <> struct NotStruck<TurnBlock> {
    using B = TurnBlock;
    static constexpr auto list =
        std::tuple(&B::error, &B::impulse, &B::left_a, &B::left_b, &B::turn0, &B::axis_a0, &B::axis_b0);
};
template <> struct NotStruck<AxisBlock> { // limits that are springs, drives and friction give no impulses
    using B = AxisBlock;
    static constexpr auto list =
        std::tuple(&B::left, &B::before, &B::limit_stiffness, &B::limit_damping, &B::limit_relative, &B::lower_impulse,
                   &B::upper_impulse, &B::drive_stiffness, &B::drive_damping, &B::target_position, &B::target_velocity,
                   &B::rigid_drive, &B::drive_relative, &B::max_drive, &B::drive_impulse, &B::drive_pull,
                   &B::max_friction, &B::friction_impulse, &B::arm_a0, &B::arm_b0, &B::gap0, &B::turn0, &B::axis_a0,
                   &B::axis_b0, &B::ratio_a, &B::ratio_b, &B::position0);
};
template <int N> struct NotStruck<PointRows<N>> {
    using B = PointRows<N>;
    static constexpr auto list = std::tuple(&B::separation0, &B::height, &B::square_lever);
};
template <> struct NotStruck<PointRows<1>> {
    static constexpr auto list =
        std::tuple(&PointRows<1>::separation0, &PointRows<1>::turning, &PointRows<1>::sliding, &PointRows<1>::rim);
};
template <int N> struct NotStruck<ContactBlock<N>> { // of friction: only that at the friction center
    using B = ContactBlock<N>;
    static constexpr auto list =
        std::tuple(&B::moved_moment, &B::d0, &B::found, &B::radius_a, &B::radius_b, &B::passing_square,
                   &B::torsion_mass, &B::torsion_coupling, &B::static_friction, &B::torsion_radius, &B::tangent_impulse,
                   &B::torsion_impulse, &B::rolling_radius, &B::rolling_impulse);
};

// One lane of a row, or of rows of rows.
template <class T> void take_lane(T (&to)[8], std::size_t lane, const T (&from)[8], std::size_t from_lane) {
    to[lane] = from[from_lane];
}
template <class Rows, std::size_t N>
requires std::is_array_v<Rows>
void take_lane(Rows (&to)[N], std::size_t lane, const Rows (&from)[N], std::size_t from_lane) {
    for (std::size_t i = 0; i < N; ++i) take_lane(to[i], lane, from[i], from_lane);
}

// What `strike` reads of a lane. What a block has one of is that of the whole block, see form_of.
template <class Block> void copy_lane(Block& to, std::size_t lane, const Block& from, std::size_t from_lane) {
    if constexpr (requires { typename BlockFields<Block>::Base; })
        copy_lane<typename BlockFields<Block>::Base>(to, lane, from, from_lane);
    const auto copy = [&]<class T, class B>(T B::*member) {
        if constexpr (std::is_same_v<T, JointEndsRest>)
            copy_lane(to.*member, lane, from.*member, from_lane);
        else if constexpr (std::is_array_v<T>)
            take_lane(to.*member, lane, from.*member, from_lane);
        else
            static_assert(std::is_same_v<T, std::uint8_t> || std::is_same_v<T, AxisKind>, "copy members of this type");
    };
    constexpr std::size_t count = std::tuple_size_v<decltype(BlockFields<Block>::list)>;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (
            [&] {
                constexpr auto member = std::get<I>(BlockFields<Block>::list);
                if constexpr (!has_field(NotStruck<Block>::list, member)) copy(member);
            }(),
            ...);
    }
    (std::make_index_sequence<count>{});
}

// Copies lanes of one run of the batch's blocks, by form and group. There are never more blocks than in the batch, so
// that each has a discard row there.
template <class Block, class Impact>
void copy_run(BatchScratch& scratch, const ImpactWork::ListedRun& run, const std::vector<Block>& from,
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
    work.runs.push_back({run.type, std::uint32_t(first), std::uint32_t(to.blocks.size() - first)});
}

void copy_listed(BatchScratch& scratch) {
    const std::int32_t ones = scratch.first_discard_row(),
                       fours = ones + std::int32_t(scratch.one_lanes.record.size() / 8);
    const auto joints = scratch.first_joint_discard_rows();
    const std::int32_t discards[] = {joints[0], joints[1], joints[2], ones, fours};
    for (const ImpactWork::ListedRun& run : scratch.impact.listed_runs) {
        if (run.begin == run.end) continue;
        const std::int32_t discard = discards[std::size_t(run.type)];
        with_type(scratch, run.type, [&](auto& from, auto& to) { copy_run(scratch, run, from, to, discard); });
    }
}

void begin_impact(const Bodies& bodies, const Joints& joints, BatchScratch& scratch, float h) {
    for_types(scratch, [](auto&, auto& struck) { struck.clear(); });
    scratch.impact.runs.clear();
    list_impact(bodies, joints, scratch, h);
    copy_listed(scratch);
    const auto renew = [&](const SolverKernels::ForPoints& k, auto& struck) {
        k.renew_masses(struck.blocks.data(), int(struck.blocks.size()), scratch.inertia.data());
    };
    renew(kernels().solver.one_point, std::get<one_point_type>(scratch.impact.blocks));
    renew(kernels().solver.four_points, std::get<four_points_type>(scratch.impact.blocks));
}

// --- passes

void strike_run(BatchScratch& scratch, int type, std::size_t first, int count, float h) {
    SolverVelocity* const velocity = scratch.velocity.data();
    with_type(scratch, type, [&](auto&, auto& struck) {
        auto* const blocks = struck.blocks.data() + first;
        auto* const impacts = struck.impacts.data() + first;
        if constexpr (std::is_same_v<std::remove_pointer_t<decltype(impacts)>, JointImpact>) {
            const JointKernels& k = kernels().joints;
            const JointKernels::ForRows* const rows[] = {&k.point, &k.turn, &k.axis};
            rows[std::size_t(type)]->strike(blocks, impacts, count, velocity, 1 / h);
        } else {
            const SolverKernels& k = kernels().solver;
            (type == four_points_type ? k.four_points : k.one_point).strike(blocks, impacts, count, velocity, 1 / h);
        }
    });
}

void strike_all(BatchScratch& scratch, ThreadPool* thread_pool, float h) {
    for (const StruckRun& run : scratch.impact.runs)
        for_chunks(thread_pool, int(run.count), blocks_per_chunk(thread_pool, int(run.count)),
                   [&](int begin, int end, int) {
                       strike_run(scratch, run.type, run.first + std::size_t(begin), end - begin, h);
                   });
}

// Lanes of groups that have settled take part no longer.
void retire_lanes(BatchScratch& scratch) {
    const std::vector<ImpactWork::Group>& groups = scratch.impact.groups;
    for_types(scratch, [&](auto&, auto& struck) {
        for (std::size_t k = 0; k < struck.impacts.size(); ++k)
            for (unsigned left = struck.impacts[k].active; left != 0; left &= left - 1) {
                const unsigned i = unsigned(std::countr_zero(left));
                if (!groups[struck.lanes[8 * k + i].group].is_settled) continue;
                struck.impacts[k].active = std::uint8_t(struck.impacts[k].active & ~(1u << i));
            }
    });
}

// Groups that have settled leave. Whether any is left.
bool settle_groups(BatchScratch& scratch) {
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
void add_to_references(BatchScratch& scratch) {
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

template <class Block> void take_totals(Block& to, std::size_t lane, const Block& from, std::size_t from_lane) {
    if constexpr (requires { to.total; }) {
        take_lane(to.total, lane, from.total, from_lane);
    } else {
        take_lane(to.total_impulse, lane, from.total_impulse, from_lane);
        take_lane(to.total_tangent, lane, from.total_tangent, from_lane);
    }
}

void take_all_totals(BatchScratch& scratch) {
    for_types(scratch, [](auto& blocks, auto& struck) {
        for (std::size_t i = 0; i < struck.lanes.size(); ++i) {
            const std::size_t source = struck.lanes[i].source;
            if (struck.lanes[i].group != none) take_totals(blocks[source / 8], source % 8, struck.blocks[i / 8], i % 8);
        }
    });
}

} // namespace

void solve_impacts(const Bodies& bodies, const Joints& joints, BatchScratch& scratch, ThreadPool* thread_pool, float h,
                   std::atomic<int>& struck_contacts) {
    if (struck_contacts == 0) return;
    struck_contacts = 0;
    begin_impact(bodies, joints, scratch, h);
    for (int pass = 0; pass < max_passes; ++pass) {
        strike_all(scratch, thread_pool, h);
        if (!settle_groups(scratch)) break;
    }
    add_to_references(scratch);
    take_all_totals(scratch);
}

} // namespace cairn
