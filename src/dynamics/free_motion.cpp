// Motion without contacts: gravity, fields, forces, and the torque-free turning of bodies with unequal moments of
// inertia. Each integrator yields a change of velocity ("drive"), and a correction that turns the velocity at the
// end of the substep into the one that moves the pose; contacts work with any of them.
#include "dynamics/bodies.h"
#include "dynamics/solver.h"
#include "math/rotation.h"

#include <algorithm>

namespace cairn {

using math::DQuat;
using math::DVec3;
using math::put;

namespace {

// Slower rotations (radians per substep) have no gyroscopic part worth computing. It makes no difference to what is
// held by friction, but the energy of a free top depends on it.
constexpr double least_turn_free = 1e-6, least_turn_in_contact = 1e-5;

constexpr double most_even_turn = 0.25; // rad

constexpr int rows_per_chunk = 256, spin_blocks_per_chunk = 4; // for threads

struct Increment {
    DVec3 velocity, correction;
};

DVec3 row_vector(const float* p) { return math::to_double(math::to_vec(p)); }

// Cut, so that forces of any size leave finite velocities.
DVec3 cut(DVec3 v, double most) {
    const double square = math::dot(v, v);
    if (square > most * most) v = std::isfinite(square) ? (most / std::sqrt(square)) * v : DVec3{};
    return v;
}

DQuat turned_by(DVec3 u, const DQuat& q) {
    if (u == DVec3{}) return q; // not even by a rounding
    return math::normalized(math::from_rotation_vector(u) * q);
}

struct Spin {
    DVec3 moments, inverse_moments; // principal
    DQuat principal;
    DVec3 to_world(const DQuat& q, DVec3 diagonal, DVec3 v) const {
        const DQuat axes = q * principal;
        return math::rotate(axes, math::scaled(diagonal, math::rotate_back(axes, v)));
    }
};

// The rotation by an angle about one principal axis.
DQuat axis_turn(int axis, double angle) {
    DVec3 u;
    u[axis] = angle;
    return math::from_rotation_vector(u);
}

// Keeps the angular momentum L to rounding, and the energy in bounds however fast the body spins, by splitting (as in
// Dullweber, Leimkuhler and McLachlan 1997): with I2 the middle moment, the energy is L^2 / (2 I2), a steady turn about
// L, plus m1^2 / 2 (1/I1 - 1/I2) and m3^2 / 2 (1/I3 - 1/I2), turns about the body's own axes. Each is followed exactly;
// a symmetric top is exact as a whole.
Increment split_spin(const Spin& spin, const DQuat& q, DVec3 w, DVec3 momentum, double h) {
    const DVec3& i = spin.moments;
    int least = i.x <= i.y ? (i.x <= i.z ? 0 : 2) : (i.y <= i.z ? 1 : 2);
    int greatest = i.x > i.y ? (i.x > i.z ? 0 : 2) : (i.y > i.z ? 1 : 2);
    if (least == greatest) least = 0, greatest = 2;
    const double middle = 1 / i[3 - least - greatest];
    DQuat axes = math::normalized(q * spin.principal);
    auto turn_about = [&](int axis, double time) {
        const double m = math::rotate_back(axes, momentum)[axis];
        axes = axes * axis_turn(axis, time * m * (1 / i[axis] - middle));
    };
    turn_about(least, 0.5 * h);
    turn_about(greatest, h);
    turn_about(least, 0.5 * h);
    axes = math::normalized(math::from_rotation_vector((h * middle) * momentum) * axes);
    const DQuat end = axes * math::conjugate(spin.principal);
    const DVec3 w_end = spin.to_world(end, spin.inverse_moments, momentum);
    return {w_end - w, (1 / h) * math::to_rotation_vector(end * math::conjugate(q)) - w_end};
}

// Euler's equation as it stands: w' = I^-1 (torque - w x I w).
Increment explicit_spin(const Spin& spin, const DQuat& q, DVec3 w, DVec3 torque, double h) {
    const DVec3 momentum = spin.to_world(q, spin.moments, w);
    const DVec3 dw = h * spin.to_world(q, spin.inverse_moments, torque - math::cross(w, momentum));
    return {dw, -dw};
}

// Classic Runge-Kutta on the rotation and the angular momentum.
Increment rk4_spin(const Spin& spin, const DQuat& q, DVec3 w, DVec3 momentum, DVec3 torque, double h) {
    auto rate = [&](const DQuat& at, double t) {
        const DVec3 u = spin.to_world(math::normalized(at), spin.inverse_moments, momentum + t * torque);
        const DQuat d = DQuat{u.x, u.y, u.z, 0} * at;
        return DQuat{0.5 * d.x, 0.5 * d.y, 0.5 * d.z, 0.5 * d.w};
    };
    auto along = [&](const DQuat& d, double t) {
        return DQuat{q.x + t * d.x, q.y + t * d.y, q.z + t * d.z, q.w + t * d.w};
    };
    const DQuat k1 = rate(q, 0), k2 = rate(along(k1, h / 2), h / 2), k3 = rate(along(k2, h / 2), h / 2),
                k4 = rate(along(k3, h), h);
    const DQuat sum{k1.x + 2 * k2.x + 2 * k3.x + k4.x, k1.y + 2 * k2.y + 2 * k3.y + k4.y,
                    k1.z + 2 * k2.z + 2 * k3.z + k4.z, k1.w + 2 * k2.w + 2 * k3.w + k4.w};
    const DQuat end = math::normalized(along(sum, h / 6));
    const DVec3 mean = (1 / h) * math::to_rotation_vector(end * math::conjugate(q)); // the rate that turns q into that
    const DVec3 w_end = spin.to_world(end, spin.inverse_moments, momentum + h * torque);
    return {w_end - w, mean - w_end};
}

Increment translate(Integrator integrator, DVec3 dv) {
    switch (integrator) {
    case Integrator::semi_implicit_euler:
        return {dv, {}};
    case Integrator::explicit_euler:
        return {dv, -dv};
    case Integrator::rk4:
        return {dv, -0.5 * dv};
    }
    return {};
}

// What acts on one body, apart from contacts.
struct Load {
    DVec3 force_acceleration;
    float gravity_scale, inverse_mass;
};

Increment linear_increment(const State& s, const Load& load, DVec3 x, DVec3 v, double h) {
    auto acceleration = [&](DVec3 at) {
        return field_acceleration(s, at, load.gravity_scale, double(load.inverse_mass)) + load.force_acceleration;
    };
    const DVec3 a1 = acceleration(x);
    if (s.settings.integrator != Integrator::rk4) return translate(s.settings.integrator, h * a1);
    const DVec3 a2 = acceleration(x + (h / 2) * v), a3 = acceleration(x + (h / 2) * v + (h * h / 4) * a1);
    const DVec3 a4 = acceleration(x + h * v + (h * h / 2) * a2);
    const DVec3 dv = (h / 6) * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    return {dv, (h / 6) * (a1 + a2 + a3) - dv};
}

bool fields_vary(const State& s) {
    for (std::uint32_t i = 0; i < s.fields.size(); ++i)
        if (s.field_slots.is_live(i) && s.fields[i].kind == ForceField::Kind::radial) return true;
    return false;
}

Load load_on(const State& s, std::int32_t b) {
    const BodyMass& mass = s.mass[std::size_t(b)];
    const BodyForces& forces = s.forces[std::size_t(b)];
    return {double(mass.inverse_mass) * forces.force, s.body_settings[std::size_t(b)].gravity_scale, mass.inverse_mass};
}

void write_linear(const State& s, BinScratch& scratch, std::size_t row, const Increment& change) {
    put(scratch.drive[row].v, math::to_float(cut(change.velocity, s.settings.max_linear_speed)));
    if (!scratch.free_correction.empty())
        put(scratch.free_correction[row].v, math::to_float(cut(change.correction, s.settings.max_linear_speed)));
}
void write_angular(const State& s, BinScratch& scratch, std::size_t row, const Increment& change) {
    put(scratch.drive[row].w, math::to_float(cut(change.velocity, s.settings.max_angular_speed)));
    if (!scratch.free_correction.empty())
        put(scratch.free_correction[row].w, math::to_float(cut(change.correction, s.settings.max_angular_speed)));
}

Spin spin_of(const BodyMass& mass) {
    const math::Vec3& i = mass.inertia;
    // Inverses in double: rounded ones would change the momentum a little in every substep.
    return {math::to_double(i),
            {mass.inverse_inertia.x > 0 ? 1.0 / i.x : 0, mass.inverse_inertia.y > 0 ? 1.0 / i.y : 0,
             mass.inverse_inertia.z > 0 ? 1.0 / i.z : 0},
            math::normalized(math::to_double(mass.principal))};
}

// Whether a body has a gyroscopic part: unequal moments, and turns faster than `least` in a substep.
bool precesses(const BodyMass& mass, DVec3 w, double h, double least) {
    const bool turns_freely = mass.inverse_inertia.x > 0 && mass.inverse_inertia.y > 0 && mass.inverse_inertia.z > 0;
    return !mass.isotropic && turns_freely && h * h * math::dot(w, w) > least * least;
}

// For a body at rotation q with the angular velocity w and the angular momentum that goes with it.
Increment gyroscopic_increment(const State& s, const Spin& spin, const DQuat& q, DVec3 w, DVec3 momentum, DVec3 torque,
                               double h) {
    switch (s.settings.integrator) {
    case Integrator::semi_implicit_euler:
        return split_spin(spin, q, w, momentum + h * torque, h);
    case Integrator::explicit_euler:
        return explicit_spin(spin, q, w, torque, h);
    case Integrator::rk4:
        return rk4_spin(spin, q, w, momentum, torque, h);
    }
    return {};
}

// The torque alone.
Increment torque_increment(const State& s, std::int32_t b, const Spin& spin, const DQuat& q, double h) {
    if (!s.is_pushed(b)) return {};
    return translate(s.settings.integrator,
                     h * spin.to_world(q, spin.inverse_moments, s.forces[std::size_t(b)].torque));
}

DQuat row_rotation(const State& s, const BinScratch& scratch, std::size_t row) {
    const float* dq = scratch.pose[row].dq;
    return math::normalized(DQuat{dq[0], dq[1], dq[2], dq[3]} * s.motion[std::size_t(scratch.row_bodies[row])].q);
}

// One row that the kernel does not do.
void spin_row(const State& s, BinScratch& scratch, SpinningRow& r, float h) {
    const std::size_t row = std::size_t(r.row);
    const std::int32_t b = scratch.row_bodies[row];
    const BodyMass& mass = s.mass[std::size_t(b)];
    const DVec3 w = row_vector(scratch.velocity[row].w);
    const DQuat q = row_rotation(s, scratch, row);
    const Spin spin = spin_of(mass);
    r.turns = precesses(mass, w, h, least_turn_in_contact);
    if (!r.turns) {
        write_angular(s, scratch, row, torque_increment(s, b, spin, q, h));
        return;
    }
    const Increment change =
        gyroscopic_increment(s, spin, q, w, spin.to_world(q, spin.moments, w), s.forces[std::size_t(b)].torque, h);
    r.free_w = w + change.velocity;
    r.end = turned_by(double(h) * (r.free_w + change.correction), q);
    write_angular(s, scratch, row, change);
}

// Explicit Euler is kept as it stands, needles have another inertia in contacts than in free motion, and torques may be
// of any size: those are left to the scalar code.
bool kernel_spins(const State& s, std::int32_t b) {
    const BodyMass& mass = s.mass[std::size_t(b)];
    const math::Vec3& i = mass.inertia;
    return s.settings.integrator != Integrator::explicit_euler && !s.is_pushed(b) && mass.inverse_inertia.x > 0 &&
           mass.inverse_inertia.y > 0 && mass.inverse_inertia.z > 0 &&
           std::min(i.x, std::min(i.y, i.z)) > least_contact_moment * std::max(i.x, std::max(i.y, i.z));
}

int spin_block_count(const BinScratch& scratch) { return int((scratch.spin_rows.size() + 7) / 8); }

void fill_spin_lane(const State& s, std::size_t b, std::int32_t row, SpinBlock& block, std::size_t lane) {
    const BodyMass& mass = s.mass[b];
    const math::Quat axes = math::to_float(math::normalized(s.motion[b].q * math::to_double(mass.principal)));
    const float q[4] = {axes.x, axes.y, axes.z, axes.w};
    block.row[lane] = std::uint32_t(row) * row_bytes;
    for (int k = 0; k < 4; ++k) block.axes[k][lane] = q[k];
    for (int k = 0; k < 3; ++k) block.moments[k][lane] = mass.inertia[k];
    for (int k = 0; k < 3; ++k) block.inverse_moments[k][lane] = mass.inverse_inertia[k];
    if (s.bodies[b].joint_count == 0) return;
    block.renewed[lane] = 1;
    block.any_renewed = 1;
}

void fill_spin_blocks(const State& s, BinScratch& scratch, Crew* crew) {
    const int blocks = spin_block_count(scratch);
    if (scratch.spin_blocks.size() < std::size_t(blocks)) scratch.spin_blocks.resize(std::size_t(blocks));
    for_chunks(crew, blocks, spin_blocks_per_chunk, [&](int begin, int end, int) {
        for (int k = begin; k < end; ++k) {
            SpinBlock& block = scratch.spin_blocks[std::size_t(k)] = {};
            const std::uint32_t discard = std::uint32_t(scratch.first_discard_row() + k) * row_bytes;
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const std::size_t at = std::size_t(k) * 8 + lane;
                block.row[lane] = discard, block.axes[3][lane] = 1;
                if (at >= scratch.spin_rows.size()) continue;
                const std::int32_t row = scratch.spin_rows[at];
                fill_spin_lane(s, std::size_t(scratch.row_bodies[std::size_t(row)]), row, block, lane);
            }
        }
        kernels().solver.begin_spin(scratch.spin_blocks.data() + begin, end - begin, scratch.inertia.data());
    });
}

// The factor exp(-c h) for a damping rate c: one over the first terms of exp(c h), so it never changes sign.
float damping_factor(float rate, float h) {
    const float x = rate * h;
    return 1.0f / (1.0f + x * (1.0f + 0.5f * x));
}

void prepare_damping(const State& s, BinScratch& scratch, float h) {
    scratch.damping.clear();
    for (std::size_t row = 0; row < scratch.row_traits.size(); ++row) {
        if (!(scratch.row_traits[row] & is_damped)) continue;
        if (scratch.damping.empty()) scratch.damping.assign(scratch.velocity.size(), {{1, 1, 1}, 1, {1, 1, 1}, 1});
        const BodySettings& settings = s.body_settings[std::size_t(scratch.row_bodies[row])];
        const float linear = damping_factor(settings.linear_damping, h),
                    angular = damping_factor(settings.angular_damping, h);
        put(scratch.damping[row].v, {linear, linear, linear});
        put(scratch.damping[row].w, {angular, angular, angular});
    }
}

} // namespace

