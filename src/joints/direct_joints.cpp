#include "joints/direct_joints.h"

#include "joints/direct_sets.h"
#include "joints/direct_view.h"
#include "state/substeps.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cairn {

using math::Block;
using math::DVec3;
using math::put;

namespace {

constexpr double bias = 0.5; // fraction of an error that is corrected in a substep
// Relative increase of the diagonal in sets with loops, where some rows are redundant.
constexpr double loop_compliance = 1e-6;
constexpr int max_bound_rounds = 8; // rounds of fixing drives at their bounds, or freeing them

DVec3 vector_of(const float* p) { return math::to_double(math::to_vec(p)); }

// --- bodies

// Geometric stiffness: a body under tension resists rotation away from it. With the impulse p on it at the arm r, a
// rotation by u changes the torque by (u x r) x p = r (p.u) - (r.p) u. A velocity solver applies this a substep late,
// which is unstable where h^2 times the stiffness exceeds the inertia. The inertia is raised to that value.
void add_stiffness(DirectBody& body, DVec3 arm, DVec3 impulse, double h) {
    const auto along = [&](DVec3 v) {
        return DVec3{math::dot(body.axes.c0, v), math::dot(body.axes.c1, v), math::dot(body.axes.c2, v)};
    };
    const DVec3 r = along(arm), p = h * along(impulse);
    const double all = math::dot(r, p);
    for (int i = 0; i < 3; ++i) {
        const double k = all - r[i] * p[i];
        if (k > 0) body.stiffness[i] += k;
    }
}

// The linear impulse of a row on body B.
DVec3 force_of(const DirectRow& row, DVec3 impulse) {
    return row.is_plain ? impulse : math::transposed_times(row.linear, impulse);
}

void find_stiffness(const SetView& v, double h) {
    for (std::size_t i = 0; i < v.set.bodies.size(); ++i) v.bodies[i].stiffness = {};
    for (std::size_t i = 0; i < v.set.nodes.size(); ++i) {
        if (v.set.nodes[i].rows == DirectRows::turn) continue;
        const std::int32_t* ends = v.set.nodes[i].body;
        const DVec3 p = force_of(v.rows[i], v.rows[i].impulse);
        add_stiffness(v.bodies[ends[0]], v.rows[i].arm_a, -p, h);
        add_stiffness(v.bodies[ends[1]], v.rows[i].arm_b, p, h);
    }
}

void place_bodies(const SetView& v, const BatchScratch& scratch) {
    for (std::size_t i = 0; i < v.set.bodies.size(); ++i) {
        DirectBody& b = v.bodies[i];
        const SolverPose& pose = scratch.pose[b.row];
        b.center = vector_of(pose.dx);
        b.turn = math::normalized(math::DQuat{pose.dq[0], pose.dq[1], pose.dq[2], pose.dq[3]});
        b.v = vector_of(scratch.velocity[b.row].v);
        b.w = vector_of(scratch.velocity[b.row].w);
        b.dv = b.dw = {};
        if (b.by_forces) b.axes = math::to_matrix(b.turn * b.axes0);
    }
}

// Computes the inverse inertia with geometric stiffness. Equal moments give an exact multiple of 1: rounding would make
// contact blocks anisotropic.
void stiffen_bodies(const SetView& v) {
    for (std::size_t i = 0; i < v.set.bodies.size(); ++i) {
        DirectBody& b = v.bodies[i];
        if (!b.by_forces) continue;
        DVec3 inverse = b.inverse_moments;
        for (int k = 0; k < 3; ++k)
            if (b.stiffness[k] > b.moments[k] && inverse[k] > 0) inverse[k] = 1 / b.stiffness[k];
        b.inverse_inertia = inverse.x == inverse.y && inverse.x == inverse.z
                                ? math::DSym3{inverse.x, 0, 0, inverse.x, 0, inverse.x}
                                : math::rotated_diagonal(b.axes, inverse);
    }
}

// Adds the changes of velocity to velocities and reference velocities alike, so that they are not carried over.
void write_velocities(const SetView& v, BatchScratch& scratch) {
    auto write = [](float* velocity, float* reference, float* rounding, DVec3 change) {
        const DVec3 was = vector_of(velocity), base = vector_of(reference);
        const math::Vec3 now = math::to_float(was + change), moved = math::to_float(base + change);
        const DVec3 kept = ((was - base) - (math::to_double(now) - math::to_double(moved))) + vector_of(rounding);
        put(velocity, now), put(reference, moved), put(rounding, math::to_float(kept));
    };
    for (std::size_t i = 0; i < v.set.bodies.size(); ++i) {
        const DirectBody& b = v.bodies[i];
        if (!b.by_forces) continue;
        const std::size_t row = std::size_t(b.row);
        write(scratch.velocity[row].v, scratch.reference[row].v, scratch.rounding[row].v, b.dv);
        write(scratch.velocity[row].w, scratch.reference[row].w, scratch.rounding[row].w, b.dw);
    }
}

// --- rows

// Diagonal entries for the directions that a node leaves free.
Block free_directions(const DirectNode& node, const JointLocks& rules, const DirectRow& r, const Block& k) {
    const double size = k.m[0] + k.m[4] + k.m[8];
    const double scale = size > 0 ? size : 1.0;
    if (node.rows == DirectRows::axis || is_bounded(node.rows)) return {{0, 0, 0, 0, scale, 0, 0, 0, scale}};
    const bool is_point = node.rows == DirectRows::point;
    if ((is_point ? rules.point : rules.turn) != JointLock::across) return {};
    Block free = math::identity_block();
    free += -(is_point ? r.linear : r.angular[1]);
    return scale * free;
}

// Whether a node is nothing but a drive, friction or a soft limit.
bool is_drive(const SetView& v, std::size_t i) { return is_bounded(v.set.nodes[i].rows); }
// Whether a turn also holds the axis that it leaves free, by its drive.
bool holds_its_drive(const SetView& v, std::size_t i) { return v.set.nodes[i].is_driven && v.rows[i].drive.bound == 0; }
// Whether such a node is at its bound, and is therefore not a row.
bool is_bound(const SetView& v, std::size_t i) { return is_drive(v, i) && v.rows[i].drive.bound != 0; }

void add_linear(Block& k, double inverse_mass, const DirectRow& row, const DirectRow& column) {
    if (row.is_plain && column.is_plain)
        for (int d = 0; d < 9; d += 4) k.m[d] += inverse_mass;
    else
        k += inverse_mass * math::times_transposed(row.linear, column.linear);
}

Block own_block(const Joints& joints, const SetView& v, std::size_t i) {
    const DirectNode& node = v.set.nodes[i];
    DirectRow& r = v.rows[i];
    const DirectBody* ends[2] = {&v.bodies[node.body[0]], &v.bodies[node.body[1]]};
    Block k;
    if (node.rows != DirectRows::turn) add_linear(k, ends[0]->inverse_mass + ends[1]->inverse_mass, r, r);
    for (int side = 0; side < 2; ++side) {
        r.response[side] = r.angular[side] * math::to_block(ends[side]->inverse_inertia);
        k += math::times_transposed(r.response[side], r.angular[side]);
    }
    if (is_bound(v, i)) {
        r.diagonal = {1, 1, 1};
        return math::identity_block();
    }
    if (is_drive(v, i)) k.m[0] += r.drive.compliance;
    if (holds_its_drive(v, i))
        k += r.drive.compliance * math::outer_block(r.axis);
    else
        k += free_directions(node, joints.info[node.joint].rules, r, k);
    r.diagonal = {k.m[0], k.m[4], k.m[8]};
    if (v.set.has_loops)
        for (int d = 0; d < 9; d += 4) k.m[d] *= 1 + loop_compliance;
    return k;
}

// --- the matrix

void assemble(const Joints& joints, const SetView& v) {
    for (std::size_t i = 0; i < v.set.nodes.size(); ++i) v.diagonal[i] = own_block(joints, v, i);
    std::fill(v.lower, v.lower + v.set.plan.block_count(), Block{});
    for (const DirectCoupling& c : v.set.plan.couplings) {
        if (is_bound(v, c.row) || is_bound(v, c.column)) continue;
        const DirectRow &row = v.rows[c.row], &column = v.rows[c.column];
        Block& block = v.lower[c.block];
        block += math::times_transposed(row.response[c.row_side], column.angular[c.column_side]);
        if (v.set.nodes[c.row].rows == DirectRows::turn || v.set.nodes[c.column].rows == DirectRows::turn) continue;
        const double inverse_mass = v.bodies[v.set.nodes[c.row].body[c.row_side]].inverse_mass;
        const double signed_mass = c.row_side == c.column_side ? inverse_mass : -inverse_mass;
        add_linear(block, signed_mass, row, column);
    }
}

// Replaces the diagonal blocks by the inverses of the pivots.
void factorize(const SetView& v) {
    const DirectPlan& plan = v.set.plan;
    const std::uint32_t* product = plan.products.data();
    for (std::size_t k = 0; k < plan.node_count(); ++k) {
        const Block inverse = v.diagonal[k] = math::inverse_of(v.diagonal[k], v.rows[k].diagonal);
        const std::size_t begin = plan.first[k];
        for (std::size_t a = plan.first[k + 1]; a-- > begin;) {
            const Block scaled = v.lower[a] * inverse;
            math::subtract_times_transposed(v.diagonal[plan.rows[a]], scaled, v.lower[a]);
            for (std::size_t b = begin; b < a; ++b)
                math::subtract_times_transposed(v.lower[*product++], scaled, v.lower[b]);
            v.lower[a] = scaled;
        }
    }
}

void substitute(const SetView& v) {
    const DirectPlan& plan = v.set.plan;
    for (std::size_t k = 0; k < plan.node_count(); ++k) {
        const DVec3 y = v.sought[k];
        for (std::size_t a = plan.first[k]; a < plan.first[k + 1]; ++a) v.sought[plan.rows[a]] -= v.lower[a] * y;
    }
    for (std::size_t k = plan.node_count(); k-- > 0;) {
        DVec3 z = v.diagonal[k] * v.sought[k];
        for (std::size_t a = plan.first[k]; a < plan.first[k + 1]; ++a)
            z -= math::transposed_times(v.lower[a], v.sought[plan.rows[a]]);
        v.sought[k] = z;
    }
}

void apply(const SetView& v, std::size_t i, DVec3 impulse) {
    const DirectNode& node = v.set.nodes[i];
    const DirectRow& r = v.rows[i];
    DirectBody &a = v.bodies[node.body[0]], &b = v.bodies[node.body[1]];
    if (node.rows != DirectRows::turn) {
        const DVec3 p = force_of(r, impulse);
        a.dv -= a.inverse_mass * p;
        b.dv += b.inverse_mass * p;
    }
    a.dw += math::transposed_times(r.response[0], impulse);
    b.dw += math::transposed_times(r.response[1], impulse);
}

DVec3 slip_of(const SetView& v, std::size_t i) {
    const DirectNode& node = v.set.nodes[i];
    const DirectRow& r = v.rows[i];
    const DirectBody &a = v.bodies[node.body[0]], &b = v.bodies[node.body[1]];
    const DVec3 turning = r.angular[0] * (a.w + a.dw) + r.angular[1] * (b.w + b.dw);
    if (node.rows == DirectRows::turn) return turning;
    const DVec3 slip = (b.v + b.dv) - (a.v + a.dv);
    return turning + (r.is_plain ? slip : r.linear * slip);
}

DVec3 return_speed(DVec3 v) {
    const double square = math::dot(v, v);
    return square > fastest_return * fastest_return ? (fastest_return / std::sqrt(square)) * v : v;
}

} // namespace

