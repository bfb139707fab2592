// Points: the anchors of two bodies are kept together, in all directions or across an axis of A. With p the impulse on
// B, c = (v_B + w_B x r_B) - (v_A + w_A x r_A) and K = (1/m_A + 1/m_B) 1 - [r_A] I_A^-1 [r_A] - [r_B] I_B^-1 [r_B].
// Where an axis is left free, r_A reaches to the anchor of B along it, and both c and p are taken across it.
#include "kernels/joint.h"

namespace cairn::CAIRN_ISA {

namespace {

// -[r] m [r], for a symmetric m.
CAIRN_INLINE Sym3x8 squared_arm(const Sym3x8& m, Vec3x8 r) {
    // The columns of m [r]: m (r x e_i) negated, and again crossed with r.
    const Vec3x8 x = m * Vec3x8{zero(), r.z, -r.y}, y = m * Vec3x8{-r.z, zero(), r.x},
                 z = m * Vec3x8{r.y, -r.x, zero()};
    // e_i . (r x ...) with signs so that the result is positive.
    return {r.z * x.y - r.y * x.z, r.z * y.y - r.y * y.z, r.z * z.y - r.y * z.z,
            r.x * y.z - r.z * y.x, r.x * z.z - r.z * z.x, r.y * z.x - r.x * z.y};
}
CAIRN_INLINE Sym3x8 even_squared_arm(f32x8 i, Vec3x8 r) {
    const Vec3x8 s = i * r;
    const f32x8 xx = s.x * r.x, yy = s.y * r.y, zz = s.z * r.z;
    return {yy + zz, -(s.x * r.y), -(s.x * r.z), xx + zz, -(s.y * r.z), xx + yy};
}
CAIRN_INLINE Sym3x8 sum(const Sym3x8& a, const Sym3x8& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}

CAIRN_INLINE void apply(const PointBlock& b, Vec3x8 arm_a, Vec3x8 arm_b, Vec3x8 p, Ends8& e) {
    e.a.v = e.a.v - load(b.mass_a) * p;
    e.b.v = e.b.v + load(b.mass_b) * p;
    e.a.w = e.a.w - inertia_times(b.even, b.inertia_a, cross(arm_a, p));
    e.b.w = e.b.w + inertia_times(b.even, b.inertia_b, cross(arm_b, p));
}
CAIRN_INLINE Vec3x8 slip_at(const Ends8& e, Vec3x8 arm_a, Vec3x8 arm_b) {
    return (e.b.v - e.a.v) + (cross(e.b.w, arm_b) - cross(e.a.w, arm_a));
}

// Arms, gap and response of the poses now.
template <bool FreeAxis> CAIRN_INLINE void refresh(PointBlock& b, const Posesx8& poses, const Massesx8& masses) {
    const Vec3x8 arm_a0 = load3(b.arm_a0), arm_b0 = load3(b.arm_b0);
    const Vec3x8 change_a = turned_difference(poses.dq_a, arm_a0), change_b = turned_difference(poses.dq_b, arm_b0);
    Vec3x8 arm_a = arm_a0 + change_a, gap = load3(b.gap0) + ((poses.dx_b - poses.dx_a) + (change_b - change_a));
    const Vec3x8 arm_b = arm_b0 + change_b;
    Vec3x8 axis = zero3();
    if constexpr (FreeAxis) {
        const Vec3x8 axis0 = load3(b.axis0);
        axis = axis0 + turned_difference(poses.dq_a, axis0);
        const Vec3x8 along = dot(axis, gap) * axis;
        arm_a = arm_a + along;
        gap = gap - along;
    }
    store3(b.arm_a, arm_a);
    store3(b.arm_b, arm_b);
    store3(b.gap, gap);
    const f32x8 m = masses.mass_a + masses.mass_b;
    Sym3x8 k = {m, zero(), zero(), m, zero(), m};
    if (b.even)
        k = sum(k, sum(even_squared_arm(masses.inertia_a.xx, arm_a), even_squared_arm(masses.inertia_b.xx, arm_b)));
    else
        k = sum(k, sum(squared_arm(masses.inertia_a, arm_a), squared_arm(masses.inertia_b, arm_b)));
    if constexpr (FreeAxis)
        store6(b.response, inverse_across(k, axis));
    else
        store6(b.response, inverse(k));
}

template <bool FreeAxis> void warm_start_block(PointBlock& b, const SolverBodies& bodies) {
    const Massesx8 masses = renew_masses(b, bodies.inertia);
    b.even = is_even(masses.inertia_a) && is_even(masses.inertia_b);
    refresh<FreeAxis>(b, gather_poses(bodies.pose, b), masses);
    Vec3x8 p = load3(b.impulse);
    if constexpr (FreeAxis) p = across(load3(b.axis0), p);
    store3(b.impulse, p);
    store3(b.total, zero3());
    Ends8 e = gather_ends(bodies.velocity, b);
    apply(b, load3(b.arm_a), load3(b.arm_b), p, e);
    scatter_ends(bodies.velocity, b, e);
}

void warm_start(void* blocks, int count, const SolverBodies& bodies, const JointSoftness&) {
    auto* all = static_cast<PointBlock*>(blocks);
    for (int k = 0; k < count; ++k)
        all[k].free_axis ? warm_start_block<true>(all[k], bodies) : warm_start_block<false>(all[k], bodies);
}

void solve(void* blocks, int count, SolverVelocity* velocity, const JointSoftness& softness) {
    auto* all = static_cast<PointBlock*>(blocks);
    const f32x8 rate = splat(softness.rate), scale = splat(softness.scale), rest = splat(1 - softness.scale);
    for (int k = 0; k < count; ++k) {
        PointBlock& b = all[k];
        Ends8 e = gather_ends(velocity, b);
        e.a.w = e.a.w + load3(b.left_a);
        e.b.w = e.b.w + load3(b.left_b);
        if (b.free_axis) {
            e.a.v = e.a.v - load(b.mass_a) * load3(b.left_linear);
            e.b.v = e.b.v + load(b.mass_b) * load3(b.left_linear);
        }
        const Vec3x8 arm_a = load3(b.arm_a), arm_b = load3(b.arm_b), p = load3(b.impulse);
        const Vec3x8 c = slip_at(e, arm_a, arm_b) + rate * load3(b.gap);
        const Vec3x8 d = -(scale * (load6(b.response) * c)) - rest * p;
        store3(b.impulse, p + d);
        apply(b, arm_a, arm_b, d, e);
        scatter_ends(velocity, b, e);
    }
}

// The impulse across the axis as it is now, and what the new arms and axis change of what is carried.
template <bool FreeAxis>
CAIRN_INLINE Vec3x8 turn_along(PointBlock& b, const Posesx8& poses, const SolverBodies& bodies) {
    const Vec3x8 old_a = load3(b.arm_a), old_b = load3(b.arm_b), old = load3(b.impulse);
    Vec3x8 p = old;
    if constexpr (FreeAxis) {
        const Vec3x8 axis0 = load3(b.axis0);
        p = across(axis0 + turned_difference(poses.dq_a, axis0), old);
    }
    Vec3x8 wa, wb;
    if (b.even) {
        refresh<FreeAxis>(b, poses, load_masses(b));
        wa = load(b.inertia_a[0]) * (cross(old_a, old) - cross(load3(b.arm_a), p));
        wb = load(b.inertia_b[0]) * (cross(load3(b.arm_b), p) - cross(old_b, old));
    } else {
        wa = load6(b.inertia_a) * cross(old_a, old);
        wb = -(load6(b.inertia_b) * cross(old_b, old));
        refresh<FreeAxis>(b, poses, renew_masses(b, bodies.inertia));
        wa = wa - load6(b.inertia_a) * cross(load3(b.arm_a), p);
        wb = wb + load6(b.inertia_b) * cross(load3(b.arm_b), p);
    }
    store3(b.left_a, wa);
    store3(b.left_b, wb);
    if constexpr (FreeAxis) store3(b.left_linear, p - old);
    return p;
}

template <bool FreeAxis> CAIRN_INLINE void relax_block(PointBlock& b, const SolverBodies& bodies) {
    const Vec3x8 old = turn_along<FreeAxis>(b, gather_poses(bodies.pose, b), bodies);
    const Vec3x8 arm_a = load3(b.arm_a), arm_b = load3(b.arm_b);
    Ends8 e = gather_ends(bodies.velocity, b);
    const Vec3x8 d = -(load6(b.response) * slip_at(e, arm_a, arm_b)), p = old + d;
    store3(b.impulse, p);
    store3(b.total, load3(b.total) + p);
    apply(b, arm_a, arm_b, d, e);
    scatter_ends(bodies.velocity, b, e);
}

void relax(void* blocks, int count, const SolverBodies& bodies, const JointSoftness&) {
    auto* all = static_cast<PointBlock*>(blocks);
    for (int k = 0; k < count; ++k)
        all[k].free_axis ? relax_block<true>(all[k], bodies) : relax_block<false>(all[k], bodies);
}

void strike(void* blocks, JointImpact* impacts, int count, SolverVelocity* velocity, float) {
    auto* all = static_cast<PointBlock*>(blocks);
    for (int k = 0; k < count; ++k) {
        if (!impacts[k].active) continue;
        PointBlock& b = all[k];
        const Vec3x8 arm_a = load3(b.arm_a), arm_b = load3(b.arm_b);
        Ends8 e = gather_ends(velocity, b);
        const Vec3x8 p = splat(-impact_relaxation) * (load6(b.response) * slip_at(e, arm_a, arm_b));
        const Vec3x8 d = select(mask_from_bits(impacts[k].active), p, zero3());
        store3(b.total, load3(b.total) + d);
        apply(b, arm_a, arm_b, d, e);
        scatter_ends(velocity, b, e);
    }
}

} // namespace

JointKernels::ForRows point_kernels() { return {warm_start, solve, relax, strike}; }

JointKernels joint_kernels() { return {point_kernels(), turn_kernels(), axis_kernels()}; }

} // namespace cairn::CAIRN_ISA
