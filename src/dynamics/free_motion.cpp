// Motion without contacts: gravity, fields, forces, and the torque-free turning of bodies with unequal moments of
// inertia. Each integrator yields a change of velocity ("drive"), and a correction that turns the velocity at the
// end of the substep into the one that moves the pose; contacts work with any of them.
#include "dynamics/bodies.h"
#include "dynamics/solver.h"

#include <algorithm>

namespace cairn {

using math::DQuat;
using math::DVec3;

namespace {

// Slower rotations (radians per substep) have no gyroscopic part worth computing. It makes no difference to what is
// held by friction, but the energy of a free top depends on it.
constexpr double least_turn_free = 1e-6, least_turn_in_contact = 1e-4;

struct Increment {
    DVec3 velocity, correction;
};

DVec3 row_vector(const float* p) { return {p[0], p[1], p[2]}; }
void put(float* p, math::Vec3 v) { p[0] = v.x, p[1] = v.y, p[2] = v.z; }

// Cut, so that forces of any size leave finite velocities.
math::Vec3 cut(DVec3 v, double most) {
    const double square = math::dot(v, v);
    if (square > most * most) v = std::isfinite(square) ? (most / std::sqrt(square)) * v : DVec3{};
    return math::to_float(v);
}

// A unit quaternion turned by the vector u, by the half-angle tangent series that the solver's kernel uses.
DQuat turned_by(DVec3 u, const DQuat& q) {
    const DVec3 half = 0.5 * u;
    const double x2 = std::min(math::dot(half, half), 1.0);
    const DVec3 t = (1 + x2 * (1.0 / 3 + x2 * (2.0 / 15))) * half;
    return math::normalized(DQuat{t.x, t.y, t.z, 1} * q);
}

struct Spin {
    DVec3 moments, inverse_moments; // principal
    DQuat principal;
    DVec3 to_world(const DQuat& q, DVec3 diagonal, DVec3 v) const {
        const DQuat axes = q * principal;
        return math::rotate(axes, math::scaled(diagonal, math::rotate_back(axes, v)));
    }
};

// Keeps the angular momentum L, and takes the inertia in the middle of the substep, found in two rounds: a hinged
// gyroscope precesses within 0.01 %, where the inertia at the start errs by 2 %.
Increment midpoint_spin(const Spin& spin, const DQuat& q, DVec3 w, DVec3 torque, double h) {
    const DVec3 momentum = spin.to_world(q, spin.moments, w) + h * torque;
    DVec3 middle = w;
    for (int round = 0; round < 2; ++round)
        middle = spin.to_world(turned_by(0.5 * h * middle, q), spin.inverse_moments, momentum);
    const DVec3 end = spin.to_world(turned_by(h * middle, q), spin.inverse_moments, momentum);
    return {end - w, middle - end};
}

// Euler's equation as it stands: w' = I^-1 (torque - w x I w).
Increment explicit_spin(const Spin& spin, const DQuat& q, DVec3 w, DVec3 torque, double h) {
    const DVec3 momentum = spin.to_world(q, spin.moments, w);
    const DVec3 dw = h * spin.to_world(q, spin.inverse_moments, torque - math::cross(w, momentum));
    return {dw, -dw};
}

// Classic Runge-Kutta on the rotation and the angular momentum.
Increment rk4_spin(const Spin& spin, const DQuat& q, DVec3 w, DVec3 torque, double h) {
    const DVec3 momentum = spin.to_world(q, spin.moments, w);
    auto rate = [&](const DQuat& at, double t) {
        const DVec3 u = spin.to_world(math::normalized(at), spin.inverse_moments, momentum + t * torque);
        const DQuat d = DQuat{u.x, u.y, u.z, 0} * at;
        return DQuat{0.5 * d.x, 0.5 * d.y, 0.5 * d.z, 0.5 * d.w};
    };
    auto along = [&](const DQuat& d, double t) { return DQuat{q.x + t * d.x, q.y + t * d.y, q.z + t * d.z, q.w + t * d.w}; };
    const DQuat k1 = rate(q, 0), k2 = rate(along(k1, h / 2), h / 2), k3 = rate(along(k2, h / 2), h / 2), k4 = rate(along(k3, h), h);
    const DQuat sum{k1.x + 2 * k2.x + 2 * k3.x + k4.x, k1.y + 2 * k2.y + 2 * k3.y + k4.y,
                    k1.z + 2 * k2.z + 2 * k3.z + k4.z, k1.w + 2 * k2.w + 2 * k3.w + k4.w};
    const DQuat end = math::normalized(along(sum, h / 6));
    // The constant rate that turns q into that: the inverse of the half-angle tangent series.
    const DQuat turn = end * math::conjugate(q);
    const DVec3 t = (1 / turn.w) * turn.vector();
    const double t2 = math::dot(t, t);
    const DVec3 mean = (2 / h) * ((1 - t2 * (1.0 / 3 - t2 * (1.0 / 5))) * t);
    const DVec3 w_end = spin.to_world(end, spin.inverse_moments, momentum + h * torque);
    return {w_end - w, mean - w_end};
}

Increment translate(Integrator integrator, DVec3 dv) {
    switch (integrator) {
    case Integrator::semi_implicit_euler: return {dv, {}};
    case Integrator::explicit_euler: return {dv, -dv};
    case Integrator::rk4: return {dv, -0.5 * dv};
    }
    return {};
}

// What acts on one body, apart from contacts.
struct Load {
    DVec3 force_acceleration, torque;
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
    return {double(mass.inverse_mass) * forces.force, forces.torque, s.body_settings[std::size_t(b)].gravity_scale, mass.inverse_mass};
}

void write_linear(State& s, std::size_t row, const Increment& change) {
    SolverScratch& scratch = s.solver;
    put(scratch.drive[row].v, cut(change.velocity, s.settings.max_linear_speed));
    if (!scratch.free_correction.empty())
        put(scratch.free_correction[row].v, cut(change.correction, s.settings.max_linear_speed));
}
void write_angular(State& s, std::size_t row, const Increment& change) {
    SolverScratch& scratch = s.solver;
    put(scratch.drive[row].w, cut(change.velocity, s.settings.max_angular_speed));
    if (!scratch.free_correction.empty())
        put(scratch.free_correction[row].w, cut(change.correction, s.settings.max_angular_speed));
}

Increment spin_increment(const State& s, std::size_t row, DVec3 w, float h) {
    const SolverScratch& scratch = s.solver;
    const std::int32_t b = scratch.row_bodies[row];
    const BodyMass& mass = s.mass[std::size_t(b)];
    const DVec3 torque = s.forces[std::size_t(b)].torque;
    const bool in_contact = s.bodies[std::size_t(b)].colors != 0;
    const double least = in_contact ? least_turn_in_contact : least_turn_free;
    if (mass.isotropic || !(double(h) * h * math::dot(w, w) > least * least)) {
        const SolverInertia& i = scratch.inertia[row];
        const math::DSym3 inverse{i.xx, i.xy, i.xz, i.yy, i.yz, i.zz};
        return translate(s.settings.integrator, double(h) * (inverse * torque));
    }
    const Spin spin{math::to_double(mass.inertia), math::to_double(mass.inverse_inertia),
                    math::normalized(math::to_double(mass.principal))};
    const float* dq = scratch.pose[row].dq;
    const DQuat q = math::normalized(DQuat{dq[0], dq[1], dq[2], dq[3]} * s.motion[std::size_t(b)].q);
    switch (s.settings.integrator) {
    case Integrator::semi_implicit_euler: return midpoint_spin(spin, q, w, torque, h);
    case Integrator::explicit_euler: return explicit_spin(spin, q, w, torque, h);
    case Integrator::rk4: return rk4_spin(spin, q, w, torque, h);
    }
    return {};
}

// What the kernel will make of it: v + drive, rounded. The rest is kept for the next substep, so that a thousand
// roundings of a free flight do not add up.
void keep_rest(const float* v, const float* drive, float* rest, DVec3 target) {
    for (int i = 0; i < 3; ++i) {
        const float rounded = v[i] + drive[i];
        rest[i] = float(target[i] - double(rounded));
    }
}

// A body that touches nothing, wholly in double.
void update_free_row(State& s, std::size_t row, float h) {
    SolverScratch& scratch = s.solver;
    const std::int32_t b = scratch.row_bodies[row];
    const BodyMass& mass = s.mass[std::size_t(b)];
    const SolverVelocity& velocity = scratch.velocity[row];
    SolverTwist& rest = scratch.rest[row];
    const DVec3 v = row_vector(velocity.v) + row_vector(rest.v), w = row_vector(velocity.w) + row_vector(rest.w);
    if (mass.inverse_mass > 0) {
        const DVec3 x = s.motion[std::size_t(b)].x + row_vector(scratch.pose[row].dx);
        Increment change = linear_increment(s, load_on(s, b), x, v, h);
        change.velocity += row_vector(rest.v);
        write_linear(s, row, change);
        keep_rest(velocity.v, scratch.drive[row].v, rest.v, row_vector(velocity.v) + change.velocity);
    }
    Increment change = spin_increment(s, row, w, h);
    change.velocity += row_vector(rest.w);
    write_angular(s, row, change);
    keep_rest(velocity.w, scratch.drive[row].w, rest.w, row_vector(velocity.w) + change.velocity);
}

// The factor exp(-c h) for a damping rate c: one over the first terms of exp(c h), so it never changes sign.
float damping_factor(float rate, float h) {
    const float x = rate * h;
    return 1.0f / (1.0f + x * (1.0f + 0.5f * x));
}

void prepare_damping(State& s, float h) {
    SolverScratch& scratch = s.solver;
    scratch.damping.clear();
    bool any = false;
    for (const std::int32_t b : scratch.row_bodies)
        any |= b != none && (s.body_settings[std::size_t(b)].linear_damping > 0 || s.body_settings[std::size_t(b)].angular_damping > 0);
    if (!any) return;
    scratch.damping.assign(scratch.row_bodies.size(), {{1, 1, 1}, 1, {1, 1, 1}, 1});
    for (std::size_t row = 0; row < scratch.row_bodies.size(); ++row) {
        const std::int32_t b = scratch.row_bodies[row];
        if (b == none || !s.is_dynamic(b)) continue;
        const BodySettings& settings = s.body_settings[std::size_t(b)];
        const float linear = damping_factor(settings.linear_damping, h), angular = damping_factor(settings.angular_damping, h);
        put(scratch.damping[row].v, {linear, linear, linear});
        put(scratch.damping[row].w, {angular, angular, angular});
    }
}

} // namespace

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
        if (field.exponent == 1) size = double(field.strength);
        else if (field.exponent == -1) size /= distance;
        else if (field.exponent == -2) size /= distance * distance;
        a += (factor * size) * to;
    }
    return a;
}

