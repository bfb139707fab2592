// Friction and rolling resistance of contact blocks, after their normal impulses.
#pragma once

#include "kernels/solve/rounds.h"

namespace cairn::CAIRN_ISA {

constexpr float no_size = 1e-20f; // added to divisors, so that nothing is divided by 0

// Sums over the points of one contact.
struct PointSums {
    f32x8 load;    // total normal impulse, for friction
    f32x8 spread;  // sum of squared lever times impulse
    Vec3x8 torque; // sum of arm times impulse
};

template <int N>
CAIRN_INLINE void add_point(const ContactBlock<N>& block, Vec3x8 normal, int i, f32x8 impulse, PointSums& sums) {
    sums.load += impulse;
    if constexpr (N > 1) {
        sums.spread += load(block.square_lever[i]) * impulse;
        sums.torque = sums.torque + impulse * arm_of(block, normal, i);
    }
}

// The load of a contact: its normal impulse, the mean of its points weighted by their impulses, and their spread.
struct Load {
    f32x8 sum, radius; // total normal impulse; spread: root mean square distance of the points from the load
    LoadOffset e;      // from the friction center
    f32x8 aside;       // |e|^2
};
template <int N>
CAIRN_INLINE Load load_of(const ContactBlock<N>& block, const PointSums& sums, Vec3x8 center, Vec3x8 t1, Vec3x8 t2) {
    Load r = {sums.load, load(block.torsion_radius), {zero(), zero()}, zero()};
    if constexpr (N > 1) {
        const f32x8 inverse = one() / select(sums.load > zero(), sums.load, one());
        r.e = load_offset(center, inverse, sums.torque, t1, t2);
        r.aside = r.e.x * r.e.x + r.e.y * r.e.y;
        r.radius = max(sqrt(max(sums.spread * inverse - r.aside, zero())), r.radius);
    }
    return r;
}

// Friction impulses, or slip velocities: along the tangents at the friction center, and about the normal.
struct FrictionImpulse {
    f32x8 t1, t2, couple;
};

// The friction of a sliding contact, at its load. One common mass for all rows makes friction converge to the direction
// opposite to the slip. `slip`: along the tangents at the friction center, and about the normal.
template <int N>
CAIRN_INLINE FrictionImpulse sliding_friction(const ContactBlock<N>& block, const Load& at, FrictionImpulse slip,
                                              FrictionImpulse old) {
    const f32x8 m11 = load(block.tangent_mass[0]), m12 = load(block.tangent_mass[1]), m22 = load(block.tangent_mass[2]);
    // The reciprocal of the greatest eigenvalue of K at the friction center; below, a lower bound of it at the load.
    const f32x8 half = splat(0.5f) * (m11 - m22);
    f32x8 mass = max(splat(0.5f) * (m11 + m22) - sqrt(half * half + m12 * m12), zero());
    const f32x8 mw = load(block.torsion_mass);
    const mask8 turns = mw > zero(), has_radius = at.radius > zero();
    const f32x8 radius = select(has_radius, at.radius, one()), limit = load(block.friction) * at.sum;
    f32x8 held = old.couple; // couple about the load
    if constexpr (N > 1) {
        const f32x8 further = one() + sqrt(select(turns, at.aside * mass / select(turns, mw, one()), zero()));
        mass = mass / (further * further);
        slip.t1 = slip.t1 + at.e.y * slip.couple, slip.t2 = slip.t2 - at.e.x * slip.couple;
        held = held - moment_at(at.e, old.t1, old.t2);
    }
    held = held / radius;
    mass = select(has_radius & turns, min(mass, mw / (radius * radius)), mass);
    if constexpr (N > 1) {
        // The couple is limited to what a load that has contracted can still hold; the tangential impulses are kept.
        const f32x8 room = sqrt(max(limit * limit - (old.t1 * old.t1 + old.t2 * old.t2), zero()));
        held = clamp(held, -room, room);
    }
    const f32x8 c1 = old.t1 - mass * slip.t1, c2 = old.t2 - mass * slip.t2;
    const f32x8 cw = select(has_radius, held - mass * (radius * slip.couple), zero());
    const f32x8 scale = min(limit / (sqrt(c1 * c1 + c2 * c2 + cw * cw) + splat(no_size)), one());
    FrictionImpulse r = {scale * c1, scale * c2, scale * cw * radius};
    if constexpr (N > 1) r.couple = r.couple + moment_at(at.e, r.t1, r.t2);
    return r;
}

// Friction acts at the load, the mean of the points weighted by their impulses. Two tangential rows and the torsional
// row share one ellipsoidal limit, the limit surface of Goyal, Ruina and Papadopoulos (1991) in the form of Howe and
// Cutkosky (1996): with r the radius of the load, n1^2 + n2^2 + (nw / r)^2 <= (friction x load)^2. While the contact
// sticks, the rows are solved with their own masses. The rows are those of the friction center, which is fixed for the
// step; the limit applies at the load, at the offset e from it. The slip is that of the middle of the substep, half a
// substep before the poses of d: with the slip of the end, bodies that ride on a turntable creep inward.
template <int N>
CAIRN_INLINE void solve_friction(ContactBlock<N>& block, const PointSums& sums, Vec3x8 normal,
                                 const ContactSoftness& softness, Velocityx8& a, Velocityx8& b) {
    const Vec3x8 center = load3(block.center), d = load3(block.d), t1 = load3(block.tangent), t2 = cross(t1, normal);
    const Vec3x8 dw = b.w - a.w, dv = b.v - a.v;
    Vec3x8 velocity = dv + cross(dw, center) + cross(b.w, d + splat(0.5f * softness.h) * dv);
    if (block.moving_points) velocity = velocity + slip_of_moving_points(block, softness.middle);
    if (has_rims(block) || has_round_pairs(block)) velocity = velocity + slip_of_rims(block, dw);
    const FrictionImpulse slip = {dot(velocity, t1), dot(velocity, t2), dot(normal, dw)};
    const FrictionImpulse old = {load(block.tangent_impulse[0]), load(block.tangent_impulse[1]),
                                 load(block.torsion_impulse)};
    const Load at = load_of(block, sums, center, t1, t2);

    // Sticking.
    FrictionImpulse now;
    const mask8 has_radius = at.radius > zero();
    now.couple = select(has_radius, old.couple - load(block.torsion_mass) * slip.couple, zero());
    const f32x8 m12 = load(block.tangent_mass[1]);
    const f32x8 x = slip.t1 + load(block.torsion_coupling[0]) * (now.couple - old.couple),
                y = slip.t2 + load(block.torsion_coupling[1]) * (now.couple - old.couple);
    now.t1 = old.t1 - (load(block.tangent_mass[0]) * x + m12 * y);
    now.t2 = old.t2 - (m12 * x + load(block.tangent_mass[2]) * y);
    f32x8 qw = now.couple;
    if constexpr (N > 1) qw = qw - moment_at(at.e, now.t1, now.t2);
    qw = select(has_radius, qw / select(has_radius, at.radius, one()), zero());
    const f32x8 static_limit = load(block.static_friction) * at.sum;
    const mask8 slides = (now.t1 * now.t1 + now.t2 * now.t2 + qw * qw) > static_limit * static_limit;
    if (any(slides)) {
        const FrictionImpulse sliding = sliding_friction(block, at, slip, old);
        now = {select(slides, sliding.t1, now.t1), select(slides, sliding.t2, now.t2),
               select(slides, sliding.couple, now.couple)};
    }

    // Without a load there is no friction. (A slip whose square underflows counts as sticking.)
    const mask8 pressed = at.sum > zero();
    now = {select(pressed, now.t1, zero()), select(pressed, now.t2, zero()), select(pressed, now.couple, zero())};
    store(block.tangent_impulse[0], now.t1);
    store(block.tangent_impulse[1], now.t2);
    store(block.total_tangent[0], load(block.total_tangent[0]) + now.t1);
    store(block.total_tangent[1], load(block.total_tangent[1]) + now.t2);
    store(block.torsion_impulse, now.couple);
    const Vec3x8 p = (now.t1 - old.t1) * t1 + (now.t2 - old.t2) * t2;
    apply_friction(block, center, d, p, (now.couple - old.couple) * normal, a, b);
}

// Rolling resistance: a couple against the relative angular velocity, at most rolling radius x load.
template <int N> CAIRN_INLINE void solve_rolling(ContactBlock<N>& block, f32x8 load_sum, Velocityx8& a, Velocityx8& b) {
    const Vec3x8 dw = b.w - a.w, old = load3(block.rolling_impulse);
    Vec3x8 p = old - rolling_mass(block) * dw;
    const f32x8 limit = load(block.rolling_radius) * load_sum;
    const f32x8 scale = min(limit / (sqrt(dot(p, p)) + splat(no_size)), one());
    p = scale * p;
    store3(block.rolling_impulse, p);
    const Vec3x8 change = p - old;
    a.w = a.w - turned_a(block, change);
    b.w = b.w + turned_b(block, change);
}

} // namespace cairn::CAIRN_ISA
