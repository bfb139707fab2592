// Separations of contact blocks at the poses of a substep, and how the offset between the centers of mass follows the
// bodies as they pass each other.
#pragma once

#include "kernels/solve/rounds.h"

namespace cairn::CAIRN_ISA {

// The smallest change of d that is followed, as a fraction of the greatest (the square root of
// max_offset_change_square).
inline constexpr float min_offset_change = 2.5e-6f;

// Updates d to the current poses, so that impulses act on both bodies at one point of the world and angular momentum is
// conserved while the bodies pass each other. The impulses that are carried into the next substep acted with the old d;
// the moment on B that they lack since is applied by the next `solve`. Lanes whose bodies have not moved are left
// unchanged: the result of a lane must not depend on the other contacts of its block.
template <int N, class Among>
CAIRN_INLINE void refresh_arm(ContactBlock<N>& block, Vec3x8 normal, Vec3x8 passed, Among&& among) {
    const Vec3x8 fitting = load3(block.d_touch), old = load3(block.d);
    const f32x8 limit = load(block.max_offset_change_square);
    Vec3x8 d = load3(block.d0) + passed, change = d - old;
    mask8 moves = among(dot(change, change) > splat(min_offset_change * min_offset_change) * limit);
    if (has_round_pairs(block)) moves = and_not(moves, mask_from_bits(block.round_pairs));
    if (!any(moves)) return;
    // The couplings K are those of d_touch: d is followed only as far from it as they still hold.
    const Vec3x8 beyond = d - fitting;
    const f32x8 square = dot(beyond, beyond);
    const mask8 far = square > limit;
    if (any(far)) {
        d = select(far, fitting + sqrt(limit / select(far, square, one())) * beyond, d);
        change = d - old;
    }
    store3(block.d, select(moves, d, old));
    f32x8 carried = zero();
    for (int i = 0; i < N; ++i) carried += load(block.impulse[i]);
    const f32x8 p1 = load(block.tangent_impulse[0]), p2 = load(block.tangent_impulse[1]);
    if (all((carried == zero()) & (p1 == zero()) & (p2 == zero()))) return;
    const Vec3x8 p = p1 * load3(block.tangent) + p2 * second_tangent(block, normal);
    const Vec3x8 moment = select(moves, cross(change, carried * normal + p), zero3());
    store3(block.moved_moment, block.moved ? load3(block.moved_moment) + moment : moment);
    block.moved = 1;
}

// Current separations, from the motion of both bodies since the start of the step. Exact: the normal, not the anchors,
// is rotated back, and by differences so that no digits cancel: with
//   delta(q) = R(q)^T n - n = 2 (q x (q x n) - q_w (q x n)) and D = delta(qB) - delta(qA),
//   s_i = s0_i + n.(dxB - dxA) + delta(qB).d + (r_i.n)(D.n) + j_i.(D x n), with d = d_touch, as for the couplings.
// This is for arms at the start of the step. The arms of a contact that was found at the time f have since rotated by
// the rotation u(t) of the step minus that up to f. Its second-order part,
//   u x (u x r) / 2 - (u_f x (u x r) + u x (u_f x r)) / 2,
// is, with u_f = u(t) f / t, that of delta times 1 - 2 f / t (`bend`). The rotation need not be uniform: at the start
// of the step and at f the result is exact. The surface of a sphere does not rotate with its body: only its center, a
// radius R from the contact point, is a point of the body. Rotating the material point would lift it by R (1 - cos),
// and a rolling ball would lose its load; R (delta.n) per sphere removes that.
template <int N>
CAIRN_INLINE void refresh_separations(ContactBlock<N>& block, const SolverPose* pose, Vec3x8 normal,
                                      float inverse_elapsed, f32x8* s, RoundTouch& round) {
    const Posex8 a = gather_pose(pose, block.a), b = gather_pose(pose, block.b);
    f32x8 on_rounds = zero();
    if constexpr (N == 1)
        if (has_round_pairs(block)) {
            round = round_touch_at(block, a, b, a.dx - b.dx, normal);
            s[0] = on_rounds = load(block.separation0[0]) + round.grown;
            if (is_all_round(block)) return store(block.separation[0], s[0]);
        }
    const f32x8 bend = one() - splat(2 * inverse_elapsed) * load(block.found);
    const Vec3x8 delta_a = turned_back_difference(a.dq, normal, bend),
                 delta_b = turned_back_difference(b.dq, normal, bend);
    const Vec3x8 difference = delta_b - delta_a, passed = a.dx - b.dx;
    f32x8 common = -dot(normal, passed);
    if (block.moving_points) {
        const float elapsed = 1 / inverse_elapsed;
        common += splat(elapsed * elapsed) * bend * load(block.departure);
    }
    f32x8 on_rims = zero();
    if constexpr (N == 1)
        if (has_rims(block)) on_rims = rim_separations(block, normal, a.dq, b.dq, delta_a, delta_b, common);
    common += dot(delta_b, load3(block.d_touch));
    if (N == 1 || block.round)
        common += load(block.radius_a) * dot(delta_a, normal) + load(block.radius_b) * dot(delta_b, normal);
    const Vec3x8 e = cross(difference, normal);
    const f32x8 f = dot(difference, normal);
    for (int i = 0; i < N; ++i) {
        f32x8 height;
        if constexpr (N == 1)
            height = dot(load3(block.center), normal);
        else
            height = load(block.height[i]);
        s[i] = load(block.separation0[i]) + (common + (height * f + dot(arm_of(block, normal, i), e)));
        if (has_rims(block)) s[i] = select(mask_from_bits(block.rims_a | block.rims_b), on_rims, s[i]);
        if (has_round_pairs(block)) s[i] = select(mask_from_bits(block.round_pairs), on_rounds, s[i]);
        store(block.separation[i], s[i]);
    }
    refresh_arm(block, normal, passed, [](mask8 lanes) { return lanes; });
}

} // namespace cairn::CAIRN_ISA