void solve_impulse_increments(const SetView& v, double rate) {
    const std::size_t n = v.set.nodes.size();
    for (std::size_t i = 0; i < n; ++i) {
        const DirectRow& r = v.rows[i];
        const DVec3 slip = slip_of(v, i);
        if (is_drive(v, i)) {
            v.sought[i] = {is_bound(v, i) ? 0 : lack_of_drive(r.drive, slip.x), 0, 0};
            continue;
        }
        v.sought[i] = -(slip + return_speed(rate * r.error));
        if (!holds_its_drive(v, i)) continue;
        const double along = math::dot(r.axis, slip);
        v.sought[i] += (along + lack_of_drive(r.drive, along)) * r.axis;
    }
    substitute(v);
    for (std::size_t i = 0; i < n; ++i) {
        DirectRow& r = v.rows[i];
        apply(v, i, v.sought[i]);
        if (is_drive(v, i)) {
            r.drive.given += v.sought[i].x;
            continue;
        }
        r.given += v.sought[i];
        if (!holds_its_drive(v, i)) continue;
        const double along = math::dot(r.axis, v.sought[i]);
        r.drive.given += along;
        r.given -= along * r.axis;
    }
}

void commit_increments(const SetView& v) {
    for (std::size_t i = 0; i < v.set.nodes.size(); ++i) {
        DirectRow& r = v.rows[i];
        r.impulse += r.given, r.drive.impulse += r.drive.given;
        r.given = {}, r.drive.given = 0;
    }
}

