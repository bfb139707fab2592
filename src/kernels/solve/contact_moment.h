// Contacts that were found at another moment of the step than its start: their state at the start, and how their points
// move within the step.
#pragma once

#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

// The state at the start of the step of contacts that were found at another moment, extrapolated with the velocities of
// the start, as in refresh_separations.
struct Before {
    Vec3x8 passed;     // displacement of A relative to B from the start up to that moment
    Vec3x8 difference; // separations are greater at the start by dot(difference, arm of the point) + apart
    f32x8 apart;       // m
};
// R(u) n - n for a rotation vector u of up to some radians: u x n sin(x) / x + u x (u x n) (1 - cos(x)) / x^2, with
// x = |u|.
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

inline constexpr float negligible_motion = 1e-6f; // m: smaller motions are neglected

// Whether the rotation of a body moves its contact point by less than a quarter of its arm's length (0.25 rad) up to a
// time. For a round surface the motion is that of the center of curvature, which has another arm than the point: the
// center of a ball does not move.
CAIRN_INLINE mask8 turns_little(f32x8 square_time, Vec3x8 w, Vec3x8 arm, Vec3x8 arm_of_center) {
    constexpr float small = 0.25f; // rad
    const f32x8 square = dot(arm, arm), moved = min(dot(arm_of_center, arm_of_center), square);
    return square_time * dot(w, w) * moved <= splat(small * small) * square;
}

// How the contact point moves, and how the relative velocity there changes as a result (slip_of_moving_points). If the
// point moves with velocity p' as seen from A, the relative velocity changes at the rate (w_B - w_A) x p', as rows keep
// B's arm up to where A is. A corner moves with its body; the contact point of a round surface with the radius of
// curvature R falls behind that by R (w_A - w_B) x n as it rolls over a face. A single point on a face is followed
// (rims.h): only the rotation of the face is added here. The face rotates the normal: the velocity along the normal
// also changes by w x n times the relative velocity, and a corner, or center of curvature, that slides over the face
// separates from it by w x n times its displacement and the time. If neither surface is a face, two edges touch, and
// the point moves with the mean of both. This holds for small rotations up to the time `until`: the points of lanes
// that rotate farther, or whose change would be negligible, do not move.
template <int N>
CAIRN_INLINE void prepare_moving_points(ContactBlock<N>& block, mask8 is_edge, mask8 face_a, mask8 face_b, f32x8 until,
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
    const Vec3x8 slip_rate = cross(b.w - a.w, moving) + dot(turned, with_b - with_a) * normal;
    const Vec3x8 dw = b.w - a.w;
    Vec3x8 slope = zero3();
    f32x8 most = dot(slip_rate, slip_rate); // maximum over the points
    if constexpr (N > 1) {
        slope = cross(cross(normal, dw), select(face_b, a.w, b.w)) + cross(turned, dw) - dot(rolling, rolling) * taper;
        f32x8 lever = zero();
        for (int i = 0; i < N; ++i) lever = max(lever, load(block.square_lever[i]));
        most += lever * dot(slope, slope);
    }
    const f32x8 square = until * until;
    mask8 touches = mask_from_bits(0);
    for (int i = 0; i < N; ++i)
        touches =
            touches | (load(block.impulse[i]) > zero()) | (load(block.separation0[i]) <= splat(negligible_motion));
    const mask8 moves = (is_edge | face_a | face_b) & touches &
                        (any_a | turns_little(square, a.w, r, r - load(block.radius_a) * normal)) &
                        (any_b | turns_little(square, b.w, r + d, r + d + load(block.radius_b) * normal)) &
                        (square * square * most > splat(negligible_motion * negligible_motion));
    block.moving_points = std::uint8_t(bits(moves));
    if (!block.moving_points) return;
    const f32x8 sliding = dot(turned, (with_b - with_a) + select(face_b, one(), splat(-1)) * rolled +
                                          splat(0.5f) * times_curvature(turned)),
                found = load(block.found);
    store3(block.slip_rate, select(moves, slip_rate, zero3()));
    if constexpr (N > 1) store3(block.slip_rate_slope, select(moves, slope, zero3()));
    store(block.departure, select(moves, sliding, zero()));
    const f32x8 parted = select(moves, found * found * sliding, zero());
    for (int i = 0; i < N; ++i) store(block.separation0[i], load(block.separation0[i]) + parted);
}

} // namespace cairn::CAIRN_ISA
