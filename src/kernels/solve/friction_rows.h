// The rows of friction of a contact, found once in a step: along two tangents and about the normal, at the friction
// center. An impulse of friction also turns the bodies, so that their points would part or meet. Where three points or
// four bear, their impulses change with it so that they do not: a cube that is stopped at its foot does not tip, and
// stopping it takes all of its mass. One that is free to tip has 0.4 of it there.
//
// Let q be the impulses of friction, and z those of three more rows: along the normal at the friction center, and what
// a unit along the normal has more of at a distance x or y from there along the tangents. The velocities of these rows
// stay if K_zz z + K_zq q = 0, which leaves friction with
//   K_qq - K_qz K_zz^-1 K_zq,
// the held coupling. The points give z = R p, with columns (1, x, y), and least of all in the sum of squares if
// p = R^T (R R^T)^-1 z: each changes by h_0 + h_1 x + h_2 y, where h = -(R R^T)^-1 K_zz^-1 K_zq q, the held normals.
#pragma once

#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

// The reciprocal of x where x > 0, else 0.
CAIRN_INLINE f32x8 safe_reciprocal(f32x8 x) {
    const mask8 positive = x > zero();
    return select(positive, one() / select(positive, x, one()), zero());
}

struct Inertiax8 {
    f32x8 inverse_mass;
    Sym3x8 inverse_inertia;
};

// Directions of impulses on a contact of two bodies: the moments that they have about the centers of mass, and what the
// inertia makes of these.
template <int N> struct MomentRows { Vec3x8 on_a[N], on_b[N], turned_a[N], turned_b[N]; };
template <int N>
CAIRN_INLINE MomentRows<N> moment_rows(const Vec3x8 (&on_a)[N], const Vec3x8 (&on_b)[N], const Inertiax8& a,
                                       const Inertiax8& b) {
    MomentRows<N> r;
    for (int i = 0; i < N; ++i) {
        r.on_a[i] = on_a[i], r.on_b[i] = on_b[i];
        r.turned_a[i] = a.inverse_inertia * on_a[i], r.turned_b[i] = b.inverse_inertia * on_b[i];
    }
    return r;
}
template <int N, int M> CAIRN_INLINE f32x8 coupling(const MomentRows<N>& x, int i, const MomentRows<M>& y, int j) {
    return dot(x.on_a[i], y.turned_a[j]) + dot(x.on_b[i], y.turned_b[j]);
}

CAIRN_INLINE f32x8 determinant(const Sym3x8& m) {
    return m.xx * (m.yy * m.zz - m.yz * m.yz) +
           (m.xy * (m.xz * m.yz - m.xy * m.zz) + m.xz * (m.xy * m.yz - m.xz * m.yy));
}
CAIRN_INLINE Sym3x8 select(mask8 m, const Sym3x8& a, const Sym3x8& b) {
    return {select(m, a.xx, b.xx), select(m, a.xy, b.xy), select(m, a.xz, b.xz),
            select(m, a.yy, b.yy), select(m, a.yz, b.yz), select(m, a.zz, b.zz)};
}
// 0 where there is none.
CAIRN_INLINE Sym3x8 inverse_of(const Sym3x8& m) {
    const f32x8 xx = m.yy * m.zz - m.yz * m.yz, xy = m.xz * m.yz - m.xy * m.zz, xz = m.xy * m.yz - m.xz * m.yy;
    const f32x8 scale = safe_reciprocal(m.xx * xx + (m.xy * xy + m.xz * xz));
    return {scale * xx,
            scale * xy,
            scale * xz,
            scale * (m.xx * m.zz - m.xz * m.xz),
            scale * (m.xy * m.xz - m.xx * m.yz),
            scale * (m.xx * m.yy - m.xy * m.xy)};
}

// Of four points: their places x and y, in units of `lever`, the root of the sum of their squares, and R R^T.
struct PointPlaces {
    f32x8 lever, inverse_lever, count, x[4], y[4];
    Sym3x8 products;
};
CAIRN_INLINE PointPlaces places_of(const ContactBlock<4>& block, Vec3x8 arm_of_center, Vec3x8 t1, Vec3x8 t2) {
    PointPlaces r;
    f32x8 squares = zero();
    r.count = zero();
    for (int i = 0; i < 4; ++i) {
        const f32x8 used = select(load(block.effective_mass[i]) > zero(), one(), zero());
        const Vec3x8 e = used * (load3(block.arm[i]) - arm_of_center); // (x t1 + y t2) x normal
        r.x[i] = dot(e, t2), r.y[i] = -dot(e, t1);
        r.count += used;
        squares += r.x[i] * r.x[i] + r.y[i] * r.y[i];
    }
    r.lever = sqrt(squares);
    r.inverse_lever = safe_reciprocal(r.lever);
    r.products = {r.count, zero(), zero(), zero(), zero(), zero()};
    Sym3x8& m = r.products;
    for (int i = 0; i < 4; ++i) {
        const f32x8 x = r.x[i] = r.inverse_lever * r.x[i], y = r.y[i] = r.inverse_lever * r.y[i];
        m.xy += x, m.xz += y, m.yy += x * x, m.yz += x * y, m.zz += y * y;
    }
    return r;
}