bool any_field(const State& s) {
    for (std::uint32_t i = 0; i < s.fields.size(); ++i)
        if (s.field_slots.is_live(i)) return true;
    return false;
}

DVec3 field_acceleration(const State& s, DVec3 x, float gravity_scale, double inverse_mass) {
    const auto& g = s.settings.gravity;
    DVec3 a = double(gravity_scale) * DVec3{g.x, g.y, g.z};
    for (std::uint32_t i = 0; i < s.fields.size(); ++i) {
        if (!s.field_slots.is_live(i)) continue;
        const ForceField& field = s.fields[i];
        const double factor = field.is_force ? inverse_mass : 1.0;
        if (field.kind == ForceField::Kind::uniform) {
            a += factor * DVec3{field.direction.x, field.direction.y, field.direction.z};
            continue;
        }
        const DVec3 to = DVec3{field.center.x, field.center.y, field.center.z} - x;
        const double distance = math::length(to);
        if (!(distance > 1e-9)) continue;
        // strength x distance^exponent along to / distance
        double size = double(field.strength) / distance;
        if (field.exponent == 1)
            size = double(field.strength);
        else if (field.exponent == -1)
            size /= distance;
        else if (field.exponent == -2)
            size /= distance * distance;
        a += (factor * size) * to;
    }
    return a;
}

