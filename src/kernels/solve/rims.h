// What touches a face by one point. The place of touch of a rim runs along it, faster than the body turns; that of a
// corner turns with the body, and so does the middle of a sphere. It is known at every pose: with the outward normal n,
// the axis u and the radius R of the rim, at the middle of that and R e, with e along n - (n.u) u; a corner is a rim
// with R = 0, and what is rounded by r touches r n beyond. Impulses act where the place is when the substep begins, and
// the velocities are asked for where it is in its middle, as bodies move by them from its start to its end.
#pragma once

#include "kernels/solve/contact_moment.h"

namespace cairn::CAIRN_ISA {

// The lanes of a block that are followed.
struct RimLanes {
    mask8 any, on_b;
    Vec3x8 outward; // the normal, out of what rolls

    RimLanes(mask8 on_a, mask8 on_b, Vec3x8 normal)
        : any(on_a | on_b), on_b(on_b), outward(select(on_b, -normal, normal)) {}
    RimLanes(const ContactBlock<1>& block, Vec3x8 normal)
        : RimLanes(mask_from_bits(block.rims_a), mask_from_bits(block.rims_b), normal) {}
    // Of two bodies, that which rolls, and that with the face.
    template <class T> T rolling(T a, T b) const { return select(on_b, b, a); }
    template <class T> T other(T a, T b) const { return select(on_b, a, b); }
};

CAIRN_INLINE Quatx8 select(mask8 m, Quatx8 a, Quatx8 b) { return {select(m, a.v, b.v), select(m, a.w, b.w)}; }
CAIRN_INLINE bool has_rims(const ContactBlock<1>& block) { return (block.rims_a | block.rims_b) != 0; }
CAIRN_INLINE bool has_rims(const ContactBlock<4>&) { return false; }

// The arm of the lowest point of a rim, or of the middle of the sphere there.
CAIRN_INLINE Vec3x8 rim_point(Vec3x8 outward, Vec3x8 axis, Vec3x8 middle, f32x8 radius) {
    const Vec3x8 across = outward - dot(outward, axis) * axis;
    const f32x8 square = dot(across, across);
    const mask8 leans = square > zero();
    return middle + (select(leans, radius, zero()) / sqrt(select(leans, square, one()))) * across;
}
// The direction in which what is on a rim rolls over a face, times the root of the radius of curvature that it has
// there, R / |u x n|.
CAIRN_INLINE Vec3x8 rim_curvature(Vec3x8 axis, f32x8 radius, Vec3x8 normal) {
    const Vec3x8 along = cross(axis, normal);
    const f32x8 square = dot(along, along);
    const mask8 leans = (radius > zero()) & (square > zero());
    const f32x8 sine = sqrt(select(leans, square, one()));
    return (select(leans, sqrt(radius / sine), zero()) / sine) * along;
}
CAIRN_INLINE Vec3x8 turned(Vec3x8 rotation, Vec3x8 u) { return u + turned_difference(rotation, u); }

// The arms of the friction center for A at the start of a substep, and how far it runs up to its middle. Given of the
// start: axis and middle of the rim, velocities, and d.
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

// What the velocities at the place of touch in the middle of the substep are more than at its start.
template <int N> CAIRN_INLINE Vec3x8 slip_of_rims(const ContactBlock<N>& block, Vec3x8 turning) {
    if constexpr (N == 1)
        if (has_rims(block) || has_rounds(block)) return cross(turning, load3(block.rim_lead));
    return zero3();
}

// At the start of a step: `center` is where the contact was found, at the time `found`, with the axis and the radius of
// the record, of the lanes given; `separation` is that of the start if the place was one point of the body. A place is
// followed where that could be seen until the time `until`, and rims wherever they are. Returns the friction center of
// the first substep.
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
    const mask8 is_seen = (radius > zero()) | (square * square * dot(slip, slip) > splat(unseen * unseen));
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
    const f32x8 rounded = sphere * dot(turned_difference(turn, normal), normal); // of which `separation` has that
    separation -= select(followed.any, dot(lanes.outward, arm0 - turned(back, arm)) + rounded, zero());
    return select(followed.any, first.arm, center);
}

// Their separations: `common` is what refresh_separations has of the two bodies' translations and of what does not
// depend on arms; `delta_a` and `delta_b` likewise.
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

// After a substep: the friction center goes to where the rim touches now. What is carried into the next was pushed at
// the old one: the moments that are missing since are left for the next `solve`.
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
