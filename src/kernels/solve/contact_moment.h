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

inline constexpr float unseen = 1e-6f; // m: what moves less is not seen

// Whether a body turns what it has at the point by less than a quarter of a radian up to a time: of what is round
// there, the center of curvature, which has another arm than the point; the center of a ball stays where it is.
CAIRN_INLINE mask8 turns_little(f32x8 square_time, Vec3x8 w, Vec3x8 arm, Vec3x8 arm_of_center) {
    constexpr float small = 0.25f; // rad
    const f32x8 square = dot(arm, arm), moved = min(dot(arm_of_center, arm_of_center), square);
    return square_time * dot(w, w) * moved <= splat(small * small) * square;
}

// How the point moves, and the velocities there with it (slip_of_turning): with p' its velocity as seen from A, they
// change by (w_B - w_A) x p', as rows keep B's arm up to where A is. A corner moves with its body; what is round, with
// the radius of curvature R, stays behind a corner by R (w_A - w_B) x n as it rolls over a face. The only
// point on a face is followed (rims.h): of that only the face counts here. The face turns the normal: velocities change
// along that by w x n times themselves as well, and what slides over it, the corner or the center of what is round,
// parts from it by w x n times its way and the time. Where neither is a face, two edges meet: the point moves with
// both, in the mean. That is true of small turns, up to the time `until`: of lanes that turn farther, or change by
// nothing that could be seen, nothing moves.
template <int N>
CAIRN_INLINE void prepare_turning(ContactBlock<N>& block, mask8 is_edge, mask8 face_a, mask8 face_b, f32x8 until,
                                  const Velocityx8& a, const Velocityx8& b, Vec3x8 normal, Vec3x8 d, Vec3x8 taper,
                                  Vec3x8 rim) {
    const Vec3x8 r = load3(block.center), apart = b.v - a.v;
    const Vec3x8 with_a = cross(a.w, r), with_b = apart + cross(b.w, r + d), rolling = cross(a.w - b.w, normal);
    const auto times_curvature = [&](Vec3x8 u) {
        const Vec3x8 around = select(face_a, load(block.radius_b), load(block.radius_a)) * u;
        if constexpr (N == 1) return around + dot(rim, u) * rim;
        return around;
    };
    const Vec3x8 rolled = times_curvature(rolling);
    const Vec3x8 from_a =
        select(face_b, with_a - rolled, select(face_a, with_b - rolled, splat(0.5f) * (with_a + with_b)));
    const Vec3x8 turned = cross(select(face_b, b.w, select(face_a, a.w, zero3())), normal);
    const mask8 any_a = N == 1 ? face_b : mask_from_bits(0), any_b = N == 1 ? face_a : mask_from_bits(0);
    const Vec3x8 along_face = select(face_b, one(), splat(-1)) * times_curvature(turned);
    const Vec3x8 moving = N == 1 ? select(is_edge, from_a, along_face) : from_a;
    const Vec3x8 turning = cross(b.w - a.w, moving) + dot(turned, with_b - with_a) * normal;
    const Vec3x8 dw = b.w - a.w;
    Vec3x8 slope = zero3();
    f32x8 most = dot(turning, turning); // of all points
    if constexpr (N > 1) {
        slope = cross(cross(normal, dw), select(face_b, a.w, b.w)) + cross(turned, dw) - dot(rolling, rolling) * taper;
        f32x8 lever = zero();
        for (int i = 0; i < N; ++i) lever = max(lever, load(block.square_lever[i]));
        most += lever * dot(slope, slope);
    }
    const f32x8 square = until * until;
    mask8 touches = mask_from_bits(0);
    for (int i = 0; i < N; ++i)
        touches = touches | (load(block.impulse[i]) > zero()) | (load(block.separation0[i]) <= splat(unseen));
    const mask8 moves = (is_edge | face_a | face_b) & touches &
                        (any_a | turns_little(square, a.w, r, r - load(block.radius_a) * normal)) &
                        (any_b | turns_little(square, b.w, r + d, r + d + load(block.radius_b) * normal)) &
                        (square * square * most > splat(unseen * unseen));
    block.turns = std::uint8_t(bits(moves));
    if (!block.turns) return;
    const f32x8 sliding = dot(turned, (with_b - with_a) + select(face_b, one(), splat(-1)) * rolled +
                                          splat(0.5f) * times_curvature(turned)),
                found = load(block.found);
    store3(block.turning, select(moves, turning, zero3()));
    if constexpr (N > 1) store3(block.turning_slope, select(moves, slope, zero3()));
    store(block.sliding, select(moves, sliding, zero()));
    const f32x8 parted = select(moves, found * found * sliding, zero());
    for (int i = 0; i < N; ++i) store(block.separation0[i], load(block.separation0[i]) + parted);
}

} // namespace cairn::CAIRN_ISA
