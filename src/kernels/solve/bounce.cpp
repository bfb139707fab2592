// Restitution. Contacts that close within this substep, faster than the threshold, bounce before the solver sees them.
// Contacts are processed one after another with the velocities at that time, and the pass is repeated until nothing
// bounces, so that an impact travels through a row of touching balls (Newton's cradle).
//
// Energy and time are exact for a constant closing acceleration a. The discrete path is a parabola; its closing speed
// at the start of the substep is the stored speed |v| (which already includes h a of this substep) minus o h a, where
// o = 1/2 for semi-implicit Euler, which moves with the velocity of the end of the substep; 1 for exact integration;
// 3/2 for explicit Euler. From u = |v| - o h a at a gap s, the surface is reached with w = sqrt(u^2 + 2 a s) after
// t = 2 s / (u + w), and left with e w; at the end of the substep the speed is e w - a (h - t), (1 - o) h a more in the
// stored convention, and the gap e w (h - t) - a (h - t)^2 / 2. The displacement to there that the stored velocity does
// not give goes to velocity_correction.
//
// Restitution applies to the free velocity (the reference). The part carried over from the last substep stands for
// forces of this substep, which act on after the bounce as before it. If it bounced as well, the force with which a
// joint presses into a contact would grow by 1 + e in each substep.
//
// The impulse acts at the poses at which the bodies meet, with the arms, normal and couplings of that moment, so that
// neither energy nor angular momentum is gained or lost by applying it earlier.
#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

