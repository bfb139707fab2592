// Contacts with a single point between a face and a rim, a corner or a sphere of the other body, the rolling body. The
// contact point on a rim moves along it, faster than the body rotates; a corner, and the center of a sphere, rotate
// with the body. The point is known at every pose: with the normal n out of the rolling body, and the axis u, the
// center and the radius R of the rim, it is the center plus R e, where e is the unit vector along n - (n.u) u. A corner
// is a rim with R = 0; on a surface that is rounded by r the point is farther out by r n. Impulses act at the position
// of the point at the start of the substep; the relative velocity is taken at its position in the middle of the
// substep, as bodies move with their velocities from its start to its end.
#pragma once

#include "kernels/solve/contact_moment.h"

namespace cairn::CAIRN_ISA {

// The lanes of a block whose contact point is followed over a face.
struct RimLanes {
    mask8 any, on_b; // on_b: B is the rolling body
    Vec3x8 outward;  // the normal, out of the rolling body

    RimLanes(mask8 on_a, mask8 on_b, Vec3x8 normal)
        : any(on_a | on_b), on_b(on_b), outward(select(on_b, -normal, normal)) {}
    RimLanes(const ContactBlock<1>& block, Vec3x8 normal)
        : RimLanes(mask_from_bits(block.rims_a), mask_from_bits(block.rims_b), normal) {}
    // Selects the value of the rolling body, or of the other body, which has the face.
    template <class T> T rolling(T a, T b) const { return select(on_b, b, a); }
    template <class T> T other(T a, T b) const { return select(on_b, a, b); }
};

CAIRN_INLINE Quatx8 select(mask8 m, Quatx8 a, Quatx8 b) { return {select(m, a.v, b.v), select(m, a.w, b.w)}; }
CAIRN_INLINE bool has_rims(const ContactBlock<1>& block) { return (block.rims_a | block.rims_b) != 0; }
CAIRN_INLINE bool has_rims(const ContactBlock<4>&) { return false; }

// The arm of the point of a rim that is farthest along `outward`; on a rounded rim, of the center of the sphere there.
// `middle`: the arm of the rim's center, which is the result if the rim is parallel to the face.
CAIRN_INLINE Vec3x8 rim_point(Vec3x8 outward, Vec3x8 axis, Vec3x8 middle, f32x8 radius) {
    const Vec3x8 across = outward - dot(outward, axis) * axis;
    const f32x8 square = dot(across, across);
    const mask8 leans = square > zero();
    return middle + (select(leans, radius, zero()) / sqrt(select(leans, square, one()))) * across;
}
// The direction in which a rim rolls over a face, times the square root of the rim's radius of curvature in that
// direction, R / |u x n|.
CAIRN_INLINE Vec3x8 rim_curvature(Vec3x8 axis, f32x8 radius, Vec3x8 normal) {
    const Vec3x8 along = cross(axis, normal);
    const f32x8 square = dot(along, along);
    const mask8 leans = (radius > zero()) & (square > zero());
    const f32x8 sine = sqrt(select(leans, square, one()));
    return (select(leans, sqrt(radius / sine), zero()) / sine) * along;
}
CAIRN_INLINE Vec3x8 turned(Vec3x8 rotation, Vec3x8 u) { return u + turned_difference(rotation, u); }

// The friction center's arm for A at the start of a substep, and its displacement relative to A's center of mass up to
// the middle of the substep. The arguments (velocities, axis and center of the rim, d) are those at the start.
struct RimCenter {
    Vec3x8 arm, lead;
};
CAIRN_INLINE RimCenter rim_center(const RimLanes& lanes, const Velocityx8& a, const Velocityx8& b, Vec3x8 axis,
                                  Vec3x8 middle, f32x8 radius, f32x8 sphere, Vec3x8 d, float h) {
    const Vec3x8 turn = splat(0.5f * h) * lanes.rolling(a.w, b.w);
    const Vec3x8 now = rim_point(lanes.outward, axis, middle, radius), arm = now + sphere * lanes.outward;
    const Vec3x8 ahead = rim_point(lanes.outward, turned(turn, axis), turned(turn, middle), radius);
    const Vec3x8 passed = splat(0.5f * h) * (a.v - b.v);
    return {lanes.rolling(arm, arm - d), (ahead - now) - lanes.rolling(zero3(), passed)};
}
CAIRN_INLINE void store_lead(ContactBlock<1>& block, const RimLanes& lanes, Vec3x8 lead) {
    store3(block.rim_lead, select(lanes.any, lead, load3(block.rim_lead)));
}

// The relative velocity at the contact point in the middle of the substep minus that at the friction center, which is
// the contact point at the start of the substep, or at its end for two round surfaces.
template <int N> CAIRN_INLINE Vec3x8 slip_of_rims(const ContactBlock<N>& block, Vec3x8 turning) {
    if constexpr (N == 1)
        if (has_rims(block) || has_round_pairs(block)) return cross(turning, load3(block.rim_lead));
    return zero3();
}

// Begins to follow the contact points of `lanes` at the start of a step. `center`, and `axis` and `radius` of the rim,
// are from the record: of the time `found`. `separation`: that at the start of the step for a point fixed in its body;
// corrected here. Rims are always followed; corners and spheres only if the effect exceeds `negligible_motion` by the
// time `until`. Returns the friction center of the first substep.
CAIRN_INLINE Vec3x8 begin_rims(ContactBlock<1>& block, const RimLanes& lanes, Vec3x8 axis, f32x8 radius, Vec3x8 normal,
                               Vec3x8 center, Vec3x8 d, f32x8 until, const Velocityx8& a, const Velocityx8& b, float h,
                               f32x8& separation) {
    const f32x8 found = load(block.found), sphere = lanes.rolling(load(block.radius_a), load(block.radius_b));
    const Vec3x8 turn = found * lanes.rolling(a.w, b.w), back = -turn, d0 = d - found * (a.v - b.v);
    const Vec3x8 arm = lanes.rolling(center, center + d), beyond = sphere * lanes.outward;
    const Vec3x8 middle = arm - rim_point(lanes.outward, axis, beyond, radius);
    const Vec3x8 axis0 = turned(back, axis), middle0 = turned(back, middle);
    const RimCenter first = rim_center(lanes, a, b, axis0, middle0, radius, sphere, d0, h);
    const Vec3x8 slip = cross(a.w - b.w, splat(2 / h) * first.lead);
    const f32x8 square = until * until;
    const mask8 is_seen =
        (radius > zero()) | (square * square * dot(slip, slip) > splat(negligible_motion * negligible_motion));
    block.rims_b = std::uint8_t(bits(lanes.any & is_seen & lanes.on_b));
    block.rims_a = std::uint8_t(bits(and_not(lanes.any & is_seen, lanes.on_b)));
    if (!has_rims(block)) return center;
    const RimLanes followed(block, normal);
    store3(block.rim_axis, select(followed.any, axis0, load3(block.rim_axis)));
    store3(block.rim_middle, select(followed.any, middle0, load3(block.rim_middle)));
    store(block.rim_radius, select(followed.any, radius, load(block.rim_radius)));
    store3(block.face_arm, select(followed.any, lanes.other(center, center + d), load3(block.face_arm)));
    store3(block.rim_moment, zero3());
    store_lead(block, followed, first.lead);
    const Vec3x8 arm0 = rim_point(lanes.outward, axis0, middle0 + beyond, radius);
    const f32x8 rounded = sphere * dot(turned_difference(turn, normal), normal); // `separation` includes this part
    separation -= select(followed.any, dot(lanes.outward, arm0 - turned(back, arm)) + rounded, zero());
    return select(followed.any, first.arm, center);
}

// Separations of followed points. `common`: the part of their change that refresh_separations computes from the
// translations of both bodies and that does not depend on arms. `delta_a`, `delta_b`: as there.
CAIRN_INLINE f32x8 rim_separations(const ContactBlock<1>& block, Vec3x8 normal, Quatx8 turn_a, Quatx8 turn_b,
                                   Vec3x8 delta_a, Vec3x8 delta_b, f32x8 common) {
    const RimLanes lanes(block, normal);
    const Quatx8 turn = lanes.rolling(turn_a, turn_b);
    const Vec3x8 axis = load3(block.rim_axis), middle = load3(block.rim_middle);
    const f32x8 radius = load(block.rim_radius);
    const Vec3x8 now = rim_point(lanes.outward, rotate(turn, axis), rotate(turn, middle), radius);
    const Vec3x8 before = rim_point(lanes.outward, axis, middle, radius);
    const f32x8 face = dot(lanes.other(-delta_a, delta_b), load3(block.face_arm));
    return load(block.separation0[0]) + (common + (face - dot(lanes.outward, now - before)));
}

// After a substep: moves the friction center to the current contact point. The impulses that are carried into the next
// substep acted at the old one; the moments that they lack since are applied by the next `solve`.
CAIRN_INLINE void advance_rims(ContactBlock<1>& block, const Posex8& at_a, const Posex8& at_b, const Velocityx8& a,
                               const Velocityx8& b, Vec3x8 normal, float h) {
    const RimLanes lanes(block, normal);
    const Quatx8 turn = lanes.rolling(at_a.dq, at_b.dq);
    const RimCenter now = rim_center(lanes, a, b, rotate(turn, load3(block.rim_axis)),
                                     rotate(turn, load3(block.rim_middle)), load(block.rim_radius),
                                     lanes.rolling(load(block.radius_a), load(block.radius_b)), load3(block.d), h);
    const Vec3x8 center = load3(block.center), next = select(lanes.any, now.arm, center);
    store_lead(block, lanes, now.lead);
    const Vec3x8 p = load(block.impulse[0]) * normal + load(block.tangent_impulse[0]) * load3(block.tangent) +
                     load(block.tangent_impulse[1]) * second_tangent(block, normal);
    const Vec3x8 moment = cross(next - center, p);
    store3(block.center, next);
    store3(block.rim_moment, select(lanes.any, moment, load3(block.rim_moment)));
    store3(block.moved_moment, block.moved ? load3(block.moved_moment) + moment : moment);
    block.moved = 1;
}

} // namespace cairn::CAIRN_ISA
