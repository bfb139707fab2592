// Restitution. Contacts that will be reached within this substep, faster than the threshold, bounce before the
// solver sees them. Contacts are taken one after another with the velocities that they then have, and the pass
// is repeated until nothing bounces, so that an impact travels through a row of touching balls (Newton's cradle).
//
// Energy and time are exact for a constant closing acceleration a. The discrete path is a parabola; its closing speed
// at the start of the substep is the stored speed |v| (which has this substep's h a in it already) less o h a, where
// o = 1/2 for semi-implicit Euler, which moves with the velocity of the end of the substep; 1 for exact integration;
// 3/2 for explicit Euler. From u = |v| - o h a at a gap s, the surface is met with w = sqrt(u^2 + 2 a s) after
// t = 2 s / (u + w), left with e w, and at the end of the substep the speed is e w - a (h - t), (1 - o) h a more in the
// stored convention, and the gap e w (h - t) - a (h - t)^2 / 2. What the pose must move beside the stored velocity to
// get there goes to velocity_correction.
#include "kernels/solver.h"

namespace cairn::CAIRN_ISA {

namespace {

constexpr int point_sweeps = 12; // Gauss-Seidel sweeps over the four points of one bouncing contact

struct Bounce {
    mask8 lanes; // where anything bounces
    f32x8 impulse[4];
    f32x8 correction; // of the pose's velocity, in units of the change of velocity
};

CAIRN_INLINE Velocityx8 gather_twist(const SolverTwist* rows, const std::uint32_t* row) {
    return gather_velocity(reinterpret_cast<const SolverVelocity*>(rows), row);
}

CAIRN_INLINE f32x8 closing_acceleration(const Velocityx8& drive_a, const Velocityx8& drive_b, Vec3x8 normal, Vec3x8 c,
                                        Vec3x8 arm, f32x8 inverse_h) {
    const f32x8 dv = dot(normal, drive_b.v - drive_a.v) + dot(c, drive_b.w) + dot(arm, drive_b.w - drive_a.w);
    return max(-(dv * inverse_h), zero());
}

struct Rebound {
    f32x8 velocity;   // stored at the end of the substep, opening
    f32x8 correction; // to move the pose by, beside it
};

CAIRN_INLINE Rebound rebound(f32x8 approach, f32x8 gap, f32x8 acceleration, f32x8 restitution, f32x8 other_correction,
                             const BounceSettings& settings) {
    const f32x8 h = splat(settings.h), ah = acceleration * h, offset = splat(settings.velocity_offset);
    const f32x8 u = max(approach - offset * ah, zero());
    const f32x8 w = sqrt(u * u + splat(2.0f) * acceleration * gap);
    const f32x8 t = min(splat(2.0f) * gap / max(u + w, splat(1e-20f)), h), left = h - t;
    const f32x8 leave = restitution * w;
    const f32x8 end_gap = max(left * (leave - splat(0.5f) * acceleration * left), zero());
    // It does not come down again in the same substep: what is that slow stays on the surface.
    const f32x8 velocity = max(leave - acceleration * left + (one() - offset) * ah, zero());
    return {velocity, (end_gap - gap) / h - velocity - other_correction};
}

template <int N>
CAIRN_INLINE Bounce find_bounce(const ContactBlock<N>& block, const SolverBodies& bodies,
                                const BounceSettings& settings, f32x8* v, const Vec3x8* arm, Vec3x8 normal, Vec3x8 c) {
    Bounce bounce;
    const f32x8 h = splat(settings.h), inverse_h = splat(1.0f / settings.h), restitution = load(block.restitution);
    mask8 arrives[N];
    bounce.lanes = zero() > one();
    for (int i = 0; i < N; ++i) {
        bounce.impulse[i] = zero();
        arrives[i] = (load(block.effective_mass[i]) > zero()) & (v[i] < splat(-settings.threshold)) &
                     (load(block.separation[i]) + h * v[i] <= zero()) & (restitution > zero());
        bounce.lanes = bounce.lanes | arrives[i];
    }
    if (!any(bounce.lanes)) return bounce;
    const Velocityx8 drive_a = gather_twist(bodies.drive, block.a), drive_b = gather_twist(bodies.drive, block.b);
    const Velocityx8 other_a = gather_twist(bodies.velocity_correction, block.a);
    const Velocityx8 other_b = gather_twist(bodies.velocity_correction, block.b);
    f32x8 target[N], change = zero(), correction = zero();
    for (int i = 0; i < N; ++i) {
        const f32x8 acceleration = closing_acceleration(drive_a, drive_b, normal, c, arm[i], inverse_h);
        const f32x8 other = dot(normal, other_b.v - other_a.v) + dot(c, other_b.w) + dot(arm[i], other_b.w - other_a.w);
        const Rebound r =
            rebound(-v[i], max(load(block.separation[i]), zero()), acceleration, restitution, other, settings);
        target[i] = r.velocity;
        change += select(arrives[i], r.velocity - v[i], zero());
        correction += select(arrives[i], r.correction, zero());
    }
    bounce.correction = select(change > zero(), correction / max(change, splat(1e-20f)), zero());
    f32x8 wanted[N];
    for (int i = 0; i < N; ++i) wanted[i] = load(block.effective_mass[i]) * (target[i] - v[i]);
    for (int sweep = 0; sweep < (N > 1 ? point_sweeps : 1); ++sweep)
        for (int i = 0; i < N; ++i) {
            const f32x8 impulse = select(arrives[i], max(wanted[i], zero()), zero()), d = impulse - bounce.impulse[i];
            bounce.impulse[i] = impulse;
            for (int j = 0; j < N; ++j)
                if (j != i) wanted[j] = wanted[j] - load(block.share[share_index<N>(j, i)]) * d;
        }
    return bounce;
}

// Coulomb friction of the impact itself, at the friction center, from rest.
template <int N>
CAIRN_INLINE Vec3x8 impact_friction(const ContactBlock<N>& block, f32x8 load_sum, const Velocityx8& a,
                                    const Velocityx8& b) {
    const Vec3x8 center = load3(block.center), t1 = load3(block.tangent[0]), t2 = load3(block.tangent[1]);
    const Vec3x8 slip = (b.v - a.v) + cross(b.w - a.w, center) + cross(b.w, load3(block.d));
    const f32x8 x = dot(slip, t1), y = dot(slip, t2);
    const f32x8 m12 = load(block.tangent_mass[1]);
    f32x8 p1 = -(load(block.tangent_mass[0]) * x + m12 * y), p2 = -(m12 * x + load(block.tangent_mass[2]) * y);
    const f32x8 size = sqrt(p1 * p1 + p2 * p2), limit = load(block.friction) * load_sum;
    const f32x8 scale = min(limit / (size + splat(1e-20f)), one());
    return scale * (p1 * t1 + p2 * t2);
}

CAIRN_INLINE void add_to_rows(SolverVelocity* rows, const std::uint32_t* row, const std::uint32_t* write,
                              const Velocityx8& change, f32x8 factor) {
    Velocityx8 r = gather_velocity(rows, row);
    r = {r.v + factor * change.v, r.w + factor * change.w};
    scatter_velocity(rows, write, r);
}

} // namespace

template <int N>
int bounce_contacts(void* blocks, int count, const SolverBodies& bodies, const BounceSettings& settings) {
    auto* all = static_cast<ContactBlock<N>*>(blocks);
    int bounced = 0;
    for (int k = 0; k < count; ++k) {
        ContactBlock<N>& block = all[k];
        const Vec3x8 normal = load3(block.normal), c = load3(block.c);
        Velocityx8 a = gather_velocity(bodies.velocity, block.a), b = gather_velocity(bodies.velocity, block.b);
        const Vec3x8 dw = b.w - a.w;
        const f32x8 common = dot(normal, b.v - a.v) + dot(c, b.w);
        f32x8 v[N];
        Vec3x8 arm[N];
        for (int i = 0; i < N; ++i) {
            arm[i] = load3(block.arm[i]);
            v[i] = common + dot(arm[i], dw);
        }
        const Bounce bounce = find_bounce<N>(block, bodies, settings, v, arm, normal, c);
        if (!any(bounce.lanes)) continue;
        ++bounced;
        f32x8 sum = zero();
        Vec3x8 torque = zero3();
        for (int i = 0; i < N; ++i) {
            sum += bounce.impulse[i];
            torque = torque + bounce.impulse[i] * arm[i];
            store(block.total_impulse[i], load(block.total_impulse[i]) + bounce.impulse[i]);
        }
        const Velocityx8 before_a = a, before_b = b;
        apply_normal(block, normal, c, sum, torque, a, b);
        const Vec3x8 p = impact_friction(block, sum, a, b);
        apply_friction(block, load3(block.center), load3(block.d), p, zero3(), a, b);
        scatter_velocity(bodies.velocity, block.a, a);
        scatter_velocity(bodies.velocity, block.write_b, b);
        const Velocityx8 change_a = {a.v - before_a.v, a.w - before_a.w},
                         change_b = {b.v - before_b.v, b.w - before_b.w};
        // The same change to the reference: the bounce is over, and must not be carried into the next substep.
        add_to_rows(bodies.reference, block.a, block.a, change_a, one());
        add_to_rows(bodies.reference, block.b, block.write_b, change_b, one());
        auto* correction = reinterpret_cast<SolverVelocity*>(bodies.velocity_correction);
        add_to_rows(correction, block.a, block.a, change_a, bounce.correction);
        add_to_rows(correction, block.b, block.write_b, change_b, bounce.correction);
    }
    return bounced;
}

template int bounce_contacts<1>(void*, int, const SolverBodies&, const BounceSettings&);
template int bounce_contacts<4>(void*, int, const SolverBodies&, const BounceSettings&);

} // namespace cairn::CAIRN_ISA
