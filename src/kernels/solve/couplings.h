// The couplings of a contact's constraint rows: the relative velocity along one row that a unit impulse along another
// one causes.
#pragma once

#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

struct Inertiax8 {
    f32x8 inverse_mass;
    Sym3x8 inverse_inertia;
};

// The reciprocal of x where x > 0, else 0.
CAIRN_INLINE f32x8 safe_reciprocal(f32x8 x) {
    const mask8 positive = x > zero();
    return select(positive, one() / select(positive, x, one()), zero());
}

// The opening velocity at a point per unit normal impulse there; j_a and j_b are the arms times the normal.
CAIRN_INLINE f32x8 normal_coupling(Vec3x8 j_a, Vec3x8 j_b, const Inertiax8& a, const Inertiax8& b) {
    return (a.inverse_mass + b.inverse_mass) + dot(a.inverse_inertia * j_a, j_a) + dot(b.inverse_inertia * j_b, j_b);
}

// The tangential and torsional rows at the friction center: the inverse of the tangential 2x2 matrix, the effective
// mass of the torsional row, and its couplings with the tangential rows.
struct FrictionCouplings {
    f32x8 m11, m12, m22, torsion, with_1, with_2;
};
CAIRN_INLINE FrictionCouplings friction_couplings(Vec3x8 normal, Vec3x8 center, Vec3x8 center_b, Vec3x8 t1, Vec3x8 t2,
                                                  const Inertiax8& a, const Inertiax8& b) {
    const Vec3x8 a1 = cross(center, t1), a2 = cross(center, t2), b1 = cross(center_b, t1), b2 = cross(center_b, t2);
    const Vec3x8 ia_1 = a.inverse_inertia * a1, ia_2 = a.inverse_inertia * a2;
    const Vec3x8 ib_1 = b.inverse_inertia * b1, ib_2 = b.inverse_inertia * b2;
    const f32x8 mass_sum = a.inverse_mass + b.inverse_mass;
    const f32x8 k11 = mass_sum + dot(a1, ia_1) + dot(b1, ib_1), k22 = mass_sum + dot(a2, ia_2) + dot(b2, ib_2);
    const f32x8 k12 = dot(a1, ia_2) + dot(b1, ib_2);
    const f32x8 inverse_determinant = safe_reciprocal(k11 * k22 - k12 * k12);
    const Vec3x8 ia_n = a.inverse_inertia * normal, ib_n = b.inverse_inertia * normal;
    return {inverse_determinant * k22,     -(inverse_determinant * k12),
            inverse_determinant * k11,     safe_reciprocal(dot(normal, ia_n) + dot(normal, ib_n)),
            dot(a1, ia_n) + dot(b1, ib_n), dot(a2, ia_n) + dot(b2, ib_n)};
}
template <int N> CAIRN_INLINE void store_couplings(ContactBlock<N>& block, const FrictionCouplings& c) {
    store(block.tangent_mass[0], c.m11);
    store(block.tangent_mass[1], c.m12);
    store(block.tangent_mass[2], c.m22);
    store(block.torsion_mass, c.torsion);
    store(block.torsion_coupling[0], c.with_1);
    store(block.torsion_coupling[1], c.with_2);
}
template <int N> CAIRN_INLINE void store_couplings(ContactBlock<N>& block, mask8 lanes, const FrictionCouplings& c) {
    store_couplings(
        block, {select(lanes, c.m11, load(block.tangent_mass[0])), select(lanes, c.m12, load(block.tangent_mass[1])),
                select(lanes, c.m22, load(block.tangent_mass[2])), select(lanes, c.torsion, load(block.torsion_mass)),
                select(lanes, c.with_1, load(block.torsion_coupling[0])),
                select(lanes, c.with_2, load(block.torsion_coupling[1]))});
}

// The inverse inertia tensor from its form in a block.
CAIRN_INLINE Sym3x8 kept_inertia(bool isotropic, const float (*rows)[8]) {
    if (!isotropic) return load6(rows);
    const f32x8 xx = load(rows[0]);
    return {xx, zero(), zero(), xx, zero(), xx};
}

} // namespace cairn::CAIRN_ISA