namespace {

constexpr int point_sweeps = 12; // Gauss-Seidel sweeps over the four points of one bouncing contact

// The contact at the moment of impact.
template <int N> struct ImpactState {
    Vec3x8 normal, d; // d: from B's center of mass to A's
    Vec3x8 center;    // arm of the friction center, for A
    Vec3x8 arm_a[N];  // r_i x normal
    Vec3x8 arm_b[N];  // (r_i + d) x normal
    f32x8 v[N];       // free normal velocities, negative where closing
    f32x8 correction; // of the velocities that move the poses, in units of the change of velocity
};

CAIRN_INLINE Velocityx8 gather_twist(const SolverTwist* rows, const std::uint32_t* row) {
    return gather_velocity(reinterpret_cast<const SolverVelocity*>(rows), row);
}

struct Rebound {
    f32x8 velocity;   // opening velocity in the stored convention, at the end of the substep
    f32x8 correction; // to add to it for moving the pose
};

CAIRN_INLINE Rebound rebound(f32x8 approach, f32x8 gap, f32x8 acceleration, f32x8 restitution, f32x8 other_correction,
                             const BounceSettings& settings) {
    const f32x8 h = splat(settings.h), ah = acceleration * h, offset = splat(settings.velocity_offset);
    const f32x8 u = max(approach - offset * ah, zero());
    const f32x8 w = sqrt(u * u + splat(2.0f) * acceleration * gap);
    const f32x8 t = min(splat(2.0f) * gap / max(u + w, splat(1e-20f)), h), left = h - t;
    const f32x8 rebound = restitution * w;
    const f32x8 end_gap = max(left * (rebound - splat(0.5f) * acceleration * left), zero());
    // A contact does not close again in the same substep: if the rebound is that slow, it stays on the surface.
    const f32x8 velocity = max(rebound - acceleration * left + (one() - offset) * ah, zero());
    return {velocity, (end_gap - gap) / h - velocity - other_correction};
}

struct TwoTwists {
    Velocityx8 a, b;
};

CAIRN_INLINE TwoTwists free_velocities(const SolverBodies& bodies, const std::uint32_t* a, const std::uint32_t* b) {
    return {gather_velocity(bodies.reference, a), gather_velocity(bodies.reference, b)};
}

CAIRN_INLINE TwoTwists carried_over(const SolverBodies& bodies, const std::uint32_t* row_a, const std::uint32_t* row_b,
                                    const TwoTwists& free) {
    const Velocityx8 a = gather_velocity(bodies.velocity, row_a), b = gather_velocity(bodies.velocity, row_b);
    return {{a.v - free.a.v, a.w - free.a.w}, {b.v - free.b.v, b.w - free.b.w}};
}

// Drives of the two bodies, and corrections of the velocities that move their poses.
struct DrivesAndCorrections {
    Velocityx8 drive_a, drive_b, other_a, other_b; // other: corrections so far
};

// The normal velocity of a point, from velocities of the two bodies or from corrections of them.
template <int N>
CAIRN_INLINE f32x8 velocity_of(const ImpactState<N>& m, int i, const Velocityx8& a, const Velocityx8& b) {
    return dot(m.normal, b.v - a.v) + (dot(m.arm_b[i], b.w) - dot(m.arm_a[i], a.w));
}

template <int N> CAIRN_INLINE void find_velocities(const Velocityx8& a, const Velocityx8& b, ImpactState<N>& m) {
    for (int i = 0; i < N; ++i) m.v[i] = velocity_of(m, i, a, b);
}

// The contact at the start of the substep.
template <int N>
CAIRN_INLINE ImpactState<N> impact_state_now(const ContactBlock<N>& block, Vec3x8 d, const Velocityx8& a,
                                             const Velocityx8& b) {
    ImpactState<N> m;
    m.normal = load3(block.normal);
    m.d = d;
    m.center = load3(block.center);
    m.correction = zero();
    const Vec3x8 c = cross(m.d, m.normal);
    for (int i = 0; i < N; ++i) {
        m.arm_a[i] = arm_of(block, m.normal, i);
        m.arm_b[i] = m.arm_a[i] + c;
    }
    find_velocities(a, b, m);
    return m;
}

// The rebound velocity of a point.
template <int N>
CAIRN_INLINE Rebound rebound_of(const ContactBlock<N>& block, const ImpactState<N>& m, int i,
                                const DrivesAndCorrections& around, const BounceSettings& settings) {
    const f32x8 acceleration = max((dot(m.arm_a[i], around.drive_a.w) - dot(m.arm_b[i], around.drive_b.w) -
                                    dot(m.normal, around.drive_b.v - around.drive_a.v)) *
                                       splat(1.0f / settings.h),
                                   zero());
    const f32x8 other = velocity_of(m, i, around.other_a, around.other_b);
    return rebound(-m.v[i], max(load(block.separation[i]), zero()), acceleration, load(block.restitution), other,
                   settings);
}

// The change of each point's arm for A when A has moved by `passed` relative to B since the pose that `normal` belongs
// to. The point stays with a sphere; with A if B cannot move; between two boxes, midway. Between two spheres the normal
// turns with the line of centers.
template <int N> CAIRN_INLINE Vec3x8 turn_to_impact(const ContactBlock<N>& block, Vec3x8 passed, Vec3x8& normal) {
    const f32x8 box_share = select(load(block.mass_b) == zero(), zero(), splat(0.5f));
    if constexpr (N == 1) {
        f32x8 radius_a = load(block.radius_a), radius_b = load(block.radius_b);
        if (has_round_pairs(block)) {
            const mask8 rounds = mask_from_bits(block.round_pairs);
            const f32x8 farther = select(rounds, half_gap(block, load(block.separation[0])), zero());
            radius_a += farther, radius_b += farther;
        }
        const mask8 round_a = radius_a > zero(), round_b = radius_b > zero(), both = round_a & round_b;
        const Vec3x8 centers = (radius_a + radius_b) * normal - passed;
        const f32x8 square = dot(centers, centers);
        const mask8 turns = both & (square > zero());
        const Vec3x8 turned = (one() / sqrt(select(turns, square, one()))) * centers;
        const Vec3x8 shift = radius_a * (turned - normal);
        const f32x8 share = select(round_a, zero(), select(round_b, one(), box_share));
        normal = select(turns, turned, normal);
        return select(turns, shift, -(share * passed));
    } else {
        return -(box_share * passed);
    }
}

template <int N>
CAIRN_INLINE ImpactState<N> impact_state_later(const ContactBlock<N>& block, const ImpactState<N>& now,
                                               const Velocityx8& a, const Velocityx8& b,
                                               const DrivesAndCorrections& around, float h) {
    ImpactState<N> m = now;
    const Vec3x8 passed = splat(h) * (around.other_a.v - around.other_b.v) - (splat(h) * now.correction) * (a.v - b.v);
    m.d = now.d + passed;
    const Vec3x8 shift = turn_to_impact(block, m.d - d_of_normal(block), m.normal);
    m.center = now.center + shift;
    const Vec3x8 c = cross(m.d, m.normal), moved = cross(shift, m.normal);
    for (int i = 0; i < N; ++i) {
        m.arm_a[i] = N == 1 ? cross(m.center, m.normal) : now.arm_a[i] + moved;
        m.arm_b[i] = m.arm_a[i] + c;
    }
    find_velocities(a, b, m);
    return m;
}

// The impulses that give the arriving points their rebound velocities: Gauss-Seidel with the couplings at the impact.
template <int N>
CAIRN_INLINE void find_impulses(const ContactBlock<N>& block, ImpactState<N>& m, const f32x8* target,
                                const mask8* arrives, f32x8* impulse) {
    const f32x8 mass = load(block.mass_a) + load(block.mass_b);
    f32x8 k[N][N], inverse[N];
    for (int i = 0; i < N; ++i) {
        const Vec3x8 ia = turned_a(block, m.arm_a[i]), ib = turned_b(block, m.arm_b[i]);
        for (int j = 0; j < N; ++j) k[j][i] = mass + (dot(m.arm_a[j], ia) + dot(m.arm_b[j], ib));
        inverse[i] = select(arrives[i], one() / max(k[i][i], splat(1e-35f)), zero());
        impulse[i] = zero();
    }
    for (int sweep = 0; sweep < (N > 1 ? point_sweeps : 1); ++sweep)
        for (int i = 0; i < N; ++i) {
            const f32x8 next = max(impulse[i] + inverse[i] * (target[i] - m.v[i]), zero()), d = next - impulse[i];
            impulse[i] = next;
            for (int j = 0; j < N; ++j) m.v[j] += k[j][i] * d;
        }
}

// Points that reach the surface within this substep, faster than the threshold.
template <int N>
CAIRN_INLINE mask8 arriving(const ContactBlock<N>& block, const ImpactState<N>& m, const TwoTwists& carried,
                            const BounceSettings& settings, mask8* arrives) {
    mask8 lanes = zero() > one();
    for (int i = 0; i < N; ++i) {
        // Velocities that are carried over may keep the bodies apart, but do not bring them together.
        const f32x8 v = m.v[i] + max(velocity_of(m, i, carried.a, carried.b), zero());
        arrives[i] = (load(block.effective_mass[i]) > zero()) & (v < splat(-settings.threshold)) &
                     (load(block.separation[i]) + splat(settings.h) * v <= zero()) & (load(block.restitution) > zero());
        lanes = lanes | arrives[i];
    }
    return lanes;
}

// The arm for A of the load of an impact. `torque_a`: the sum of impulse times arm.
template <int N>
CAIRN_INLINE Vec3x8 load_center(const ContactBlock<N>& block, const ImpactState<N>& m, f32x8 sum, Vec3x8 torque_a) {
    if constexpr (N == 1) return m.center;
    const Vec3x8 t1 = load3(block.tangent), t2 = second_tangent(block, load3(block.normal));
    const mask8 bears = sum > zero();
    const LoadOffset e = load_offset(m.center, one() / select(bears, sum, one()), torque_a, t1, t2);
    return m.center + select(bears, e.x * t1 + e.y * t2, zero3());
}

// Coulomb friction of the impact itself, at its load, with an initial impulse of zero.
template <int N>
CAIRN_INLINE Vec3x8 impact_friction(const ContactBlock<N>& block, const ImpactState<N>& m, f32x8 load_sum,
                                    const Velocityx8& a, const Velocityx8& b) {
    const Vec3x8 t1 = load3(block.tangent), t2 = second_tangent(block, load3(block.normal));
    const Vec3x8 slip = (b.v - a.v) + cross(b.w - a.w, m.center) + cross(b.w, m.d);
    const auto [p1, p2] = slip_stop(block, m.center, m.d, t1, t2, dot(slip, t1), dot(slip, t2));
    const f32x8 size = sqrt(p1 * p1 + p2 * p2), limit = load(block.friction) * load_sum;
    const f32x8 scale = min(limit / (size + splat(1e-20f)), one());
    return scale * (p1 * t1 + p2 * t2);
}

// Torsional friction and rolling resistance of the impact itself: a couple, limited by friction and the rolling radius
// times the normal impulses. Without it, a body on a surface with restitution would never stop rolling: it rests by
// bouncing in every substep. `aside`: squared distance from the friction center to the load.
template <int N>
CAIRN_INLINE Vec3x8 impact_couple(const ContactBlock<N>& block, Vec3x8 normal, const f32x8* impulse, f32x8 sum,
                                  f32x8 aside, const Velocityx8& a, const Velocityx8& b) {
    f32x8 radius_load = load(block.torsion_radius) * sum;
    if constexpr (N > 1) {
        f32x8 spread = zero();
        for (int i = 0; i < N; ++i) spread += load(block.square_lever[i]) * impulse[i];
        radius_load = max(radius_load, sqrt(max(sum * (spread - aside * sum), zero())));
    }
    const f32x8 limit = load(block.friction) * radius_load;
    const Vec3x8 dw = b.w - a.w;
    const f32x8 spin = clamp(-(load(block.torsion_mass) * dot(normal, dw)), -limit, limit);
    if (!block.rolls) return spin * normal;
    const Vec3x8 p = -(rolling_mass(block) * dw); // as in relax
    const f32x8 most = load(block.rolling_radius) * sum;
    const f32x8 scale = min(most / (sqrt(dot(p, p)) + splat(1e-20f)), one());
    return spin * normal + scale * p;
}

CAIRN_INLINE void add_to_rows(SolverVelocity* rows, const std::uint32_t* row, const std::uint32_t* write,
                              const Velocityx8& change, f32x8 factor) {
    Velocityx8 r = gather_velocity(rows, row);
    r = {r.v + factor * change.v, r.w + factor * change.w};
    scatter_velocity(rows, write, r);
}

// Displacement of A relative to B since the start of the step.
CAIRN_INLINE Vec3x8 passed_of(const SolverPose* pose, const std::uint32_t* a, const std::uint32_t* b) {
    const auto* rows = reinterpret_cast<const SolverVelocity*>(pose); // dx has the offset of v
    return gather_velocity(rows, a).v - gather_velocity(rows, b).v;
}

// Bounces one block; returns whether anything bounced. Contacts of jointed bodies bounce in an impact (impact.cpp),
// together with the joints.
template <int N>
CAIRN_INLINE bool bounce_block(ContactBlock<N>& block, const SolverBodies& bodies, const BounceSettings& settings) {
    if (!block.bounces) return false;
    const TwoTwists free = free_velocities(bodies, block.a, block.b),
                    carried = carried_over(bodies, block.a, block.b, free);
    ImpactState<N> now = impact_state_now(block, load3(block.d), free.a, free.b);
    mask8 arrives[N];
    mask8 may_bounce = arriving(block, now, carried, settings, arrives);
    if (!any(may_bounce)) return false;
    if (block.joined) {
        const mask8 joined = mask_from_bits(block.joined);
        block.in_impact = std::uint8_t(block.in_impact | bits(may_bounce & joined));
        may_bounce = and_not(may_bounce, joined);
        if (!any(may_bounce)) return false;
    }
    // d in the block is limited, because carried-over impulses act there (refresh_arm); a bounce acts at the actual d.
    // A lane must arrive with both: else the result would depend on whether another lane of its block does.
    now = impact_state_now(block, load3(block.d0) + passed_of(bodies.pose, block.a, block.b), free.a, free.b);
    if (!any(may_bounce & arriving(block, now, carried, settings, arrives))) return false;
    for (int i = 0; i < N; ++i) arrives[i] = arrives[i] & may_bounce;
    const DrivesAndCorrections around = {gather_twist(bodies.drive, block.a), gather_twist(bodies.drive, block.b),
                                         gather_twist(bodies.velocity_correction, block.a),
                                         gather_twist(bodies.velocity_correction, block.b)};
    f32x8 change = zero(), correction = zero(), target[N], impulse[N], sum = zero();
    for (int i = 0; i < N; ++i) {
        const Rebound r = rebound_of(block, now, i, around, settings);
        change += select(arrives[i], r.velocity - now.v[i], zero());
        correction += select(arrives[i], r.correction, zero());
    }
    // The bodies meet within the substep: the correction takes back none to all of the change of velocity.
    now.correction = clamp(correction / max(change, splat(1e-20f)), splat(-1.0f), zero());
    ImpactState<N> m = impact_state_later(block, now, free.a, free.b, around, settings.h);
    mask8 bounces = zero() > one();
    for (int i = 0; i < N; ++i) {
        arrives[i] = arrives[i] & (m.v[i] < splat(-settings.threshold));
        bounces = bounces | arrives[i];
        target[i] = rebound_of(block, m, i, around, settings).velocity;
    }
    if (!any(bounces)) return false;
    find_impulses(block, m, target, arrives, impulse);
    Vec3x8 torque_a = zero3(), torque_b = zero3();
    for (int i = 0; i < N; ++i) {
        sum += impulse[i];
        torque_a = torque_a + impulse[i] * m.arm_a[i];
        torque_b = torque_b + impulse[i] * m.arm_b[i];
        store(block.total_impulse[i], load(block.total_impulse[i]) + impulse[i]);
    }
    // Friction acts on the whole velocities, with those that are carried over.
    const Velocityx8 before_a = gather_velocity(bodies.velocity, block.a),
                     before_b = gather_velocity(bodies.velocity, block.b);
    Velocityx8 a = before_a, b = before_b;
    a = {a.v - (load(block.mass_a) * sum) * m.normal, a.w - turned_a(block, torque_a)};
    b = {b.v + (load(block.mass_b) * sum) * m.normal, b.w + turned_b(block, torque_b)};
    const Vec3x8 load_at = load_center(block, m, sum, torque_a), e = load_at - m.center;
    m.center = load_at;
    const Vec3x8 p = impact_friction(block, m, sum, a, b);
    apply_friction(block, m.center, m.d, p, zero3(), a, b);
    const Vec3x8 couple = impact_couple<N>(block, m.normal, impulse, sum, dot(e, e), a, b);
    a.w = a.w - turned_a(block, couple);
    b.w = b.w + turned_b(block, couple);
    scatter_velocity(bodies.velocity, block.a, a);
    scatter_velocity(bodies.velocity, block.write_b, b);
    const Velocityx8 change_a = {a.v - before_a.v, a.w - before_a.w}, change_b = {b.v - before_b.v, b.w - before_b.w};
    // The reference changes by the same: the bounce is complete, and must not be carried into the next substep.
    add_to_rows(bodies.reference, block.a, block.a, change_a, one());
    add_to_rows(bodies.reference, block.b, block.write_b, change_b, one());
    auto* corrections = reinterpret_cast<SolverVelocity*>(bodies.velocity_correction);
    add_to_rows(corrections, block.a, block.a, change_a, now.correction);
    add_to_rows(corrections, block.b, block.write_b, change_b, now.correction);
    return true;
}

} // namespace