// Impulses of four points that do nothing together: of each as much as the other three span, to and fro. 0 where those
// lie in a line, as they do not hold the fourth then.
CAIRN_INLINE void find_null_impulse(ContactBlock<4>& block, const PointPlaces& at) {
    constexpr float in_a_line = 1e-3f; // of the greatest
    const auto area = [&](int i, int j, int k) {
        return at.x[i] * (at.y[j] - at.y[k]) + (at.x[j] * (at.y[k] - at.y[i]) + at.x[k] * (at.y[i] - at.y[j]));
    };
    const f32x8 areas[4] = {-area(1, 2, 3), area(0, 2, 3), -area(0, 1, 3), area(0, 1, 2)};
    f32x8 greatest = zero();
    for (const f32x8& i : areas) greatest = max(greatest, abs(i));
    const f32x8 scale = select(at.count > splat(3.5f), safe_reciprocal(greatest), zero());
    for (int i = 0; i < 4; ++i) {
        const f32x8 p = scale * areas[i];
        store(block.null_impulse[i], select(abs(p) > splat(in_a_line), p, zero()));
    }
}

// `friction`: its rows, of which K is `k`; `normal`: the three of the normal direction.
CAIRN_INLINE void hold_points(ContactBlock<4>& block, const MomentRows<3>& friction, const PointPlaces& at,
                              const MomentRows<3>& normal, f32x8 mass_sum, const Sym3x8& k) {
    constexpr float in_a_line = 1e-5f; // of what the places span: 1/4 if they are as far apart one way as the other
    const Sym3x8& p = at.products;
    block.spans = bits(determinant(p) > splat(in_a_line));
    const f32x8 unit = safe_reciprocal(mass_sum); // so that no product of three is out of range
    const auto couple = [&](int i, int j) { return unit * coupling(normal, i, normal, j); };
    const Sym3x8 inverse =
        inverse_of({one() + couple(0, 0), couple(0, 1), couple(0, 2), couple(1, 1), couple(1, 2), couple(2, 2)});
    const Sym3x8 to_points = inverse_of(p);
    Vec3x8 with_normal[3], held[3]; // one for each row of friction
    for (int j = 0; j < 3; ++j) {
        with_normal[j] = {coupling(normal, 0, friction, j), coupling(normal, 1, friction, j),
                          coupling(normal, 2, friction, j)};
        held[j] = -(inverse * (unit * with_normal[j]));
        const Vec3x8 of_points = to_points * held[j];
        store(block.held_normal[j], of_points.x);
        store(block.held_normal[3 + j], at.inverse_lever * of_points.y);
        store(block.held_normal[6 + j], at.inverse_lever * of_points.z);
    }
    const auto held_k = [&](int i, int j) { return dot(with_normal[i], held[j]); };
    store6(block.held_coupling, {k.xx + held_k(0, 0), k.xy + held_k(0, 1), k.xz + held_k(0, 2), k.yy + held_k(1, 1),
                                 k.yz + held_k(1, 2), k.zz + held_k(2, 2)});
    find_null_impulse(block, at);
}

template <int N>
CAIRN_INLINE void couple_friction(ContactBlock<N>& block, Vec3x8 normal, Vec3x8 center, Vec3x8 center_b, Vec3x8 t1,
                                  Vec3x8 t2, const Inertiax8& a, const Inertiax8& b) {
    const f32x8 mass_sum = a.inverse_mass + b.inverse_mass;
    const MomentRows<3> friction = moment_rows<3>({cross(center, t1), cross(center, t2), normal},
                                                  {cross(center_b, t1), cross(center_b, t2), normal}, a, b);
    const auto k = [&](int i, int j) { return coupling(friction, i, friction, j); };
    const Sym3x8 all = {mass_sum + k(0, 0), k(0, 1), k(0, 2), mass_sum + k(1, 1), k(1, 2), k(2, 2)};
    store6(block.friction_coupling, all);
    if constexpr (N > 1) {
        const Vec3x8 along_a = cross(center, normal), along_b = cross(center_b, normal);
        const PointPlaces at = places_of(block, along_a, t1, t2);
        const Vec3x8 by_x = at.lever * t2, by_y = -(at.lever * t1); // a tangent x the normal
        hold_points(block, friction, at, moment_rows<3>({along_a, by_x, by_y}, {along_b, by_x, by_y}, a, b), mass_sum,
                    all);
    }
}

} // namespace cairn::CAIRN_ISA