std::uint8_t row_traits(const State& s, std::int32_t b) {
    const BodySettings& settings = s.body_settings[std::size_t(b)];
    const BodyMass& mass = s.mass[std::size_t(b)];
    int traits = is_dynamic_row;
    if (mass.inverse_mass > 0 && settings.gravity_scale == 1.0f && !s.is_pushed(b)) traits |= falls_plainly;
    if (settings.linear_damping > 0 || settings.angular_damping > 0) traits |= is_damped;
    if (!mass.isotropic) traits |= kernel_spins(s, b) ? spins_wide : spins_alone;
    return std::uint8_t(traits);
}

SlowTurns slow_turns(bool rests) {
    // In 1/60 s the axis of such a turn goes astray by less than 1e-4 of itself, and what the pose is off is not seen
    // in single precision. Joints would show it (the period of a pendulum), but not in a heap at rest: there it is a
    // thousandth, or what friction does to a body in a millisecond.
    SlowTurns slow{0.004f, 0.0f, 0.0f};
    if (rests) slow = {0.05f, 0.05f, 0.001f};
    return slow;
}

// Those that are quick first: blocks of slow ones have little to do.
void list_spinning_rows(BinScratch& scratch) {
    scratch.spinning_rows.clear();
    scratch.spin_rows.clear();
    scratch.slow_rows.clear();
    const float slow = std::max(scratch.slow.speed, scratch.slow.speed_in_joints);
    for (std::size_t row = 0; row < scratch.row_traits.size(); ++row) {
        if (scratch.row_traits[row] & spins_wide) {
            const math::Vec3 w = math::to_vec(scratch.velocity[row].w);
            (math::dot(w, w) < slow * slow ? scratch.slow_rows : scratch.spin_rows).push_back(std::int32_t(row));
        }
        if (scratch.row_traits[row] & spins_alone) scratch.spinning_rows.push_back({std::int32_t(row), false, {}, {}});
    }
    scratch.spin_rows.insert(scratch.spin_rows.end(), scratch.slow_rows.begin(), scratch.slow_rows.end());
}