template <int N>
BounceCount bounce_contacts(void* blocks, int count, const SolverBodies& bodies, const BounceSettings& settings) {
    auto* all = static_cast<ContactBlock<N>*>(blocks);
    BounceCount blocks_that{0, 0};
    for (int k = 0; k < count; ++k) {
        blocks_that.bounced += bounce_block<N>(all[k], bodies, settings);
        blocks_that.in_impact += all[k].in_impact != 0;
    }
    return blocks_that;
}

template <int N>
void find_contact_rebounds(const void* blocks, void* impacts, const ReboundTargets& aimed, int count,
                           const SolverBodies& bodies, const BounceSettings& settings) {
    auto* all = static_cast<const ContactBlock<N>*>(blocks);
    auto* given = static_cast<ContactImpact<N>*>(impacts);
    for (int k = 0; k < count; ++k) {
        const ContactBlock<N>& block = all[k];
        const f32x8 restitution = load(block.restitution);
        const TwoTwists free = free_velocities(bodies, block.a, block.b),
                        carried = carried_over(bodies, block.a, block.b, free);
        const ImpactState<N> now = impact_state_now(block, load3(block.d), free.a, free.b);
        const Velocityx8 other_a = gather_twist(bodies.velocity_correction, block.a),
                         other_b = gather_twist(bodies.velocity_correction, block.b);
        mask8 arrives[N];
        const mask8 takes_part = arriving(block, now, carried, settings, arrives) | (restitution <= zero());
        const Velocityx8 drive_a = gather_twist(bodies.drive, block.a), drive_b = gather_twist(bodies.drive, block.b);
        for (int i = 0; i < N; ++i) {
            const f32x8 forced = velocity_of(now, i, carried.a, carried.b), v = now.v[i] + forced;
            // The gap of contacts that bounced before in this substep is that which they would have had they come with
            // their present velocity.
            const f32x8 shift = velocity_of(now, i, other_a, other_b);
            const f32x8 gap = load(block.separation[i]) + splat(settings.h) * shift;
            const f32x8 way = select(arrives[i], splat(-settings.h) * v, one());
            const f32x8 arrival = clamp(gap / way, zero(), one());
            // The velocity that forces add between the moment that stored velocities belong to and the impact.
            const f32x8 late =
                (forced + velocity_of(now, i, drive_a, drive_b)) * (arrival - splat(settings.velocity_offset));
            const f32x8 after = restitution * max(-v - late, zero()) - late;
            // A point that forces would bring back within the substep stays on the surface, held by the solver.
            const f32x8 rebound = select(after >= zero(), after, min(forced, zero()));
            store(aimed.speed + 8 * (N * k + i), select(arrives[i], rebound, splat(does_not_arrive)));
            store(aimed.arrival + 8 * (N * k + i), arrival);
        }
        given[k].active = std::uint8_t(given[k].active & bits(takes_part));
    }
}

template void find_contact_rebounds<1>(const void*, void*, const ReboundTargets&, int, const SolverBodies&,
                                       const BounceSettings&);
template void find_contact_rebounds<4>(const void*, void*, const ReboundTargets&, int, const SolverBodies&,
                                       const BounceSettings&);
template BounceCount bounce_contacts<1>(void*, int, const SolverBodies&, const BounceSettings&);
template BounceCount bounce_contacts<4>(void*, int, const SolverBodies&, const BounceSettings&);

} // namespace cairn::CAIRN_ISA