namespace {

double speed_along_drive(const SetView& v, std::size_t i) {
    if (is_drive(v, i)) return slip_of(v, i).x;
    const DirectBody &a = v.bodies[v.set.nodes[i].body[0]], &b = v.bodies[v.set.nodes[i].body[1]];
    return math::dot(v.rows[i].axis, (b.w + b.dw) - (a.w + a.dw));
}
void apply_drive(const SetView& v, std::size_t i, double impulse) {
    if (is_drive(v, i)) return apply(v, i, {impulse, 0, 0});
    DirectBody &a = v.bodies[v.set.nodes[i].body[0]], &b = v.bodies[v.set.nodes[i].body[1]];
    a.dw -= impulse * (a.inverse_inertia * v.rows[i].axis);
    b.dw += impulse * (b.inverse_inertia * v.rows[i].axis);
}

// Fixes drives at their bounds, or frees them. Returns whether any changed; then the matrix is assembled again.
bool bound_drives(const Joints& joints, const SetView& v) {
    bool any = false;
    for (std::size_t i = 0; i < v.set.nodes.size(); ++i) {
        v.sought[i] = {};
        if (has_drive(v.set.nodes[i])) any |= bound_drive(v.rows[i].drive, speed_along_drive(v, i), v.sought[i].x);
    }
    if (!any) return false;
    for (std::size_t i = 0; i < v.set.nodes.size(); ++i) {
        if (v.sought[i].x != 0) apply_drive(v, i, v.sought[i].x);
        if (v.set.nodes[i].is_driven) aim_driven_turn(v.rows[i]);
    }
    assemble(joints, v);
    factorize(v);
    return true;
}

void seek_within_bounds(const Joints& joints, const SetView& v, double rate) {
    solve_impulse_increments(v, rate);
    for (int round = 0; round < max_bound_rounds && bound_drives(joints, v); ++round) solve_impulse_increments(v, rate);
}

void solve_rows(const Joints& joints, const SetView& v, double rate) {
    seek_within_bounds(joints, v, rate);
    commit_increments(v);
}

double return_rate(double h) { return bias / std::max(h, double(stiffest_substep)); }

void read_velocities(const SetView& v, const BatchScratch& scratch) {
    for (std::size_t i = 0; i < v.set.bodies.size(); ++i) {
        DirectBody& b = v.bodies[i];
        b.v = vector_of(scratch.velocity[b.row].v);
        b.w = vector_of(scratch.velocity[b.row].w);
        b.dv = b.dw = {};
    }
    for (std::size_t i = 0; i < v.set.nodes.size(); ++i) v.rows[i].given = {}, v.rows[i].drive.given = 0;
}

void begin_set(const Joints& joints, const SetView& v, BatchScratch& scratch, double h, bool first) {
    const std::size_t n = v.set.nodes.size();
    place_bodies(v, scratch);
    const auto refresh_rows = [&] {
        for (std::size_t i = 0; i < n; ++i) refresh_row(joints, v, i, h);
    };
    refresh_rows();
    if (first && v.is_new) { // the tension must be known before any body rotates
        stiffen_bodies(v);
        assemble(joints, v);
        factorize(v);
        for (std::size_t i = 0; i < n; ++i) v.rows[i].impulse = {}, v.rows[i].drive.impulse = 0;
        forget_limits(v);
        solve_rows(joints, v, 0);
        for (std::size_t i = 0; i < v.set.bodies.size(); ++i) v.bodies[i].dv = v.bodies[i].dw = {};
    }
    if (first) {
        find_stiffness(v, h);
        refresh_rows();
    }
    stiffen_bodies(v);
    assemble(joints, v);
    factorize(v);
    for (std::size_t i = 0; i < n; ++i) {
        apply(v, i, v.rows[i].impulse);
        if (has_drive(v.set.nodes[i])) apply_drive(v, i, v.rows[i].drive.impulse);
    }
    write_velocities(v, scratch);
}

void begin_limits_of(const SetView& v, BatchScratch& scratch) {
    if (v.limit_count == 0) return;
    read_velocities(v, scratch);
    begin_limits(v);
    write_velocities(v, scratch);
}

// Adds the impulses of a node's rows and of its drive to its total.
void count_impulse(const SetView& v, std::size_t i, DVec3 impulse, double drive) {
    DirectRow& r = v.rows[i];
    const bool is_turning = r.linear.m[0] == 0 && r.linear.m[1] == 0 && r.linear.m[2] == 0;
    const bool turns = v.set.nodes[i].rows != DirectRows::point && is_turning;
    if (is_drive(v, i)) impulse = {drive, 0, 0};
    r.total += turns ? math::transposed_times(r.angular[1], impulse) : force_of(r, impulse);
    if (v.set.nodes[i].is_driven) r.total += drive * r.axis;
}

void solve_set(const Joints& joints, const SetView& v, BatchScratch& scratch, double h) {
    const double rate = return_rate(h);
    read_velocities(v, scratch);
    solve_rows(joints, v, rate);
    hold_limits(v, rate, h);
    if (bound_drives(joints, v)) { // because of the limits' impulses
        solve_rows(joints, v, rate);
        hold_limits(v, rate, h);
    }
    count_limits(v);
    find_stiffness(v, h);
    for (std::size_t i = 0; i < v.set.nodes.size(); ++i)
        count_impulse(v, i, v.rows[i].impulse, v.rows[i].drive.impulse);
    write_velocities(v, scratch);
}

// Finds the velocities that the joints allow: the changes are in dv and dw.
void join_set(const Joints& joints, const SetView& v, const BatchScratch& scratch, double h) {
    const double rate = return_rate(h);
    read_velocities(v, scratch);
    seek_within_bounds(joints, v, rate);
    hold_limits_for_now(v, rate, h);
}

void hold_set(const Joints& joints, const SetView& v, BatchScratch& scratch, double h) {
    if (!v.is_touched) return;
    join_set(joints, v, scratch, h);
    for (std::size_t i = 0; i < v.set.bodies.size(); ++i) {
        DirectBody& b = v.bodies[i];
        if (!b.by_forces) continue;
        SolverVelocity& velocity = scratch.velocity[b.row];
        b.kept_v = math::to_vec(velocity.v), b.kept_w = math::to_vec(velocity.w);
        put(velocity.v, math::to_float(b.v + b.dv)), put(velocity.w, math::to_float(b.w + b.dw));
    }
}

void release_set(const SetView& v, BatchScratch& scratch) {
    if (!v.is_touched) return;
    for (std::size_t i = 0; i < v.set.bodies.size(); ++i) {
        const DirectBody& b = v.bodies[i];
        if (!b.by_forces) continue;
        put(scratch.velocity[b.row].v, b.kept_v), put(scratch.velocity[b.row].w, b.kept_w);
    }
}

SetView view_of(const DirectSets& direct, BatchScratch& scratch, std::size_t place) {
    DirectWork& w = scratch.direct;
    const DirectSolve& solve = w.sets[place];
    return {direct.sets[solve.set],
            w.bodies.data() + solve.first_body,
            w.rows.data() + solve.first_row,
            w.diagonal.data() + solve.first_row,
            w.lower.data() + solve.first_block,
            w.sought.data() + solve.first_row,
            solve.is_new,
            solve.is_touched,
            w.limits.data() + solve.first_limit,
            solve.limit_count,
            scratch.axis_blocks.data()};
}

template <class F> void for_sets(const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool, F&& work) {
    DirectWork& w = scratch.direct;
    if (w.sets.empty()) return; // in most batches: avoids the overhead of threads
    for_chunks(thread_pool, int(w.sets.size()), 1, [&](int begin, int end, int) {
        for (int k = begin; k < end; ++k) work(view_of(direct, scratch, std::size_t(k)));
    });
}

} // namespace