void prepare_free_motion(const State& s, BinScratch& scratch, Crew* crew, float h, bool bounces) {
    const std::size_t rows = scratch.row_bodies.size(), all = scratch.velocity.size();
    scratch.drive.assign(all, {});
    scratch.free_correction.clear();
    scratch.drive_varies = fields_vary(s);
    scratch.bounces = bounces;
    prepare_damping(s, scratch, h);
    list_spinning_rows(scratch);
    fill_spin_blocks(s, scratch, crew);
    if (!scratch.spinning_rows.empty() || !scratch.spin_rows.empty() || bounces ||
        s.settings.integrator != Integrator::semi_implicit_euler)
        scratch.free_correction.assign(all, {});
    if (bounces) scratch.correction.resize(all); // filled in each substep
    // Of most bodies.
    const bool only_gravity = !any_field(s);
    const Increment fall = only_gravity ? linear_increment(s, {{}, 1.0f, 0.0f}, {}, {}, h) : Increment{};
    auto drive_row = [&](std::size_t row) {
        const std::uint8_t traits = scratch.row_traits[row];
        if (!(traits & is_dynamic_row)) return;
        if (only_gravity && (traits & falls_plainly)) {
            write_linear(s, scratch, row, fall);
            return;
        }
        // What varies is computed at the start of each substep.
        const std::int32_t b = scratch.row_bodies[row];
        const BodyMotion& motion = s.motion[std::size_t(b)];
        const BodyMass& mass = s.mass[std::size_t(b)];
        if (mass.inverse_mass > 0 && !scratch.drive_varies)
            write_linear(s, scratch, row, linear_increment(s, load_on(s, b), motion.x, math::to_double(motion.v), h));
        if (mass.isotropic && s.is_pushed(b))
            write_angular(s, scratch, row, torque_increment(s, b, spin_of(mass), motion.q, h));
    };
    for_chunks(crew, int(rows), rows_per_chunk, [&](int begin, int end, int) {
        for (int row = begin; row < end; ++row) drive_row(std::size_t(row));
    });
}

