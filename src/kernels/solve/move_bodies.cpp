// Writes the motion of solver rows back to bodies at the end of a step, 8 at a time.
#include "kernels/solve/body_motion.h"
#include "kernels/solve/solver.h"
#include "simd/f64x4.h"

namespace cairn::CAIRN_ISA {

namespace {

struct Quatx4 {
    f64x4 x, y, z, w;
};

CAIRN_INLINE void transpose(f64x4& a, f64x4& b, f64x4& c, f64x4& d) {
    const f64x4 ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), ba = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const f64x4 cd = __builtin_shufflevector(c, d, 0, 4, 2, 6), dc = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    a = __builtin_shufflevector(ab, cd, 0, 1, 4, 5), c = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    b = __builtin_shufflevector(ba, dc, 0, 1, 4, 5), d = __builtin_shufflevector(ba, dc, 2, 3, 6, 7);
}

// The normalized product a b.
CAIRN_INLINE Quatx4 turned_on(const Quatx4& a, const Quatx4& b) {
    const Quatx4 q = {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
    const f64x4 s = splat4(1) / sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {q.x * s, q.y * s, q.z * s, q.w * s};
}

CAIRN_INLINE void turn_bodies(BodyMotion* const* body, const SolverPose* pose) {
    Quatx4 dq = {load4(pose[0].dq), load4(pose[1].dq), load4(pose[2].dq), load4(pose[3].dq)};
    Quatx4 q = {load4(&body[0]->q.x), load4(&body[1]->q.x), load4(&body[2]->q.x), load4(&body[3]->q.x)};
    transpose(dq.x, dq.y, dq.z, dq.w);
    transpose(q.x, q.y, q.z, q.w);
    q = turned_on(dq, q);
    transpose(q.x, q.y, q.z, q.w);
    store4(&body[0]->q.x, q.x), store4(&body[1]->q.x, q.y), store4(&body[2]->q.x, q.z), store4(&body[3]->q.x, q.w);
}

// Bits of the lanes whose motion is finite and not near a limit.
CAIRN_INLINE int plain_lanes(const SolverVelocity* velocity, const SolverPose* pose, const HalfLimits& half) {
    std::uint32_t offset[8];
    for (std::uint32_t i = 0; i < 8; ++i) offset[i] = i * row_bytes;
    const Velocityx8 v = gather_velocity(velocity, offset);
    const float* row[8];
    Vec3x8 dx;
    Quatx8 q;
    f32x8 unused;
    for (int i = 0; i < 8; ++i) row[i] = pose[i].dx;
    gather4(row, dx.x, dx.y, dx.z, unused);
    for (int i = 0; i < 8; ++i) row[i] = pose[i].dq;
    gather4(row, q.v.x, q.v.y, q.v.z, q.w);
    const f32x8 turn = dot(q.v, q.v) + q.w * q.w;
    const auto within = [](Vec3x8 u, float most) { return dot(u, u) < splat(most * most); };
    return bits(within(dx, half.way) & within(v.v, half.speed) & within(v.w, half.angular_speed) &
                (turn > splat(0.25f)) & (turn < splat(4.0f)));
}

} // namespace

int move_bodies(const std::int32_t* bodies, int lanes, const SolverVelocity* velocity, const SolverPose* pose,
                BodyMotion* motion, const HalfLimits& half) {
    lanes &= plain_lanes(velocity, pose, half);
    if (lanes == 0) return 0;
    BodyMotion discarded[8] = {};
    BodyMotion* body[8];
    for (int i = 0; i < 8; ++i) body[i] = (lanes >> i & 1) != 0 ? motion + bodies[i] : discarded + i;
    for (int i = 0; i < 8; ++i) {
        BodyMotion& b = *body[i];
        const SolverVelocity& v = velocity[i];
        const float *dx = pose[i].dx, *dq = pose[i].dq;
        b.x.x += static_cast<double>(dx[0]), b.x.y += static_cast<double>(dx[1]), b.x.z += static_cast<double>(dx[2]);
        b.v.x = v.v[0], b.v.y = v.v[1], b.v.z = v.v[2];
        b.w.x = v.w[0], b.w.y = v.w[1], b.w.z = v.w[2];
        b.turned.x = dq[0], b.turned.y = dq[1], b.turned.z = dq[2], b.turned.w = dq[3];
        b.v_rest.x = b.v_rest.y = b.v_rest.z = 0.0f;
        b.w_rest.x = b.w_rest.y = b.w_rest.z = 0.0f;
    }
    turn_bodies(body, pose);
    turn_bodies(body + 4, pose + 4);
    return lanes;
}

} // namespace cairn::CAIRN_ISA
