// The contact solver's inner loops: warm start, solve (with soft bias) and relax (without), 8 contacts at a time. The
// method is the soft step of Catto ("Solver2D", 2024) with three exact reductions; the derivation is in docs/solver.md.
// In short, for the points i of one contact, with arms j_i for body A and j_i + c for B:
//   normal velocity   v_i  = n.(vB - vA) + c.wB + j_i.(wB - wA)
//   coupling          K_ij = 1/mA + 1/mB + j_i.IA^-1 j_j + (j_i + c).IB^-1 (j_j + c)
// so sweeps over the points use four numbers per point alone (see Rows), and the bodies change once:
//   vA -= n S/mA, vB += n S/mB, wA -= IA^-1 T, wB += IB^-1 (T + S c),  S = sum d_i, T = sum j_i d_i.
#include "kernels/solve/friction.h"
#include "kernels/solve/separations.h"

namespace cairn::CAIRN_ISA {

namespace {

// After bounces: adds to d the displacement by this substep's velocity corrections, if either body has bounced.
template <int N>
void refresh_arms(void* blocks, int count, const SolverBodies& bodies, const SolverTwist* free_correction, float h) {
    auto* all = static_cast<ContactBlock<N>*>(blocks);
    auto* correction = reinterpret_cast<const SolverVelocity*>(bodies.velocity_correction);
    auto* free = reinterpret_cast<const SolverVelocity*>(free_correction);
    for (int k = 0; k < count; ++k) {
        ContactBlock<N>& block = all[k];
        const Vec3x8 a = gather_velocity(correction, block.a).v, b = gather_velocity(correction, block.b).v;
        const Vec3x8 free_a = gather_velocity(free, block.a).v, free_b = gather_velocity(free, block.b).v;
        const mask8 still = (a.x == free_a.x) & (a.y == free_a.y) & (a.z == free_a.z) & (b.x == free_b.x) &
                            (b.y == free_b.y) & (b.z == free_b.z);
        const Vec3x8 passed = gather_pose(bodies.pose, block.a).dx - gather_pose(bodies.pose, block.b).dx;
        refresh_arm(block, load3(block.normal), passed + splat(h) * (a - b),
                    [&](mask8 lanes) { return and_not(lanes, still); });
    }
}

template <int N> void warm_start(const void* blocks, int count, SolverVelocity* velocity) {
    auto* all = static_cast<const ContactBlock<N>*>(blocks);
    for (int k = 0; k < count; ++k) {
        const ContactBlock<N>& block = all[k];
        Velocityx8 a = gather_velocity(velocity, block.a), b = gather_velocity(velocity, block.b);
        const Vec3x8 normal = load3(block.normal), d = load3(block.d), t1 = load3(block.tangent),
                     t2 = second_tangent(block, normal);
        f32x8 sum = zero();
        Vec3x8 torque = zero3();
        for (int i = 0; i < N; ++i) {
            const f32x8 impulse = load(block.impulse[i]);
            sum += impulse;
            torque = torque + impulse * arm_of(block, normal, i);
        }
        apply_normal(block, normal, cross(d, normal), sum, torque, a, b);
        const Vec3x8 p = load(block.tangent_impulse[0]) * t1 + load(block.tangent_impulse[1]) * t2;
        apply_friction(block, load3(block.center), d, p, load(block.torsion_impulse) * normal, a, b);
        scatter_velocity(velocity, block.a, a);
        scatter_velocity(velocity, block.write_b, b);
    }
}

// Applies the moment on A and the impulse on both that carried impulses lack as points moved and normals rotated.
CAIRN_INLINE void apply_missing_impulses(const ContactBlock<1>& block, Velocityx8& a, Velocityx8& b) {
    const mask8 rounds = mask_from_bits(block.round_pairs_moved), places = mask_from_bits(block.rims_a | block.rims_b);
    if (has_rims(block) || block.round_pairs_moved)
        a.w = a.w - select(places | rounds, turned_a(block, load3(block.rim_moment)), zero3());
    if (!block.round_pairs_moved) return;
    const Vec3x8 push = select(rounds, load3(block.slip_rate), zero3());
    a.v = a.v - load(block.mass_a) * push;
    b.v = b.v + load(block.mass_b) * push;
}

// The working state of a block's normal rows. The impulse that satisfies a soft row with compliance is
//   impulse_i' = impulse_i - m_i scale_i (v_i + bias_i) - (1 - scale_i) impulse_i = scale_i wanted_i,
//   wanted_i = impulse_i - m_i (v_i + bias_i),
// and is clamped to be at least 0; scale is 1 for a rigid row. A change of the point's own impulse does not alter
// `wanted`, as m_i K_ii = 1; a change of the impulse at point j by d reduces it by m_i K_ij d. So the points can be
// swept without reading the bodies again.
template <int N> struct Rows {
    Velocityx8 a, b;
    f32x8 wanted[N], impulse[N], old[N], scale[N];
    RoundTouch round; // in relax, for blocks with two round surfaces: their current contact
};

// Lanes that have zero impulse and keep it: their bodies need no update. In a heap they are half of all contacts.
template <int N> CAIRN_INLINE mask8 is_idle(const Rows<N>& rows) {
    mask8 lanes = (rows.impulse[0] == zero()) & (rows.wanted[0] <= zero());
    for (int i = 1; i < N; ++i) lanes = lanes & (rows.impulse[i] == zero()) & (rows.wanted[i] <= zero());
    return lanes;
}

// Sweeps over the points of M blocks at once: each sweep is a chain of dependent operations, and interleaved chains
// take little more time than one. The second sweep is needed: after one, the corner that was visited first carries most
// of the load, and a box that falls flat tips and slides by 5 cm (0.25 mm with two).
template <int N, int M, bool Soft> CAIRN_INLINE void sweep_points(const ContactBlock<N>* blocks, Rows<N>* rows) {
    constexpr int visits = N == 1 ? 1 : 2 * N;
#pragma GCC unroll 8 // so that rows stay in registers
    for (int k = 0; k < visits; ++k) {
        const int i = k % N;
        f32x8 d[M];
#pragma GCC unroll 4
        for (int m = 0; m < M; ++m) {
            f32x8 impulse = max(rows[m].wanted[i], zero());
            if constexpr (Soft) impulse = rows[m].scale[i] * impulse;
            d[m] = impulse - rows[m].impulse[i];
            rows[m].impulse[i] = impulse;
        }
        if constexpr (N > 1)
#pragma GCC unroll 4
            for (int j = 0; j < N; ++j)
#pragma GCC unroll 4
                for (int m = 0; m < M; ++m)
                    if (j > i || (j < i && k < N)) // values that are not read again are not updated
                        rows[m].wanted[j] = rows[m].wanted[j] - load(blocks[m].share[share_index<N>(j, i)]) * d[m];
    }
}

// Adds the effect of the motion of contact points within the step on their opening velocities (slip_of_moving_points),
// which varies linearly with the position among several points.
template <int N>
CAIRN_INLINE void add_slip_of_moving_points(const ContactBlock<N>& block, const ContactSoftness& softness,
                                            Vec3x8 normal, f32x8* v) {
    f32x8 slip = dot(slip_of_moving_points(block, softness.middle), normal);
    if constexpr (N == 1) {
        v[0] += slip;
    } else {
        const Vec3x8 slope = (splat(softness.middle) - load(block.found)) * load3(block.slip_rate_slope);
        const f32x8 along = dot(slope, normal);
        const Vec3x8 across = cross(slope, normal);
        slip -= dot(slope, load3(block.center));
        for (int i = 0; i < N; ++i) v[i] += slip + (along * load(block.height[i]) + dot(across, load3(block.arm[i])));
    }
}

// Moving contact points need the opening velocities, and the arm of B, in the middle of the substep; d is that of its
// start in `solve`, of its end in `relax`. `late`: s, from the middle to the moment of d. Without this, a plank that
// slides over spinning rollers is rotated by them.
template <int N>
CAIRN_INLINE void add_contact_point_motion(const ContactBlock<N>& block, const ContactSoftness& softness, Vec3x8 normal,
                                           const Velocityx8& a, const Velocityx8& b, float late, f32x8* v) {
    if (!block.moving_points && !has_rims(block)) return;
    const mask8 moves = mask_from_bits(block.moving_points | block.rims_a | block.rims_b);
    const f32x8 of_arm = select(moves, splat(late) * dot(normal, cross(b.w, b.v - a.v)), zero());
    for (int i = 0; i < N; ++i) v[i] += of_arm;
    if (block.moving_points) add_slip_of_moving_points<N>(block, softness, normal, v);
    if (has_rims(block)) v[0] += dot(slip_of_rims(block, b.w - a.w), normal);
}

// Mean opening velocities of the points in a substep. `late`: as above; `separation`: of the first point; `now`: in
// relax, the current contact of two round surfaces.
template <int N>
CAIRN_INLINE void opening_velocities(const ContactBlock<N>& block, const ContactSoftness& softness, Vec3x8 normal,
                                     const Rows<N>& rows, float late, f32x8 separation, const RoundTouch* now,
                                     f32x8* v) {
    if (!is_all_round(block)) {
        normal_velocities<N>(block, rows.a, rows.b, normal, cross(load3(block.d), normal), v);
        add_contact_point_motion<N>(block, softness, normal, rows.a, rows.b, late, v);
    }
    if constexpr (N == 1)
        if (has_round_pairs(block)) {
            const f32x8 opening = round_velocity(block, rows.a, rows.b, separation, now, softness.h);
            v[0] = is_all_round(block) ? opening : select(mask_from_bits(block.round_pairs), opening, v[0]);
        }
}

template <int N>
CAIRN_INLINE void begin_solve(ContactBlock<N>& block, const SolverVelocity* velocity, const ContactSoftness& softness,
                              Rows<N>& rows) {
    rows.a = gather_velocity(velocity, block.a);
    rows.b = gather_velocity(velocity, block.b);
    if (block.moved) rows.b.w = rows.b.w + turned_b(block, load3(block.moved_moment));
    if constexpr (N == 1)
        if (block.moved) apply_missing_impulses(block, rows.a, rows.b);
    const mask8 immovable = load(block.mass_b) == zero();
    const ContactSoftness::Spring &fixed = softness.on_immovable, &other = softness.on_movable;
    const f32x8 push_rate = select(immovable, splat(fixed.push_rate), splat(other.push_rate));
    const f32x8 fastest = select(immovable, splat(-fixed.fastest_push), splat(-other.fastest_push));
    const f32x8 softened = select(immovable, splat(fixed.scale), splat(other.scale));
    const f32x8 inverse_h = splat(softness.inverse_h);
    f32x8 v[N];
    const Vec3x8 normal = load3(block.normal);
    opening_velocities<N>(block, softness, normal, rows, -0.5f * softness.h, load(block.separation[0]), nullptr, v);
    for (int i = 0; i < N; ++i) {
        const f32x8 s = load(block.separation[i]), mass = load(block.effective_mass[i]);
        const mask8 apart = s > zero();
        const f32x8 bias = select(apart, s * inverse_h, max(push_rate * s, fastest));
        rows.scale[i] = select(apart, one(), softened);
        rows.old[i] = rows.impulse[i] = load(block.impulse[i]);
        rows.wanted[i] = rows.old[i] - mass * (v[i] + bias);
    }
}

// Whether any contact is hit faster than `impact_speed`: those lanes keep their old impulses. As this is rare, it is
// first tested whether the sum of the impulses changes a body's velocity by more than that.
template <int N>
CAIRN_INLINE int defer_impacts(ContactBlock<N>& block, Vec3x8 normal, f32x8& sum, Vec3x8& torque, Rows<N>& rows,
                               const ContactSoftness& softness) {
    const f32x8 speed = splat(softness.impact_speed);
    const mask8 jolts = max(load(block.mass_a), load(block.mass_b)) * sum > speed;
    if (!any(jolts)) return 0;
    f32x8 v[N];
    normal_velocities<N>(block, rows.a, rows.b, normal, cross(load3(block.d), normal), v);
    mask8 in_impact = mask_from_bits(0);
    f32x8 carried = zero();
    for (int i = 0; i < N; ++i) {
        carried += rows.old[i];
        const f32x8 closing = v[i] + max(load(block.separation[i]), zero()) * splat(softness.inverse_h);
        in_impact = in_impact | ((rows.impulse[i] > rows.old[i]) & (closing < -speed));
    }
    // No impact: a contact that already carries this impulse, or was hit twice in this step (something drives it).
    // Twice is usual: in solve, which lets the contact close its gap, and in relax, once it is closed.
    in_impact = and_not(in_impact & jolts & (sum > carried), mask_from_bits(block.in_impact_twice));
    if (!any(in_impact)) return 0;
    block.in_impact_twice = std::uint8_t(block.in_impact_twice | (block.in_impact_once & bits(in_impact)));
    block.in_impact_once = std::uint8_t(block.in_impact_once | bits(in_impact));
    block.in_impact = std::uint8_t(block.in_impact | bits(in_impact));
    sum = select(in_impact, zero(), sum);
    torque = select(in_impact, zero3(), torque);
    for (int i = 0; i < N; ++i) rows.impulse[i] = select(in_impact, rows.old[i], rows.impulse[i]);
    return 1;
}

template <int N, bool Watched>
CAIRN_INLINE int end_solve(ContactBlock<N>& block, SolverVelocity* velocity, const ContactSoftness& softness,
                           Rows<N>& rows) {
    f32x8 sum = zero();
    Vec3x8 torque = zero3();
    const Vec3x8 normal = load3(block.normal);
    for (int i = 0; i < N; ++i) {
        const f32x8 d = rows.impulse[i] - rows.old[i];
        store(block.impulse[i], rows.impulse[i]);
        sum += d;
        torque = torque + d * arm_of(block, normal, i);
    }
    int in_impact = 0;
    if constexpr (Watched) in_impact = defer_impacts<N>(block, normal, sum, torque, rows, softness);
    if (in_impact)
        for (int i = 0; i < N; ++i) store(block.impulse[i], rows.impulse[i]);
    apply_normal(block, normal, cross(load3(block.d), normal), sum, torque, rows.a, rows.b);
    scatter_velocity(velocity, block.a, rows.a);
    scatter_velocity(velocity, block.write_b, rows.b);
    return in_impact;
}

template <int N, int M, bool Watched>
CAIRN_INLINE int solve_some(ContactBlock<N>* blocks, SolverVelocity* velocity, const ContactSoftness& softness) {
    Rows<N> rows[M];
    int in_impact = 0;
#pragma GCC unroll 4
    for (int m = 0; m < M; ++m) begin_solve<N>(blocks[m], velocity, softness, rows[m]);
    mask8 idle = is_idle(rows[0]);
    int moved = blocks[0].moved;
    for (int m = 1; m < M; ++m) idle = idle & is_idle(rows[m]), moved |= blocks[m].moved;
    if (!moved && all(idle)) return 0;
    for (int m = 0; m < M; ++m) blocks[m].moved = 0;
    sweep_points<N, M, true>(blocks, rows);
#pragma GCC unroll 4
    for (int m = 0; m < M; ++m) in_impact += end_solve<N, Watched>(blocks[m], velocity, softness, rows[m]);
    return in_impact;
}

// The number of blocks that solve and relax process interleaved. In WebAssembly one: with several, engines keep nearly
// all rows in memory, which costs more than the latency of a single chain. The results are bit-identical.
#if defined(__wasm_simd128__)
constexpr int solved_together = 1, relaxed_together = 1;
#else
constexpr int solved_together = 4, relaxed_together = 2;
#endif

// The pass with soft constraints: penetration is pushed out at a rate and with a compliance given by `softness`; a gap
// is closed no faster than within one substep.
template <int N, bool Watched>
int solve_all(ContactBlock<N>* all, int count, SolverVelocity* velocity, const ContactSoftness& softness) {
    int k = 0, in_impact = 0;
    for (; k + solved_together <= count; k += solved_together)
        in_impact += solve_some<N, solved_together, Watched>(all + k, velocity, softness);
    for (; k < count; ++k) in_impact += solve_some<N, 1, Watched>(all + k, velocity, softness);
    return in_impact;
}
// Batches without treatment of impacts use code without the test for them, which costs registers.
bool looks_for_impacts(const ContactSoftness& softness) { return softness.impact_speed < 1e20f; }

template <int N> int solve(void* blocks, int count, SolverVelocity* velocity, const ContactSoftness& softness) {
    auto* all = static_cast<ContactBlock<N>*>(blocks);
    return looks_for_impacts(softness) ? solve_all<N, true>(all, count, velocity, softness)
                                       : solve_all<N, false>(all, count, velocity, softness);
}

// The rigid pass: stops only the approach beyond what closes the gap. Contacts that will bounce are not stopped: they
// must arrive at full speed.
template <int N>
CAIRN_INLINE void begin_relax(ContactBlock<N>& block, const SolverBodies& bodies, const ContactSoftness& softness,
                              Rows<N>& rows) {
    constexpr float never = -1e30f;
    const Vec3x8 normal = load3(block.normal);
    f32x8 s[N], v[N];
    const f32x8 inverse_h = splat(softness.inverse_h);
    refresh_separations<N>(block, bodies.pose, normal, softness.inverse_elapsed, s, rows.round);
    rows.a = gather_velocity(bodies.velocity, block.a);
    rows.b = gather_velocity(bodies.velocity, block.b);
    opening_velocities<N>(block, softness, normal, rows, 0.5f * softness.h, s[0], &rows.round, v);
    if constexpr (N == 1)
        if (has_round_pairs(block)) advance_round_pairs(block, rows.round);
    for (int i = 0; i < N; ++i) {
        rows.old[i] = rows.impulse[i] = load(block.impulse[i]);
        rows.wanted[i] = rows.old[i] - load(block.effective_mass[i]) * (v[i] + max(s[i], zero()) * inverse_h);
    }
    if (block.bounces) {
        const mask8 bounces = load(block.restitution) > zero();
        for (int i = 0; i < N; ++i) {
            const mask8 flies = bounces & (s[i] > zero()) & (rows.old[i] <= zero());
            rows.wanted[i] = select(flies, splat(never), rows.wanted[i]);
        }
    }
}

// Lanes without tangential, torsional or rolling impulse.
template <int N> CAIRN_INLINE mask8 is_frictionless(const ContactBlock<N>& block) {
    mask8 lanes = (load(block.tangent_impulse[0]) == zero()) & (load(block.tangent_impulse[1]) == zero()) &
                  (load(block.torsion_impulse) == zero());
    if (block.rolls)
        for (const auto& impulse : block.rolling_impulse) lanes = lanes & (load(impulse) == zero());
    return lanes;
}

template <int N, bool Watched>
CAIRN_INLINE PointSums apply_relax(ContactBlock<N>& block, Vec3x8 normal, const ContactSoftness& softness,
                                   Rows<N>& rows, int& in_impact) {
    PointSums sums = {zero(), zero(), zero3()};
    f32x8 sum = zero();
    Vec3x8 torque = zero3();
    for (int i = 0; i < N; ++i) {
        const f32x8 impulse = rows.impulse[i], d = impulse - rows.old[i];
        store(block.impulse[i], impulse);
        store(block.total_impulse[i], load(block.total_impulse[i]) + impulse);
        sum += d;
        torque = torque + d * arm_of(block, normal, i);
        add_point(block, normal, i, impulse, sums);
    }
    if (Watched && defer_impacts<N>(block, normal, sum, torque, rows, softness)) {
        ++in_impact;
        sums = {zero(), zero(), zero3()};
        for (int i = 0; i < N; ++i) {
            const f32x8 impulse = rows.impulse[i], too_much = load(block.impulse[i]) - impulse;
            store(block.impulse[i], impulse);
            store(block.total_impulse[i], load(block.total_impulse[i]) - too_much);
            add_point(block, normal, i, impulse, sums);
        }
    }
    apply_normal(block, normal, cross(load3(block.d), normal), sum, torque, rows.a, rows.b);
    return sums;
}

template <int N>
CAIRN_INLINE void follow_rims(ContactBlock<N>& block, const SolverBodies& bodies, const ContactSoftness& softness,
                              const Rows<N>& rows) {
    if constexpr (N == 1)
        if (has_rims(block))
            advance_rims(block, gather_pose(bodies.pose, block.a), gather_pose(bodies.pose, block.b), rows.a, rows.b,
                         load3(block.normal), softness.h);
}

template <int N, int M, bool Watched>
CAIRN_INLINE int relax_some(ContactBlock<N>* blocks, const SolverBodies& bodies, const ContactSoftness& softness) {
    int in_impact = 0;
    Rows<N> rows[M];
#pragma GCC unroll 4
    for (int m = 0; m < M; ++m) begin_relax<N>(blocks[m], bodies, softness, rows[m]);
    mask8 idle = is_idle(rows[0]) & is_frictionless(blocks[0]);
    for (int m = 1; m < M; ++m) idle = idle & is_idle(rows[m]) & is_frictionless(blocks[m]);
    if (all(idle)) { // without a load there is no friction
        for (int m = 0; m < M; ++m) follow_rims<N>(blocks[m], bodies, softness, rows[m]);
        return 0;
    }
    sweep_points<N, M, false>(blocks, rows);
    PointSums sums[M];
#pragma GCC unroll 4
    for (int m = 0; m < M; ++m)
        sums[m] = apply_relax<N, Watched>(blocks[m], load3(blocks[m].normal), softness, rows[m], in_impact);
#pragma GCC unroll 4
    for (int m = 0; m < M; ++m)
        solve_friction<N>(blocks[m], sums[m], load3(blocks[m].normal), softness, rows[m].a, rows[m].b);
#pragma GCC unroll 4
    for (int m = 0; m < M; ++m) {
        ContactBlock<N>& block = blocks[m];
        if (block.rolls) solve_rolling<N>(block, sums[m].load, rows[m].a, rows[m].b);
        follow_rims<N>(block, bodies, softness, rows[m]);
        scatter_velocity(bodies.velocity, block.a, rows[m].a);
        scatter_velocity(bodies.velocity, block.write_b, rows[m].b);
    }
    return in_impact;
}

template <int N, bool Watched>
int relax_all(ContactBlock<N>* all, int count, const SolverBodies& bodies, const ContactSoftness& softness) {
    int k = 0, in_impact = 0;
    for (; k + relaxed_together <= count; k += relaxed_together)
        in_impact += relax_some<N, relaxed_together, Watched>(all + k, bodies, softness);
    if (k < count) in_impact += relax_some<N, 1, Watched>(all + k, bodies, softness);
    return in_impact;
}
template <int N> int relax(void* blocks, int count, const SolverBodies& bodies, const ContactSoftness& softness) {
    auto* all = static_cast<ContactBlock<N>*>(blocks);
    return looks_for_impacts(softness) ? relax_all<N, true>(all, count, bodies, softness)
                                       : relax_all<N, false>(all, count, bodies, softness);
}

template <int N> SolverKernels::ForPoints contact_kernels() {
    return {prepare_contacts<N>,
            warm_start<N>,
            solve<N>,
            relax<N>,
            renew_masses<N>,
            solve_impact_contacts<N>,
            find_contact_rebounds<N>,
            bounce_contacts<N>,
            refresh_arms<N>,
            store_contacts<N>};
}

} // namespace

SolverKernels solver_kernels() {
    return {contact_kernels<1>(), contact_kernels<4>(), change_since,         begin_spin,      spin,
            renew_inertia,        finish_spin,          integrate_velocities, integrate_poses, move_bodies};
}

} // namespace cairn::CAIRN_ISA
