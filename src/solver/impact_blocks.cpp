#include "solver/impact_blocks.h"

#include "kernels/kernels.h"
#include "kernels/solve/block_fields.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace cairn {

namespace {

// Block-wide options by which lanes may share a block. All other block-wide members are the same in the whole run.
std::uint8_t form_of(const PointBlock& b) { return std::uint8_t(b.isotropic | b.has_turn << 1); }
std::uint8_t form_of(const TurnBlock& b) { return b.isotropic; }
std::uint8_t form_of(const AxisBlock& b) {
    return std::uint8_t(b.isotropic | b.has_limits << 1 | int(b.points != 0) << 2);
}
template <int N> std::uint8_t form_of(const ContactBlock<N>& b) { return b.isotropic; }

// Redirects writes for a body that forces do not move from the source block's discard row to that of the copy.
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

// Members of a block that `impact_pass` does not read, and that are therefore not copied. New members are copied unless
// listed here.
template <class Block> struct NotInImpact { static constexpr std::tuple<> list{}; };
template <> struct NotInImpact<PointBlock> {
    using B = PointBlock;
    static constexpr auto list = std::tuple(&B::gap, &B::impulse, &B::left_a, &B::left_b, &B::arm_a0, &B::arm_b0,
                                            &B::gap0, &B::left_linear, &B::axis0, &B::turn_axis0);
};
template <> struct NotInImpact<TurnBlock> {
    using B = TurnBlock;
    static constexpr auto list =
        std::tuple(&B::error, &B::impulse, &B::left_a, &B::left_b, &B::turn0, &B::axis_a0, &B::axis_b0);
};
template <> struct NotInImpact<AxisBlock> { // springs in limits, drives and friction give no impulses
    using B = AxisBlock;
    static constexpr auto list =
        std::tuple(&B::left, &B::before, &B::limit_stiffness, &B::limit_damping, &B::limit_relative, &B::lower_impulse,
                   &B::upper_impulse, &B::drive_stiffness, &B::drive_damping, &B::target_position, &B::target_velocity,
                   &B::rigid_drive, &B::drive_relative, &B::max_drive, &B::drive_impulse, &B::drive_pull,
                   &B::max_friction, &B::friction_impulse, &B::arm_a0, &B::arm_b0, &B::gap0, &B::turn0, &B::axis_a0,
                   &B::axis_b0, &B::ratio_a, &B::ratio_b, &B::position0, &B::moved_mass, &B::point_axis0,
                   &B::turn_axis0, &B::turns, &B::plain_locks, &B::direct);
};
template <int N> struct NotInImpact<PointRows<N>> {
    using B = PointRows<N>;
    static constexpr auto list =
        std::tuple(&B::separation0, &B::height, &B::square_lever, &B::total_impulse, &B::slip_rate_slope);
};
template <> struct NotInImpact<PointRows<1>> {
    using B = PointRows<1>;
    static constexpr auto list = std::tuple(&B::rim_axis, &B::rim_middle, &B::rim_radius, &B::face_arm, &B::rim_lead,
                                            &B::rim_moment, &B::separation0, &B::total_impulse);
};
template <int N> struct NotInImpact<ContactBlock<N>> { // only friction at the friction center acts
    using B = ContactBlock<N>;
    static constexpr auto list = std::tuple(
        &B::moved_moment, &B::d0, &B::found, &B::radius_a, &B::radius_b, &B::max_offset_change_square, &B::slip_rate,
        &B::departure, &B::torsion_mass, &B::torsion_coupling, &B::static_friction, &B::torsion_radius,
        &B::tangent_impulse, &B::torsion_impulse, &B::total_tangent, &B::rolling_radius, &B::rolling_impulse);
};

// Copies one lane of an array, or of an array of arrays.
template <class T> void take_lane(T (&to)[8], std::size_t lane, const T (&from)[8], std::size_t from_lane) {
    to[lane] = from[from_lane];
}
template <class Rows, std::size_t N>
requires std::is_array_v<Rows>
void take_lane(Rows (&to)[N], std::size_t lane, const Rows (&from)[N], std::size_t from_lane) {
    for (std::size_t i = 0; i < N; ++i) take_lane(to[i], lane, from[i], from_lane);
}

// Copies the members of a lane that `impact_pass` reads. Members that the whole block shares are not copied, see
// form_of.
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
                if constexpr (!has_field(NotInImpact<Block>::list, member)) copy(member);
            }(),
            ...);
    }
    (std::make_index_sequence<count>{});
}