void prepare_free_motion(State& s, float h, bool corrects) {
    SolverScratch& scratch = s.solver;
    const std::size_t rows = scratch.row_bodies.size();
    scratch.drive.assign(rows, {});
    scratch.rest.assign(rows, {});
    scratch.free_rows.clear();
    scratch.spinning_rows.clear();
    scratch.free_correction.clear();
    scratch.corrects = corrects;
    scratch.drive_varies = fields_vary(s);
    prepare_damping(s, h);
    bool turns = false;
    for (std::size_t row = 0; row < rows; ++row) {
        const std::int32_t b = scratch.row_bodies[row];
        if (b == none || !s.is_dynamic(b)) continue;
        const BodyMass& mass = s.mass[std::size_t(b)];
        turns |= !mass.isotropic;
        if (s.bodies[std::size_t(b)].colors == 0 && scratch.damping.empty()) {
            scratch.free_rows.push_back(std::int32_t(row));
            put(scratch.rest[row].v, s.motion[std::size_t(b)].v_rest);
            put(scratch.rest[row].w, s.motion[std::size_t(b)].w_rest);
        } else if (!mass.isotropic) {
            scratch.spinning_rows.push_back(std::int32_t(row));
        }
    }
    if (turns || corrects || s.settings.integrator != Integrator::semi_implicit_euler)
        scratch.free_correction.assign(rows, {});
    scratch.correction = scratch.free_correction;
    for (std::size_t row = 0; row < rows; ++row) {
        const std::int32_t b = scratch.row_bodies[row];
        if (b == none || !s.is_dynamic(b)) continue;
        const BodyMotion& motion = s.motion[std::size_t(b)];
        if (s.mass[std::size_t(b)].inverse_mass > 0)
            write_linear(s, row, linear_increment(s, load_on(s, b), motion.x, math::to_double(motion.v), h));
        if (s.forces[std::size_t(b)].any) write_angular(s, row, spin_increment(s, row, math::to_double(motion.w), h));
    }
}

void update_free_motion(State& s, float h) {
    SolverScratch& scratch = s.solver;
    if (scratch.drive_varies)
        for (std::size_t row = 0; row < scratch.row_bodies.size(); ++row) {
            const std::int32_t b = scratch.row_bodies[row];
            if (b == none || !s.is_dynamic(b) || !(s.mass[std::size_t(b)].inverse_mass > 0)) continue;
            const DVec3 x = s.motion[std::size_t(b)].x + row_vector(scratch.pose[row].dx);
            write_linear(s, row, linear_increment(s, load_on(s, b), x, row_vector(scratch.velocity[row].v), h));
        }
    for (const std::int32_t row : scratch.free_rows) update_free_row(s, std::size_t(row), h);
    for (const std::int32_t row : scratch.spinning_rows)
        write_angular(s, std::size_t(row), spin_increment(s, std::size_t(row), row_vector(scratch.velocity[std::size_t(row)].w), h));
    scratch.correction = scratch.free_correction;
}

} // namespace cairn
