
#include "solver/row_motion.h"

#include "bodies/bodies.h"
#include "bodies/integrators.h"
#include "core/room.h"

#include <algorithm>

namespace cairn {

using math::DQuat;
using math::DVec3;
using math::put;

namespace {

constexpr int rows_per_chunk = 256, spin_blocks_per_chunk = 4; // for threads

DVec3 row_vector(const float* p) { return math::to_double(math::to_vec(p)); }

void write_linear(const WorldDef& settings, BatchScratch& scratch, std::size_t row, const Increment& change) {
    put(scratch.drive[row].v, math::to_float(cut(change.velocity, settings.max_linear_speed)));
    if (!scratch.free_correction.empty())
        put(scratch.free_correction[row].v, math::to_float(cut(change.correction, settings.max_linear_speed)));
}
void write_angular(const WorldDef& settings, BatchScratch& scratch, std::size_t row, const Increment& change) {
    put(scratch.drive[row].w, math::to_float(cut(change.velocity, settings.max_angular_speed)));
    if (!scratch.free_correction.empty())
        put(scratch.free_correction[row].w, math::to_float(cut(change.correction, settings.max_angular_speed)));
}

DQuat row_rotation(const Bodies& bodies, const BatchScratch& scratch, std::size_t row) {
    const float* dq = scratch.pose[row].dq;
    return math::normalized(DQuat{dq[0], dq[1], dq[2], dq[3]} * bodies.motion[scratch.row_bodies[row]].q);
}

// Computes the rotation of a body that the spin kernel does not handle.
void spin_row(const Bodies& bodies, const WorldDef& settings, BatchScratch& scratch, SpinningRow& r, float h) {
    const std::size_t row = std::size_t(r.row);
    const std::int32_t b = scratch.row_bodies[row];
    const BodyMass& mass = bodies.mass[b];
    const DVec3 w = row_vector(scratch.velocity[row].w);
    const DQuat q = row_rotation(bodies, scratch, row);
    const Spin spin = spin_of(mass);
    r.turns = precesses(mass, w, h);
    if (!r.turns) {
        write_angular(settings, scratch, row, torque_increment(bodies, settings, b, spin, q, h));
        return;
    }
    const Increment change =
        gyroscopic_increment(settings, spin, q, w, spin.to_world(q, spin.moments, w), bodies.forces[b].torque, h);
    r.free_w = w + change.velocity;
    r.end = turned_by(double(h) * (r.free_w + change.correction), q);
    write_angular(settings, scratch, row, change);
}

// Whether the spin kernel handles the body. Explicit Euler is kept without modification, needles have another inertia
// in contacts than in free motion, and torques may be of any size: these cases are left to scalar code.
bool kernel_spins(const Bodies& bodies, const WorldDef& settings, std::int32_t b) {
    const BodyMass& mass = bodies.mass[b];
    const math::Vec3& i = mass.inertia;
    return settings.integrator != Integrator::explicit_euler && !bodies.is_pushed(b) && mass.inverse_inertia.x > 0 &&
           mass.inverse_inertia.y > 0 && mass.inverse_inertia.z > 0 &&
           std::min(i.x, std::min(i.y, i.z)) > min_contact_moment * std::max(i.x, std::max(i.y, i.z));
}

int spin_block_count(const BatchScratch& scratch) { return int((scratch.spin_rows.size() + 7) / 8); }

void fill_spin_lane(const Bodies& bodies, std::size_t b, std::int32_t row, SpinBlock& block, std::size_t lane) {
    const BodyMass& mass = bodies.mass[b];
    const math::Quat axes = math::to_float(math::normalized(bodies.motion[b].q * math::to_double(mass.principal)));
    const float q[4] = {axes.x, axes.y, axes.z, axes.w};
    block.row[lane] = std::uint32_t(row) * row_bytes;
    for (int k = 0; k < 4; ++k) block.axes[k][lane] = q[k];
    for (int k = 0; k < 3; ++k) block.moments[k][lane] = mass.inertia[k];
    for (int k = 0; k < 3; ++k) block.inverse_moments[k][lane] = mass.inverse_inertia[k];
    if (bodies.links[b].joint_count == 0) return;
    block.renewed[lane] = 1;
    block.any_renewed = 1;
}

void fill_spin_blocks(const Bodies& bodies, BatchScratch& scratch, ThreadPool* thread_pool) {
    const int blocks = spin_block_count(scratch);
    if (scratch.spin_blocks.size() < std::size_t(blocks)) set_size_anew(scratch.spin_blocks, std::size_t(blocks));
    for_chunks(thread_pool, blocks, spin_blocks_per_chunk, [&](int begin, int end, int) {
        for (int k = begin; k < end; ++k) {
            SpinBlock& block = scratch.spin_blocks[k] = {};
            const std::uint32_t discard = std::uint32_t(scratch.first_discard_row() + k) * row_bytes;
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const std::size_t at = std::size_t(k) * 8 + lane;
                block.row[lane] = discard, block.axes[3][lane] = 1;
                if (at >= scratch.spin_rows.size()) continue;
                const std::int32_t row = scratch.spin_rows[at];
                fill_spin_lane(bodies, std::size_t(scratch.row_bodies[row]), row, block, lane);
            }
        }
        kernels().solver.begin_spin(scratch.spin_blocks.data() + begin, end - begin, scratch.inertia.data());
    });
}

void prepare_damping(const Bodies& bodies, BatchScratch& scratch, float h) {
    scratch.damping.clear();
    for (std::size_t row = 0; row < scratch.row_traits.size(); ++row) {
        if (!(scratch.row_traits[row] & is_damped)) continue;
        if (scratch.damping.empty()) scratch.damping.assign(scratch.velocity.size(), {{1, 1, 1}, 1, {1, 1, 1}, 1});
        const BodySettings& settings = bodies.settings[scratch.row_bodies[row]];
        const float linear = damping_factor(settings.linear_damping, h),
                    angular = damping_factor(settings.angular_damping, h);
        put(scratch.damping[row].v, {linear, linear, linear});
        put(scratch.damping[row].w, {angular, angular, angular});
    }
}

} // namespace

