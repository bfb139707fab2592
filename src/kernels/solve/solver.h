// The solver kernels of one instruction set, and the helpers that they share.
#pragma once

#include "kernels/solve/solver_data.h"
#include "simd/wide_math.h"

#include <type_traits>

namespace cairn::CAIRN_ISA {

SolverKernels solver_kernels();
template <int N>
void prepare_contacts(void* blocks, int count, const ContactLanes& lanes, const ContactRecord* records,
                      const SolverInertia* inertia, const SolverVelocity* velocity, float half_step, float h);
template <int N>
void store_contacts(const void* blocks, int count, const ContactLanes& lanes, const SolverPose* pose,
                    ContactRecord* records, ContactReport* reports, float dt);
template <int N>
BounceCount bounce_contacts(void* blocks, int count, const SolverBodies& bodies, const BounceSettings& settings);
template <int N>
void find_contact_rebounds(const void* blocks, void* impacts, const ReboundTargets& aimed, int count,
                           const SolverBodies& bodies, const BounceSettings& settings);
template <int N> void renew_masses(void* blocks, const std::uint8_t* lanes, int count, const SolverInertia* inertia);
template <int N>
void solve_impact_contacts(void* blocks, void* impacts, const float* leave, int count, SolverVelocity* velocity,
                           float inverse_h);
float change_since(const SolverVelocity* velocity, const std::int32_t* rows, int count, SolverVelocity* last,
                   SettledChange settled);
void integrate_velocities(const SolverBodies& bodies, int begin, int end, bool first);
void begin_spin(SpinBlock* blocks, int count, SolverInertia* inertia);
void spin(SpinBlock* blocks, int count, const SolverBodies& bodies, SolverTwist* drive, SolverTwist* correction,
          float h, bool first);
void renew_inertia(SpinBlock* blocks, int count, const SolverVelocity* velocity, const SolverPose* pose,
                   SolverInertia* inertia);
void finish_spin(const SpinBlock* blocks, int count, SolverVelocity* velocity, const SolverPose* pose);
void integrate_poses(const SolverBodies& bodies, int begin, int end, float h);
int move_bodies(const std::int32_t* bodies, int lanes, const SolverVelocity* velocity, const SolverPose* pose,
                BodyMotion* motion, const HalfLimits& half);

// Over-relaxation factor of the impact passes: they converge several times as fast as with 1.
inline constexpr float impact_relaxation = 1.5f;

// Velocities of 8 bodies.
struct Velocityx8 {
    Vec3x8 v, w;
};

// The row at a byte offset: an index would need a shift for every lane.
template <class Row> CAIRN_INLINE Row& row_at(Row* rows, std::uint32_t offset) {
    static_assert(sizeof(Row) == row_bytes);
    using Byte = std::conditional_t<std::is_const_v<Row>, const char, char>;
    return *reinterpret_cast<Row*>(reinterpret_cast<Byte*>(rows) + offset);
}

CAIRN_INLINE Velocityx8 gather_velocity(const SolverVelocity* rows, const std::uint32_t* offset) {
    const float* p[8];
    Velocityx8 r;
    f32x8 unused;
    for (int i = 0; i < 8; ++i) p[i] = row_at(rows, offset[i]).v;
    gather4(p, r.v.x, r.v.y, r.v.z, unused);
    for (int i = 0; i < 8; ++i) p[i] += 4;
    gather4(p, r.w.x, r.w.y, r.w.z, unused);
    return r;
}
CAIRN_INLINE void scatter_velocity(SolverVelocity* rows, const std::uint32_t* offset, const Velocityx8& a) {
    float* p[8];
    for (int i = 0; i < 8; ++i) p[i] = row_at(rows, offset[i]).v;
    scatter4(p, a.v.x, a.v.y, a.v.z, zero());
    for (int i = 0; i < 8; ++i) p[i] += 4;
    scatter4(p, a.w.x, a.w.y, a.w.z, zero());
}

// Gathers or scatters the angular parts of rows of SolverVelocity, or of a struct with the same layout.
template <class Row> CAIRN_INLINE Vec3x8 gather_angular(const Row* rows, const std::uint32_t* offset) {
    const float* p[8];
    Vec3x8 w;
    f32x8 unused;
    for (int i = 0; i < 8; ++i) p[i] = row_at(rows, offset[i]).w;
    gather4(p, w.x, w.y, w.z, unused);
    return w;
}
template <class Row> CAIRN_INLINE void scatter_angular(Row* rows, const std::uint32_t* offset, Vec3x8 w) {
    float* p[8];
    for (int i = 0; i < 8; ++i) p[i] = row_at(rows, offset[i]).w;
    scatter4(p, w.x, w.y, w.z, zero());
}

// How far 8 bodies have moved since the start of the step.
struct Posex8 {
    Vec3x8 dx;
    Quatx8 dq;
};
CAIRN_INLINE Posex8 gather_pose(const SolverPose* rows, const std::uint32_t* offset) {
    const float* p[8];
    Posex8 r;
    f32x8 unused;
    for (int i = 0; i < 8; ++i) p[i] = row_at(rows, offset[i]).dx;
    gather4(p, r.dx.x, r.dx.y, r.dx.z, unused);
    for (int i = 0; i < 8; ++i) p[i] += 4;
    gather4(p, r.dq.v.x, r.dq.v.y, r.dq.v.z, r.dq.w);
    return r;
}

CAIRN_INLINE Quatx8 multiply(Quatx8 a, Quatx8 b) {
    return {a.w * b.v + (b.w * a.v + cross(a.v, b.v)), a.w * b.w - dot(a.v, b.v)};
}

// tan |u| in the direction of u: with x = |u|, tan x = x (1 + x^2/3 + 2 x^4/15 + 17 x^6/315 + ...). With t the result,
// the unnormalized quaternion (t, 1) is a rotation by 2 x up to O(x^9), and its square (2 t, 1 - t^2) one by 4 x. For
// rotations beyond four radians only the axis matters.
CAIRN_INLINE Vec3x8 half_tangent(Vec3x8 u) {
    const f32x8 x2 = min(dot(u, u), one());
    const f32x8 series = splat(1.0f / 3.0f) + x2 * (splat(2.0f / 15.0f) + x2 * splat(17.0f / 315.0f));
    return (one() + x2 * series) * u;
}

// The rotation q followed by one by the rotation vector 4 u.
CAIRN_INLINE Quatx8 turned_by(Vec3x8 u, Quatx8 q) {
    const Vec3x8 t = half_tangent(u);
    const Quatx8 r = multiply({t + t, one() - dot(t, t)}, q);
    const f32x8 scale = one() / sqrt(dot(r.v, r.v) + r.w * r.w);
    return {scale * r.v, scale * r.w};
}

// R(q)^T n - n, with the part that is of second order in the rotation multiplied by `bend`.
CAIRN_INLINE Vec3x8 turned_back_difference(Quatx8 q, Vec3x8 n, f32x8 bend) {
    const Vec3x8 g = cross(q.v, n);
    return splat(2.0f) * (bend * cross(q.v, g) - q.w * g);
}

// Index in a block of the share K_ji / K_jj: by how much a unit impulse at point i reduces the wanted impulse of point
// j.
template <int N> constexpr int share_index(int j, int i) { return j * (N - 1) + (i < j ? i : i - 1); }

template <int N> CAIRN_INLINE Vec3x8 arm_of(const ContactBlock<N>& block, Vec3x8 normal, int i) {
    if constexpr (N == 1)
        return cross(load3(block.center), normal);
    else
        return load3(block.arm[i]);
}
template <int N> CAIRN_INLINE Vec3x8 second_tangent(const ContactBlock<N>& block, Vec3x8 normal) {
    return cross(load3(block.tangent), normal);
}

// Offset of the load from the friction center, along the two tangents. With t2 = t1 x n and j = r x n, r.t1 = j.t2 and
// r.t2 = -j.t1.
struct LoadOffset {
    f32x8 x, y;
};
// `torque`: the sum of impulse times arm (j_i) over the points; `inverse`: the reciprocal of the sum of the impulses.
CAIRN_INLINE LoadOffset load_offset(Vec3x8 center, f32x8 inverse, Vec3x8 torque, Vec3x8 t1, Vec3x8 t2) {
    return {inverse * dot(torque, t2) - dot(center, t1), -(inverse * dot(torque, t1)) - dot(center, t2)};
}
// The moment about the normal at the friction center of a tangential impulse (p1, p2) that acts at the load.
CAIRN_INLINE f32x8 moment_at(const LoadOffset& e, f32x8 p1, f32x8 p2) { return e.y * p1 - e.x * p2; }

// Normal velocities of the contact points, positive where they separate; c = d x normal.
template <int N>
CAIRN_INLINE void normal_velocities(const ContactBlock<N>& block, const Velocityx8& a, const Velocityx8& b,
                                    Vec3x8 normal, Vec3x8 c, f32x8* v) {
    const Vec3x8 dw = b.w - a.w;
    const f32x8 common = dot(normal, b.v - a.v) + dot(c, b.w);
    for (int i = 0; i < N; ++i) v[i] = common + dot(arm_of(block, normal, i), dw);
}

// The change of the relative velocity at a contact point that moves within the step, with a corner of a body or because
// a round body rolls: `slip_rate` times the time from the moment at which the contact was found to `middle`, the middle
// of the substep. Bodies move during a substep by its velocities, which should therefore be those of its middle; then
// the rotation takes as much energy from the bodies as it gives back, from substep to substep. With arms fixed at the
// middle of the step, Euler's disk loses a third of its energy in a second.
template <int N> CAIRN_INLINE Vec3x8 slip_of_moving_points(const ContactBlock<N>& block, float middle) {
    const mask8 turns = mask_from_bits(block.moving_points);
    return (splat(middle) - load(block.found)) * select(turns, load3(block.slip_rate), zero3());
}

// The inverse inertia tensor of A or of B times a vector.
CAIRN_INLINE Vec3x8 inertia_times(bool isotropic, const float (*inertia)[8], Vec3x8 u) {
    return isotropic ? load(inertia[0]) * u : load6(inertia) * u;
}
template <int N> CAIRN_INLINE Vec3x8 turned_a(const ContactBlock<N>& block, Vec3x8 u) {
    return inertia_times(block.isotropic, block.inertia_a, u);
}
template <int N> CAIRN_INLINE Vec3x8 turned_b(const ContactBlock<N>& block, Vec3x8 u) {
    return inertia_times(block.isotropic, block.inertia_b, u);
}

// Effective mass of rolling resistance. One mass for all directions: the smallest that the trace of the inverse inertia
// permits, so that the row never overshoots.
template <int N> CAIRN_INLINE f32x8 rolling_mass(const ContactBlock<N>& block) {
    constexpr int xx = 0, yy = 3, zz = 5;
    auto sum = [&](int i) { return load(block.inertia_a[i]) + load(block.inertia_b[i]); };
    const f32x8 trace = block.isotropic ? (sum(xx) + sum(xx)) + sum(xx) : (sum(xx) + sum(yy)) + sum(zz);
    const mask8 turns = trace > zero();
    return select(turns, splat(3.0f) / select(turns, trace, one()), zero()) * splat(1.0f / 3.0f);
}

// Applies the normal impulses S = sum of d_i and T = sum of j_i d_i to both bodies.
template <int N>
CAIRN_INLINE void apply_normal(const ContactBlock<N>& block, Vec3x8 normal, Vec3x8 c, f32x8 sum, Vec3x8 torque,
                               Velocityx8& a, Velocityx8& b) {
    a.v = a.v - (load(block.mass_a) * sum) * normal;
    b.v = b.v + (load(block.mass_b) * sum) * normal;
    a.w = a.w - turned_a(block, torque);
    b.w = b.w + turned_b(block, torque + sum * c);
}

CAIRN_INLINE bool has_round_pairs(const ContactBlock<1>& block) { return block.round_pairs != 0; }
CAIRN_INLINE bool has_round_pairs(const ContactBlock<4>&) { return false; }
template <int N> CAIRN_INLINE bool is_all_round(const ContactBlock<N>& block) { return block.round_pairs == 0xff; }
// How much farther than its radius each center of curvature of two round surfaces is from the contact point, at this
// separation.
CAIRN_INLINE f32x8 half_gap(const ContactBlock<1>& block, f32x8 separation) {
    const f32x8 apart = load(block.rim_radius) + separation;
    return splat(0.5f) * (apart - (load(block.radius_a) + load(block.radius_b)));
}
// d at the poses that the block's normal belongs to.
template <int N> CAIRN_INLINE Vec3x8 d_of_normal(const ContactBlock<N>& block) {
    const Vec3x8 d = load3(block.d_touch);
    return has_round_pairs(block) ? select(mask_from_bits(block.round_pairs), load3(block.d), d) : d;
}

// The tangential impulse that stops the slip (x, y) at `center`, the load of the whole contact in an impact.
struct SlipStop {
    f32x8 p1, p2;
};
template <int N>
CAIRN_INLINE SlipStop slip_stop(const ContactBlock<N>& block, Vec3x8 center, Vec3x8 d, Vec3x8 t1, Vec3x8 t2, f32x8 x,
                                f32x8 y) {
    f32x8 m11 = load(block.tangent_mass[0]), m12 = load(block.tangent_mass[1]), m22 = load(block.tangent_mass[2]);
    if constexpr (N > 1) { // else `center` is the friction center, whose masses the block stores
        const Vec3x8 a1 = cross(center, t1), a2 = cross(center, t2), b1 = a1 + cross(d, t1), b2 = a2 + cross(d, t2);
        const Vec3x8 ia_2 = turned_a(block, a2), ib_2 = turned_b(block, b2);
        const f32x8 mass = load(block.mass_a) + load(block.mass_b);
        const f32x8 k11 = mass + dot(a1, turned_a(block, a1)) + dot(b1, turned_b(block, b1));
        const f32x8 k22 = mass + dot(a2, ia_2) + dot(b2, ib_2), k12 = dot(a1, ia_2) + dot(b1, ib_2);
        const f32x8 determinant = k11 * k22 - k12 * k12;
        const mask8 gives = determinant > zero();
        const f32x8 inverse = select(gives, one() / select(gives, determinant, one()), zero());
        m11 = inverse * k22, m12 = -(inverse * k12), m22 = inverse * k11;
    }
    return {-(m11 * x + m12 * y), -(m12 * x + m22 * y)};
}

// Applies the impulse p at the friction center, and the couple about the normal, to both bodies.
template <int N>
CAIRN_INLINE void apply_friction(const ContactBlock<N>& block, Vec3x8 center, Vec3x8 d, Vec3x8 p, Vec3x8 couple,
                                 Velocityx8& a, Velocityx8& b) {
    const Vec3x8 torque_a = cross(center, p) + couple;
    a.v = a.v - load(block.mass_a) * p;
    b.v = b.v + load(block.mass_b) * p;
    a.w = a.w - turned_a(block, torque_a);
    b.w = b.w + turned_b(block, torque_a + cross(d, p));
}

} // namespace cairn::CAIRN_ISA
