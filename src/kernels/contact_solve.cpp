// The contact solver's inner loops: warm start, solve (with soft bias) and relax (without), 8 contacts at a
// time. The method is the soft step of Catto ("Solver2D", 2024) with three exact reductions; the derivation
// is in docs/solver.md. In short, for the points i of one contact, with arms j_i for body A and j_i + c for B:
//   normal velocity   v_i  = n.(vB - vA) + c.wB + j_i.(wB - wA)
//   coupling          K_ij = 1/mA + 1/mB + j_i.IA^-1 j_j + (j_i + c).IB^-1 (j_j + c)
// so the points are swept on the four numbers v_i alone, v_j += K_ij d_i, and the bodies change once:
//   vA -= n S/mA, vB += n S/mB, wA -= IA^-1 T, wB += IB^-1 (T + S c),  S = sum d_i, T = sum j_i d_i.
#include "kernels/solver.h"

namespace cairn::CAIRN_ISA {

namespace {

constexpr float tiny = 1e-20f;
constexpr float most_passing = 0.1f; // of B's arm, in one step

// The sums over the points of one sweep.
struct SweepSums {
    f32x8 impulse;    // S
    Vec3x8 torque;    // T
    f32x8 load;       // total normal impulse, for friction
    f32x8 lever_load; // sum of lever times impulse
};

template <int N>
CAIRN_INLINE void normal_velocities(const ContactBlock<N>& block, const Velocityx8& a, const Velocityx8& b,
                                    Vec3x8 normal, Vec3x8 c, f32x8* v, Vec3x8* arm) {
    const Vec3x8 dw = b.w - a.w;
    const f32x8 common = dot(normal, b.v - a.v) + dot(c, b.w);
    for (int i = 0; i < N; ++i) {
        arm[i] = load3(block.arm[i]);
        v[i] = common + dot(arm[i], dw);
    }
}

struct Posex8 {
    Vec3x8 dx;
    Quatx8 dq;
};
CAIRN_INLINE Posex8 gather_pose(const SolverPose* rows, const std::int32_t* row) {
    const float* p[8];
    Posex8 r;
    f32x8 unused;
    for (int i = 0; i < 8; ++i) p[i] = rows[row[i]].dx;
    gather4(p, r.dx.x, r.dx.y, r.dx.z, unused);
    for (int i = 0; i < 8; ++i) p[i] += 4;
    gather4(p, r.dq.v.x, r.dq.v.y, r.dq.v.z, r.dq.w);
    return r;
}
CAIRN_INLINE Vec3x8 turned_back_difference(Quatx8 q, Vec3x8 n) {
    const Vec3x8 g = cross(q.v, n);
    return splat(2.0f) * (cross(q.v, g) - q.w * g);
}
// Separations now, from the motion of both bodies since the start of the step. Exact: the normal, not the
// anchors, is rotated back, and by differences so that nothing cancels: with
// delta(q) = R(q)^T n - n = 2 (q x (q x n) - q_w (q x n)) and D = delta(qB) - delta(qA),
// s_i = s0_i + n.(dxB - dxA) + delta(qB).d + (r_i.n)(D.n) + j_i.(D x n).
// The surface of a sphere does not turn with it: only its center, a radius R from the point, is a point of the body.
// Turning the material point would lift it by R (1 - cos), and a rolling ball would lose its weight; R (delta.n) per
// sphere takes that out again.
// Also brings d and c up to the new poses, so that both bodies are pushed at one point of the world and angular
// momentum is kept while they pass each other; returns by how much d changed.
template <int N>
CAIRN_INLINE Vec3x8 refresh_separations(ContactBlock<N>& block, const SolverPose* pose, Vec3x8 normal, f32x8* s) {
    const Posex8 a = gather_pose(pose, block.a), b = gather_pose(pose, block.b);
    const Vec3x8 delta_a = turned_back_difference(a.dq, normal), delta_b = turned_back_difference(b.dq, normal);
    const Vec3x8 difference = delta_b - delta_a, d0 = load3(block.d0);
    f32x8 common = dot(normal, b.dx - a.dx) + dot(delta_b, d0);
    if constexpr (N == 1)
        common += load(block.radius_a) * dot(delta_a, normal) + load(block.radius_b) * dot(delta_b, normal);
    const Vec3x8 e = cross(difference, normal);
    const f32x8 f = dot(difference, normal);
    for (int i = 0; i < N; ++i) {
        s[i] = load(block.separation0[i]) + (common + (load(block.height[i]) * f + dot(load3(block.arm[i]), e)));
        store(block.separation[i], s[i]);
    }
    // Only as far as the couplings K, which are those of the start, still fit.
    const Vec3x8 passed = a.dx - b.dx, arm_b = load3(block.center) + d0;
    const f32x8 limit = splat(most_passing * most_passing) * dot(arm_b, arm_b), square = dot(passed, passed);
    const mask8 far = square > limit;
    const f32x8 share = select(far, sqrt(limit / select(far, square, one())), one());
    const Vec3x8 d = d0 + share * passed, change = d - load3(block.d);
    store3(block.d, d);
    store3(block.c, cross(d, normal));
    return change;
}

template <int N> void warm_start(const void* blocks, int count, SolverVelocity* velocity) {
    auto* all = static_cast<const ContactBlock<N>*>(blocks);
    for (int k = 0; k < count; ++k) {
        const ContactBlock<N>& block = all[k];
        Velocityx8 a = gather_velocity(velocity, block.a), b = gather_velocity(velocity, block.b);
        const Vec3x8 normal = load3(block.normal), t1 = load3(block.tangent), t2 = cross(t1, normal);
        f32x8 sum = zero();
        Vec3x8 torque = zero3();
        for (int i = 0; i < N; ++i) {
            const f32x8 impulse = load(block.impulse[i]);
            sum += impulse;
            torque = torque + impulse * load3(block.arm[i]);
        }
        apply_normal(block, normal, load3(block.c), sum, torque, a, b);
        const Vec3x8 p = load(block.tangent_impulse[0]) * t1 + load(block.tangent_impulse[1]) * t2;
        apply_friction(block, load3(block.center), load3(block.d), p, load(block.torsion_impulse) * normal, a, b);
        scatter_velocity(velocity, block.write_a, a);
        scatter_velocity(velocity, block.write_b, b);
    }
}

// One normal row of a contact: impulse' = max(0, impulse - mass v - bias - keep impulse).
struct Row {
    f32x8 mass, bias, keep, old, impulse;
};

// Sweeps over the points of a contact. Only the points' own velocities v change, by the couplings; the bodies are not
// touched, so that a second sweep is cheap. It is needed: after one, the corner that came first carries most, and a
// box that falls flat tips and slides by 5 cm (0.25 mm with two).
template <int N> CAIRN_INLINE void sweep_points(const ContactBlock<N>& block, Row* rows, f32x8* v) {
    constexpr int visits = N == 1 ? 1 : 2 * N;
#pragma GCC unroll 8 // so that rows and velocities stay in registers
    for (int k = 0; k < visits; ++k) {
        const int i = k % N;
        Row& row = rows[i];
        const f32x8 impulse = max(row.impulse - (row.mass * v[i] + row.bias + row.keep * row.impulse), zero());
        const f32x8 d = impulse - row.impulse;
        row.impulse = impulse;
        const bool again = k < visits - N; // only velocities that will be read need to be kept up
#pragma GCC unroll 4
        for (int j = 0; j < N; ++j) {
            if (j == i && again) v[j] += load(block.self[i]) * d;
            if (j > i) v[j] += load(block.coupling[coupling_index(i, j)]) * d;
            if (j < i && again) v[j] += load(block.coupling[coupling_index(j, i)]) * d;
        }
    }
}

// One sweep with soft constraints: overlap is pushed out at a rate and with a compliance given by `softness`;
// a gap is closed no faster than it takes one substep to close it.
template <int N> void solve(void* blocks, int count, SolverVelocity* velocity, const ContactSoftness& softness) {
    auto* all = static_cast<ContactBlock<N>*>(blocks);
    const f32x8 inverse_h = splat(softness.inverse_h), slowest = splat(-softness.recovery_speed);
    for (int k = 0; k < count; ++k) {
        ContactBlock<N>& block = all[k];
        Velocityx8 a = gather_velocity(velocity, block.a), b = gather_velocity(velocity, block.b);
        const mask8 immovable = load(block.mass_b) == zero();
        const f32x8 bias_rate = select(immovable, splat(softness.bias_rate_static), splat(softness.bias_rate));
        const f32x8 mass_scale = select(immovable, splat(softness.mass_scale_static), splat(softness.mass_scale));
        const f32x8 impulse_scale =
            select(immovable, splat(softness.impulse_scale_static), splat(softness.impulse_scale));
        const Vec3x8 normal = load3(block.normal), c = load3(block.c);
        f32x8 v[N];
        Vec3x8 arm[N];
        normal_velocities<N>(block, a, b, normal, c, v, arm);
        f32x8 sum = zero();
        Vec3x8 torque = zero3();
        Row rows[N];
        for (int i = 0; i < N; ++i) {
            const f32x8 s = load(block.separation[i]), mass = load(block.effective_mass[i]);
            const mask8 apart = s > zero();
            rows[i].bias = mass * select(apart, s * inverse_h, max(bias_rate * s, slowest));
            rows[i].mass = mass * select(apart, one(), mass_scale);
            rows[i].keep = select(apart, zero(), impulse_scale);
            rows[i].old = rows[i].impulse = load(block.impulse[i]);
        }
        sweep_points<N>(block, rows, v);
        for (int i = 0; i < N; ++i) {
            const f32x8 d = rows[i].impulse - rows[i].old;
            store(block.impulse[i], rows[i].impulse);
            sum += d;
            torque = torque + d * arm[i];
        }
        apply_normal(block, normal, c, sum, torque, a, b);
        scatter_velocity(velocity, block.write_a, a);
        scatter_velocity(velocity, block.write_b, b);
    }
}

// The rigid sweep of the normal rows: only approach beyond the gap is stopped. Not that of contacts that will bounce:
// they must arrive with all of their speed.
template <int N>
CAIRN_INLINE SweepSums relax_normals(ContactBlock<N>& block, const f32x8* s, f32x8* v, const Vec3x8* arm,
                                     f32x8 inverse_h) {
    SweepSums sums = {zero(), zero3(), zero(), zero()};
    Row rows[N];
    const mask8 bounces = load(block.restitution) > zero();
    for (int i = 0; i < N; ++i) {
        rows[i].old = rows[i].impulse = load(block.impulse[i]);
        const mask8 flies = bounces & (s[i] > zero()) & (rows[i].old <= zero());
        rows[i].mass = select(flies, zero(), load(block.effective_mass[i]));
        rows[i].bias = rows[i].mass * (max(s[i], zero()) * inverse_h);
        rows[i].keep = zero();
    }
    sweep_points<N>(block, rows, v);
    for (int i = 0; i < N; ++i) {
        const f32x8 impulse = rows[i].impulse, d = impulse - rows[i].old;
        store(block.impulse[i], impulse);
        store(block.total_impulse[i], load(block.total_impulse[i]) + impulse);
        sums.impulse += d;
        sums.torque = sums.torque + d * arm[i];
        sums.load += impulse;
        sums.lever_load += load(block.lever[i]) * impulse;
    }
    return sums;
}

// Friction at the friction center. Two tangential rows and the torsional row share one ellipsoidal limit, the
// limit surface of Goyal, Ruina and Papadopoulos (1991) in the form of Howe and Cutkosky (1996): with r the
// radius of the pressed points, n1^2 + n2^2 + (nw / r)^2 <= (friction x load)^2. While it sticks, the rows are
// solved with their own masses; once it slides, with one common mass, so that friction opposes the slip.
template <int N>
CAIRN_INLINE void solve_friction(ContactBlock<N>& block, const SweepSums& sums, Vec3x8 normal, Velocityx8& a,
                                 Velocityx8& b) {
    const Vec3x8 center = load3(block.center), d = load3(block.d), t1 = load3(block.tangent), t2 = cross(t1, normal);
    const Vec3x8 dw = b.w - a.w;
    const Vec3x8 slip = (b.v - a.v) + cross(dw, center) + cross(b.w, d);
    const f32x8 x = dot(slip, t1), y = dot(slip, t2), spin = dot(normal, dw);
    const f32x8 m11 = load(block.tangent_mass[0]), m12 = load(block.tangent_mass[1]), m22 = load(block.tangent_mass[2]);
    const f32x8 mw = load(block.torsion_mass);
    const f32x8 old1 = load(block.tangent_impulse[0]), old2 = load(block.tangent_impulse[1]);
    const f32x8 oldw = load(block.torsion_impulse);

    f32x8 radius = load(block.torsion_radius);
    if constexpr (N > 1) radius = max(sums.lever_load / max(sums.load, splat(tiny)), radius);
    const mask8 has_radius = radius > splat(1e-6f);
    const f32x8 inverse_radius = select(has_radius, one() / select(has_radius, radius, one()), zero());

    // Sticking.
    f32x8 nw = select(has_radius, oldw - mw * spin, zero());
    const f32x8 xs = x + load(block.torsion_coupling[0]) * (nw - oldw),
                ys = y + load(block.torsion_coupling[1]) * (nw - oldw);
    f32x8 n1 = old1 - (m11 * xs + m12 * ys), n2 = old2 - (m12 * xs + m22 * ys);
    const f32x8 qw = nw * inverse_radius, static_limit = load(block.static_friction) * sums.load;
    const mask8 slides = (n1 * n1 + n2 * n2 + qw * qw) > static_limit * static_limit;

    // Sliding.
    f32x8 mass = min(m11, m22);
    mass = select(has_radius, min(mass, mw * inverse_radius * inverse_radius), mass);
    const f32x8 c1 = old1 - mass * x, c2 = old2 - mass * y;
    const f32x8 cw = select(has_radius, oldw * inverse_radius - mass * (radius * spin), zero());
    const f32x8 limit = load(block.friction) * sums.load;
    const f32x8 scale = min(limit / (sqrt(c1 * c1 + c2 * c2 + cw * cw) + splat(tiny)), one());
    n1 = select(slides, scale * c1, n1);
    n2 = select(slides, scale * c2, n2);
    nw = select(slides, scale * cw * radius, nw);

    store(block.tangent_impulse[0], n1);
    store(block.tangent_impulse[1], n2);
    store(block.total_tangent[0], load(block.total_tangent[0]) + n1);
    store(block.total_tangent[1], load(block.total_tangent[1]) + n2);
    store(block.torsion_impulse, nw);
    const Vec3x8 p = (n1 - old1) * t1 + (n2 - old2) * t2;
    apply_friction(block, center, d, p, (nw - oldw) * normal, a, b);
}

// Rolling resistance: a couple against the relative angular velocity, at most rolling radius x load.
template <int N> CAIRN_INLINE void solve_rolling(ContactBlock<N>& block, f32x8 load_sum, Velocityx8& a, Velocityx8& b) {
    const Sym3x8 ia = load6(block.inertia_a), ib = load6(block.inertia_b);
    const Vec3x8 dw = b.w - a.w, old = load3(block.rolling_impulse);
    const f32x8 trace = ((ia.xx + ib.xx) + (ia.yy + ib.yy)) + (ia.zz + ib.zz);
    // One mass for all directions, the smallest effective one that the trace guarantees: never overshoots.
    const mask8 turns = trace > zero();
    const f32x8 mass = select(turns, splat(3.0f) / select(turns, trace, one()), zero()) * splat(1.0f / 3.0f);
    Vec3x8 p = old - mass * dw;
    const f32x8 limit = load(block.rolling_radius) * load_sum;
    const f32x8 scale = min(limit / (sqrt(dot(p, p)) + splat(tiny)), one());
    p = scale * p;
    store3(block.rolling_impulse, p);
    const Vec3x8 change = p - old;
    a.w = a.w - ia * change;
    b.w = b.w + ib * change;
}

// What is carried into the next substep (velocity less reference) was pushed at the old d: moved to the new one.
template <int N>
CAIRN_INLINE void move_carried_impulse(const ContactBlock<N>& block, SolverVelocity* reference, Vec3x8 normal,
                                       Vec3x8 d_change) {
    if (!any(load(block.mass_b) > zero())) return;
    const Vec3x8 t1 = load3(block.tangent), t2 = cross(t1, normal);
    f32x8 sum = zero();
    for (int i = 0; i < N; ++i) sum += load(block.impulse[i]);
    const Vec3x8 impulse = sum * normal + (load(block.tangent_impulse[0]) * t1 + load(block.tangent_impulse[1]) * t2);
    Velocityx8 b = gather_velocity(reference, block.b);
    b.w = b.w - load6(block.inertia_b) * cross(d_change, impulse);
    scatter_velocity(reference, block.write_b, b);
}

template <int N> void relax(void* blocks, int count, const SolverBodies& bodies, const ContactSoftness& softness) {
    auto* all = static_cast<ContactBlock<N>*>(blocks);
    const f32x8 inverse_h = splat(softness.inverse_h);
    for (int k = 0; k < count; ++k) {
        ContactBlock<N>& block = all[k];
        const Vec3x8 normal = load3(block.normal);
        f32x8 s[N], v[N];
        Vec3x8 arm[N];
        const Vec3x8 d_change = refresh_separations<N>(block, bodies.pose, normal, s);
        move_carried_impulse<N>(block, bodies.reference, normal, d_change);
        const Vec3x8 c = load3(block.c);
        Velocityx8 a = gather_velocity(bodies.velocity, block.a), b = gather_velocity(bodies.velocity, block.b);
        normal_velocities<N>(block, a, b, normal, c, v, arm);
        const SweepSums sums = relax_normals<N>(block, s, v, arm, inverse_h);
        apply_normal(block, normal, c, sums.impulse, sums.torque, a, b);
        solve_friction<N>(block, sums, normal, a, b);
        if (any(load(block.rolling_radius) > zero())) solve_rolling<N>(block, sums.load, a, b);
        scatter_velocity(bodies.velocity, block.write_a, a);
        scatter_velocity(bodies.velocity, block.write_b, b);
    }
}

template <int N> SolverKernels::ForPoints contact_kernels() {
    return {prepare_contacts<N>, warm_start<N>, solve<N>, relax<N>, bounce_contacts<N>, store_contacts<N>};
}

} // namespace

SolverKernels solver_kernels() {
    return {contact_kernels<1>(), contact_kernels<4>(), integrate_velocities, integrate_poses};
}

} // namespace cairn::CAIRN_ISA
