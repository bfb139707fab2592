// Impacts. Contacts that approach faster than the solver should stop them within its soft passes are stopped by
// separate rigid passes, repeated until nothing changes (impacts.cpp). Their impulses begin at zero and are not carried
// into the next substep. docs/solver.md gives the reasons.
#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

namespace {

// Computes the wanted impulses of the points, over-relaxed, and from them the new impulses, swept as in solve.
template <int N>
CAIRN_INLINE void strike_points(const ContactBlock<N>& block, mask8 active, const f32x8* v, f32x8 inverse_h,
                                const f32x8* speed, const f32x8* old, f32x8* impulse) {
    f32x8 wanted[N];
    mask8 takes_part[N];
    const mask8 bounces = load(block.restitution) > zero();
    for (int i = 0; i < N; ++i) {
        const f32x8 s = load(block.separation[i]), mass = splat(impact_relaxation) * load(block.effective_mass[i]);
        // As in relax: a contact that will bounce must reach the surface with its full speed.
        const mask8 bounces_now = speed[i] > splat(does_not_arrive);
        const mask8 flies = and_not(bounces & (s > zero()) & (load(block.impulse[i]) <= zero()), bounces_now);
        const f32x8 left = select(bounces_now, -speed[i], max(s, zero()) * inverse_h);
        impulse[i] = old[i];
        takes_part[i] = and_not(active, flies);
        wanted[i] = old[i] - mass * (v[i] + left);
    }
    for (int sweep = 0; sweep < (N > 1 ? 2 : 1); ++sweep)
        for (int i = 0; i < N; ++i) {
            const f32x8 next = select(takes_part[i], max(wanted[i], zero()), impulse[i]), d = next - impulse[i];
            impulse[i] = next;
            if constexpr (N > 1)
                for (int j = 0; j < N; ++j)
                    if (j != i) wanted[j] = wanted[j] - load(block.share[share_index<N>(j, i)]) * d;
        }
}

template <int N>
CAIRN_INLINE void strike_block(ContactBlock<N>& block, ContactImpact<N>& impact, const float* rebound_speed,
                               SolverVelocity* velocity, f32x8 inverse_h) {
    const mask8 active = mask_from_bits(impact.active);
    Velocityx8 a = gather_velocity(velocity, block.a), b = gather_velocity(velocity, block.b);
    const Vec3x8 normal = load3(block.normal), d = load3(block.d), c = cross(d, normal);
    f32x8 v[N], speed[N], old[N], impulse[N], sum = zero(), load_sum = zero();
    Vec3x8 torque = zero3(), load_torque = zero3();
    normal_velocities<N>(block, a, b, normal, c, v);
    for (int i = 0; i < N; ++i)
        old[i] = load(impact.impulse[i]),
        speed[i] = rebound_speed ? load(rebound_speed + 8 * i) : splat(does_not_arrive);
    strike_points<N>(block, active, v, inverse_h, speed, old, impulse);
    const f32x8 old1 = load(impact.tangent[0]), old2 = load(impact.tangent[1]);
    mask8 idle = (old1 == zero()) & (old2 == zero());
    for (int i = 0; i < N; ++i) idle = idle & (old[i] == zero()) & (impulse[i] == zero());
    if (all(idle)) return; // without a load there is no friction
    for (int i = 0; i < N; ++i) {
        const f32x8 change = impulse[i] - old[i];
        store(impact.impulse[i], impulse[i]);
        sum += change;
        load_sum += impulse[i];
        const Vec3x8 arm = arm_of(block, normal, i);
        torque = torque + change * arm;
        load_torque = load_torque + impulse[i] * arm;
    }
    apply_normal(block, normal, c, sum, torque, a, b);
    // Coulomb friction of the impact itself, at its load.
    const Vec3x8 t1 = load3(block.tangent), t2 = second_tangent(block, normal);
    Vec3x8 center = load3(block.center);
    if constexpr (N > 1) {
        const mask8 bears = load_sum > zero();
        const LoadOffset e = load_offset(center, one() / select(bears, load_sum, one()), load_torque, t1, t2);
        center = center + select(bears, e.x * t1 + e.y * t2, zero3());
    }
    const Vec3x8 slip = (b.v - a.v) + cross(b.w - a.w, center) + cross(b.w, d);
    const auto [stop1, stop2] = slip_stop(block, center, d, t1, t2, dot(slip, t1), dot(slip, t2));
    f32x8 p1 = old1 + stop1, p2 = old2 + stop2;
    const f32x8 size = sqrt(p1 * p1 + p2 * p2), limit = load(block.friction) * load_sum;
    const f32x8 scale = min(limit / (size + splat(1e-20f)), one());
    p1 = select(active, scale * p1, old1);
    p2 = select(active, scale * p2, old2);
    store(impact.tangent[0], p1);
    store(impact.tangent[1], p2);
    apply_friction(block, center, d, (p1 - old1) * t1 + (p2 - old2) * t2, zero3(), a, b);
    scatter_velocity(velocity, block.a, a);
    scatter_velocity(velocity, block.write_b, b);
}

} // namespace

template <int N>
void solve_impact_contacts(void* blocks, void* impacts, const float* rebound_speed, int count, SolverVelocity* velocity,
                           float inverse_h) {
    auto* all = static_cast<ContactBlock<N>*>(blocks);
    auto* given = static_cast<ContactImpact<N>*>(impacts);
    for (int k = 0; k < count; ++k)
        if (given[k].active)
            strike_block<N>(all[k], given[k], rebound_speed ? rebound_speed + 8 * N * k : nullptr, velocity,
                            splat(inverse_h));
}

float change_since(const SolverVelocity* velocity, const std::int32_t* rows, int count, SolverVelocity* last,
                   SettledChange settled) {
    static_assert(sizeof(SolverVelocity) == 8 * sizeof(float));
    const float v = 1 / settled.v, w = 1 / settled.w;
    alignas(32) const float units[8] = {v, v, v, 0, w, w, w, 0};
    const f32x8 unit = load(units);
    f32x8 most = zero();
    for (int i = 0; i < count; ++i) {
        const f32x8 now = load(velocity[rows[i]].v);
        most = max(unit * abs(now - load(last[i].v)), most);
        store(last[i].v, now);
    }
    alignas(32) float lanes[8];
    float greatest = 0;
    store(lanes, most);
    for (const float lane : lanes) greatest = lane > greatest ? lane : greatest;
    return greatest;
}

template void solve_impact_contacts<1>(void*, void*, const float*, int, SolverVelocity*, float);
template void solve_impact_contacts<4>(void*, void*, const float*, int, SolverVelocity*, float);

} // namespace cairn::CAIRN_ISA