std::uint8_t row_traits(const Bodies& bodies, const WorldDef& settings, std::int32_t b) {
    const BodySettings& own = bodies.settings[b];
    const BodyMass& mass = bodies.mass[b];
    int traits = is_dynamic_row;
    if (mass.inverse_mass > 0 && own.gravity_scale == 1.0f && !bodies.is_pushed(b)) traits |= falls_plainly;
    if (own.linear_damping > 0 || own.angular_damping > 0) traits |= is_damped;
    if (!mass.isotropic) traits |= kernel_spins(bodies, settings, b) ? spins_wide : spins_alone;
    return std::uint8_t(traits);
}

void list_spinning_rows(BatchScratch& scratch) {
    scratch.spinning_rows.clear();
    scratch.spin_rows.clear();
    for (std::size_t row = 0; row < scratch.row_traits.size(); ++row) {
        if (scratch.row_traits[row] & spins_wide) scratch.spin_rows.push_back(std::int32_t(row));
        if (scratch.row_traits[row] & spins_alone) scratch.spinning_rows.push_back({std::int32_t(row), false, {}, {}});
    }
}

void prepare_free_motion(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings,
                         BatchScratch& scratch, ThreadPool* thread_pool, float h, bool bounces) {
    const std::size_t rows = scratch.row_bodies.size(), all = scratch.velocity.size();
    scratch.drive.assign(all, {});
    scratch.free_correction.clear();
    scratch.drive_varies = fields_vary(fields);
    scratch.bounces = bounces;
    prepare_damping(bodies, scratch, h);
    list_spinning_rows(scratch);
    fill_spin_blocks(bodies, scratch, thread_pool);
    if (!scratch.spinning_rows.empty() || !scratch.spin_rows.empty() || bounces ||
        settings.integrator != Integrator::semi_implicit_euler)
        scratch.free_correction.assign(all, {});
    if (bounces) scratch.correction.resize(all); // filled in each substep
    // Velocity change by gravity, which most bodies have in common.
    const bool only_gravity = !any_field(fields);
    const Increment fall = only_gravity ? linear_increment(fields, settings, {{}, 1.0f, 0.0f}, {}, {}, h) : Increment{};
    const math::Vec3 fall_velocity = math::to_float(cut(fall.velocity, settings.max_linear_speed)),
                     fall_correction = math::to_float(cut(fall.correction, settings.max_linear_speed));
    auto drive_row = [&](std::size_t row) {
        const std::uint8_t traits = scratch.row_traits[row];
        if (!(traits & is_dynamic_row)) return;
        if (only_gravity && (traits & falls_plainly)) {
            put(scratch.drive[row].v, fall_velocity);
            if (!scratch.free_correction.empty()) put(scratch.free_correction[row].v, fall_correction);
            return;
        }
        // Terms that vary within the step are computed at the start of each substep.
        const std::int32_t b = scratch.row_bodies[row];
        const BodyMotion& motion = bodies.motion[b];
        const BodyMass& mass = bodies.mass[b];
        if (mass.inverse_mass > 0 && !scratch.drive_varies)
            write_linear(
                settings, scratch, row,
                linear_increment(fields, settings, load_on(bodies, b), motion.x, math::to_double(motion.v), h));
        if (mass.isotropic && bodies.is_pushed(b))
            write_angular(settings, scratch, row, torque_increment(bodies, settings, b, spin_of(mass), motion.q, h));
    };
    for_chunks(thread_pool, int(rows), rows_per_chunk, [&](int begin, int end, int) {
        for (int row = begin; row < end; ++row) drive_row(std::size_t(row));
    });
}

