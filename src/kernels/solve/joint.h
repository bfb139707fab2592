// Helpers of the joint kernels. The impulses of a substep are carried into the next one as the difference of the
// velocities and the reference (integrate.cpp), which is M^-1 J^T impulse. When a Jacobian is updated to new poses, the
// resulting difference is left for the next solve: the substep then begins as if it had been warm started with the new
// Jacobian. The present velocities are not changed, or a pendulum would lose energy in every substep.
#pragma once

#include "kernels/solve/joint_data.h"
#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

JointKernels joint_kernels();
JointKernels::ForRows point_kernels();
JointKernels::ForRows turn_kernels();
JointKernels::ForRows axis_kernels();

// Current inverse masses and inertias of both bodies.
struct Massesx8 {
    f32x8 mass_a, mass_b;
    Sym3x8 inertia_a, inertia_b;
};
CAIRN_INLINE void gather_mass(const SolverInertia* rows, const std::uint32_t* offset, f32x8& mass, Sym3x8& i) {
    const float* p[8];
    f32x8 unused;
    for (int k = 0; k < 8; ++k) p[k] = &row_at(rows, offset[k]).inverse_mass;
    gather4(p, mass, i.xx, i.xy, i.xz);
    for (int k = 0; k < 8; ++k) p[k] += 4;
    gather4(p, i.yy, i.yz, i.zz, unused);
}
template <class Block> CAIRN_INLINE Massesx8 renew_masses(Block& block, const SolverInertia* rows) {
    Massesx8 m;
    gather_mass(rows, block.a, m.mass_a, m.inertia_a);
    gather_mass(rows, block.b, m.mass_b, m.inertia_b);
    store(block.mass_a, m.mass_a);
    store(block.mass_b, m.mass_b);
    store6(block.rest.inertia_a, m.inertia_a);
    store6(block.rest.inertia_b, m.inertia_b);
    return m;
}
// Whether the tensors of all lanes are multiples of 1.
CAIRN_INLINE bool is_isotropic(const Sym3x8& m) {
    const mask8 isotropic = (m.xx == m.yy) & (m.xx == m.zz) & (m.xy == zero()) & (m.xz == zero()) & (m.yz == zero());
    return all(isotropic);
}
// Gathers masses at the start of a step. Of isotropic tensors only the moments are stored.
template <class Block> CAIRN_INLINE Massesx8 first_masses(Block& block, const SolverInertia* rows) {
    const Massesx8 m = renew_masses(block, rows);
    block.isotropic = is_isotropic(m.inertia_a) && is_isotropic(m.inertia_b);
    store(block.isotropic_a, m.inertia_a.xx);
    store(block.isotropic_b, m.inertia_b.xx);
    return m;
}
template <class Block> CAIRN_INLINE Massesx8 load_masses(const Block& block) {
    return {load(block.mass_a), load(block.mass_b), load6(block.rest.inertia_a), load6(block.rest.inertia_b)};
}
// The inverse inertia tensor of A or of B times a vector.
template <class Block> CAIRN_INLINE Vec3x8 turned_a(const Block& block, Vec3x8 u) {
    return block.isotropic ? load(block.isotropic_a) * u : load6(block.rest.inertia_a) * u;
}
template <class Block> CAIRN_INLINE Vec3x8 turned_b(const Block& block, Vec3x8 u) {
    return block.isotropic ? load(block.isotropic_b) * u : load6(block.rest.inertia_b) * u;
}

struct Posesx8 {
    Vec3x8 dx_a, dx_b;
    Quatx8 dq_a, dq_b;
};
CAIRN_INLINE Posesx8 gather_poses(const SolverPose* rows, const JointEnds& ends) {
    Posesx8 r;
    f32x8 unused;
    const float *a[8], *b[8];
    for (int i = 0; i < 8; ++i) a[i] = row_at(rows, ends.a[i]).dx, b[i] = row_at(rows, ends.b[i]).dx;
    gather4(a, r.dx_a.x, r.dx_a.y, r.dx_a.z, unused);
    gather4(b, r.dx_b.x, r.dx_b.y, r.dx_b.z, unused);
    for (int i = 0; i < 8; ++i) a[i] += 4, b[i] += 4;
    gather4(a, r.dq_a.v.x, r.dq_a.v.y, r.dq_a.v.z, r.dq_a.w);
    gather4(b, r.dq_b.v.x, r.dq_b.v.y, r.dq_b.v.z, r.dq_b.w);
    return r;
}

// R(q) v - v, without cancellation.
CAIRN_INLINE Vec3x8 turned_difference(Quatx8 q, Vec3x8 v) {
    const Vec3x8 g = cross(q.v, v);
    return splat(2.0f) * (cross(q.v, g) + q.w * g);
}

struct Ends8 {
    Velocityx8 a, b;
};
CAIRN_INLINE Ends8 gather_ends(const SolverVelocity* rows, const JointEnds& ends) {
    return {gather_velocity(rows, ends.a), gather_velocity(rows, ends.b)};
}

