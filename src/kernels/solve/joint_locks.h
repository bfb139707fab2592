// The couplings between the rows of one joint. Rows that are solved one after the other as if each were alone undo each
// other's work: with a small ball at the end of an arm, a limit rotates the ball about its own center, and the point
// that holds the arm reverses that, so that a thousandth of the limit's correction is left. Therefore each row of a
// joint acts together with those impulses of the rows after it that keep their velocities unchanged, and a single joint
// is solved at once. With the rows in the order axes, turn, point, this is the block elimination of J M^-1 J^T, which
// is exact for two bodies.
#pragma once

#include "kernels/solve/joint.h"

namespace cairn::CAIRN_ISA {

// -[r] m [r] for a symmetric m, where [r] u = r x u.
CAIRN_INLINE Sym3x8 squared_arm(const Sym3x8& m, Vec3x8 r) {
    // The columns of m [r], m (r x e_i) negated, and again crossed with r.
    const Vec3x8 x = {m.xy * r.z - m.xz * r.y, m.yy * r.z - m.yz * r.y, m.yz * r.z - m.zz * r.y};
    const Vec3x8 y = {m.xz * r.x - m.xx * r.z, m.yz * r.x - m.xy * r.z, m.zz * r.x - m.xz * r.z};
    const Vec3x8 z = {m.xx * r.y - m.xy * r.x, m.xy * r.y - m.yy * r.x, m.xz * r.y - m.yz * r.x};
    // e_i . (r x ...) with signs so that the result is positive.
    return {r.z * x.y - r.y * x.z, r.z * y.y - r.y * y.z, r.z * z.y - r.y * z.z,
            r.x * y.z - r.z * y.x, r.x * z.z - r.z * z.x, r.y * z.x - r.x * z.y};
}
CAIRN_INLINE Sym3x8 even_squared_arm(f32x8 i, Vec3x8 r) {
    const Vec3x8 s = i * r;
    const f32x8 xx = s.x * r.x, yy = s.y * r.y, zz = s.z * r.z;
    return {yy + zz, -(s.x * r.y), -(s.x * r.z), xx + zz, -(s.y * r.z), xx + yy};
}
CAIRN_INLINE Sym3x8 difference(const Sym3x8& a, const Sym3x8& b) {
    return {a.xx - b.xx, a.xy - b.xy, a.xz - b.xz, a.yy - b.yy, a.yz - b.yz, a.zz - b.zz};
}
CAIRN_INLINE Sym3x8 sum(const Sym3x8& a, const Sym3x8& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}
CAIRN_INLINE Sym3x8 zero6() { return {zero(), zero(), zero(), zero(), zero(), zero()}; }

// Relative error of a difference of 32-bit floats after the operations here: differences that are smaller, relative to
// the operands, are noise.
constexpr float rounding = 1e-6f;

// The arms from the centers of mass to the joint's point.
struct Arms8 {
    Vec3x8 a, b;
};
// K_pp: the relative velocity at the point per unit impulse there.
CAIRN_INLINE Sym3x8 slip_by_push(const Massesx8& m, const Arms8& arm) {
    const f32x8 both = m.mass_a + m.mass_b;
    const Sym3x8 linear = {both, zero(), zero(), both, zero(), both};
    return sum(linear, sum(squared_arm(m.inertia_a, arm.a), squared_arm(m.inertia_b, arm.b)));
}
// K_pt and its transpose: the relative velocity at the point by an angular impulse p, and the relative angular velocity
// by an impulse p at the point.
CAIRN_INLINE Vec3x8 slip_by_turn(const Massesx8& m, const Arms8& arm, Vec3x8 p) {
    return cross(m.inertia_b * p, arm.b) + cross(m.inertia_a * p, arm.a);
}
CAIRN_INLINE Vec3x8 turn_by_push(const Massesx8& m, const Arms8& arm, Vec3x8 p) {
    return m.inertia_b * cross(arm.b, p) + m.inertia_a * cross(arm.a, p);
}

// The elimination of a joint's turn from its point: an impulse p at the point acts together with the angular impulse
// -D^T p, which keeps the relative angular velocity unchanged. `slip` is the remainder of K_pp.
struct HeldTurn {
    Mat3x8 d;    // D = K_pt K_tt^-1
    Sym3x8 slip; // K_pp - D K_tp
};
// `turn`: K_tt^-1, zero about a free axis. Where the arms are so long relative to the bodies that `slip` would be
// nothing but rounding, the point is solved alone.
CAIRN_INLINE HeldTurn hold_turn(const Massesx8& m, const Arms8& arm, const Sym3x8& turn) {
    const Sym3x8 k = slip_by_push(m, arm);
    const Mat3x8 by_turn = {slip_by_turn(m, arm, {turn.xx, turn.xy, turn.xz}),
                            slip_by_turn(m, arm, {turn.xy, turn.yy, turn.yz}),
                            slip_by_turn(m, arm, {turn.xz, turn.yz, turn.zz})};
    const Vec3x8 x = by_turn * turn_by_push(m, arm, {one(), zero(), zero()}),
                 y = by_turn * turn_by_push(m, arm, {zero(), one(), zero()}),
                 z = by_turn * turn_by_push(m, arm, {zero(), zero(), one()});
    const mask8 is_known = splat(rounding) * (k.xx + (k.yy + k.zz)) < m.mass_a + m.mass_b;
    const Sym3x8 left = {k.xx - x.x, k.xy - y.x, k.xz - z.x, k.yy - y.y, k.yz - z.y, k.zz - z.z};
    return {{select(is_known, by_turn.c0, zero3()), select(is_known, by_turn.c1, zero3()),
             select(is_known, by_turn.c2, zero3())},
            select(is_known, left, k)};
}
// The impulse at the point per relative velocity there; zero along a free axis.
CAIRN_INLINE Sym3x8 response_of(const HeldTurn& held, Vec3x8 free_axis) {
    return inverse_across(held.slip, free_axis, [](const Sym3x8& q) { return inverse_by_pivots(q); });
}
CAIRN_INLINE Sym3x8 response_of_turn(const Massesx8& m, Vec3x8 free_axis) {
    return inverse_across(sum(m.inertia_a, m.inertia_b), free_axis);
}

} // namespace cairn::CAIRN_ISA
