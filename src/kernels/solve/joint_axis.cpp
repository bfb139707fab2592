// Axis rows: one direction of motion, with limits, a drive and friction, which share one scalar velocity. The kind
// defines the position and its rate of change with the velocities: J = (linear_a, angular_a, linear_b, angular_b).
#include "kernels/solve/joint_angles.h"
#include "kernels/solve/joint_locks.h"

#include <type_traits>

namespace cairn::CAIRN_ISA {

namespace {

constexpr float tiny = 1e-20f, min_length = 1e-6f;

CAIRN_INLINE Vec3x8 unit(Vec3x8 v, f32x8 length) { return guarded_inverse(length, length > splat(min_length)) * v; }

struct Jacobianx8 {
    Vec3x8 linear_a, angular_a, linear_b, angular_b;
};
CAIRN_INLINE Jacobianx8 load_jacobian(const AxisBlock& b) {
    return {load3(b.linear_a), load3(b.angular_a), load3(b.linear_b), load3(b.angular_b)};
}
CAIRN_INLINE bool is_turning(AxisKind kind) {
    switch (kind) {
    case AxisKind::linear:
    case AxisKind::radial:
    case AxisKind::distance:
    case AxisKind::rack:
    case AxisKind::pulley:
        return false;
    default:
        return true;
    }
}
// Rows about an axis rotate the bodies of joints without a point but do not move them: linear velocities are neither
// read nor written. The bits are the same as with a Jacobian whose linear part is zero.
template <class F> CAIRN_INLINE void for_kind(const AxisBlock& b, F&& f) {
    is_turning(b.kind) && b.points == 0 ? f(std::true_type{}) : f(std::false_type{});
}

template <bool Turns> CAIRN_INLINE void apply(const AxisBlock& b, const Jacobianx8& j, f32x8 p, Ends8& e) {
    if constexpr (!Turns) {
        e.a.v = e.a.v + load(b.mass_a) * (p * j.linear_a);
        e.b.v = e.b.v + load(b.mass_b) * (p * j.linear_b);
    }
    e.a.w = e.a.w + turned_a(b, p * j.angular_a);
    e.b.w = e.b.w + turned_b(b, p * j.angular_b);
}
template <bool Turns> CAIRN_INLINE f32x8 velocity_of(const Jacobianx8& j, const Ends8& e) {
    const f32x8 turning = dot(j.angular_a, e.a.w) + dot(j.angular_b, e.b.w);
    if constexpr (Turns) return zero() + turning;
    return (dot(j.linear_a, e.a.v) + dot(j.linear_b, e.b.v)) + turning;
}
template <bool Turns> CAIRN_INLINE Ends8 gather_moved(const SolverVelocity* rows, const AxisBlock& b) {
    if constexpr (Turns)
        return {{zero3(), gather_angular(rows, b.a)}, {zero3(), gather_angular(rows, b.b)}};
    else
        return gather_ends(rows, b);
}
template <bool Turns, class Lanes> CAIRN_INLINE void scatter_moved(SolverVelocity* rows, Lanes lanes, const Ends8& e) {
    if constexpr (Turns) {
        scatter_angular(rows, lanes.to_a, e.a.w);
        scatter_angular(rows, lanes.to_b, e.b.w);
    } else {
        scatter_ends(rows, lanes, e);
    }
}
CAIRN_INLINE f32x8 net_impulse(const AxisBlock& b) {
    return (load(b.drive_impulse) + load(b.friction_impulse)) + (load(b.lower_impulse) - load(b.upper_impulse));
}

// Arms, gap and axes at the current poses.
struct Geometryx8 {
    const Posesx8& poses;
    Vec3x8 arm_a, arm_b, gap, axis_a, axis_b;
};
template <bool Turns> CAIRN_INLINE Geometryx8 geometry_of(const AxisBlock& b, const Posesx8& poses) {
    const Vec3x8 axis_a0 = load3(b.axis_a0), axis_b0 = load3(b.axis_b0);
    const Vec3x8 axis_a = axis_a0 + turned_difference(poses.dq_a, axis_a0),
                 axis_b = axis_b0 + turned_difference(poses.dq_b, axis_b0);
    if constexpr (Turns) return {poses, zero3(), zero3(), zero3(), axis_a, axis_b};
    const Vec3x8 arm_a0 = load3(b.arm_a0), arm_b0 = load3(b.arm_b0);
    const Vec3x8 change_a = turned_difference(poses.dq_a, arm_a0), change_b = turned_difference(poses.dq_b, arm_b0);
    return {poses,
            arm_a0 + change_a,
            arm_b0 + change_b,
            load3(b.gap0) + ((poses.dx_b - poses.dx_a) + (change_b - change_a)),
            axis_a,
            axis_b};
}

CAIRN_INLINE Jacobianx8 linear_jacobian(const Geometryx8& g, Vec3x8 d) {
    return {-d, -cross(g.arm_a + g.gap, d), d, cross(g.arm_b, d)};
}
CAIRN_INLINE Jacobianx8 angular_jacobian(Vec3x8 a) { return {zero3(), -a, zero3(), a}; }

// The angle by which the body has rotated about the axis since the start of the step.
CAIRN_INLINE f32x8 angle_about(Quatx8 dq, Vec3x8 axis) { return splat(2.0f) * angle_of(dot(dq.v, axis), dq.w); }
// The rotation vector of the shorter rotation.
CAIRN_INLINE Vec3x8 rotation_vector(Quatx8 q) {
    const f32x8 sign = select(q.w < zero(), splat(-1.0f), one()), sine = sqrt(dot(q.v, q.v));
    const f32x8 factor = select(sine > splat(min_length), angle_of(sine, abs(q.w)) / (sine + splat(tiny)), one());
    return ((sign + sign) * factor) * q.v;
}

struct Rowx8 {
    Jacobianx8 jacobian;
    f32x8 position;
};

CAIRN_INLINE Rowx8 pulley_row(const AxisBlock& b, const Geometryx8& g) {
    // axis_a0 and axis_b0 reach from the fixed points to the anchors at the start of the step; they do not turn.
    const Vec3x8 reach_a = load3(b.axis_a0) + (g.poses.dx_a + (g.arm_a - load3(b.arm_a0)));
    const Vec3x8 reach_b = load3(b.axis_b0) + (g.poses.dx_b + (g.arm_b - load3(b.arm_b0)));
    const f32x8 length_a = sqrt(dot(reach_a, reach_a)), length_b = sqrt(dot(reach_b, reach_b));
    const f32x8 ra = load(b.ratio_a), rb = load(b.ratio_b);
    const Vec3x8 da = ra * unit(reach_a, length_a), db = rb * unit(reach_b, length_b);
    return {{da, cross(g.arm_a, da), db, cross(g.arm_b, db)}, ra * length_a + rb * length_b};
}

// The angle plus those full turns that bring it closest to the last position.
CAIRN_INLINE f32x8 counted_angle(const AxisBlock& b, f32x8 angle) {
    return angle + splat(2 * pi) * rounded((load(b.position) - angle) * splat(0.5f / pi));
}
CAIRN_INLINE f32x8 angle_between(Vec3x8 u, Vec3x8 w, Vec3x8 n) { return angle_of(dot(n, cross(u, w)), dot(u, w)); }

// The component of the rotation vector r along an axis a of A. With the relative angular velocity w, it changes at the
// rate u.w with u = a + (r x a) / 2 + c r x (r x a), c = (1 - (phi / 2) cot(phi / 2)) / phi^2, where phi = |r|. A
// spring that acted along a itself would accelerate the remaining rotation without bound.
CAIRN_INLINE Rowx8 rotation_row(const Geometryx8& g, Quatx8 turn) {
    const Vec3x8 r = rotation_vector(turn), across = cross(r, g.axis_a);
    const f32x8 square = dot(r, r), sine = sqrt(dot(turn.v, turn.v));
    const mask8 is_large = square > splat(0.01f);
    const f32x8 half_cotangent = splat(0.5f) * sqrt(square) * abs(turn.w) / (sine + splat(tiny));
    const f32x8 exact = (one() - half_cotangent) / select(is_large, square, one());
    const f32x8 c = select(is_large, exact, splat(1.0f / 12) + splat(1.0f / 720) * square);
    return {angular_jacobian(g.axis_a + splat(0.5f) * across + c * cross(r, across)), dot(r, g.axis_a)};
}

CAIRN_INLINE Rowx8 turning_row(const AxisBlock& b, const Geometryx8& g) {
    switch (b.kind) {
    case AxisKind::swing: {
        const Vec3x8 u = cross(g.axis_a, g.axis_b);
        const f32x8 sine = sqrt(dot(u, u));
        return {angular_jacobian(unit(u, sine)), angle_of(sine, dot(g.axis_a, g.axis_b))};
    }
    case AxisKind::perpendicular:
        return {angular_jacobian(cross(g.axis_b, g.axis_a)), dot(g.axis_a, g.axis_b)};
    case AxisKind::gear: {
        const f32x8 ra = load(b.ratio_a), rb = load(b.ratio_b);
        const f32x8 way = ra * angle_about(g.poses.dq_a, g.axis_a) + rb * angle_about(g.poses.dq_b, g.axis_b);
        return {{zero3(), ra * g.axis_a, zero3(), rb * g.axis_b}, load(b.position0) + way};
    }
    default:
        break;
    }
    const Quatx8 turn = turn_now(g.poses, load_quat(b.turn0));
    switch (b.kind) {
    case AxisKind::twist: {
        const f32x8 angle = splat(2.0f) * angle_of(dot(turn.v, g.axis_a), turn.w);
        // The rate of the twist angle is the component of the relative angular velocity along (a + b) / (1 + a.b).
        const f32x8 s = one() / max(one() + dot(g.axis_a, g.axis_b), splat(0.1f));
        return {angular_jacobian(s * (g.axis_a + g.axis_b)), counted_angle(b, angle)};
    }
    case AxisKind::cross_a:
        return {angular_jacobian(g.axis_a),
                counted_angle(b, angle_between(rotate_back(turn, g.axis_b), g.axis_b, g.axis_a))};
    case AxisKind::cross_b:
        return {angular_jacobian(g.axis_b),
                counted_angle(b, angle_between(g.axis_a, rotate(turn, g.axis_a), g.axis_b))};
    case AxisKind::turn: {
        const Vec3x8 r = rotation_vector(turn);
        const f32x8 angle = sqrt(dot(r, r));
        return {angular_jacobian(unit(r, angle)), angle};
    }
    default: // rotation
        return rotation_row(g, turn);
    }
}

CAIRN_INLINE Rowx8 moving_row(const AxisBlock& b, const Geometryx8& g) {
    switch (b.kind) {
    case AxisKind::linear:
        return {linear_jacobian(g, g.axis_a), dot(g.axis_a, g.gap)};
    case AxisKind::radial: {
        const Vec3x8 off = across(g.axis_a, g.gap);
        const f32x8 distance = sqrt(dot(off, off));
        return {linear_jacobian(g, unit(off, distance)), distance};
    }
    case AxisKind::distance: {
        const f32x8 distance = sqrt(dot(g.gap, g.gap));
        return {linear_jacobian(g, unit(g.gap, distance)), distance};
    }
    case AxisKind::rack: {
        const f32x8 ra = load(b.ratio_a), rb = load(b.ratio_b);
        const f32x8 way = ra * angle_about(g.poses.dq_a, g.axis_a) + rb * dot(g.axis_b, g.poses.dx_b);
        return {{zero3(), ra * g.axis_a, rb * g.axis_b, zero3()}, load(b.position0) + way};
    }
    default:
        return pulley_row(b, g);
    }
}

// The angular part of M^-1 J^T for both bodies, and k = J M^-1 J^T.
struct Response8 {
    Vec3x8 a, b;
    f32x8 k;
};
CAIRN_INLINE Response8 response_of(const AxisBlock& b, const Jacobianx8& j) {
    const Vec3x8 by_a = turned_a(b, j.angular_a), by_b = turned_b(b, j.angular_b);
    const f32x8 turning = dot(j.angular_a, by_a) + dot(j.angular_b, by_b);
    const f32x8 linear = load(b.mass_a) * dot(j.linear_a, j.linear_a) + load(b.mass_b) * dot(j.linear_b, j.linear_b);
    return {by_a, by_b, linear + turning};
}

// The row together with those impulses of the joint's point and turn that keep their velocities unchanged:
// J - c^T J_p - d^T J_t, with K_pp c + K_pt d = J_p M^-1 J^T and K_tp c + K_tt d = J_t M^-1 J^T. Plain: no joint of the
// block has a turn, and their points have no free axis.
template <bool Plain>
CAIRN_INLINE Jacobianx8 held_by_locks(const AxisBlock& b, const Geometryx8& g, const Jacobianx8& j,
                                      const Response8& alone) {
    const Massesx8 m = load_masses(b);
    const auto axis_now = [&](const float(*p)[8]) {
        const Vec3x8 axis0 = load3(p);
        return axis0 + turned_difference(g.poses.dq_a, axis0);
    };
    const Vec3x8 point_axis = Plain ? zero3() : axis_now(b.point_axis0);
    const Arms8 arm{Plain ? g.arm_a : g.arm_a + dot(point_axis, g.gap) * point_axis, g.arm_b};
    const Vec3x8 slip =
        (m.mass_b * j.linear_b - m.mass_a * j.linear_a) + (cross(alone.b, arm.b) - cross(alone.a, arm.a));
    const mask8 points = mask_from_bits(b.points);
    Vec3x8 c, d = zero3();
    if constexpr (Plain) {
        c = select(points, inverse_by_pivots(slip_by_push(m, arm)) * slip, zero3());
    } else {
        const Sym3x8 turn = select(mask_from_bits(b.turns), response_of_turn(m, axis_now(b.turn_axis0)), zero6());
        const HeldTurn held = hold_turn(m, arm, turn);
        const Vec3x8 turning = alone.b - alone.a;
        c = select(points, response_of(held, point_axis) * (slip - held.d * turning), zero3());
        d = turn * turning - transposed_times(held.d, c);
    }
    return {j.linear_a + c, j.angular_a + (cross(arm.a, c) + d), j.linear_b - c, j.angular_b - (cross(arm.b, c) + d)};
}
CAIRN_INLINE Jacobianx8 select(mask8 m, const Jacobianx8& a, const Jacobianx8& b) {
    return {select(m, a.linear_a, b.linear_a), select(m, a.angular_a, b.angular_a), select(m, a.linear_b, b.linear_b),
            select(m, a.angular_b, b.angular_b)};
}

// Computes Jacobian, effective mass and position at the current poses.
template <bool Turns> CAIRN_INLINE void refresh(AxisBlock& b, const Posesx8& poses) {
    const Geometryx8 geometry = geometry_of<Turns>(b, poses);
    const Rowx8 row = is_turning(b.kind) ? turning_row(b, geometry) : moving_row(b, geometry);
    Jacobianx8 j = row.jacobian;
    const Response8 alone = response_of(b, j);
    f32x8 k = alone.k, moved = k;
    if (b.points | b.turns) {
        const Jacobianx8 held =
            b.plain_locks ? held_by_locks<true>(b, geometry, j, alone) : held_by_locks<false>(b, geometry, j, alone);
        const f32x8 left = response_of(b, held).k;
        const mask8 is_known = left > splat(rounding) * k; // else point and turn hold it all, or it is taken alone
        moved = select(is_known, left, k);
        const mask8 is_held = and_not(is_known, mask_from_bits(b.direct));
        j = select(is_held, held, j);
        k = select(is_held, left, k);
    }
    store3(b.angular_a, j.angular_a);
    store3(b.angular_b, j.angular_b);
    if constexpr (!Turns) store3(b.linear_a, j.linear_a), store3(b.linear_b, j.linear_b);
    store(b.position, row.position);
    store(b.mass, guarded_inverse(k, k > splat(tiny)));
    store(b.moved_mass, guarded_inverse(moved, moved > splat(tiny)));
}

// Computes the impulse of the drive's spring at the current position.
template <class Lanes> CAIRN_INLINE void refresh_drive(AxisBlock& b, Lanes lanes, f32x8 h) {
    if (!b.has_drive) return;
    const f32x8 unit_of = select(load(b.drive_relative) > zero(), load(b.moved_mass), one());
    const f32x8 k = load(b.drive_stiffness) * unit_of, d = load(b.drive_damping) * unit_of;
    const f32x8 pull = h * (k * (load(b.target_position) - load(b.position)) + d * load(b.target_velocity));
    store(b.drive_pull, among(lanes, pull, load(b.drive_pull)));
}

// A damped spring of stiffness k and damping d that acts at the end of the substep is a row of softness g = h (h k +
// d): its impulse is p = g ((pull / g) - v).
CAIRN_INLINE f32x8 spring_gain(f32x8 stiffness, f32x8 damping, f32x8 relative, f32x8 mass, f32x8 h) {
    return h * (h * stiffness + damping) * select(relative > zero(), mass, one());
}

// The velocity that a motor keeps, limited so that it does not drive the axis past rigid limits within a substep: these
// would not hold a motor that is stronger than they are stiff.
CAIRN_INLINE f32x8 motor_velocity(const AxisBlock& b, f32x8 inverse_h) {
    const f32x8 target = load(b.target_velocity);
    if (!b.has_limits) return target;
    const f32x8 x = load(b.position), least = min((load(b.lower) - x) * inverse_h, zero()),
                most = max((load(b.upper) - x) * inverse_h, zero());
    return select(load(b.rigid_limit) > zero(), clamp(target, least, most), target);
}

template <class Lanes> CAIRN_INLINE f32x8 drive(AxisBlock& b, Lanes lanes, f32x8 k, f32x8 v, f32x8 h, f32x8 inverse_h) {
    const f32x8 mass = load(b.mass), old = load(b.drive_impulse), most = load(b.max_drive);
    const f32x8 g =
        spring_gain(load(b.drive_stiffness), load(b.drive_damping), load(b.drive_relative), load(b.moved_mass), h);
    const mask8 rigid = load(b.rigid_drive) > zero();
    const f32x8 yields = one() / (k * g + one());
    const f32x8 gain = select(rigid, mass, g * yields), ease = select(rigid, zero(), yields);
    const f32x8 aim = select(rigid, motor_velocity(b, inverse_h), zero());
    const f32x8 p = clamp((old - gain * (v - aim)) - ease * (old - load(b.drive_pull)), -most, most);
    store(b.drive_impulse, among(lanes, p, old));
    return p - old;
}

struct LimitSoftness {
    f32x8 scale, rate;
};
template <bool Soft> CAIRN_INLINE LimitSoftness limit_softness(const AxisBlock& b, f32x8 k, const JointSoftness& s) {
    if (!b.has_soft_limits) return {splat(Soft ? s.scale : 1.0f), splat(Soft ? s.rate : 0.0f)};
    const f32x8 h = splat(s.h), relative = load(b.limit_relative), mass = load(b.moved_mass);
    const f32x8 stiffness = load(b.limit_stiffness), damping = load(b.limit_damping);
    const f32x8 g = spring_gain(stiffness, damping, relative, mass, h), kg = k * g;
    const mask8 rigid = load(b.rigid_limit) > zero();
    const f32x8 rate = stiffness / max(h * stiffness + damping, splat(tiny));
    return {select(rigid, splat(Soft ? s.scale : 1.0f), kg / (kg + one())),
            select(rigid, splat(Soft ? s.rate : 0.0f), rate)};
}

// One limit. v: velocity away from the limit; gap: distance from it; spring_gap: extension of its spring.
template <class Lanes>
CAIRN_INLINE f32x8 limit(float* impulse, Lanes lanes, const LimitSoftness& softness, f32x8 mass, f32x8 v, f32x8 gap,
                         f32x8 spring_gap, mask8 equation, f32x8 inverse_h) {
    const f32x8 old = load(impulse);
    const mask8 apart = and_not(gap > zero(), equation);
    const f32x8 scale = select(apart, one(), softness.scale);
    const f32x8 bias = select(apart, gap * inverse_h, softness.rate * spring_gap);
    const f32x8 p = scale * (old - mass * (v + bias));
    const f32x8 bounded = select(equation, p, max(p, zero()));
    store(impulse, among(lanes, bounded, old));
    return bounded - old;
}

// Solves drive, friction and limits of the row in turn; returns the sum of the impulses added. `before`: the position
// before this substep's poses were integrated, for springs.
template <bool Soft, class Lanes>
CAIRN_INLINE f32x8 act(AxisBlock& b, Lanes lanes, f32x8 v, f32x8 before, const JointSoftness& softness) {
    const f32x8 mass = load(b.mass), h = splat(softness.h), inverse_h = splat(softness.inverse_h);
    const mask8 gives = mass > zero();
    const f32x8 k = guarded_inverse(mass, gives);
    f32x8 sum = zero();
    if (b.has_drive) {
        const f32x8 d = drive(b, lanes, k, v, h, inverse_h);
        sum += d;
        v += k * d;
    }
    if (b.has_friction) {
        const f32x8 most = load(b.max_friction), old = load(b.friction_impulse);
        const f32x8 p = clamp(old - mass * v, -most, most), d = p - old;
        store(b.friction_impulse, among(lanes, p, old));
        sum += d;
        v += k * d;
    }
    if (b.has_limits) {
        const LimitSoftness soft = limit_softness<Soft>(b, k, softness);
        const f32x8 x = load(b.position), lower = load(b.lower), upper = load(b.upper);
        const mask8 equation = load(b.equation) > zero();
        const f32x8 up = limit(b.lower_impulse, lanes, soft, mass, v, x - lower, before - lower, equation, inverse_h);
        v += k * up;
        const f32x8 beyond = select(equation, splat(unlimited), upper);
        const f32x8 down =
            limit(b.upper_impulse, lanes, soft, mass, -v, beyond - x, beyond - before, mask_from_bits(0), inverse_h);
        sum += up - down;
    }
    return among(lanes, select(gives, sum, zero()), zero());
}

template <bool Turns> void begin_block(AxisBlock& b, const SolverBodies& bodies, const JointSoftness& softness) {
    first_masses(b, bodies.inertia);
    if constexpr (Turns) store3(b.linear_a, zero3()), store3(b.linear_b, zero3()); // others read them
    refresh<Turns>(b, gather_poses(bodies.pose, b));
    store(b.position0, load(b.position));
    refresh_drive(b, all_of(b), splat(softness.h));
    b.leaves = 0;
    store(b.total, zero());
}

template <bool Turns, class Lanes>
CAIRN_INLINE void warm_start_block(AxisBlock& b, Lanes lanes, const SolverBodies& bodies,
                                   const JointSoftness& softness) {
    if (lanes.is_solved_first) begin_block<Turns>(b, bodies, softness);
    const f32x8 p = among(lanes, net_impulse(b), zero());
    if (all(p == zero())) return; // the usual case of limits
    Ends8 e = gather_moved<Turns>(bodies.velocity, b);
    apply<Turns>(b, load_jacobian(b), p, e);
    scatter_moved<Turns>(bodies.velocity, lanes, e);
}

template <bool Turns, class Lanes>
CAIRN_INLINE void solve_block(AxisBlock& b, Lanes lanes, SolverVelocity* velocity, const JointSoftness& softness) {
    Ends8 e = gather_moved<Turns>(velocity, b);
    if (b.leaves) {
        if constexpr (!Turns) e.a.v = e.a.v + load3(b.left[0]), e.b.v = e.b.v + load3(b.left[2]);
        e.a.w = e.a.w + load3(b.left[1]), e.b.w = e.b.w + load3(b.left[3]);
    }
    const Jacobianx8 j = load_jacobian(b);
    const f32x8 d = act<true>(b, lanes, velocity_of<Turns>(j, e), load(b.position), softness);
    if (!b.leaves && all(d == zero())) return;
    apply<Turns>(b, j, d, e);
    scatter_moved<Turns>(velocity, lanes, e);
}

// Updates the block to the new poses. The change of the carried-over impulse's effect by the new Jacobian is left for
// the next solve.
template <bool Turns> void follow_poses(AxisBlock& b, const SolverBodies& bodies) {
    store(b.before, load(b.position));
    const Posesx8 poses = gather_poses(bodies.pose, b);
    const f32x8 p = net_impulse(b);
    b.leaves = !all(p == zero());
    Ends8 change = {{zero3(), zero3()}, {zero3(), zero3()}};
    if (b.leaves) apply<Turns>(b, load_jacobian(b), -p, change);
    if (!b.isotropic) renew_masses(b, bodies.inertia);
    refresh<Turns>(b, poses);
    if (!b.leaves) return;
    apply<Turns>(b, load_jacobian(b), p, change);
    if constexpr (!Turns) store3(b.left[0], change.a.v), store3(b.left[2], change.b.v);
    store3(b.left[1], change.a.w), store3(b.left[3], change.b.w);
}

template <bool Turns, class Lanes>
CAIRN_INLINE void relax_block(AxisBlock& b, Lanes lanes, const SolverBodies& bodies, const JointSoftness& softness) {
    if (lanes.is_solved_first) follow_poses<Turns>(b, bodies);
    const Jacobianx8 j = load_jacobian(b);
    Ends8 e = gather_moved<Turns>(bodies.velocity, b);
    const f32x8 d = act<false>(b, lanes, velocity_of<Turns>(j, e), load(b.before), softness), total = load(b.total);
    store(b.total, among(lanes, total + net_impulse(b), total));
    refresh_drive(b, lanes, splat(softness.h));
    if (all(d == zero())) return;
    apply<Turns>(b, j, d, e);
    scatter_moved<Turns>(bodies.velocity, lanes, e);
}

// Calls f(block, its lanes, whether its rows only rotate bodies, as a constant) for the blocks of a run.
template <class F> CAIRN_INLINE void for_kinds(const JointBlocks& run, F&& f) {
    for_lanes<AxisBlock>(run, [&](AxisBlock& b, auto lanes) { for_kind(b, [&](auto turns) { f(b, lanes, turns); }); });
}
void warm_start(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness& softness) {
    for_kinds(run, [&](auto& b, auto lanes, auto turns) { warm_start_block<turns>(b, lanes, bodies, softness); });
}
void solve(const JointBlocks& run, SolverVelocity* velocity, const JointSoftness& softness) {
    for_kinds(run, [&](auto& b, auto lanes, auto turns) { solve_block<turns>(b, lanes, velocity, softness); });
}
void relax(const JointBlocks& run, const SolverBodies& bodies, const JointSoftness& softness) {
    for_kinds(run, [&](auto& b, auto lanes, auto turns) { relax_block<turns>(b, lanes, bodies, softness); });
}

// One pass of an impact on rigid limits and equations; drives and friction give no impulses.
template <bool Turns>
CAIRN_INLINE void strike_block(AxisBlock& b, JointImpact& impact, SolverVelocity* velocity, float inverse_h) {
    Ends8 e = gather_moved<Turns>(velocity, b);
    const Jacobianx8 j = load_jacobian(b);
    const f32x8 mass = load(b.mass), wanted = splat(impact_relaxation) * mass, ih = splat(inverse_h);
    const mask8 active = mask_from_bits(impact.active) & (load(b.rigid_limit) > zero()) & (mass > zero());
    const mask8 equation = load(b.equation) > zero(), bounded = and_not(active, equation);
    const f32x8 x = load(b.position), old_up = load(impact.lower), old_down = load(impact.upper);
    f32x8 v = velocity_of<Turns>(j, e);
    f32x8 up = max(old_up - wanted * (v + max(x - load(b.lower), zero()) * ih), zero());
    up = select(bounded, up, old_up);
    v += guarded_inverse(mass, active) * (up - old_up);
    f32x8 down = max(old_down - wanted * (max(load(b.upper) - x, zero()) * ih - v), zero());
    down = select(bounded, down, old_down);
    const f32x8 held = select(active & equation, -(wanted * v), zero());
    const f32x8 d = held + ((up - old_up) - (down - old_down));
    store(impact.lower, up);
    store(impact.upper, down);
    if (all(d == zero())) return; // limits out of reach
    store(b.total, load(b.total) + d);
    apply<Turns>(b, j, d, e);
    scatter_moved<Turns>(velocity, all_of(b), e);
}
void impact_pass(void* blocks, JointImpact* impacts, int count, SolverVelocity* velocity, float inverse_h) {
    auto* all = static_cast<AxisBlock*>(blocks);
    for (int k = 0; k < count; ++k) {
        if (!impacts[k].active || !all[k].has_limits) continue;
        for_kind(all[k], [&](auto turns) { strike_block<turns>(all[k], impacts[k], velocity, inverse_h); });
    }
}

} // namespace

JointKernels::ForRows axis_kernels() { return {warm_start, solve, relax, impact_pass}; }

} // namespace cairn::CAIRN_ISA