void update_free_motion(const State& s, BinScratch& scratch, Crew* crew, const SolverBodies& bodies, float h,
                        bool first) {
    if (scratch.drive_varies)
        for (std::size_t row = 0; row < scratch.row_bodies.size(); ++row) {
            const std::int32_t b = scratch.row_bodies[row];
            if (b == none || !s.is_dynamic(b) || !(s.mass[std::size_t(b)].inverse_mass > 0)) continue;
            const DVec3 x = s.motion[std::size_t(b)].x + row_vector(scratch.pose[row].dx);
            write_linear(s, scratch, row,
                         linear_increment(s, load_on(s, b), x, row_vector(scratch.velocity[row].v), h));
        }
    for (SpinningRow& row : scratch.spinning_rows) spin_row(s, scratch, row, h);
    if (!scratch.spin_rows.empty())
        for_chunks(crew, spin_block_count(scratch), spin_blocks_per_chunk, [&](int begin, int end, int) {
            kernels().solver.spin(scratch.spin_blocks.data() + begin, end - begin, bodies, scratch.drive.data(),
                                  scratch.free_correction.data(), h, first, scratch.slow);
        });
    if (scratch.bounces) scratch.correction = scratch.free_correction;
}

void turn_spinning_rows(const State& s, BinScratch& scratch, float h) {
    for (const SpinningRow& r : scratch.spinning_rows) {
        if (!r.turns) continue;
        const std::size_t row = std::size_t(r.row);
        DVec3 contacts = row_vector(scratch.velocity[row].w) - r.free_w;
        if (scratch.bounces)
            contacts += row_vector(scratch.correction[row].w) - row_vector(scratch.free_correction[row].w);
        const DQuat start = s.motion[std::size_t(scratch.row_bodies[row])].q;
        const math::Quat turn =
            math::to_float(math::normalized(turned_by(double(h) * contacts, r.end) * math::conjugate(start)));
        float* dq = scratch.pose[row].dq;
        dq[0] = turn.x, dq[1] = turn.y, dq[2] = turn.z, dq[3] = turn.w;
    }
}

