// Building contact blocks from contact records, and writing the impulses back.
#include "kernels/solve/rounds.h"

namespace cairn::CAIRN_ISA {

namespace {

constexpr float unused_separation = 1e9f; // m: points with at least this separation are unused

CAIRN_INLINE bool is_movable(const SolverInertia& i) {
    return i.inverse_mass > 0.0f || i.xx > 0.0f || i.yy > 0.0f || i.zz > 0.0f;
}

CAIRN_INLINE Inertiax8 gather_inertia(const SolverInertia* rows, const std::int32_t* row) {
    const float* p[8];
    Inertiax8 r;
    f32x8 unused;
    Sym3x8& m = r.inverse_inertia;
    for (int i = 0; i < 8; ++i) p[i] = &rows[row[i]].inverse_mass;
    gather4(p, r.inverse_mass, m.xx, m.xy, m.xz);
    for (int i = 0; i < 8; ++i) p[i] += 4;
    gather4(p, m.yy, m.yz, m.zz, unused);
    return r;
}

// Effective masses and shares, from the matrix K of the points' normal velocities. `j`: arms for A; `put(row, values)`
// stores them.
template <int N, class Put>
CAIRN_INLINE void couple_points(ContactBlock<N>& block, const Vec3x8* j, const mask8* used, Vec3x8 c,
                                const Inertiax8& a, const Inertiax8& b, Put&& put) {
    const f32x8 mass_sum = a.inverse_mass + b.inverse_mass;
    Vec3x8 ia_j[N], ib_j[N];
    f32x8 mass[N], coupling[N][N]; // K_ij, i < j
    for (int i = 0; i < N; ++i) {
        ia_j[i] = a.inverse_inertia * j[i];
        ib_j[i] = b.inverse_inertia * (j[i] + c);
        for (int k = 0; k < i; ++k) coupling[k][i] = mass_sum + dot(ia_j[k], j[i]) + dot(ib_j[k], j[i] + c);
        const f32x8 k_ii = mass_sum + dot(ia_j[i], j[i]) + dot(ib_j[i], j[i] + c);
        mass[i] = select(used[i], safe_reciprocal(k_ii), zero());
        put(block.effective_mass[i], mass[i]);
    }
    if constexpr (N > 1)
        for (int i = 0; i < N; ++i)
            for (int k = 0; k < N; ++k)
                if (k != i) put(block.share[share_index<N>(k, i)], mass[k] * coupling[k < i ? k : i][k < i ? i : k]);
}

// Normal rows: arms, the matrix K of the points' normal velocities, and the friction center: the mean of the points
// that were loaded in the last step, or of all if none was. With the mean of all, friction at two points of which one
// is unloaded would hold neither.
template <int N, class PlaceOf>
CAIRN_INLINE Vec3x8 prepare_points(ContactBlock<N>& block, const ContactRecord* const* record, Vec3x8 normal, Vec3x8 c,
                                   const Before& before, const Inertiax8& a, const Inertiax8& b, PlaceOf&& place_of) {
    Vec3x8 r[N], j[N], sum = zero3();
    mask8 used[N];
    f32x8 points = zero(), carried = zero();
    for (int i = 0; i < N; ++i) carried += load(block.impulse[i]);
    const mask8 is_free = carried <= zero();
    for (int i = 0; i < N; ++i) {
        f32x8 found;
        gather_field(record, point_offset(i), r[i].x, r[i].y, r[i].z, found);
        f32x8 s = found + (before.apart + dot(before.difference, r[i]));
        r[i] = place_of(r[i], found, s);
        used[i] = s < splat(unused_separation);
        if constexpr (N > 1) {
            const f32x8 weight = select(used[i] & ((load(block.impulse[i]) > zero()) | is_free), one(), zero());
            sum = sum + weight * r[i], points += weight;
        }
        j[i] = cross(r[i], normal);
        if constexpr (N > 1) {
            store3(block.arm[i], j[i]);
            store(block.height[i], dot(r[i], normal));
        }
        store(block.separation0[i], s);
        store(block.separation[i], s);
        store(block.total_impulse[i], zero());
    }
    couple_points<N>(block, j, used, c, a, b, [](float* row, f32x8 values) { store(row, values); });
    if constexpr (N == 1) {
        store3(block.center, r[0]);
        return r[0];
    } else {
        const Vec3x8 center = safe_reciprocal(points) * sum;
        store3(block.center, center);
        for (int i = 0; i < N; ++i) {
            const Vec3x8 e = r[i] - center;
            store(block.square_lever[i], select(used[i], dot(e, e), zero()));
        }
        return center;
    }
}

// The moment of friction about the normal at the friction center, which arises because friction acts at the load.
template <int N> CAIRN_INLINE f32x8 moment_about_center(const ContactBlock<N>& block, Vec3x8 t1, Vec3x8 t2) {
    if constexpr (N == 1) return zero();
    f32x8 sum = zero();
    Vec3x8 torque = zero3();
    for (int i = 0; i < N; ++i) {
        const f32x8 impulse = load(block.impulse[i]);
        sum += impulse;
        torque = torque + impulse * arm_of(block, zero3(), i);
    }
    const mask8 bears = sum > zero();
    const LoadOffset e = load_offset(load3(block.center), one() / select(bears, sum, one()), torque, t1, t2);
    return select(bears, moment_at(e, load(block.tangent_impulse[0]), load(block.tangent_impulse[1])), zero());
}

// The square of the greatest change of d for which the couplings K still hold: an arm that is longer by this adds at
// most a quarter of the masses' part of K. A row whose K has more than doubled would overshoot by more than the error
// that it corrects, which happens soon if B is a thin rod. The inverse inertia counts with the mean of its eigenvalues
// weighted by themselves: their value if they are equal, otherwise about that of the axis with the least moment of
// inertia.
CAIRN_INLINE f32x8 max_offset_change_square(const Inertiax8& a, const Inertiax8& b, Vec3x8 center_b) {
    const Sym3x8& i = b.inverse_inertia;
    const f32x8 sum = (i.xx + i.yy) + i.zz, aside = (i.xy * i.xy + i.xz * i.xz) + i.yz * i.yz,
                squares = ((i.xx * i.xx + i.yy * i.yy) + i.zz * i.zz) + (aside + aside);
    const mask8 turns = squares > zero();
    return select(turns, splat(0.25f) * (a.inverse_mass + b.inverse_mass) * (sum / select(turns, squares, one())),
                  dot(center_b, center_b));
}

// Tangential and torsional rows at the friction center. Records hold the couple about the load instead, as the friction
// center moves when a contact point appears or disappears.
template <int N>
CAIRN_INLINE void prepare_friction(ContactBlock<N>& block, const ContactRecord* const* record, Vec3x8 normal, Vec3x8 d,
                                   Vec3x8 center, const Inertiax8& a, const Inertiax8& b) {
    // Any tangent will do: the friction limit is the same in all directions.
    const mask8 steep = abs(normal.x) < splat(0.5f);
    const Vec3x8 axis = {select(steep, one(), zero()), select(steep, zero(), one()), zero()};
    Vec3x8 t1 = cross(axis, normal);
    t1 = safe_reciprocal(sqrt(dot(t1, t1))) * t1;
    const Vec3x8 t2 = cross(t1, normal);
    store3(block.tangent, t1);

    Vec3x8 impulse;
    f32x8 torsion;
    gather_field(record, offsetof(ContactRecord, friction_impulse), impulse.x, impulse.y, impulse.z, torsion);
    store(block.tangent_impulse[0], dot(impulse, t1));
    store(block.tangent_impulse[1], dot(impulse, t2));
    store(block.torsion_impulse, torsion + moment_about_center(block, t1, t2));
    store(block.total_tangent[0], zero());
    store(block.total_tangent[1], zero());
    store3(block.rolling_impulse, zero3());

    const Vec3x8 center_b = center + d;
    store(block.max_offset_change_square, max_offset_change_square(a, b, center_b));
    store_couplings(block, friction_couplings(normal, center, center_b, t1, t2, a, b));
}

CAIRN_INLINE mask8 is_isotropic(const Sym3x8& m) {
    const f32x8 none = zero();
    return (m.xx == m.yy) & (m.xx == m.zz) & (m.xy == none) & (m.xz == none) & (m.yz == none);
}

template <int N> CAIRN_INLINE void store_inertia(ContactBlock<N>& block, const Sym3x8& a, const Sym3x8& b) {
    block.isotropic = all(is_isotropic(a) & is_isotropic(b));
    if (block.isotropic) {
        store(block.inertia_a[0], a.xx);
        store(block.inertia_b[0], b.xx);
    } else {
        store6(block.inertia_a, a);
        store6(block.inertia_b, b);
    }
}

template <int N>
CAIRN_INLINE void prepare_block(ContactBlock<N>& block, const std::int32_t* ids, const std::int32_t* row_a,
                                const std::int32_t* row_b, const ContactRecord* records, const SolverInertia* inertia,
                                const SolverVelocity* velocity, std::int32_t discard_row, float half_step, float h) {
    const std::uint32_t discard = std::uint32_t(discard_row) * row_bytes;
    const ContactRecord* record[8];
    for (int i = 0; i < 8; ++i) {
        record[i] = ids[i] >= 0 ? records + ids[i] : &empty_record;
        block.a[i] = ids[i] >= 0 ? std::uint32_t(row_a[i]) * row_bytes : discard;
        block.b[i] = ids[i] >= 0 ? std::uint32_t(row_b[i]) * row_bytes : discard;
        block.write_b[i] = is_movable(inertia[row_b[i]]) ? block.b[i] : discard;
    }
    block.moved = block.joined = block.in_impact = block.in_impact_once = block.in_impact_twice = 0;
    const Inertiax8 a = gather_inertia(inertia, row_a), b = gather_inertia(inertia, row_b);
    Vec3x8 normal, d;
    f32x8 friction, restitution;
    gather_field(record, offsetof(ContactRecord, normal), normal.x, normal.y, normal.z, friction);
    gather_field(record, offsetof(ContactRecord, center_offset), d.x, d.y, d.z, restitution);
    store3(block.normal, normal);
    store(block.friction, friction);
    store(block.restitution, restitution);
    block.bounces = any(restitution > zero());
    store(block.mass_a, a.inverse_mass);
    store(block.mass_b, b.inverse_mass);
    store_inertia(block, a.inverse_inertia, b.inverse_inertia);

    f32x8 impulse[4], static_friction, rolling_radius, torsion_radius, unused;
    gather_field(record, offsetof(ContactRecord, impulses), impulse[0], impulse[1], impulse[2], impulse[3]);
    for (int i = 0; i < N; ++i) store(block.impulse[i], impulse[i]);
    gather_field(record, offsetof(ContactRecord, static_friction), static_friction, rolling_radius, torsion_radius,
                 unused);
    store(block.static_friction, static_friction);
    store(block.rolling_radius, rolling_radius);
    block.rolls = any(rolling_radius > zero());
    store(block.torsion_radius, torsion_radius);
    f32x8 radius_a, radius_b, found;
    gather_field(record, offsetof(ContactRecord, radius_a), radius_a, radius_b, unused, found);
    store(block.found, found);
    store(block.radius_a, max(radius_a, zero()));
    store(block.radius_b, max(radius_b, zero()));
    block.round = any((radius_a > zero()) | (radius_b > zero()));
    block.moving_points = block.rims_a = block.rims_b = block.round_pairs = block.axes_a = block.axes_b =
        block.round_arms = block.round_pairs_moved = 0;

    Before start = {zero3(), zero3(), zero()};
    const bool found_later = any(found > zero());
    Velocityx8 at_a, at_b;
    const mask8 face_a = radius_a == splat(on_face), face_b = radius_b == splat(on_face);
    const bool any_face = any(face_a | face_b);
    const f32x8 until = max(found, splat(half_step));
    Vec3x8 rim_axis = zero3();
    f32x8 rim_radius = zero();
    if constexpr (N == 1) {
        if (any_face) gather_field(record, point_offset(1), rim_axis.x, rim_axis.y, rim_axis.z, rim_radius);
    }
    const bool may_turn = N == 1 || any_face;
    if (may_turn || found_later) at_a = velocity_of(velocity, row_a), at_b = velocity_of(velocity, row_b);
    if (found_later) {
        start = before(found, at_a, at_b, normal, d, load(block.radius_a), load(block.radius_b));
    }
    const Vec3x8 d0 = d - start.passed;
    store3(block.d0, d0);
    store3(block.d, d0);
    store3(block.d_touch, d);
    RoundTouch rounds;
    if constexpr (N == 1) {
        store3(block.rim_lead, zero3());
        const mask8 both = (radius_a > zero()) & (radius_b > zero());
        if (any(both)) rounds = begin_round_pairs(block, record, both, found, at_a, at_b, d, normal);
        d = select(mask_from_bits(block.round_pairs), d0, d);
        store3(block.normal, normal);
    }
    const auto place_of = [&](Vec3x8 r, f32x8 s_found, f32x8& s) {
        if constexpr (N == 1) {
            if (any_face)
                r = begin_rims(block, RimLanes(face_b, face_a, normal), rim_axis, rim_radius, normal, r, d, until, at_a,
                               at_b, h, s);
            if (has_round_pairs(block)) {
                const mask8 lanes = mask_from_bits(block.round_pairs);
                s = select(lanes, s_found + rounds.grown, s);
                r = select(lanes, rounds.arm, r);
            }
        }
        return r;
    };
    const Vec3x8 center = prepare_points<N>(block, record, normal, cross(d, normal), start, a, b, place_of);
    prepare_friction<N>(block, record, normal, d, center, a, b);
    if (!may_turn) return;
    const mask8 is_edge = N == 1 ? (radius_a == zero()) & (radius_b == zero()) : mask_from_bits(0);
    Vec3x8 taper = zero3();
    if constexpr (N > 1) {
        f32x8 separation;
        gather_field(record, point_offset(3), taper.x, taper.y, taper.z, separation);
        taper = select(separation >= splat(unused_separation), taper, zero3());
    }
    prepare_moving_points<N>(block, is_edge, face_a, face_b, until, at_a, at_b, normal, d, taper,
                             rim_curvature(rim_axis, rim_radius, normal));
}

} // namespace

template <int N>
void prepare_contacts(void* blocks, int count, const ContactLanes& lanes, const ContactRecord* records,
                      const SolverInertia* inertia, const SolverVelocity* velocity, float half_step, float h) {
    auto* block = static_cast<ContactBlock<N>*>(blocks);
    for (int k = 0; k < count; ++k) {
        if (k + 1 < count) prefetch_records(lanes.record + 8 * (k + 1), records);
        prepare_block<N>(block[k], lanes.record + 8 * k, lanes.row_a + 8 * k, lanes.row_b + 8 * k, records, inertia,
                         velocity, lanes.first_discard + k, half_step, h);
    }
}

// Recomputes the masses of the given lanes of each block with the current inertia, as joints use it, and the current
// poses. Rows of one body with two inertias would not agree on its energy: a rod on a ball joint that hit a pole at
// 50 rad/s flew off at 2,000 m/s.
template <int N> void renew_masses(void* blocks, const std::uint8_t* lanes, int count, const SolverInertia* inertia) {
    auto* all = static_cast<ContactBlock<N>*>(blocks);
    for (int k = 0; k < count; ++k) {
        ContactBlock<N>& block = all[k];
        const mask8 renewed = mask_from_bits(lanes ? lanes[k] : 0xff);
        std::int32_t row_a[8], row_b[8];
        for (int i = 0; i < 8; ++i)
            row_a[i] = std::int32_t(block.a[i] / row_bytes), row_b[i] = std::int32_t(block.b[i] / row_bytes);
        const Inertiax8 a = gather_inertia(inertia, row_a), b = gather_inertia(inertia, row_b);
        const Vec3x8 normal = load3(block.normal), d = load3(block.d), center = load3(block.center),
                     t1 = load3(block.tangent);
        store_inertia(block, select(renewed, a.inverse_inertia, kept_inertia(block.isotropic, block.inertia_a)),
                      select(renewed, b.inverse_inertia, kept_inertia(block.isotropic, block.inertia_b)));
        Vec3x8 j[N];
        mask8 used[N];
        for (int i = 0; i < N; ++i) j[i] = arm_of(block, normal, i), used[i] = load(block.effective_mass[i]) > zero();
        couple_points<N>(block, j, used, cross(d, normal), a, b,
                         [&](float* row, f32x8 values) { store(row, select(renewed, values, load(row))); });
        store_couplings(block, renewed,
                        friction_couplings(normal, center, center + d, t1, second_tangent(block, normal), a, b));
    }
}
template void renew_masses<1>(void*, const std::uint8_t*, int, const SolverInertia*);
template void renew_masses<4>(void*, const std::uint8_t*, int, const SolverInertia*);

// Writes one report per lane: the sum of the points' normal impulses, and their least separation.
template <int N>
CAIRN_INLINE void store_reports(const ContactBlock<N>& block, const std::int32_t* ids, Vec3x8 friction_impulse,
                                ContactReport* reports) {
    f32x8 impulse = load(block.total_impulse[0]), separation = load(block.separation0[0]);
    for (int i = 1; i < N; ++i) {
        impulse += load(block.total_impulse[i]);
        separation = min(separation, load(block.separation0[i]));
    }
    impulse += zero() * ((friction_impulse.x + friction_impulse.y) + friction_impulse.z);
    alignas(32) float impulses[8], separations[8], inverse_masses[8];
    store(impulses, impulse);
    store(separations, separation);
    store(inverse_masses, load(block.mass_a) + load(block.mass_b));
    for (int i = 0; i < 8; ++i)
        if (ids[i] >= 0) reports[ids[i]] = {impulses[i], separations[i], inverse_masses[i]};
}

// The displacement of contact points in a step, as an affine function of their position r: turn * r + shift.
struct PointMotionx8 {
    Mat3x8 turn;
    Vec3x8 shift;
    Vec3x8 passed; // displacement of A relative to B
};
// Approximately the fraction `share` of a rotation.
CAIRN_INLINE Quatx8 part_of(Quatx8 q, f32x8 share) {
    const Vec3x8 v = share * q.v;
    return {v, select(share < one(), sqrt(max(one() - dot(v, v), zero())), q.w)};
}
// A contact point moves to midway between the two points of the bodies that coincided when the contact was found. Round
// surfaces do not rotate with their bodies.
template <int N>
CAIRN_INLINE PointMotionx8 point_motion(const ContactBlock<N>& block, const SolverPose* pose, f32x8 inverse_dt) {
    const Posex8 a = gather_pose(pose, block.a), b = gather_pose(pose, block.b);
    const f32x8 rest = one() - inverse_dt * load(block.found), half = splat(0.5f);
    const Mat3x8 turn_a = turn_of(part_of(a.dq, rest)), turn_b = turn_of(part_of(b.dq, rest));
    const Vec3x8 n = load3(block.normal), d = load3(block.d_touch), passed = a.dx - b.dx;
    Vec3x8 arm_b = d, round_a = zero3();
    if (N == 1 || block.round) arm_b = d + load(block.radius_b) * n, round_a = turn_a * (load(block.radius_a) * n);
    const Vec3x8 since = passed - (d - load3(block.d0));
    return {half * (turn_a + turn_b), half * ((turn_b * arm_b - round_a) - since), passed};
}

// Points whose new position or separation is not finite stay where they were, as their bodies do.
CAIRN_INLINE mask8 is_finite(Vec3x8 r, f32x8 s) { return zero() * ((r.x + r.y) + (r.z + s)) == zero(); }

// Moves the points of the records with the bodies; points that have not moved keep their bits.
template <int N>
CAIRN_INLINE void move_points(const ContactBlock<N>& block, const SolverPose* pose, ContactRecord* const* record,
                              f32x8 inverse_dt) {
    const PointMotionx8 m = point_motion(block, pose, inverse_dt);
    for (int i = 0; i < N; ++i) {
        float* point[8];
        for (int k = 0; k < 8; ++k)
            point[k] = reinterpret_cast<float*>(reinterpret_cast<char*>(record[k]) + point_offset(i));
        Vec3x8 r;
        f32x8 s;
        gather4(point, r.x, r.y, r.z, s);
        const Vec3x8 moved = r + (m.turn * r + m.shift);
        const f32x8 now = load(block.separation[i]);
        const mask8 moves = (load(block.separation0[i]) < splat(unused_separation)) & is_finite(moved, now);
        r = select(moves, moved, r), s = select(moves, now, s);
        scatter4(point, r.x, r.y, r.z, s);
        if constexpr (N == 1)
            if (has_round_pairs(block)) store_round_pairs(block, pose, moves, record);
    }
    Vec3x8 d = load3(block.d0);
    d = d + select(is_finite(m.passed, zero()), m.passed, zero3());
    float* offset[8];
    for (int k = 0; k < 8; ++k) offset[k] = record[k]->center_offset, record[k]->touch_time = 0; // the end of the step
    scatter4(offset, d.x, d.y, d.z, load(block.restitution));
}

template <int N>
void store_contacts(const void* blocks, int count, const ContactLanes& lanes, const SolverPose* pose,
                    ContactRecord* records, ContactReport* reports, float dt) {
    auto* block = static_cast<const ContactBlock<N>*>(blocks);
    ContactRecord discarded = empty_record;
    for (int k = 0; k < count; ++k) {
        if (k + 1 < count) prefetch_records(lanes.record + 8 * (k + 1), records);
        const ContactBlock<N>& b = block[k];
        const std::int32_t* ids = lanes.record + 8 * k;
        ContactRecord* record[8];
        float *impulses[8], *friction[8], *totals[8], *more_totals[8];
        for (int i = 0; i < 8; ++i) {
            ContactRecord* const r = record[i] = ids[i] >= 0 ? records + ids[i] : &discarded;
            impulses[i] = r->impulses, friction[i] = r->friction_impulse;
            totals[i] = r->total_friction, more_totals[i] = r->more_totals;
        }
        f32x8 impulse[4];
        for (int i = 0; i < 4; ++i) impulse[i] = i < N ? load(b.impulse[i < N ? i : 0]) : zero();
        scatter4(impulses, impulse[0], impulse[1], impulse[2], impulse[3]);
        const Vec3x8 t1 = load3(b.tangent), t2 = second_tangent(b, load3(b.normal));
        const Vec3x8 p = load(b.tangent_impulse[0]) * t1 + load(b.tangent_impulse[1]) * t2;
        // Adding zero removes negative zeros: the sign of a zero may depend on the other contacts of the block.
        scatter4(friction, p.x + zero(), p.y + zero(), p.z + zero(),
                 (load(b.torsion_impulse) - moment_about_center(b, t1, t2)) + zero());
        const Vec3x8 sum = load(b.total_tangent[0]) * t1 + load(b.total_tangent[1]) * t2;
        scatter4(totals, sum.x, sum.y, sum.z, load(b.total_impulse[0]));
        if constexpr (N > 1)
            scatter4(more_totals, load(b.total_impulse[1]), load(b.total_impulse[2]), load(b.total_impulse[3]), zero());
        store_reports<N>(b, ids, p, reports);
        move_points(b, pose, record, splat(1 / dt));
    }
}

template void prepare_contacts<1>(void*, int, const ContactLanes&, const ContactRecord*, const SolverInertia*,
                                  const SolverVelocity*, float, float);
template void prepare_contacts<4>(void*, int, const ContactLanes&, const ContactRecord*, const SolverInertia*,
                                  const SolverVelocity*, float, float);
template void store_contacts<1>(const void*, int, const ContactLanes&, const SolverPose*, ContactRecord*,
                                ContactReport*, float);
template void store_contacts<4>(const void*, int, const ContactLanes&, const SolverPose*, ContactRecord*,
                                ContactReport*, float);

} // namespace cairn::CAIRN_ISA