void begin_direct_substep(const Joints& joints, const DirectSets& direct, BatchScratch& scratch,
                          ThreadPool* thread_pool, float h, bool first) {
    for_sets(direct, scratch, thread_pool, [&](const SetView& v) { begin_set(joints, v, scratch, double(h), first); });
}

void begin_direct_limits(const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool) {
    for_sets(direct, scratch, thread_pool, [&](const SetView& v) { begin_limits_of(v, scratch); });
}

void solve_direct_rows(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool,
                       float h) {
    for_sets(direct, scratch, thread_pool, [&](const SetView& v) { solve_set(joints, v, scratch, double(h)); });
}

void hold_direct_bodies(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool,
                        float h) {
    for_sets(direct, scratch, thread_pool, [&](const SetView& v) { hold_set(joints, v, scratch, double(h)); });
}

void release_direct_bodies(const DirectSets& direct, BatchScratch& scratch, ThreadPool* thread_pool) {
    for_sets(direct, scratch, thread_pool, [&](const SetView& v) { release_set(v, scratch); });
}

void join_velocities(const Joints& joints, const DirectSets& direct, BatchScratch& scratch, std::size_t place,
                     float h) {
    const SetView v = view_of(direct, scratch, place);
    join_set(joints, v, scratch, double(h));
    for (std::size_t i = 0; i < v.set.nodes.size(); ++i) {
        DirectRow& r = v.rows[i];
        count_impulse(v, i, r.given, r.drive.given);
        r.drive.impulse += std::exchange(r.drive.given, 0); // otherwise it would be given again
    }
    for (std::size_t i = 0; i < v.set.bodies.size(); ++i) {
        const DirectBody& b = v.bodies[i];
        if (!b.by_forces) continue;
        SolverVelocity& velocity = scratch.velocity[b.row];
        put(velocity.v, math::to_float(b.v + b.dv)), put(velocity.w, math::to_float(b.w + b.dw));
    }
}

} // namespace cairn