void renew_inertia(const State& s, BinScratch& scratch, Crew* crew) {
    if (scratch.joint_layout->joints.empty()) return;
    for_chunks(crew, spin_block_count(scratch), spin_blocks_per_chunk, [&](int begin, int end, int) {
        kernels().solver.renew_inertia(scratch.spin_blocks.data() + begin, end - begin, scratch.velocity.data(),
                                       scratch.pose.data(), scratch.inertia.data(), scratch.slow.still_sine);
    });
    for (const SpinningRow& r : scratch.spinning_rows) {
        const std::size_t row = std::size_t(r.row), b = std::size_t(scratch.row_bodies[row]);
        const DVec3 turn = row_vector(scratch.pose[row].dq);
        const double still = double(scratch.slow.still_sine);
        if (s.bodies[b].joint_count == 0 || math::dot(turn, turn) < still * still) continue;
        BodyMotion now = s.motion[b];
        now.q = row_rotation(s, scratch, row);
        const math::Sym3 i = contact_inverse_inertia(now, s.mass[b]);
        scratch.inertia[row] = {s.mass[b].inverse_mass, i.xx, i.xy, i.xz, i.yy, i.yz, i.zz, 0};
    }
}

void finish_free_motion(BinScratch& scratch) {
    kernels().solver.finish_spin(scratch.spin_blocks.data(), spin_block_count(scratch), scratch.velocity.data(),
                                 scratch.pose.data());
}

