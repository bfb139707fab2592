// Contacts with a single point between two round surfaces: of two balls (or ends of capsules), or of a ball and a
// surface that is round about an axis. The normal lies on the line between the centers of curvature (on an axis, its
// point nearest to the other center), and rotates as the bodies pass each other. With the normal and the contact point
// of the start of the step, a normal impulse would exert a torque on one of the bodies: balls without friction would
// spin.
#pragma once

#include "kernels/solve/couplings.h"
#include "kernels/solve/records.h"
#include "kernels/solve/rims.h"

namespace cairn::CAIRN_ISA {

// The arms of the centers of curvature (on an axis, of a point that is fixed on it), and the axis of the surface that
// is round about one; zero for two balls.
struct RoundCenters {
    Vec3x8 a, b, axis;
};
// Changes since then: the displacement of A relative to B, the changes of both centers' arms, and the new axis.
struct RoundChange {
    Vec3x8 passed, a, b, axis;
};
// The contact point, midway between the surfaces, as an arm of A; d; the normal; the axis; the distance of the centers,
// and how much it has grown, which is computed from differences so that no digits cancel.
struct RoundTouch {
    Vec3x8 arm, d, normal, axis;
    f32x8 distance, grown;
};

CAIRN_INLINE bool has_axes(const ContactBlock<1>& block) { return block.axes_a | block.axes_b; }
CAIRN_INLINE RoundCenters first_centers(const ContactBlock<1>& block) {
    return {load3(block.rim_middle), load3(block.face_arm), load3(block.rim_axis)};
}

// `d`, `distance`: d and the distance of the centers before the change; `otherwise`: the normal if the centers
// coincide. A's arm uses A's center before the change, as the inertia of the bodies is also that before the change; B's
// arm follows from it by d, so that impulses act on both bodies at one point and angular momentum is conserved.
CAIRN_INLINE RoundTouch round_touch(const ContactBlock<1>& block, const RoundCenters& before, Vec3x8 d, f32x8 distance,
                                    const RoundChange& change, Vec3x8 otherwise) {
    const Vec3x8 moved = (change.passed + change.a) - change.b, was = (d + before.a) - before.b;
    Vec3x8 apart = was + moved, shift = zero3();
    f32x8 growth = dot(moved, was + apart);
    if (has_axes(block)) {
        const f32x8 along = dot(apart, change.axis), was_along = dot(was, before.axis);
        growth -= along * along - was_along * was_along;
        apart = apart - along * change.axis, shift = along * before.axis;
    }
    const f32x8 square = dot(apart, apart);
    const mask8 is_apart = square > splat(1e-20f);
    RoundTouch r;
    r.distance = sqrt(select(is_apart, square, splat(1e-20f)));
    r.grown = growth / (r.distance + distance);
    r.normal = select(is_apart, (splat(-1) / r.distance) * apart, otherwise);
    r.axis = change.axis;
    r.d = d + change.passed;
    const f32x8 ra = load(block.radius_a), half_gap = splat(0.5f) * (r.distance - (ra + load(block.radius_b)));
    r.arm = before.a + (ra + half_gap) * r.normal;
    if (has_axes(block)) r.arm = r.arm - select(mask_from_bits(block.axes_b), zero3(), shift);
    return r;
}
// R(q) c - c.
CAIRN_INLINE Vec3x8 turned_difference(Quatx8 q, Vec3x8 c) {
    const Vec3x8 t = splat(2.0f) * cross(q.v, c);
    return q.w * t + cross(q.v, t);
}
CAIRN_INLINE RoundTouch round_touch_at(const ContactBlock<1>& block, const Posex8& a, const Posex8& b, Vec3x8 passed,
                                       Vec3x8 otherwise) {
    const RoundCenters start = first_centers(block);
    RoundChange change = {passed, zero3(), zero3(), zero3()};
    if (block.round_arms) change.a = turned_difference(a.dq, start.a), change.b = turned_difference(b.dq, start.b);
    if (has_axes(block)) change.axis = rotate(select(mask_from_bits(block.axes_b), b.dq, a.dq), start.axis);
    const f32x8 distance = load(block.rim_radius) + load(block.separation0[0]);
    return round_touch(block, start, load3(block.d0), distance, change, otherwise);
}

// The mean relative velocity of the centers in a substep from its start (on an axis, of the material point that is
// nearest at the start), the axis, and the speed at which the nearest point moves along it. For that speed, the axis at
// the end of the substep is normalized: otherwise the motion along the axis could exceed the total motion and grow
// without bound.
struct RoundMotion {
    Vec3x8 velocity, axis;
    f32x8 along;
};
CAIRN_INLINE RoundMotion round_motion(const ContactBlock<1>& block, Vec3x8 between, f32x8 distance, const Velocityx8& a,
                                      const Velocityx8& b, float h) {
    RoundMotion r = {b.v - a.v, zero3(), zero()};
    if (block.round_arms) {
        const mask8 far = mask_from_bits(block.round_arms);
        const Vec3x8 normal = load3(block.normal), center = load3(block.center), half_a = splat(0.5f * h) * a.w,
                     half_b = splat(0.5f * h) * b.w;
        const f32x8 ra = load(block.radius_a), rb = load(block.radius_b),
                    half_gap = splat(0.5f) * (distance - (ra + rb));
        const Vec3x8 arm_a = select(far, center - (ra + half_gap) * normal, zero3()),
                     arm_b = select(far, (center + load3(block.d)) + (rb + half_gap) * normal, zero3());
        r.velocity =
            (b.v + cross(b.w, arm_b + cross(half_b, arm_b))) - (a.v + cross(a.w, arm_a + cross(half_a, arm_a)));
    }
    if (has_axes(block)) {
        r.axis = load3(block.d_touch);
        const Vec3x8 turning = cross(select(mask_from_bits(block.axes_b), b.w, a.w), r.axis);
        const Vec3x8 turned = splat(h) * turning;
        r.along = (dot(r.velocity, r.axis + turned) + dot(between, turning)) / sqrt(one() + dot(turned, turned));
    }
    return r;
}

// The mean speed in a substep at which the centers separate, from the vector D = `between` (from A's center to B's, of
// length `distance`): (|D + u h| - |D|) / h, transformed so that no digits cancel. With the velocity along the normal
// of the start alone, bodies that pass each other would be deflected late.
CAIRN_INLINE f32x8 round_opening(const ContactBlock<1>& block, Vec3x8 between, f32x8 distance, const Velocityx8& a,
                                 const Velocityx8& b, float h) {
    const RoundMotion m = round_motion(block, between, distance, a, b, h);
    const f32x8 growth =
        splat(2) * dot(between, m.velocity) + splat(h) * (dot(m.velocity, m.velocity) - m.along * m.along);
    const f32x8 later = sqrt(max(distance * distance + splat(h) * growth, zero()));
    return growth / max(later + distance, splat(1e-10f));
}
// The opening speed of the contact point. Where the surfaces touch or overlap, it is the mean of the substep in which
// the bodies move with these velocities; where `now` is given and there is a gap, the mean of the next substep.
CAIRN_INLINE f32x8 round_velocity(const ContactBlock<1>& block, const Velocityx8& a, const Velocityx8& b, f32x8 s,
                                  const RoundTouch* now, float h) {
    const Vec3x8 normal = load3(block.normal);
    const f32x8 distance = load(block.rim_radius) + s;
    const Vec3x8 direction = now ? select(s > zero(), now->normal, normal) : normal;
    return round_opening(block, distance * direction, distance, a, b, h);
}

// At the start of a step: converts the normal and the centers of curvature of lanes with two round surfaces from the
// time `found`, at which the contact was found, to the start of the step. `both`: lanes in which both surfaces have a
// radius. Returns the contact at the start of the step.
CAIRN_INLINE RoundTouch begin_round_pairs(ContactBlock<1>& block, const ContactRecord* const* record, mask8 both,
                                          f32x8 found, const Velocityx8& a, const Velocityx8& b, Vec3x8 d,
                                          Vec3x8& normal) {
    Vec3x8 axis, center;
    f32x8 kind, separation;
    RoundTouch touch;
    gather_field(record, point_offset(1), axis.x, axis.y, axis.z, kind);
    const mask8 lanes = both & (kind > zero());
    block.round_pairs = std::uint8_t(bits(lanes));
    if (!block.round_pairs) return touch;
    gather_field(record, point_offset(0), center.x, center.y, center.z, separation);
    block.axes_a = std::uint8_t(bits(lanes & (kind == splat(round_about_axis_of_a))));
    block.axes_b = std::uint8_t(bits(lanes & (kind == splat(round_about_axis_of_b))));
    axis = select(lanes & (kind > splat(round_about_points)), axis, zero3());
    const f32x8 ra = load(block.radius_a), rb = load(block.radius_b), reach = ra + rb;
    RoundCenters c = {center - ra * normal, (center + d) + rb * normal, axis};
    constexpr float rounding = 1e-6f;
    const f32x8 least = splat(rounding) * reach;
    const mask8 far = (dot(c.a, c.a) + dot(c.b, c.b) > least * least) | (dot(axis, axis) > zero());
    block.round_arms = std::uint8_t(bits(lanes & far));
    c.a = select(far, c.a, zero3()), c.b = select(far, c.b, zero3());
    f32x8 grown = zero();
    if (any(found > zero())) {
        const Vec3x8 turn_a = -(found * a.w), turn_b = -(found * b.w);
        const RoundChange back = {-(found * (a.v - b.v)), turned_difference(turn_a, c.a),
                                  turned_difference(turn_b, c.b),
                                  turned(select(mask_from_bits(block.axes_b), turn_b, turn_a), axis)};
        grown = round_touch(block, c, d, reach, back, normal).grown;
        c = {c.a + back.a, c.b + back.b, back.axis};
    }
    touch = round_touch(block, c, load3(block.d0), reach + grown, {zero3(), zero3(), zero3(), c.axis}, normal);
    touch.grown = grown;
    store3(block.rim_axis, c.axis);
    store3(block.d_touch, select(lanes, c.axis, load3(block.d_touch)));
    store3(block.rim_middle, c.a);
    store3(block.face_arm, c.b);
    store(block.rim_radius, reach - separation);
    normal = select(lanes, touch.normal, normal);
    return touch;
}

// Recomputes the couplings with the current arms. With old ones, a row whose arm has grown along a thin rod would
// overshoot by more than the error that it corrects.
CAIRN_INLINE void renew_couplings(ContactBlock<1>& block, mask8 lanes) {
    const Inertiax8 a = {load(block.mass_a), kept_inertia(block.isotropic, block.inertia_a)},
                    b = {load(block.mass_b), kept_inertia(block.isotropic, block.inertia_b)};
    const Vec3x8 normal = load3(block.normal), arm_a = load3(block.center), arm_b = arm_a + load3(block.d);
    const f32x8 mass = safe_reciprocal(normal_coupling(cross(arm_a, normal), cross(arm_b, normal), a, b));
    store(block.effective_mass[0], select(lanes, mass, load(block.effective_mass[0])));
    store_couplings(
        block, lanes,
        friction_couplings(normal, arm_a, arm_b, load3(block.tangent), second_tangent(block, normal), a, b));
}

// A unit tangent of `normal`, from the tangents t1 and t2 of another normal: t1, or t2 if t1 is nearly parallel to
// `normal`, is projected onto the plane of contact.
CAIRN_INLINE Vec3x8 tangent_near(Vec3x8 t1, Vec3x8 t2, Vec3x8 normal) {
    const f32x8 along = dot(t1, normal);
    const Vec3x8 t = select(abs(along) < splat(0.9f), t1, t2), across = t - dot(t, normal) * normal;
    return (one() / sqrt(dot(across, across))) * across;
}

// After a substep: updates the normal, the tangent, the friction center and d to the current poses. The impulses that
// are carried over acted with the old ones; the impulse and the moments that they lack since are applied by the next
// `solve`. Friction needs the slip in the middle of the substep: rim_lead leads halfway back to the old contact point.
CAIRN_INLINE void advance_round_pairs(ContactBlock<1>& block, const RoundTouch& now) {
    constexpr float negligible_fraction = 1e-6f; // of the distance of the centers: smaller displacements are neglected
    const Vec3x8 normal = load3(block.normal), center = load3(block.center), d = load3(block.d);
    const Vec3x8 run = now.arm - center, passed = now.d - d;
    const f32x8 least = splat(negligible_fraction) * now.distance;
    const mask8 moves = mask_from_bits(block.round_pairs) & (dot(run, run) + dot(passed, passed) > least * least);
    block.round_pairs_moved = 0;
    const Vec3x8 lead = select(moves, splat(-0.5f) * run, zero3());
    store3(block.rim_lead, select(mask_from_bits(block.round_pairs), lead, load3(block.rim_lead)));
    if (!any(moves)) return;
    const Vec3x8 t1 = load3(block.tangent), tilted = now.normal - normal;
    const Vec3x8 next_t1 = tangent_near(t1, cross(t1, normal), now.normal);
    const f32x8 load_n = load(block.impulse[0]), p1 = load(block.tangent_impulse[0]),
                p2 = load(block.tangent_impulse[1]);
    const mask8 carries = moves & ((load_n > zero()) | (p1 * p1 + p2 * p2 > zero()));
    if (any(carries)) {
        const Vec3x8 before = load_n * normal + p1 * t1 + p2 * cross(t1, normal),
                     after = load_n * now.normal + p1 * next_t1 + p2 * cross(next_t1, now.normal);
        const Vec3x8 couple = load(block.torsion_impulse) * tilted;
        const Vec3x8 moment_a = (cross(now.arm, after) - cross(center, before)) + couple,
                     moment_b = (cross(now.arm + now.d, after) - cross(center + d, before)) + couple;
        const Vec3x8 moment = select(carries, moment_b, zero3());
        store3(block.rim_moment, select(carries, moment_a, load3(block.rim_moment)));
        store3(block.slip_rate, select(carries, after - before, load3(block.slip_rate)));
        store3(block.moved_moment, block.moved ? load3(block.moved_moment) + moment : moment);
        block.round_pairs_moved = std::uint8_t(bits(carries));
        block.moved = 1;
    }
    store3(block.normal, select(moves, now.normal, normal));
    store3(block.tangent, select(moves, next_t1, t1));
    store3(block.center, select(moves, now.arm, center));
    store3(block.d, select(moves, now.d, d));
    if (block.round_arms) renew_couplings(block, moves & mask_from_bits(block.round_arms));
    if (has_axes(block)) store3(block.d_touch, select(moves, now.axis, load3(block.d_touch)));
}

// At the end of a step: writes the current normal, contact point, radii and axis to the records of two round surfaces.
CAIRN_INLINE void store_round_pairs(const ContactBlock<1>& block, const SolverPose* pose, mask8 among,
                                    ContactRecord* const* record) {
    const f32x8 ra = load(block.radius_a), rb = load(block.radius_b), separation = load(block.separation[0]);
    const Vec3x8 n = load3(block.normal);
    const f32x8 wider = half_gap(block, separation), now_a = ra + wider, now_b = rb + wider;
    const Vec3x8 center_a = load3(block.center) - now_a * n;
    const Vec3x8 place = rotate(gather_pose(pose, block.a).dq, center_a) + now_a * n;
    alignas(32) float normal[3][8], point[3][8], axis[3][8], radius_a[8], radius_b[8];
    store3(normal, n), store3(point, place), store3(axis, load3(block.d_touch));
    store(radius_a, now_a), store(radius_b, now_b);
    const int axes = block.axes_a | block.axes_b, lanes = block.round_pairs & int(bits(among));
    for (int i = 0; i < 8; ++i) {
        if ((lanes >> i & 1) == 0) continue;
        ContactRecord& r = *record[i];
        r.radius_a = radius_a[i], r.radius_b = radius_b[i];
        for (int k = 0; k < 3; ++k) r.normal[k] = normal[k][i], r.first_point[k] = point[k][i];
        for (int k = 0; k < 3 && (axes >> i & 1) != 0; ++k) r.more_points[0][k] = axis[k][i];
    }
}

} // namespace cairn::CAIRN_ISA
