// Contacts that were found at another moment of the step than its start: how they are at the start, and how their
// places move within the step.
#pragma once

#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

// How contacts are at the start of the step that were found at another moment of it: by the velocities of the start, as
// in refresh_separations.
struct Before {
    Vec3x8 passed;     // how far A passes B up to that moment
    Vec3x8 difference; // times the arm of a point, and
    f32x8 apart;       // how much farther apart the points are
};
// R(u) n - n, of a rotation vector of up to some radians: u x n sin(x) / x + u x (u x n) (1 - cos(x)) / x^2, x = |u|.
CAIRN_INLINE Vec3x8 turned_difference(Vec3x8 u, Vec3x8 n) {
    const f32x8 x2 = dot(u, u);
    const f32x8 sine = one() - x2 * (splat(1.0f / 6) - x2 * (splat(1.0f / 120) - x2 * splat(1.0f / 5040)));
    const f32x8 cosine = splat(0.5f) - x2 * (splat(1.0f / 24) - x2 * (splat(1.0f / 720) - x2 * splat(1.0f / 40320)));
    const Vec3x8 g = cross(u, n);
    return sine * g + cosine * cross(u, g);
}
CAIRN_INLINE Before before(f32x8 found, const Velocityx8& a, const Velocityx8& b, Vec3x8 normal, Vec3x8 d,
                           f32x8 radius_a, f32x8 radius_b) {
    const Vec3x8 delta_a = turned_difference(found * a.w, normal), delta_b = turned_difference(found * b.w, normal);
    const Vec3x8 passed = found * (a.v - b.v);
    return {passed, delta_b - delta_a,
            dot(passed, normal) + dot(delta_b, d) +
                (radius_a * dot(delta_a, normal) + radius_b * dot(delta_b, normal))};
}

CAIRN_INLINE Velocityx8 velocity_of(const SolverVelocity* velocity, const std::int32_t* rows) {
    std::uint32_t offset[8];
    for (int i = 0; i < 8; ++i) offset[i] = std::uint32_t(rows[i]) * row_bytes;
    return gather_velocity(velocity, offset);
}

// How the point moves, and the velocities there with it (slip_of_turning): with p' its velocity, it is
// w_B x (p' - v_B) - w_A x (p' - v_A). A corner of either body moves with it, and of both, in the mean, what touches by
// edges. On a rim, with the radius of curvature R along t, a corner would go on by R t (t.(w_A - w_B) x n) farther than
// the place of touch does. That is true of small turns, up to the time `until`: of lanes that turn farther, or by
// nothing that could be seen, and where it is 0, nothing moves.
CAIRN_INLINE void prepare_turning(ContactBlock<1>& block, mask8 is_corner, mask8 rolls_on_a, mask8 rolls_on_b,
                                  f32x8 until, const Velocityx8& a, const Velocityx8& b, Vec3x8 normal, Vec3x8 d) {
    constexpr float tiny = 1e-4f, small = 0.25f; // rad
    const f32x8 turn = until * until * max(dot(a.w, a.w), dot(b.w, b.w));
    const mask8 moves = (is_corner | rolls_on_a | rolls_on_b) & (until > zero()) & (turn > splat(tiny * tiny)) &
                        (turn < splat(small * small));
    block.turns = any(moves);
    if (!block.turns) return;
    const Vec3x8 r = load3(block.center), rim = load3(block.rim), apart = b.v - a.v;
    const Vec3x8 with_a = cross(a.w, r), with_b = apart + cross(b.w, r + d);
    const Vec3x8 rolled = dot(rim, cross(a.w - b.w, normal)) * rim;
    const Vec3x8 from_a =
        select(rolls_on_a, with_a - rolled, select(rolls_on_b, with_b - rolled, splat(0.5f) * (with_a + with_b)));
    const Vec3x8 turning = cross(b.w, from_a - apart) - cross(a.w, from_a);
    store3(block.turning, select(moves, turning, zero3()));
}

} // namespace cairn::CAIRN_ISA