// The lanes of a block to be solved: all of them, or some. Velocities are written to the rows at the offsets to_a and
// to_b.
struct AllLanes {
    static constexpr bool is_solved_first = true;
    const std::uint32_t *to_a, *to_b;
};
struct SomeLanes {
    mask8 mask;
    bool is_solved_first; // whether these lanes are the first of the block to be solved: then quantities of the poses
                          // are computed for all of its lanes
    const std::uint32_t *to_a, *to_b;
};
CAIRN_INLINE f32x8 among(AllLanes, f32x8 value, f32x8) { return value; }
CAIRN_INLINE f32x8 among(SomeLanes lanes, f32x8 value, f32x8 other) { return select(lanes.mask, value, other); }
template <class Lanes> CAIRN_INLINE Vec3x8 among(Lanes lanes, Vec3x8 value, Vec3x8 other) {
    return {among(lanes, value.x, other.x), among(lanes, value.y, other.y), among(lanes, value.z, other.z)};
}
template <class Block> CAIRN_INLINE AllLanes all_of(const Block& block) {
    return {block.redirects ? block.rest.write_a : block.a, block.redirects ? block.rest.write_b : block.b};
}
// Calls f(block, its lanes) for the blocks of a run.
template <class Block, class F> CAIRN_INLINE void for_lanes(const JointBlocks& run, F&& f) {
    auto* const blocks = static_cast<Block*>(run.blocks);
    const int last = run.count - 1, whole = run.part ? last : run.count;
    for (int k = 0; k < whole; ++k) f(blocks[k], all_of(blocks[k]));
    if (!run.part) return;
    const PartLanes& own = *run.part;
    f(blocks[last], SomeLanes{mask_from_bits(own.lanes), (own.lanes & 1) != 0, own.to_a, own.to_b});
}

template <class Lanes> CAIRN_INLINE void scatter_ends(SolverVelocity* rows, Lanes lanes, const Ends8& e) {
    scatter_velocity(rows, lanes.to_a, e.a);
    scatter_velocity(rows, lanes.to_b, e.b);
}

CAIRN_INLINE f32x8 guarded_inverse(f32x8 x, mask8 valid) {
    return select(valid, one() / select(valid, x, one()), zero());
}

// Inverse of a symmetric positive definite matrix, by cofactors; zero where it has none.
CAIRN_INLINE Sym3x8 inverse(const Sym3x8& m) {
    const f32x8 xx = m.yy * m.zz - m.yz * m.yz, xy = m.xz * m.yz - m.xy * m.zz, xz = m.xy * m.yz - m.xz * m.yy;
    const f32x8 determinant = m.xx * xx + (m.xy * xy + m.xz * xz);
    const f32x8 s = guarded_inverse(determinant, determinant > zero());
    return {s * xx,
            s * xy,
            s * xz,
            s * (m.xx * m.zz - m.xz * m.xz),
            s * (m.xy * m.xz - m.xx * m.yz),
            s * (m.xx * m.yy - m.xy * m.xy)};
}

// The inverse by L D L^T. Where one eigenvalue is much greater than the others, cofactors cancel; the error here is no
// more than the rounding of the greatest.
CAIRN_INLINE Sym3x8 inverse_by_pivots(const Sym3x8& m) {
    const f32x8 p = guarded_inverse(m.xx, m.xx > zero()), lyx = m.xy * p, lzx = m.xz * p;
    const f32x8 yy = m.yy - lyx * m.xy, yz = m.yz - lyx * m.xz;
    const f32x8 q = guarded_inverse(yy, yy > zero()), lzy = yz * q;
    const f32x8 zz = (m.zz - lzx * m.xz) - lzy * yz, r = guarded_inverse(zz, zz > zero());
    // The inverse of L has -lyx, -lzy and `low` below its diagonal.
    const f32x8 low = lyx * lzy - lzx, lr = low * r, lq = lyx * q, yr = lzy * r;
    return {p + (lq * lyx + lr * low), -(lq + lr * lzy), lr, q + yr * lzy, -yr, r};
}

// With P = 1 - a a^T: the inverse of P m P on the plane perpendicular to the unit vector a, zero along a. With u = m a
// and t = a.u, the matrix Q = m - a u^T - u a^T + 2 t a a^T is P m P + t a a^T; the result is its inverse less
// a a^T / t.
template <class Inverse> CAIRN_INLINE Sym3x8 inverse_across(const Sym3x8& m, Vec3x8 a, Inverse&& inverse_of) {
    const Vec3x8 u = m * a;
    const f32x8 t = dot(a, u), t2 = t + t;
    const Sym3x8 q = {m.xx + a.x * (t2 * a.x - (u.x + u.x)),
                      m.xy + (t2 * a.x * a.y - (a.x * u.y + u.x * a.y)),
                      m.xz + (t2 * a.x * a.z - (a.x * u.z + u.x * a.z)),
                      m.yy + a.y * (t2 * a.y - (u.y + u.y)),
                      m.yz + (t2 * a.y * a.z - (a.y * u.z + u.y * a.z)),
                      m.zz + a.z * (t2 * a.z - (u.z + u.z))};
    Sym3x8 r = inverse_of(q);
    const f32x8 s = guarded_inverse(t, t > zero());
    const Vec3x8 sa = s * a;
    return {r.xx - sa.x * a.x, r.xy - sa.x * a.y, r.xz - sa.x * a.z,
            r.yy - sa.y * a.y, r.yz - sa.y * a.z, r.zz - sa.z * a.z};
}

CAIRN_INLINE Sym3x8 inverse_across(const Sym3x8& m, Vec3x8 a) {
    return inverse_across(m, a, [](const Sym3x8& q) { return inverse(q); });
}

CAIRN_INLINE Vec3x8 across(Vec3x8 a, Vec3x8 v) { return v - dot(a, v) * a; }

CAIRN_INLINE Quatx8 conjugate(Quatx8 q) { return {-q.v, q.w}; }
CAIRN_INLINE Quatx8 load_quat(const float (*p)[8]) { return {load3(p), load(p[3])}; }
// The rotation of B's frame relative to A's, in world axes, at the current poses.
CAIRN_INLINE Quatx8 turn_now(const Posesx8& poses, Quatx8 turn0) {
    return multiply(multiply(poses.dq_b, turn0), conjugate(poses.dq_a));
}

} // namespace cairn::CAIRN_ISA