void update_free_motion(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings,
                        BatchScratch& scratch, ThreadPool* thread_pool, const SolverBodies& solver_bodies, float h,
                        bool first) {
    if (scratch.drive_varies)
        for (std::size_t row = 0; row < scratch.row_bodies.size(); ++row) {
            const std::int32_t b = scratch.row_bodies[row];
            if (b == none || !bodies.is_dynamic(b) || !(bodies.mass[b].inverse_mass > 0)) continue;
            const DVec3 x = bodies.motion[b].x + row_vector(scratch.pose[row].dx);
            write_linear(
                settings, scratch, row,
                linear_increment(fields, settings, load_on(bodies, b), x, row_vector(scratch.velocity[row].v), h));
        }
    for (SpinningRow& row : scratch.spinning_rows) spin_row(bodies, settings, scratch, row, h);
    if (!scratch.spin_rows.empty())
        for_chunks(thread_pool, spin_block_count(scratch), spin_blocks_per_chunk, [&](int begin, int end, int) {
            kernels().solver.spin(scratch.spin_blocks.data() + begin, end - begin, solver_bodies, scratch.drive.data(),
                                  scratch.free_correction.data(), h, first);
        });
    if (scratch.bounces) scratch.correction = scratch.free_correction;
}

namespace {

// Calls f(row, k) for the rows of bodies that may rotate freely; k is the index in held_turns.
template <class F> void for_turning_rows(BatchScratch& scratch, ThreadPool* thread_pool, F&& f) {
    const std::size_t wide = scratch.spin_rows.size(), all = wide + scratch.spinning_rows.size();
    for_chunks(thread_pool, int(all), rows_per_chunk, [&](int begin, int end, int) {
        for (auto k = std::size_t(begin); k < std::size_t(end); ++k)
            f(std::size_t(k < wide ? scratch.spin_rows[k] : scratch.spinning_rows[k - wide].row), k);
    });
}
// Adds `turn` (rad/s) to the angular velocity and subtracts it from the correction; the pose moves by their sum.
void move_to_velocity(BatchScratch& scratch, std::size_t row, math::Vec3 turn) {
    SolverTwist& rest = (scratch.bounces ? scratch.correction : scratch.free_correction)[row];
    SolverVelocity& velocity = scratch.velocity[row];
    put(velocity.w, math::to_vec(velocity.w) + turn);
    put(rest.w, math::to_vec(rest.w) - turn);
}

} // namespace

void use_midpoint_spin(BatchScratch& scratch, ThreadPool* thread_pool) {
    scratch.held_turns.resize(scratch.spin_rows.size() + scratch.spinning_rows.size());
    for_turning_rows(scratch, thread_pool, [&](std::size_t row, std::size_t k) {
        const math::Vec3 turn = scratch.held_turns[k] = math::to_vec(scratch.free_correction[row].w);
        if (!(turn == math::Vec3{})) move_to_velocity(scratch, row, turn);
    });
}
void restore_end_spin(BatchScratch& scratch, ThreadPool* thread_pool) {
    for_turning_rows(scratch, thread_pool, [&](std::size_t row, std::size_t k) {
        const math::Vec3 turn = scratch.held_turns[k];
        if (!(turn == math::Vec3{})) move_to_velocity(scratch, row, -turn);
    });
}

void turn_spinning_rows(const Bodies& bodies, BatchScratch& scratch, float h) {
    for (std::size_t k = 0; k < scratch.spinning_rows.size(); ++k) {
        const SpinningRow& r = scratch.spinning_rows[k];
        if (!r.turns) continue;
        const std::size_t row = std::size_t(r.row);
        const math::Vec3 held = scratch.held_turns[scratch.spin_rows.size() + k];
        DVec3 contacts = row_vector(scratch.velocity[row].w) - math::to_double(held) - r.free_w;
        if (scratch.bounces)
            contacts += row_vector(scratch.correction[row].w) + math::to_double(held) -
                        row_vector(scratch.free_correction[row].w);
        const DQuat start = bodies.motion[scratch.row_bodies[row]].q;
        const math::Quat turn =
            math::to_float(math::normalized(turned_by(double(h) * contacts, r.end) * math::conjugate(start)));
        float* dq = scratch.pose[row].dq;
        dq[0] = turn.x, dq[1] = turn.y, dq[2] = turn.z, dq[3] = turn.w;
    }
}

void renew_inertia(const Bodies& bodies, BatchScratch& scratch, ThreadPool* thread_pool) {
    if (scratch.joint_layout->joints.empty()) return;
    for_chunks(thread_pool, spin_block_count(scratch), spin_blocks_per_chunk, [&](int begin, int end, int) {
        kernels().solver.renew_inertia(scratch.spin_blocks.data() + begin, end - begin, scratch.velocity.data(),
                                       scratch.pose.data(), scratch.inertia.data());
    });
    for (const SpinningRow& r : scratch.spinning_rows) {
        const std::size_t row = std::size_t(r.row), b = std::size_t(scratch.row_bodies[row]);
        if (bodies.links[b].joint_count == 0) continue;
        BodyMotion now = bodies.motion[b];
        now.q = row_rotation(bodies, scratch, row);
        const math::Sym3 i = contact_inverse_inertia(now, bodies.mass[b]);
        scratch.inertia[row] = {bodies.mass[b].inverse_mass, i.xx, i.xy, i.xz, i.yy, i.yz, i.zz, 0};
    }
}

void finish_free_motion(BatchScratch& scratch) {
    kernels().solver.finish_spin(scratch.spin_blocks.data(), spin_block_count(scratch), scratch.velocity.data(),
                                 scratch.pose.data());
}

} // namespace cairn
