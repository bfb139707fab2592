// Velocity and pose integration of the bodies of one batch.
#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

// One row is one 8-lane register. The constraint impulses of the last substep are the difference of the velocity and
// the reference; as the constraint directions stay fixed during a step, carrying that difference over is the warm start
// of the next substep, at no cost.
void integrate_velocities(const SolverBodies& bodies, int begin, int end, bool first) {
    // Local copies of the pointers: a vector store may alias them, so that the compiler would reload them after each
    // one.
    SolverVelocity *const velocity = bodies.velocity, *const reference = bodies.reference,
                          *const rounding = bodies.rounding;
    const SolverTwist *const drive = bodies.drive, *const damping = bodies.damping;
    for (int i = begin; i < end; ++i) {
        const f32x8 v = load_halves(velocity[i].v);
        f32x8 free = v + load_halves(drive[i].v);
        if (damping) free = free * load(damping[i].v);
        const f32x8 carried = first ? zero() : (v - load(reference[i].v)) + load(rounding[i].v);
        const f32x8 sum = free + carried;
        store(reference[i].v, free);
        store(rounding[i].v, carried - (sum - free));
        store(velocity[i].v, sum);
    }
}

void integrate_poses(const SolverBodies& bodies, int begin, int end, float h) {
    SolverPose* const pose = bodies.pose;
    const SolverVelocity *const velocity = bodies.velocity, *const correction = reinterpret_cast<const SolverVelocity*>(
                                                                bodies.velocity_correction);
    const f32x8 step = splat(h);
    for (int i = begin; i < end; i += 8) {
        alignas(32) float move[8][8]; // one row of velocities each
        const float* w[8];
        float* dq[8];
        Vec3x8 turn;
        Quatx8 q;
        f32x8 unused;
        for (int k = 0; k < 8; ++k) {
            const f32x8 v = load_halves(velocity[i + k].v);
            store(move[k], correction ? v + load_halves(correction[i + k].v) : v);
            w[k] = move[k] + 4, dq[k] = pose[i + k].dq;
        }
        gather4(w, turn.x, turn.y, turn.z, unused);
        gather4(dq, q.v.x, q.v.y, q.v.z, q.w);
        const Quatx8 turned = turned_by(splat(0.25f * h) * turn, q);
        // Adds to both halves of a row; the second half, the rotation, is overwritten below.
        for (int k = 0; k < 8; ++k) store(pose[i + k].dx, load(pose[i + k].dx) + step * load(move[k]));
        scatter4(dq, turned.v.x, turned.v.y, turned.v.z, turned.w);
    }
}

} // namespace cairn::CAIRN_ISA
