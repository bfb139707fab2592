
#include "bodies/integrators.h"

#include "bodies/bodies.h"
#include "collision/core_sweep.h"

#include <algorithm>

namespace cairn {

using math::DQuat;
using math::DVec3;

namespace {

// rad: up to this angle the series for a rotation is accurate to rounding.
constexpr double max_series_turn = 0.25;

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

// Euler's equation, explicitly: w' = I^-1 (torque - w x I w).
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
    const DVec3 mean =
        (1 / h) * math::to_rotation_vector(end * math::conjugate(q)); // the rate that rotates q into `end`
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

} // namespace

DVec3 cut(DVec3 v, double most) {
    const double square = math::dot(v, v);
    if (square > most * most) v = std::isfinite(square) ? (most / std::sqrt(square)) * v : DVec3{};
    return v;
}

DQuat turned_by(DVec3 u, const DQuat& q) {
    if (u == DVec3{}) return q; // exactly unchanged, without a rounding error
    int halvings = 0;
    if (std::isfinite(math::dot(u, u)))
        for (; math::dot(u, u) > max_series_turn * max_series_turn; ++halvings) u = 0.5 * u;
    DQuat turn = math::from_rotation_vector(u); // the identity if u is not finite
    for (; halvings > 0; --halvings) turn = turn * turn;
    return math::normalized(turn * q);
}

Increment linear_increment(const ForceFields& fields, const WorldDef& settings, const Load& load, DVec3 x, DVec3 v,
                           double h) {
    auto acceleration = [&](DVec3 at) {
        return field_acceleration(fields, settings, at, load.gravity_scale, double(load.inverse_mass)) +
               load.force_acceleration;
    };
    const DVec3 a1 = acceleration(x);
    if (settings.integrator != Integrator::rk4) return translate(settings.integrator, h * a1);
    const DVec3 a2 = acceleration(x + (h / 2) * v), a3 = acceleration(x + (h / 2) * v + (h * h / 4) * a1);
    const DVec3 a4 = acceleration(x + h * v + (h * h / 2) * a2);
    const DVec3 dv = (h / 6) * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    return {dv, (h / 6) * (a1 + a2 + a3) - dv};
}

bool fields_vary(const ForceFields& fields) {
    for (std::uint32_t i = 0; i < fields.all.size(); ++i)
        if (fields.slots.is_live(i) && fields.all[i].kind == ForceField::Kind::radial) return true;
    return false;
}

Load load_on(const Bodies& bodies, std::int32_t b) {
    const BodyMass& mass = bodies.mass[b];
    const BodyForces& forces = bodies.forces[b];
    return {double(mass.inverse_mass) * forces.force, bodies.settings[b].gravity_scale, mass.inverse_mass};
}

Spin spin_of(const BodyMass& mass) {
    const math::Vec3& i = mass.inertia;
    // Inverses in double: rounded ones would change the momentum a little in every substep.
    return {math::to_double(i),
            {mass.inverse_inertia.x > 0 ? 1.0 / i.x : 0, mass.inverse_inertia.y > 0 ? 1.0 / i.y : 0,
             mass.inverse_inertia.z > 0 ? 1.0 / i.z : 0},
            math::normalized(math::to_double(mass.principal))};
}

namespace {

bool turns_freely(const BodyMass& mass) {
    return mass.inverse_inertia.x > 0 && mass.inverse_inertia.y > 0 && mass.inverse_inertia.z > 0;
}

} // namespace

DVec3 spin_change(const Bodies& bodies, std::int32_t b, DVec3 w, DQuat q) {
    if (bodies.mass[b].isotropic) return {};
    const Spin spin = spin_of(bodies.mass[b]);
    return spin.to_world(q, spin.inverse_moments, math::cross(spin.to_world(q, spin.moments, w), w));
}

bool gyrates(const Bodies& bodies, std::int32_t b, DVec3 w, DQuat q, double dt) {
    const BodyLinks& links = bodies.links[b];
    const double speed = math::length(w), most = core_depth_of(double(links.inner_radius));
    const double off_by = dt * dt * dt / 3 * speed * double(links.radius); // for a change of 1 rad/s^2
    // No principal moment exceeds the sum of the other two, so the angular acceleration is at most the square of the
    // rate.
    if (turns_freely(bodies.mass[b]) && off_by * speed * speed <= most) return false;
    return off_by * math::length(spin_change(bodies, b, w, q)) > most;
}

bool keeps_inertia(const Bodies& bodies, std::int32_t b, DVec3 w, DQuat q, double dt) {
    const Spin spin = spin_of(bodies.mass[b]);
    const DVec3 i = spin.moments, half = math::rotate_back(q * spin.principal, 0.5 * dt * w);
    const DVec3 mixed = {std::fabs(i.y - i.z), std::fabs(i.z - i.x), std::fabs(i.x - i.y)};
    return 4 * math::dot(math::scaled(half, half), mixed) <= std::min(i.x, std::min(i.y, i.z));
}

bool precesses(const BodyMass& mass, DVec3 w, double h) {
    return !mass.isotropic && turns_freely(mass) && h * h * math::dot(w, w) > min_turn * min_turn;
}

Increment gyroscopic_increment(const WorldDef& settings, const Spin& spin, const DQuat& q, DVec3 w, DVec3 momentum,
                               DVec3 torque, double h) {
    switch (settings.integrator) {
    case Integrator::semi_implicit_euler:
        return split_spin(spin, q, w, momentum + h * torque, h);
    case Integrator::explicit_euler:
        return explicit_spin(spin, q, w, torque, h);
    case Integrator::rk4:
        return rk4_spin(spin, q, w, momentum, torque, h);
    }
    return {};
}

Increment torque_increment(const Bodies& bodies, const WorldDef& settings, std::int32_t b, const Spin& spin,
                           const DQuat& q, double h) {
    if (!bodies.is_pushed(b)) return {};
    return translate(settings.integrator, h * spin.to_world(q, spin.inverse_moments, bodies.forces[b].torque));
}

DVec3 acceleration_at(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t b,
                      DVec3 x) {
    const double inverse_mass = bodies.is_dynamic(b) ? double(bodies.mass[b].inverse_mass) : 0;
    if (!(inverse_mass > 0)) return {};
    DVec3 a = field_acceleration(fields, settings, x, bodies.settings[b].gravity_scale, inverse_mass);
    if (bodies.is_pushed(b)) a += inverse_mass * bodies.forces[b].force;
    return a;
}

float damping_factor(float rate, float h) {
    const float x = rate * h;
    return 1.0f / (1.0f + x * (1.0f + 0.5f * x));
}

bool any_field(const ForceFields& fields) {
    for (std::uint32_t i = 0; i < fields.all.size(); ++i)
        if (fields.slots.is_live(i) && fields.all[i].kind != ForceField::Kind::fluid) return true;
    return false;
}

DVec3 field_acceleration(const ForceFields& fields, const WorldDef& settings, DVec3 x, float gravity_scale,
                         double inverse_mass) {
    const auto& g = settings.gravity;
    DVec3 a = double(gravity_scale) * DVec3{g.x, g.y, g.z};
    for (std::uint32_t i = 0; i < fields.all.size(); ++i) {
        if (!fields.slots.is_live(i)) continue;
        const ForceField& field = fields.all[i];
        if (field.kind == ForceField::Kind::fluid) continue; // bodies/fluids.h
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

DVec3 pull_at(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t body) {
    return field_acceleration(fields, settings, bodies.motion[body].x, bodies.settings[body].gravity_scale,
                              double(bodies.mass[body].inverse_mass));
}

BodyWeights::BodyWeights(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings)
    : bodies_(bodies), fields_(fields), settings_(settings), any_field_(any_field(fields)) {
    const auto& g = settings.gravity;
    gravity_ = math::length(math::Vec3{g.x, g.y, g.z});
    along_ = {g.x, g.y, g.z};
}

float BodyWeights::operator()(std::int32_t body) const {
    const float pull = any_field_ ? float(math::length(pull_at(bodies_, fields_, settings_, body)))
                                  : std::fabs(bodies_.settings[body].gravity_scale) * gravity_;
    return bodies_.mass[body].mass * pull;
}

math::Sym3 contact_inverse_inertia(const BodyMotion& motion, const BodyMass& mass) {
    const math::Vec3 d = mass.inverse_inertia;
    const float least = std::min({d.x, d.y, d.z}), most = least / min_contact_moment;
    if (mass.isotropic || !(least > 0) || std::max({d.x, d.y, d.z}) <= most) return world_inverse_inertia(motion, mass);
    BodyMass rounder = mass;
    rounder.inverse_inertia = {std::min(d.x, most), std::min(d.y, most), std::min(d.z, most)};
    return world_inverse_inertia(motion, rounder);
}

} // namespace cairn
