// Points: the anchors of two bodies are kept together, in all directions or perpendicular to an axis of A. With p the
// impulse on B, c = (v_B + w_B x r_B) - (v_A + w_A x r_A) and
// K = (1/m_A + 1/m_B) 1 - [r_A] I_A^-1 [r_A] - [r_B] I_B^-1 [r_B]. If an axis is free, r_A extends to the anchor of B
// along it, and only the components of c and p perpendicular to it count. If the joint has a turn, p acts together with
// the angular impulse that keeps the relative angular velocity unchanged (joint_locks.h): the moments are r x p - D^T
// p.
#include "kernels/solve/joint_locks.h"

#include <type_traits>

namespace cairn::CAIRN_ISA {

namespace {

template <bool Isotropic> CAIRN_INLINE Vec3x8 times_inertia_a(const PointBlock& b, Vec3x8 u) {
    return Isotropic ? load(b.isotropic_a) * u : load6(b.rest.inertia_a) * u;
}
template <bool Isotropic> CAIRN_INLINE Vec3x8 times_inertia_b(const PointBlock& b, Vec3x8 u) {
    return Isotropic ? load(b.isotropic_b) * u : load6(b.rest.inertia_b) * u;
}
// The moment of an impulse p at that arm.
template <bool Turns> CAIRN_INLINE Vec3x8 moment_of(const PointBlock& b, Vec3x8 arm, Vec3x8 p) {
    if constexpr (Turns) return cross(arm, p) - transposed_times(load9(b.by_turn), p);
    return cross(arm, p);
}
template <bool Isotropic, bool Turns>
CAIRN_INLINE void apply(const PointBlock& b, Vec3x8 arm_a, Vec3x8 arm_b, Vec3x8 p, Ends8& e) {
    e.a.v = e.a.v - load(b.mass_a) * p;
    e.b.v = e.b.v + load(b.mass_b) * p;
    e.a.w = e.a.w - times_inertia_a<Isotropic>(b, moment_of<Turns>(b, arm_a, p));
    e.b.w = e.b.w + times_inertia_b<Isotropic>(b, moment_of<Turns>(b, arm_b, p));
}
CAIRN_INLINE Vec3x8 slip_at(const Ends8& e, Vec3x8 arm_a, Vec3x8 arm_b) {
    return (e.b.v - e.a.v) + (cross(e.b.w, arm_b) - cross(e.a.w, arm_a));
}

// The geometry of a block at the current poses: arms, gap, the free axis, and the axis about which the joint is free to
// rotate.
struct Pointx8 {
    Vec3x8 arm_a, arm_b, gap, axis, turn_axis;
};
template <bool FreeAxis> CAIRN_INLINE void reach_along_axis(Pointx8& point) {
    if constexpr (FreeAxis) {
        const Vec3x8 along = dot(point.axis, point.gap) * point.axis;
        point.arm_a = point.arm_a + along;
        point.gap = point.gap - along;
    }
}
template <bool FreeAxis, bool Turns> CAIRN_INLINE Pointx8 point_at_start(const PointBlock& b) {
    Pointx8 point{load3(b.arm_a0), load3(b.arm_b0), load3(b.gap0), FreeAxis ? load3(b.axis0) : zero3(),
                  Turns ? load3(b.turn_axis0) : zero3()};
    reach_along_axis<FreeAxis>(point);
    return point;
}
template <bool FreeAxis, bool Turns> CAIRN_INLINE Pointx8 point_now(const PointBlock& b, const Posesx8& poses) {
    const Vec3x8 arm_a0 = load3(b.arm_a0), arm_b0 = load3(b.arm_b0);
    const Vec3x8 change_a = turned_difference(poses.dq_a, arm_a0), change_b = turned_difference(poses.dq_b, arm_b0);
    Pointx8 point{arm_a0 + change_a, arm_b0 + change_b,
                  load3(b.gap0) + ((poses.dx_b - poses.dx_a) + (change_b - change_a)), zero3(), zero3()};
    if constexpr (FreeAxis) {
        const Vec3x8 axis0 = load3(b.axis0);
        point.axis = axis0 + turned_difference(poses.dq_a, axis0);
    }
    if constexpr (Turns) {
        const Vec3x8 axis0 = load3(b.turn_axis0);
        point.turn_axis = axis0 + turned_difference(poses.dq_a, axis0);
    }
    reach_along_axis<FreeAxis>(point);
    return point;
}

template <bool FreeAxis, bool Isotropic> CAIRN_INLINE Sym3x8 response_of(const PointBlock& b, const Pointx8& point) {
    Sym3x8 k;
    if constexpr (Isotropic) {
        const f32x8 m = load(b.mass_a) + load(b.mass_b);
        k = sum({m, zero(), zero(), m, zero(), m}, sum(even_squared_arm(load(b.isotropic_a), point.arm_a),
                                                       even_squared_arm(load(b.isotropic_b), point.arm_b)));
    } else {
        k = slip_by_push(load_masses(b), {point.arm_a, point.arm_b});
    }
    if constexpr (FreeAxis)
        return inverse_across(k, point.axis);
    else
        return inverse(k);
}
template <bool FreeAxis, bool Isotropic, bool Turns> CAIRN_INLINE void keep(PointBlock& b, const Pointx8& point) {
    store3(b.arm_a, point.arm_a);
    store3(b.arm_b, point.arm_b);
    store3(b.gap, point.gap);
    if constexpr (Turns) {
        const Massesx8 masses = load_masses(b);
        const HeldTurn held = hold_turn(masses, {point.arm_a, point.arm_b}, response_of_turn(masses, point.turn_axis));
        store9(b.by_turn, held.d);
        store6(b.response, response_of(held, point.axis));
    } else {
        store6(b.response, response_of<FreeAxis, Isotropic>(b, point));
    }
}

// Calls f with a condition, as a constant.
template <class F> CAIRN_INLINE void as_constant(bool condition, F&& f) {
    condition ? f(std::true_type{}) : f(std::false_type{});
}
// Calls f with constants: whether an axis is free, whether tensors are isotropic, and whether the joint has a turn.
template <class F> CAIRN_INLINE void for_form(PointBlock& b, F&& f) {
    as_constant(b.free_axis != 0, [&](auto free_axis) {
        as_constant(b.isotropic != 0, [&](auto isotropic) {
            as_constant(b.has_turn != 0, [&](auto turns) { f(free_axis, isotropic, turns); });
        });
    });
}

// Prepares a block at the poses of the start of the step.
template <bool FreeAxis, bool Isotropic, bool Turns> void begin_block(PointBlock& b) {
    const Pointx8 point = point_at_start<FreeAxis, Turns>(b);
    keep<FreeAxis, Isotropic, Turns>(b, point);
    if constexpr (FreeAxis) store3(b.impulse, across(point.axis, load3(b.impulse)));
    b.leaves = 0;
    store3(b.total, zero3());
}

template <bool FreeAxis, bool Isotropic, bool Turns, class Lanes>
CAIRN_INLINE void warm_start_block(PointBlock& b, Lanes lanes, const SolverBodies& bodies) {
    if (lanes.is_solved_first) begin_block<FreeAxis, Isotropic, Turns>(b);
    Ends8 e = gather_ends(bodies.velocity, b);
    apply<Isotropic, Turns>(b, load3(b.arm_a), load3(b.arm_b), among(lanes, load3(b.impulse), zero3()), e);
    scatter_ends(bodies.velocity, lanes, e);
}

void warm_start(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness&) {
    for_lanes<PointBlock>(run, [&](PointBlock& b, auto lanes) {
        if (lanes.is_solved_first) first_masses(b, bodies.inertia);
        for_form(b, [&](auto free_axis, auto isotropic, auto turns) {
            warm_start_block<free_axis, isotropic, turns>(b, lanes, bodies);
        });
    });
}

template <bool FreeAxis, bool Isotropic, bool Turns, class Lanes>
CAIRN_INLINE void solve_block(PointBlock& b, Lanes lanes, SolverVelocity* velocity, f32x8 rate, f32x8 scale,
                              f32x8 rest) {
    Ends8 e = gather_ends(velocity, b);
    if (b.leaves) {
        e.a.w = e.a.w + load3(b.left_a);
        e.b.w = e.b.w + load3(b.left_b);
        if constexpr (FreeAxis) {
            e.a.v = e.a.v - load(b.mass_a) * load3(b.left_linear);
            e.b.v = e.b.v + load(b.mass_b) * load3(b.left_linear);
        }
    }
    const Vec3x8 arm_a = load3(b.arm_a), arm_b = load3(b.arm_b), p = load3(b.impulse);
    const Vec3x8 c = slip_at(e, arm_a, arm_b) + rate * load3(b.gap);
    const Vec3x8 d = -(scale * (load6(b.response) * c)) - rest * p;
    store3(b.impulse, among(lanes, p + d, p));
    apply<Isotropic, Turns>(b, arm_a, arm_b, d, e);
    scatter_ends(velocity, lanes, e);
}

void solve(const JointBlocks& run, SolverVelocity* velocity, const JointSoftness& softness) {
    const f32x8 rate = splat(softness.rate), scale = splat(softness.scale), rest = splat(1 - softness.scale);
    for_lanes<PointBlock>(run, [&](PointBlock& b, auto lanes) {
        for_form(b, [&](auto free_axis, auto isotropic, auto turns) {
            solve_block<free_axis, isotropic, turns>(b, lanes, velocity, rate, scale, rest);
        });
    });
}

// The change of a torque's effect is that due to the change of the torque plus that due to the change of the inertia.
// For isotropic bodies the latter is exactly zero, whether all bodies of the block are isotropic or not.
template <bool Isotropic>
CAIRN_INLINE void leave_change_of_arms(PointBlock& b, Vec3x8 change_a, Vec3x8 change_b, Vec3x8 torque_a,
                                       Vec3x8 torque_b, const SolverInertia* inertia) {
    if constexpr (Isotropic) {
        store3(b.left_a, times_inertia_a<true>(b, change_a));
        store3(b.left_b, times_inertia_b<true>(b, change_b));
    } else {
        const Sym3x8 old_a = load6(b.rest.inertia_a), old_b = load6(b.rest.inertia_b);
        const Massesx8 now = renew_masses(b, inertia);
        store3(b.left_a, now.inertia_a * change_a + difference(old_a, now.inertia_a) * torque_a);
        store3(b.left_b, now.inertia_b * change_b + difference(now.inertia_b, old_b) * torque_b);
    }
}

// Updates the block to the new poses. The change of the carried-over impulse's effect by the new arms, axis and D is
// left for the next solve; `p` is the part of the impulse `old` that is carried on.
template <bool FreeAxis, bool Isotropic, bool Turns>
CAIRN_INLINE void follow_point(PointBlock& b, const Pointx8& point, Vec3x8 p, Vec3x8 old,
                               const SolverInertia* inertia) {
    const Vec3x8 old_a = load3(b.arm_a), old_b = load3(b.arm_b);
    b.leaves = 1;
    if constexpr (!FreeAxis && !Turns) {
        leave_change_of_arms<Isotropic>(b, cross(old_a - point.arm_a, p), cross(point.arm_b - old_b, p),
                                        cross(old_a, p), cross(old_b, p), inertia);
        keep<FreeAxis, Isotropic, Turns>(b, point);
    } else {
        const Vec3x8 before_a = times_inertia_a<Isotropic>(b, moment_of<Turns>(b, old_a, old)),
                     before_b = times_inertia_b<Isotropic>(b, moment_of<Turns>(b, old_b, old));
        if constexpr (!Isotropic) renew_masses(b, inertia);
        keep<FreeAxis, Isotropic, Turns>(b, point);
        store3(b.left_a, before_a - times_inertia_a<Isotropic>(b, moment_of<Turns>(b, point.arm_a, p)));
        store3(b.left_b, times_inertia_b<Isotropic>(b, moment_of<Turns>(b, point.arm_b, p)) - before_b);
        if constexpr (FreeAxis) store3(b.left_linear, p - old);
    }
}

// Applies the rigid impulse that stops the relative velocity at the point.
template <bool Isotropic, bool Turns, class Lanes>
CAIRN_INLINE void stop_slip(PointBlock& b, Lanes lanes, const SolverBodies& bodies) {
    const Vec3x8 arm_a = load3(b.arm_a), arm_b = load3(b.arm_b), carried = load3(b.impulse), total = load3(b.total);
    Ends8 e = gather_ends(bodies.velocity, b);
    const Vec3x8 d = -(load6(b.response) * slip_at(e, arm_a, arm_b)), p = carried + d;
    store3(b.impulse, among(lanes, p, carried));
    store3(b.total, among(lanes, total + p, total));
    apply<Isotropic, Turns>(b, arm_a, arm_b, d, e);
    scatter_ends(bodies.velocity, lanes, e);
}

template <bool FreeAxis, bool Isotropic, bool Turns> void follow_poses(PointBlock& b, const SolverBodies& bodies) {
    const Posesx8 poses = gather_poses(bodies.pose, b);
    const Pointx8 point = point_now<FreeAxis, Turns>(b, poses);
    const Vec3x8 old = load3(b.impulse), carried = FreeAxis ? across(point.axis, old) : old;
    follow_point<FreeAxis, Isotropic, Turns>(b, point, carried, old, bodies.inertia);
    if constexpr (FreeAxis) store3(b.impulse, carried);
}

void relax(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness&) {
    for_lanes<PointBlock>(run, [&](PointBlock& b, auto lanes) {
        for_form(b, [&](auto free_axis, auto isotropic, auto turns) {
            if (lanes.is_solved_first) follow_poses<free_axis, isotropic, turns>(b, bodies);
            stop_slip<isotropic, turns>(b, lanes, bodies);
        });
    });
}

void impact_pass(void* blocks, JointImpact* impacts, int count, SolverVelocity* velocity, float) {
    auto* all = static_cast<PointBlock*>(blocks);
    for (int k = 0; k < count; ++k) {
        if (!impacts[k].active) continue;
        PointBlock& b = all[k];
        const Vec3x8 arm_a = load3(b.arm_a), arm_b = load3(b.arm_b);
        Ends8 e = gather_ends(velocity, b);
        for_form(b, [&](auto, auto isotropic, auto turns) {
            Vec3x8 slip = slip_at(e, arm_a, arm_b);
            if constexpr (turns) slip = slip - load9(b.by_turn) * (e.b.w - e.a.w); // what remains when the turn stops
            const Vec3x8 p = splat(-impact_relaxation) * (load6(b.response) * slip);
            const Vec3x8 d = select(mask_from_bits(impacts[k].active), p, zero3());
            store3(b.total, load3(b.total) + d);
            apply<isotropic, turns>(b, arm_a, arm_b, d, e);
        });
        scatter_ends(velocity, all_of(b), e);
    }
}

} // namespace

JointKernels::ForRows point_kernels() { return {warm_start, solve, relax, impact_pass}; }

JointKernels joint_kernels() { return {point_kernels(), turn_kernels(), axis_kernels()}; }

} // namespace cairn::CAIRN_ISA
