// The torque-free rotation of bodies with unequal moments of inertia that touch something, 8 at a time. (Free bodies
// are rotated in double, in bodies/integrators.cpp.) The angular momentum L is followed through the step: contacts act
// on the solver's inertia, that of the start of the step, and they add to L this inertia times their change of the
// angular velocity w. Taking I w with the current inertia instead would lose a part of every impulse.
//
// The rotation is integrated by the midpoint rule on L: w = R I^-1 R^T L at the rotation R half a substep ahead.
#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

namespace {

CAIRN_INLINE Quatx8 gather_turn(const SolverPose* pose, const std::uint32_t* offset) {
    const float* p[8];
    Quatx8 q;
    for (int i = 0; i < 8; ++i) p[i] = row_at(pose, offset[i]).dq;
    gather4(p, q.v.x, q.v.y, q.v.z, q.w);
    return q;
}

CAIRN_INLINE Vec3x8 scaled(Vec3x8 a, Vec3x8 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

// R diag(d) R^T.
CAIRN_INLINE Sym3x8 rotated_diagonal(const Mat3x8& r, Vec3x8 d) {
    const Vec3x8 a = d.x * r.c0, b = d.y * r.c1, c = d.z * r.c2;
    return {(a.x * r.c0.x + b.x * r.c1.x) + c.x * r.c2.x, (a.x * r.c0.y + b.x * r.c1.y) + c.x * r.c2.y,
            (a.x * r.c0.z + b.x * r.c1.z) + c.x * r.c2.z, (a.y * r.c0.y + b.y * r.c1.y) + c.y * r.c2.y,
            (a.y * r.c0.z + b.y * r.c1.z) + c.y * r.c2.z, (a.z * r.c0.z + b.z * r.c1.z) + c.z * r.c2.z};
}

// The tensor with this diagonal in the axes q, times v.
CAIRN_INLINE Vec3x8 tensor(Quatx8 q, Vec3x8 diagonal, Vec3x8 v) {
    return rotate(q, scaled(diagonal, rotate_back(q, v)));
}

// Writes to the rows of `lanes` the inverse inertia that is diagonal in these axes.
CAIRN_INLINE void write_inverse_inertia(const SpinBlock& block, const Mat3x8& axes, mask8 lanes, SolverInertia* rows) {
    float *low[8], *high[8];
    for (int lane = 0; lane < 8; ++lane) {
        low[lane] = &row_at(rows, block.row[lane]).inverse_mass;
        high[lane] = low[lane] + 4;
    }
    f32x8 mass, unused;
    Sym3x8 was;
    gather4(low, mass, was.xx, was.xy, was.xz);
    gather4(high, was.yy, was.yz, was.zz, unused);
    const Sym3x8 now = select(lanes, rotated_diagonal(axes, load3(block.inverse_moments)), was);
    scatter4(low, mass, now.xx, now.xy, now.xz);
    scatter4(high, now.yy, now.yz, now.zz, zero());
}

// Lanes that have rotated so little in the step that the change of w by an impulse is at most twice what the inertia of
// the start of the step predicts: beyond that, each substep would overshoot by more than the error that it corrects,
// and thin rods hit by something would set whole heaps in motion. For a rotation by an angle a from an axis of the
// smallest moment toward another one, the ratio is 1 + sin^2 a (other / smallest - 1). A rotation about an axis of
// symmetry, as that of a top, does not count.
CAIRN_INLINE mask8 answer_as_told(const SpinBlock& block, Quatx8 turn, Quatx8 axes) {
    const Vec3x8 i = load3(block.moments), v = rotate_back(axes, turn.v); // axis times the sine of half the angle
    const f32x8 least = min(min(i.x, i.y), i.z);
    const Vec3x8 mixed = {abs(i.y - i.z), abs(i.z - i.x), abs(i.x - i.y)};
    return splat(4.0f) * dot(scaled(v, v), mixed) <= least;
}

// The current L, including what contacts have added since the last free motion.
CAIRN_INLINE Vec3x8 momentum_now(const SpinBlock& block, Quatx8 turn, Quatx8 axes, Vec3x8 w, bool first) {
    if (first) return tensor(axes, load3(block.moments), w);
    mask8 followed = answer_as_told(block, turn, axes);
    if (block.any_renewed) followed = followed | (load(block.renewed) > zero());
    Vec3x8 momentum = zero3();
    if (!all(followed)) momentum = tensor(axes, load3(block.moments), w);
    const Vec3x8 tracked = load3(block.momentum) + load6(block.contact_inertia) * (w - load3(block.free_w));
    return select(followed, tracked, momentum);
}

// In the frame of the principal axes: the angular velocity that belongs to the momentum after the axes have rotated by
// the rotation vector 4 u.
CAIRN_INLINE Vec3x8 velocity_after(Vec3x8 u, Vec3x8 inverse_moments, Vec3x8 momentum) {
    const Vec3x8 t = half_tangent(u);
    const f32x8 square = dot(t, t), scale = one() / (one() + square);
    const Quatx8 turn = {scale * (t + t), scale * (one() - square)};
    return rotate(turn, scaled(inverse_moments, rotate_back(turn, momentum)));
}

// The working state of a block.
struct Spinning {
    Vec3x8 w, factor; // damping factors
    mask8 calm;
    Quatx8 q;
    Vec3x8 momentum;
    Vec3x8 l, middle, end; // in the frame of the principal axes: momentum, and angular velocities at the midpoint and
                           // the end
};

CAIRN_INLINE Spinning look_at(const SpinBlock& block, const SolverBodies& bodies) {
    Spinning s;
    s.w = gather_angular(bodies.velocity, block.row);
    // Lanes below calm_speed are not rotated until the end of the step.
    s.calm = and_not(dot(s.w, s.w) < splat(calm_speed * calm_speed), load(block.renewed) > zero());
    if (bodies.damping) {
        s.factor = gather_angular(bodies.damping, block.row);
        s.calm = s.calm & (s.factor.x == one());
    }
    return s;
}

// The angular velocity half a substep ahead: by Euler's equations to first order, then one fixed-point iteration. M
// blocks are interleaved: each is a chain of dependent operations, and chains side by side take little more than the
// time of one.
template <int M> CAIRN_INLINE void turn_freely(const SpinBlock* blocks, Spinning* s, float h) {
#pragma GCC unroll 2
    for (int m = 0; m < M; ++m) {
        const Vec3x8 inverse_moments = load3(blocks[m].inverse_moments);
        s[m].l = rotate_back(s[m].q, s[m].momentum);
        const Vec3x8 start = scaled(inverse_moments, s[m].l);
        s[m].middle = start + splat(0.5f * h) * scaled(inverse_moments, cross(s[m].l, start));
    }
#pragma GCC unroll 2
    for (int m = 0; m < M; ++m)
        s[m].middle = velocity_after(splat(0.125f * h) * s[m].middle, load3(blocks[m].inverse_moments), s[m].l);
#pragma GCC unroll 2
    for (int m = 0; m < M; ++m)
        s[m].end = velocity_after(splat(0.25f * h) * s[m].middle, load3(blocks[m].inverse_moments), s[m].l);
}

// Writes to the rows the change of the angular velocity in the substep, and the difference of the midpoint's from the
// end's. `turns`: whether any lane is not calm.
CAIRN_INLINE void write_turn(SpinBlock& block, const Spinning& s, const SolverBodies& bodies, SolverTwist* drive,
                             SolverTwist* correction, bool turns, bool first) {
    Vec3x8 change = zero3(), beyond = zero3();
    if (turns) {
        change = select(s.calm, zero3(), rotate(s.q, s.end) - s.w);
        beyond = select(s.calm, zero3(), rotate(s.q, s.middle - s.end));
    }
    block.turns = turns;
    scatter_angular(drive, block.row, change);
    scatter_angular(correction, block.row, beyond);
    // The same operations as in integrate_velocities, so that the bits are the same.
    Vec3x8 free = s.w + change, left = s.momentum;
    if (bodies.damping) {
        free = scaled(free, s.factor);
        left = scaled(left, s.factor);
    }
    const mask8 kept = first ? mask_from_bits(0) : s.calm; // contact impulses of calm lanes are added later
    store3(block.momentum, select(kept, load3(block.momentum), left));
    store3(block.free_w, select(kept, load3(block.free_w), free));
}

template <int M>
CAIRN_INLINE void spin_some(SpinBlock* blocks, Spinning* s, const SolverBodies& bodies, SolverTwist* drive,
                            SolverTwist* correction, float h, bool first) {
    bool turn[M], any_turns = false;
#pragma GCC unroll 2
    for (int m = 0; m < M; ++m) {
        const Quatx8 turned = gather_turn(bodies.pose, blocks[m].row);
        s[m].q = multiply(turned, {load3(blocks[m].axes), load(blocks[m].axes[3])});
        s[m].momentum = momentum_now(blocks[m], turned, s[m].q, s[m].w, first);
        turn[m] = !all(s[m].calm);
        any_turns = any_turns || turn[m];
    }
    if (any_turns) turn_freely<M>(blocks, s, h);
    for (int m = 0; m < M; ++m) write_turn(blocks[m], s[m], bodies, drive, correction, turn[m], first);
}

} // namespace

void begin_spin(SpinBlock* blocks, int count, SolverInertia* inertia) {
    for (int k = 0; k < count; ++k) {
        SpinBlock& block = blocks[k];
        const Mat3x8 axes = to_matrix({load3(block.axes), load(block.axes[3])});
        store6(block.contact_inertia, rotated_diagonal(axes, load3(block.moments)));
        write_inverse_inertia(block, axes, mask_from_bits(255), inertia);
    }
}

void spin(SpinBlock* blocks, int count, const SolverBodies& bodies, SolverTwist* drive, SolverTwist* correction,
          float h, bool first) {
    for (int k = 0; k < count;) {
        Spinning s[2] = {look_at(blocks[k], bodies)};
        const auto is_left = [&](int m) { return all(s[m].calm) && !first && !blocks[k + m].turns; };
        if (is_left(0)) {
            ++k;
            continue;
        }
        if (k + 1 < count) s[1] = look_at(blocks[k + 1], bodies);
        if (k + 1 < count && !is_left(1)) {
            spin_some<2>(blocks + k, s, bodies, drive, correction, h, first);
            k += 2;
        } else {
            spin_some<1>(blocks + k, s, bodies, drive, correction, h, first);
            ++k;
        }
    }
}

void renew_inertia(SpinBlock* blocks, int count, const SolverVelocity* velocity, const SolverPose* pose,
                   SolverInertia* inertia) {
    for (int k = 0; k < count; ++k) {
        SpinBlock& block = blocks[k];
        if (!block.any_renewed) continue;
        const Quatx8 turn = gather_turn(pose, block.row);
        const mask8 renewed = load(block.renewed) > zero();
        if (!any(renewed)) continue;
        const Mat3x8 axes = to_matrix(multiply(turn, {load3(block.axes), load(block.axes[3])}));
        const Sym3x8 i = rotated_diagonal(axes, load3(block.moments)), old = load6(block.contact_inertia);
        // Impulses up to now acted on the old inertia.
        const Vec3x8 w = gather_angular(velocity, block.row), before = load3(block.free_w),
                     was_l = load3(block.momentum);
        store3(block.momentum, select(renewed, was_l + old * (w - before), was_l));
        store3(block.free_w, select(renewed, w, before));
        store6(block.contact_inertia, select(renewed, i, old));
        write_inverse_inertia(block, axes, renewed, inertia);
    }
}

void finish_spin(const SpinBlock* blocks, int count, SolverVelocity* velocity, const SolverPose* pose) {
    for (int k = 0; k < count; ++k) {
        const SpinBlock& block = blocks[k];
        const Vec3x8 w = gather_angular(velocity, block.row);
        const Quatx8 turn = gather_turn(pose, block.row);
        const Quatx8 q = multiply(turn, {load3(block.axes), load(block.axes[3])});
        const Vec3x8 momentum = momentum_now(block, turn, q, w, false);
        scatter_angular(velocity, block.row, tensor(q, load3(block.inverse_moments), momentum));
    }
}

} // namespace cairn::CAIRN_ISA
