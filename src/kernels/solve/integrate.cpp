// Velocity and pose integration of the bodies of one batch.
#include "kernels/solve/solver.h"

namespace cairn::CAIRN_ISA {

// One row is one 8-lane register. The constraint impulses of the last substep are what the velocity gained
// over the reference; as the constraint directions stay fixed during a step, carrying that difference over is
// the warm start of the next substep, for free.
void integrate_velocities(const SolverBodies& bodies, int begin, int end, bool first) {
    for (int i = begin; i < end; ++i) {
        const f32x8 v = load(bodies.velocity[i].v);
        f32x8 free = v + load(bodies.drive[i].v);
        if (bodies.damping) free = free * load(bodies.damping[i].v);
        const f32x8 carried = first ? zero() : (v - load(bodies.reference[i].v)) + load(bodies.rounding[i].v);
        const f32x8 sum = free + carried;
        store(bodies.reference[i].v, free);
        store(bodies.rounding[i].v, carried - (sum - free));
        store(bodies.velocity[i].v, sum);
    }
}

void integrate_poses(const SolverBodies& bodies, int begin, int end, float h) {
    const f32x8 step = splat(h);
    for (int i = begin; i < end; i += 8) {
        std::uint32_t row[8];
        for (int k = 0; k < 8; ++k) row[k] = std::uint32_t(i + k) * row_bytes;
        Velocityx8 move = gather_velocity(bodies.velocity, row);
        if (bodies.velocity_correction) {
            const Velocityx8 extra =
                gather_velocity(reinterpret_cast<const SolverVelocity*>(bodies.velocity_correction), row);
            move = {move.v + extra.v, move.w + extra.w};
        }
        float* p[8];
        Vec3x8 dx;
        Quatx8 q;
        f32x8 unused;
        for (int k = 0; k < 8; ++k) p[k] = bodies.pose[i + k].dx;
        gather4(p, dx.x, dx.y, dx.z, unused);
        dx = dx + step * move.v;
        scatter4(p, dx.x, dx.y, dx.z, zero());
        for (int k = 0; k < 8; ++k) p[k] += 4;
        gather4(p, q.v.x, q.v.y, q.v.z, q.w);
        const Quatx8 turned = turned_by(splat(0.25f * h) * move.w, q);
        scatter4(p, turned.v.x, turned.v.y, turned.v.z, turned.w);
    }
}

} // namespace cairn::CAIRN_ISA
