// Lists of the members of the blocks in solver_data.h and joint_data.h, for code that iterates over all of them. Not
// for kernel translation units, which share no functions.
#pragma once

#include "core/fields.h"
#include "kernels/solve/joint_data.h"
#include "kernels/solve/solver_data.h"

#include <tuple>

namespace cairn {

// `list`: pointers to the members of a block, without those of its base, which has a list of its own.
template <class Block> struct BlockFields;

#define CAIRN_BLOCK_IS_LISTED(bases, ...)                                                                              \
    static_assert(lists_fields<__VA_ARGS__>(BlockFields<__VA_ARGS__>::list, bases),                                    \
                  "the block has a member that its BlockFields do not name: add it there")

template <> struct BlockFields<JointEnds> {
    using B = JointEnds;
    static constexpr auto list = std::tuple(&B::a, &B::b, &B::mass_a, &B::mass_b, &B::isotropic_a, &B::isotropic_b);
};
CAIRN_BLOCK_IS_LISTED(0, JointEnds);

template <> struct BlockFields<JointEndsRest> {
    using B = JointEndsRest;
    static constexpr auto list = std::tuple(&B::write_a, &B::write_b, &B::inertia_a, &B::inertia_b);
};
CAIRN_BLOCK_IS_LISTED(0, JointEndsRest);

template <> struct BlockFields<PointBlock> {
    using B = PointBlock;
    using Base = JointEnds;
    static constexpr auto list =
        std::tuple(&B::arm_a, &B::arm_b, &B::gap, &B::impulse, &B::response, &B::left_a, &B::left_b, &B::free_axis,
                   &B::isotropic, &B::redirects, &B::leaves, &B::has_turn, &B::by_turn, &B::arm_a0, &B::arm_b0,
                   &B::gap0, &B::total, &B::rest, &B::left_linear, &B::axis0, &B::turn_axis0);
};
CAIRN_BLOCK_IS_LISTED(1, PointBlock);

template <> struct BlockFields<TurnBlock> {
    using B = TurnBlock;
    using Base = JointEnds;
    static constexpr auto list =
        std::tuple(&B::error, &B::response, &B::impulse, &B::left_a, &B::left_b, &B::turn0, &B::axis_a0, &B::axis_b0,
                   &B::total, &B::free_axis, &B::isotropic, &B::redirects, &B::leaves, &B::rest);
};
CAIRN_BLOCK_IS_LISTED(1, TurnBlock);

template <> struct BlockFields<AxisBlock> {
    using B = AxisBlock;
    using Base = JointEnds;
    static constexpr auto list = std::tuple(
        &B::linear_a, &B::linear_b, &B::angular_a, &B::angular_b, &B::left, &B::mass, &B::moved_mass, &B::position,
        &B::before, &B::lower, &B::upper, &B::equation, &B::rigid_limit, &B::limit_stiffness, &B::limit_damping,
        &B::limit_relative, &B::lower_impulse, &B::upper_impulse, &B::drive_stiffness, &B::drive_damping,
        &B::target_position, &B::target_velocity, &B::rigid_drive, &B::drive_relative, &B::max_drive, &B::drive_impulse,
        &B::drive_pull, &B::max_friction, &B::friction_impulse, &B::total, &B::arm_a0, &B::arm_b0, &B::gap0, &B::turn0,
        &B::axis_a0, &B::axis_b0, &B::ratio_a, &B::ratio_b, &B::position0, &B::point_axis0, &B::turn_axis0, &B::points,
        &B::turns, &B::plain_locks, &B::direct, &B::kind, &B::isotropic, &B::redirects, &B::leaves, &B::has_limits,
        &B::has_soft_limits, &B::has_drive, &B::has_friction, &B::rest);
};
CAIRN_BLOCK_IS_LISTED(1, AxisBlock);

template <int N> struct BlockFields<PointRows<N>> {
    using B = PointRows<N>;
    static constexpr auto list =
        std::tuple(&B::separation0, &B::height, &B::square_lever, &B::total_impulse, &B::slip_rate_slope, &B::arm,
                   &B::share, &B::effective_mass, &B::impulse, &B::separation);
};
CAIRN_BLOCK_IS_LISTED(0, PointRows<4>);

template <> struct BlockFields<PointRows<1>> {
    using B = PointRows<1>;
    static constexpr auto list =
        std::tuple(&B::rim_axis, &B::rim_middle, &B::rim_radius, &B::face_arm, &B::rim_lead, &B::rim_moment,
                   &B::separation0, &B::total_impulse, &B::effective_mass, &B::impulse, &B::separation);
};
CAIRN_BLOCK_IS_LISTED(0, PointRows<1>);

template <int N> struct BlockFields<ContactBlock<N>> {
    using B = ContactBlock<N>;
    using Base = PointRows<N>;
    static constexpr auto list =
        std::tuple(&B::a, &B::b, &B::write_b, &B::center, &B::normal, &B::d, &B::mass_a, &B::mass_b, &B::inertia_a,
                   &B::inertia_b, &B::moved_moment, &B::moved, &B::isotropic, &B::rolls, &B::bounces, &B::round,
                   &B::moving_points, &B::rims_a, &B::rims_b, &B::round_pairs, &B::axes_a, &B::axes_b, &B::round_arms,
                   &B::round_pairs_moved, &B::joined, &B::in_impact, &B::in_impact_once, &B::in_impact_twice, &B::d0,
                   &B::d_touch, &B::found, &B::radius_a, &B::radius_b, &B::max_offset_change_square, &B::slip_rate,
                   &B::departure, &B::tangent, &B::tangent_mass, &B::torsion_mass, &B::torsion_coupling, &B::friction,
                   &B::static_friction, &B::torsion_radius, &B::tangent_impulse, &B::torsion_impulse, &B::total_tangent,
                   &B::rolling_radius, &B::rolling_impulse, &B::restitution);
};
CAIRN_BLOCK_IS_LISTED(1, ContactBlock<1>);
CAIRN_BLOCK_IS_LISTED(1, ContactBlock<4>);

#undef CAIRN_BLOCK_IS_LISTED

} // namespace cairn