std::uint64_t move_free_body(State& s, std::int32_t b, float dt) {
    std::uint64_t clamped_speeds = 0;
    BodyMotion& motion = s.motion[std::size_t(b)];
    const BodyMass& mass = s.mass[std::size_t(b)];
    const BodySettings& settings = s.body_settings[std::size_t(b)];
    if (clamp_velocity(s.settings, motion.v, motion.w)) {
        ++clamped_speeds;
        motion.v_rest = motion.w_rest = {};
    }
    const int substeps = s.in_pass(s.settings.substeps);
    const double h = double(dt) / substeps;
    const double linear = damping_factor(settings.linear_damping, float(h));
    const double angular = damping_factor(settings.angular_damping, float(h));
    const Load load = load_on(s, b);
    const Spin spin = spin_of(mass);
    const DVec3 torque = s.forces[std::size_t(b)].torque;
    DVec3 x = motion.x, v = math::to_double(motion.v) + math::to_double(motion.v_rest);
    DVec3 w = math::to_double(motion.w) + math::to_double(motion.w_rest);
    DQuat q = motion.q;
    const double most_v = s.settings.max_linear_speed, most_w = s.settings.max_angular_speed;
    bool clamped = false;
    auto limited = [&](DVec3 u, double most) {
        clamped |= math::dot(u, u) > most * most;
        return cut(u, most);
    };
    const bool force_varies = fields_vary(s);
    // About one axis: by one rotation, where its series holds to rounding.
    const bool turns_evenly = !(angular < 1) && !s.is_pushed(b) && !precesses(mass, w, h, least_turn_free) &&
                              double(dt) * double(dt) * math::dot(w, w) < most_even_turn * most_even_turn;
    const auto linear_change = [&] {
        const Increment change = linear_increment(s, load, x, v, h);
        return Increment{cut(change.velocity, most_v), cut(change.correction, most_v)};
    };
    Increment change = linear_change();
    for (int substep = 0; substep < substeps; ++substep) {
        if (mass.inverse_mass > 0) {
            if (force_varies && substep > 0) change = linear_change();
            v = limited(linear * (v + change.velocity), most_v);
            x += h * (v + change.correction);
        }
        if (turns_evenly) continue;
        const Increment turn = precesses(mass, w, h, least_turn_free)
                                   ? gyroscopic_increment(s, spin, q, w, spin.to_world(q, spin.moments, w), torque, h)
                                   : torque_increment(s, b, spin, q, h);
        w = limited(angular * (w + cut(turn.velocity, most_w)), most_w);
        q = turned_by(h * (w + cut(turn.correction, most_w)), q);
    }
    if (turns_evenly) q = turned_by(double(dt) * w, q);
    clamped_speeds += clamped;
    if (!(math::is_finite(x) && math::is_finite(q) && math::is_finite(v) && math::is_finite(w))) {
        ++clamped_speeds; // beyond the range of numbers: it stops where it is
        motion.v = motion.w = motion.v_rest = motion.w_rest = {};
        motion.turned = {};
        return clamped_speeds;
    }
    motion.turned = math::to_float(q * math::conjugate(motion.q));
    motion.x = x;
    motion.q = q;
    motion.v = math::to_float(v);
    motion.w = math::to_float(w);
    motion.v_rest = math::to_float(v - math::to_double(motion.v));
    motion.w_rest = math::to_float(w - math::to_double(motion.w));
    return clamped_speeds;
}

} // namespace cairn