// Copies listed lanes of one run of the batch's blocks, sorted by form and group. The copy never has more blocks than
// the batch, so each of its blocks can use a discard row of the batch.
template <class Block, class Impact>
void copy_run(BatchScratch& scratch, const ImpactWork::ListedRun& run, const std::vector<Block>& from,
              ImpactBlocks<Block, Impact>& to, std::int32_t first_discard_row) {
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
            to.lanes.insert(to.lanes.end(), 8, {0, none, true});
            empty_lanes(to.blocks.back(), discard);
            used = 0;
        }
        copy_lane(to.blocks.back(), used, block, lane->source % 8);
        redirect(to.blocks.back(), used, first_discard, discard);
        to.lanes[8 * (to.blocks.size() - 1) + used] = {lane->source, lane->group, true};
        to.impacts.back().active = std::uint8_t(to.impacts.back().active | 1u << used);
    }
    const auto place = std::uint32_t(&run - work.listed_runs.data());
    work.runs.push_back({run.type, place, std::uint32_t(first), std::uint32_t(to.blocks.size() - first)});
}

// Adds the impulses that an impact gave to a contact or joint to its totals over the step.
template <class Block>
void add_total(Block& to, std::size_t lane, const Block& from, const JointImpact&, std::size_t from_lane) {
    take_lane(to.total, lane, from.total, from_lane);
}
template <int N>
void add_total(ContactBlock<N>& to, std::size_t lane, const ContactBlock<N>&, const ContactImpact<N>& impact,
               std::size_t from_lane) {
    for (int i = 0; i < N; ++i) to.total_impulse[i][lane] += impact.impulse[i][from_lane];
    for (int i = 0; i < 2; ++i) to.total_tangent[i][lane] += impact.tangent[i][from_lane];
}

} // namespace

void copy_listed(BatchScratch& scratch) {
    for_types(scratch, [](auto&, auto& in_impact) { in_impact.clear(); });
    scratch.impact.runs.clear();
    const std::int32_t ones = scratch.first_discard_row(),
                       fours = ones + std::int32_t(scratch.one_lanes.record.size() / 8);
    const auto joints = scratch.first_joint_discard_rows();
    const std::int32_t discards[] = {joints[0], joints[1], joints[2], ones, fours};
    for (const ImpactWork::ListedRun& run : scratch.impact.listed_runs) {
        if (run.begin == run.end) continue;
        const std::int32_t discard = discards[std::size_t(run.type)];
        with_type(scratch, run.type, [&](auto& from, auto& to) { copy_run(scratch, run, from, to, discard); });
    }
    const auto renew = [&](const SolverKernels::ForPoints& k, auto& in_impact) {
        k.renew_masses(in_impact.blocks.data(), nullptr, int(in_impact.blocks.size()), scratch.inertia.data());
    };
    renew(kernels().solver.one_point, std::get<one_point_type>(scratch.impact.blocks));
    renew(kernels().solver.four_points, std::get<four_points_type>(scratch.impact.blocks));
}

void add_totals(BatchScratch& scratch) {
    for_types(scratch, [](auto& blocks, auto& in_impact) {
        for (std::size_t i = 0; i < in_impact.lanes.size(); ++i) {
            const std::size_t source = in_impact.lanes[i].source;
            if (in_impact.lanes[i].group != none && in_impact.lanes[i].is_own)
                add_total(blocks[source / 8], source % 8, in_impact.blocks[i / 8], in_impact.impacts[i / 8], i % 8);
        }
    });
}

} // namespace cairn
