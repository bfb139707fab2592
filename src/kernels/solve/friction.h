// Friction and rolling resistance of contact blocks, after their normal impulses.
#pragma once

#include "kernels/solve/friction_rows.h"
#include "kernels/solve/rims.h"

namespace cairn::CAIRN_ISA {

constexpr float no_size = 1e-20f; // so that nothing is divided by 0

// The sums over the points of one contact.
struct PointSums {
    f32x8 load;    // total normal impulse, for friction
    f32x8 spread;  // sum of squared lever times impulse
    Vec3x8 torque; // sum of arm times impulse
};

template <int N>
CAIRN_INLINE void add_point(const ContactBlock<N>& block, Vec3x8 normal, int i, f32x8 impulse, PointSums& sums) {
    sums.load += impulse;
    if constexpr (N > 1) {
        sums.spread += square_lever(block, normal, i) * impulse;
        sums.torque = sums.torque + impulse * arm_of(block, normal, i);
    }
}

constexpr float least_load = 1e-36f; // N s: less is none, so that its reciprocal is a number

// The load of a contact, as friction sees it: beside the friction center, and how far it is spread.
struct Load {
    f32x8 sum, radius; // the radius about the load: root of the mean square
    LoadOffset e;      // where it is
    f32x8 aside;       // |e|^2
};
template <int N>
CAIRN_INLINE Load load_of(const ContactBlock<N>& block, const PointSums& sums, Vec3x8 center, Vec3x8 t1, Vec3x8 t2) {
    Load r = {sums.load, load(block.torsion_radius), {zero(), zero()}, zero()};
    if constexpr (N > 1) {
        const f32x8 inverse = one() / select(sums.load > splat(least_load), sums.load, one());
        r.e = load_offset(center, inverse, sums.torque, t1, t2);
        r.aside = r.e.x * r.e.x + r.e.y * r.e.y;
        r.radius = max(sqrt(max(sums.spread * inverse - r.aside, zero())), r.radius);
    }
    return r;
}

// Impulses of friction: along the tangents at the friction center, and about the normal.
struct FrictionImpulse {
    f32x8 t1, t2, couple;
};

// Friction at the load, in units in which its limit is a ball: two tangential rows and the torsional row share one
// ellipsoid, the limit surface of Goyal, Ruina and Papadopoulos (1991) in the form of Howe and Cutkosky (1996): with r
// the radius of the load, p1^2 + p2^2 + (couple / r)^2 <= (friction x load)^2.
struct LimitBall {
    f32x8 radius, inverse_radius; // 0 where nothing holds what turns about the normal
    Sym3x8 k;                     // in units of its trace: no product of three of its members is out of range
    Vec3x8 old, slip;             // the slip likewise
};
CAIRN_INLINE Vec3x8 in_ball(const Load& at, f32x8 inverse_radius, FrictionImpulse p) {
    return {p.t1, p.t2, inverse_radius * (p.couple - moment_at(at.e, p.t1, p.t2))};
}
CAIRN_INLINE LimitBall limit_ball(const Sym3x8& k, const Load& at, FrictionImpulse slip, FrictionImpulse old) {
    constexpr float seen = 1e-12f;  // what is less beside the others does not count
    constexpr float least = 1e-30f; // 1/kg
    LimitBall r;
    const Sym3x8 there = coupling_at(k, at.e);
    const f32x8 across = there.xx + there.yy, zz = at.radius * at.radius * k.zz;
    const mask8 turns = zz > splat(seen) * across;
    r.radius = select(turns, at.radius, zero());
    r.inverse_radius = safe_reciprocal(r.radius);
    const f32x8 trace = across + zz;
    const f32x8 unit = select(trace > splat(least), safe_reciprocal(trace), zero());
    r.k = {unit * there.xx,
           unit * there.xy,
           unit * (r.radius * there.xz),
           unit * there.yy,
           unit * (r.radius * there.yz),
           select(turns, unit * zz, one())};
    r.old = in_ball(at, r.inverse_radius, old);
    r.slip = unit * Vec3x8{slip.t1 + at.e.y * slip.couple, slip.t2 - at.e.x * slip.couple, r.radius * slip.couple};
    return r;
}

// The impulses at which what slides opposes the slip that it leaves: (K + x 1) p = K old - slip with the x > 0 for
// which p is at its limit, by Newton's method on 1 / |p|, which comes from below. `p`: that for x = 0. What is left
// beyond the limit in the end is taken in the direction in which p changes with x: at a radius of a millimeter the
// couple has a millionth of the K of the tangents, and takes most steps.
CAIRN_INLINE Vec3x8 sliding_impulse(const LimitBall& ball, f32x8 limit, Vec3x8 p) {
    constexpr int most_steps = 6;
    constexpr float near = 1.01f;
    constexpr float least = 1e-3f; // of its size: less is not asked for in one step
    const Sym3x8& k = ball.k;
    const Vec3x8 pull = k * ball.old - ball.slip;
    f32x8 x = zero();
    Vec3x8 change = inverse_of(k) * p;
    for (int i = 0; i < most_steps; ++i) {
        const f32x8 square = dot(p, p), size = sqrt(square), slope = dot(p, change);
        const f32x8 wanted = max(limit, splat(least) * size);
        const mask8 beyond = (limit > zero()) & (size > splat(near) * wanted) & (slope > zero());
        if (!any(beyond)) break;
        const f32x8 step = (square / select(beyond, slope, one())) * ((size - wanted) / select(beyond, wanted, one()));
        x += select(beyond, step, zero());
        const Sym3x8 inverse = inverse_of({k.xx + x, k.xy, k.xz, k.yy + x, k.yz, k.zz + x});
        p = select(beyond, inverse * pull, p);
        change = inverse * p;
    }
    // The nearer root s of |p - s change| = limit, or where that is least.
    const f32x8 a = dot(change, change), b = dot(p, change), c = dot(p, p) - limit * limit;
    constexpr float no_number = 1e38f;
    const mask8 beyond = (c > zero()) & (a > zero()) & (b * b < splat(no_number));
    const f32x8 s = (b - sqrt(max(b * b - a * c, zero()))) / select(beyond, a, one());
    p = p - select(beyond, s, zero()) * change;
    return min(limit / (sqrt(dot(p, p)) + splat(no_size)), one()) * p;
}

// `k`: K of friction at its center; `slip`: along the tangents there, and about the normal; `sticks`: the limit of what
// does not slide yet.
CAIRN_INLINE FrictionImpulse friction_impulse(const Sym3x8& k, const Load& at, FrictionImpulse slip,
                                              FrictionImpulse old, f32x8 sticks, f32x8 limit) {
    LimitBall ball = limit_ball(k, at, slip, old);
    const Vec3x8 change = inverse_of(ball.k) * ball.slip;
    Vec3x8 p = ball.old - change;
    const mask8 slides = dot(p, p) > sticks * sticks;
    if (any(slides)) {
        // A load that draws together holds no such couple any more; what it holds along the surface stays.
        const f32x8 along = ball.old.x * ball.old.x + ball.old.y * ball.old.y;
        const f32x8 room = sqrt(max(limit * limit - along, zero()));
        ball.old.z = clamp(ball.old.z, -room, room);
        p = select(slides, sliding_impulse(ball, limit, ball.old - change), p);
    }
    return {p.x, p.y, ball.radius * p.z + moment_at(at.e, p.x, p.y)};
}

// Lanes of which the points hold the bodies, so that friction does not tip them: they bear, but for one of four that
// the other three hold.
CAIRN_INLINE mask8 points_that_hold(const ContactBlock<4>& block) {
    f32x8 idle = zero();
    mask8 held = mask_from_bits(block.spans);
    for (int i = 0; i < 4; ++i) {
        const f32x8 apart = abs(load(block.null_impulse[i]));
        const mask8 bears = (load(block.impulse[i]) > zero()) | (load(block.effective_mass[i]) <= zero());
        idle += select(bears, zero(), one());
        held = held & (bears | (apart > zero()));
    }
    return held & (idle < splat(1.5f));
}

// How the normal impulses change with those of friction so that the points neither part nor meet (friction_rows.h).
// What does nothing is added so that no point pulls, if that can be, and one that bears nothing does not come to.
struct HeldNormals {
    mask8 holds;
    f32x8 change[4];
};
CAIRN_INLINE HeldNormals held_normals(const ContactBlock<4>& block, FrictionImpulse change, Vec3x8 normal, Vec3x8 t1,
                                      Vec3x8 t2) {
    constexpr float no_end = 1e30f;
    const auto held = [&](int i) {
        return (load(block.held_normal[i]) * change.t1 + load(block.held_normal[i + 1]) * change.t2) +
               load(block.held_normal[i + 2]) * change.couple;
    };
    const Vec3x8 slope = held(3) * t2 - held(6) * t1; // with arms, as x = j.t2 and y = -j.t1
    const f32x8 at_no_arm = held(0) - dot(cross(load3(block.center), normal), slope);
    HeldNormals r;
    f32x8 least = splat(-no_end), most = splat(no_end); // of what does nothing
    r.holds = mask_from_bits(255);
    for (int i = 0; i < 4; ++i) {
        const f32x8 impulse = load(block.impulse[i]), nothing = load(block.null_impulse[i]);
        r.change[i] =
            select(load(block.effective_mass[i]) > zero(), at_no_arm + dot(load3(block.arm[i]), slope), zero());
        const mask8 up = nothing > zero(), down = nothing<zero(), bears = impulse> zero();
        const f32x8 missing = -(impulse + r.change[i]), to_zero = missing / select(up | down, nothing, one());
        r.holds = r.holds & (up | down | (missing <= zero()));
        least = select(up | and_not(down, bears), max(least, to_zero), least);
        most = select(down | and_not(up, bears), min(most, to_zero), most);
    }
    r.holds = r.holds & (least <= most);
    const f32x8 amount = min(max(least, zero()), most);
    for (int i = 0; i < 4; ++i)
        r.change[i] = max(r.change[i] + amount * load(block.null_impulse[i]), -load(block.impulse[i]));
    return r;
}

CAIRN_INLINE void change_normals(ContactBlock<4>& block, const HeldNormals& held, Vec3x8 normal, Vec3x8 d, mask8 holds,
                                 Velocityx8& a, Velocityx8& b) {
    f32x8 sum = zero();
    Vec3x8 torque = zero3();
    for (int i = 0; i < 4; ++i) {
        const f32x8 change = select(holds, held.change[i], zero());
        store(block.impulse[i], load(block.impulse[i]) + change);
        store(block.total_impulse[i], load(block.total_impulse[i]) + change);
        sum += change;
        torque = torque + change * load3(block.arm[i]);
    }
    apply_normal(block, normal, cross(d, normal), sum, torque, a, b);
}

// Friction at the load: the mean of the points, weighted by their impulses. The rows stand at the friction center,
// which is fixed for the step; the load is e beside it, and the limit is its. The slip is that of the middle of the
// substep, half of which d is ahead of: by the slip of its end, what rides on a turntable crept inward.
template <int N>
CAIRN_INLINE void solve_friction(ContactBlock<N>& block, const PointSums& sums, Vec3x8 normal,
                                 const ContactSoftness& softness, Velocityx8& a, Velocityx8& b) {
    const Vec3x8 center = load3(block.center), d = load3(block.d), t1 = load3(block.tangent), t2 = cross(t1, normal);
    const Vec3x8 dw = b.w - a.w, dv = b.v - a.v;
    Vec3x8 velocity = dv + cross(dw, center) + cross(b.w, d + splat(0.5f * softness.h) * dv);
    if (block.turns) velocity = velocity + slip_of_turning(block, softness.middle);
    if (has_rims(block)) velocity = velocity + slip_of_rims(block, dw);
    const FrictionImpulse slip = {dot(velocity, t1), dot(velocity, t2), dot(normal, dw)};
    const FrictionImpulse old = {load(block.tangent_impulse[0]), load(block.tangent_impulse[1]),
                                 load(block.torsion_impulse)};
    const Load at = load_of(block, sums, center, t1, t2);
    const f32x8 sticks = load(block.static_friction) * at.sum, limit = load(block.friction) * at.sum;
    // Without a load there is none. A slip of which the square is too small for a float is not seen to slide.
    const mask8 pressed = at.sum > splat(least_load);
    const auto impulse = [&](const Sym3x8& k) {
        const FrictionImpulse p = friction_impulse(k, at, slip, old, sticks, limit);
        return FrictionImpulse{select(pressed, p.t1, zero()), select(pressed, p.t2, zero()),
                               select(pressed, p.couple, zero())};
    };
    const Sym3x8 alone = load6(block.friction_coupling);
    mask8 may_hold = mask_from_bits(0);
    if constexpr (N > 1) may_hold = pressed & points_that_hold(block);
    FrictionImpulse now = {zero(), zero(), zero()};
    if constexpr (N > 1) {
        if (any(may_hold)) {
            now = impulse(select(may_hold, load6(block.held_coupling), alone));
            const HeldNormals held =
                held_normals(block, {now.t1 - old.t1, now.t2 - old.t2, now.couple - old.couple}, normal, t1, t2);
            change_normals(block, held, normal, d, may_hold & held.holds, a, b);
            const mask8 tips = and_not(may_hold, held.holds);
            if (any(tips)) {
                const FrictionImpulse p = impulse(alone);
                now = {select(tips, p.t1, now.t1), select(tips, p.t2, now.t2), select(tips, p.couple, now.couple)};
            }
        }
    }
    if (any(pressed) && !any(may_hold)) now = impulse(alone);
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
