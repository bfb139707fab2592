// Turns: B's frame is kept from rotating relative to A's, about all axes or about those perpendicular to one. With p
// the angular impulse on B, c = w_B - w_A and K = I_A^-1 + I_B^-1.
#include "kernels/solve/joint.h"

namespace cairn::CAIRN_ISA {

namespace {

CAIRN_INLINE void apply(const TurnBlock& b, Vec3x8 p, Ends8& e) {
    e.a.w = e.a.w - turned_a(b, p);
    e.b.w = e.b.w + turned_b(b, p);
}

// Computes error and response at the current poses; returns the free axis, or zero.
template <bool FreeAxis> CAIRN_INLINE Vec3x8 refresh(TurnBlock& b, const Posesx8& poses, const Massesx8& masses) {
    const Sym3x8 &i = masses.inertia_a, &j = masses.inertia_b;
    const Sym3x8 k = {i.xx + j.xx, i.xy + j.xy, i.xz + j.xz, i.yy + j.yy, i.yz + j.yz, i.zz + j.zz};
    if constexpr (FreeAxis) {
        const Vec3x8 a0 = load3(b.axis_a0), b0 = load3(b.axis_b0);
        const Vec3x8 axis = a0 + turned_difference(poses.dq_a, a0), held = b0 + turned_difference(poses.dq_b, b0);
        store3(b.error, cross(axis, held));
        store6(b.response, inverse_across(k, axis));
        return axis;
    } else {
        const Quatx8 turn = turn_now(poses, load_quat(b.turn0));
        store3(b.error, select(turn.w < zero(), splat(-2.0f), splat(2.0f)) * turn.v);
        store6(b.response, inverse(k));
        return zero3();
    }
}

template <bool FreeAxis> void begin_block(TurnBlock& b, const SolverBodies& bodies) {
    const Massesx8 masses = first_masses(b, bodies.inertia);
    const Vec3x8 axis = refresh<FreeAxis>(b, gather_poses(bodies.pose, b), masses);
    if constexpr (FreeAxis) store3(b.impulse, across(axis, load3(b.impulse)));
    b.leaves = 0;
    store3(b.total, zero3());
}

void warm_start(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness&) {
    for_lanes<TurnBlock>(run, [&](TurnBlock& b, auto lanes) {
        if (lanes.is_solved_first) b.free_axis ? begin_block<true>(b, bodies) : begin_block<false>(b, bodies);
        Ends8 e = gather_ends(bodies.velocity, b);
        apply(b, among(lanes, load3(b.impulse), zero3()), e);
        scatter_ends(bodies.velocity, lanes, e);
    });
}

void solve(const JointBlocks& run, SolverVelocity* velocity, const JointSoftness& softness) {
    const f32x8 rate = splat(softness.rate), scale = splat(softness.scale), rest = splat(1 - softness.scale);
    for_lanes<TurnBlock>(run, [&](TurnBlock& b, auto lanes) {
        Ends8 e = gather_ends(velocity, b);
        if (b.leaves) {
            e.a.w = e.a.w + load3(b.left_a);
            e.b.w = e.b.w + load3(b.left_b);
        }
        const Vec3x8 p = load3(b.impulse), c = (e.b.w - e.a.w) + rate * load3(b.error);
        const Vec3x8 d = -(scale * (load6(b.response) * c)) - rest * p;
        store3(b.impulse, among(lanes, p + d, p));
        apply(b, d, e);
        scatter_ends(velocity, lanes, e);
    });
}

// Applies the rigid impulse that stops the relative rotation.
template <class Lanes> CAIRN_INLINE void stop_turn(TurnBlock& b, Lanes lanes, const SolverBodies& bodies) {
    const Vec3x8 carried = load3(b.impulse), total = load3(b.total);
    Ends8 e = gather_ends(bodies.velocity, b);
    const Vec3x8 d = -(load6(b.response) * (e.b.w - e.a.w)), p = carried + d;
    store3(b.impulse, among(lanes, p, carried));
    store3(b.total, among(lanes, total + p, total));
    apply(b, d, e);
    scatter_ends(bodies.velocity, lanes, e);
}

template <bool FreeAxis> void follow_poses(TurnBlock& b, const SolverBodies& bodies) {
    const Posesx8 poses = gather_poses(bodies.pose, b);
    const Vec3x8 old = load3(b.impulse);
    const Vec3x8 wa = turned_a(b, old), wb = -turned_b(b, old);
    if (!b.isotropic) renew_masses(b, bodies.inertia);
    const Vec3x8 axis = refresh<FreeAxis>(b, poses, load_masses(b));
    Vec3x8 p = old;
    if constexpr (FreeAxis) p = across(axis, old);
    if (FreeAxis || !b.isotropic) {
        store3(b.left_a, wa - turned_a(b, p));
        store3(b.left_b, wb + turned_b(b, p));
        b.leaves = 1;
    }
    if constexpr (FreeAxis) store3(b.impulse, p);
}

void relax(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness&) {
    for_lanes<TurnBlock>(run, [&](TurnBlock& b, auto lanes) {
        if (lanes.is_solved_first) b.free_axis ? follow_poses<true>(b, bodies) : follow_poses<false>(b, bodies);
        stop_turn(b, lanes, bodies);
    });
}

void impact_pass(void* blocks, JointImpact* impacts, int count, SolverVelocity* velocity, float) {
    auto* all = static_cast<TurnBlock*>(blocks);
    for (int k = 0; k < count; ++k) {
        if (!impacts[k].active) continue;
        TurnBlock& b = all[k];
        Ends8 e = gather_ends(velocity, b);
        const Vec3x8 p = splat(-impact_relaxation) * (load6(b.response) * (e.b.w - e.a.w));
        const Vec3x8 d = select(mask_from_bits(impacts[k].active), p, zero3());
        store3(b.total, load3(b.total) + d);
        apply(b, d, e);
        scatter_ends(velocity, all_of(b), e);
    }
}

} // namespace

JointKernels::ForRows turn_kernels() { return {warm_start, solve, relax, impact_pass}; }

} // namespace cairn::CAIRN_ISA
