
#include "bodies/free_body.h"

#include "bodies/bodies.h"
#include "bodies/integrators.h"

#include <algorithm>

namespace cairn {

using math::DQuat;
using math::DVec3;

namespace {

// The effect of all substeps on a velocity u, where each substep maps u to factor (u + change): the final velocity is
// kept u + gained change, and the sum of the velocities after each substep is sum_kept u + sum_gained change.
struct Substeps {
    double kept = 1, gained = 0, sum_kept = 0, sum_gained = 0;
    Substeps(double factor, int count) {
        for (int k = 0; k < count; ++k) {
            kept = factor * kept, gained = factor * (gained + 1);
            sum_kept += kept, sum_gained += gained;
        }
    }
};

// One step of one free body.
struct FreeStep {
    const Bodies& bodies;
    const ForceFields& fields;
    const WorldDef& settings;
    std::int32_t body;
    double h;
    int substeps;
    bool is_clamped = false;

    DVec3 limited(DVec3 u, double most) {
        is_clamped |= math::dot(u, u) > most * most;
        return cut(u, most);
    }
    void move(DVec3& x, DVec3& v);
    void turn(DQuat& q, DVec3& w);
};

void FreeStep::move(DVec3& x, DVec3& v) {
    if (!(bodies.mass[body].inverse_mass > 0)) return;
    const double factor = damping_factor(bodies.settings[body].linear_damping, float(h));
    const double most = settings.max_linear_speed;
    const Load load = load_on(bodies, body);
    const auto change_at = [&] {
        const Increment change = linear_increment(fields, settings, load, x, v, h);
        return Increment{cut(change.velocity, most), cut(change.correction, most)};
    };
    Increment change = change_at();
    const bool varies = fields_vary(fields);
    const double half = 0.5 * most, gain = substeps * math::length(change.velocity);
    if (!varies && gain < half && math::dot(v, v) < half * half) { // below the speed limit: all substeps in closed form
        const Substeps all(factor, substeps);
        x += h * (all.sum_kept * v + all.sum_gained * change.velocity + double(substeps) * change.correction);
        v = all.kept * v + all.gained * change.velocity;
        return;
    }
    for (int k = 0; k < substeps; ++k) {
        if (varies && k > 0) change = change_at();
        v = limited(factor * (v + change.velocity), most);
        x += h * (v + change.correction);
    }
}

void FreeStep::turn(DQuat& q, DVec3& w) {
    const BodyMass& mass = bodies.mass[body];
    const double factor = damping_factor(bodies.settings[body].angular_damping, float(h));
    if (!bodies.is_pushed(body) && !precesses(mass, w, h)) { // the axis of rotation is constant
        const Substeps all(factor, substeps);
        q = turned_by(h * all.sum_kept * w, q);
        w = all.kept * w;
        return;
    }
    const double most = settings.max_angular_speed;
    const Spin spin = spin_of(mass);
    const DVec3 torque = bodies.forces[body].torque;
    for (int k = 0; k < substeps; ++k) {
        const Increment turn =
            precesses(mass, w, h)
                ? gyroscopic_increment(settings, spin, q, w, spin.to_world(q, spin.moments, w), torque, h)
                : torque_increment(bodies, settings, body, spin, q, h);
        w = limited(factor * (w + cut(turn.velocity, most)), most);
        q = turned_by(h * (w + cut(turn.correction, most)), q);
    }
}

} // namespace

std::uint64_t move_free_body(Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t b,
                             float dt, int substeps) {
    std::uint64_t clamped_speeds = 0;
    BodyMotion& motion = bodies.motion[b];
    if (clamp_velocity(settings, motion.v, motion.w)) {
        ++clamped_speeds;
        motion.v_rest = motion.w_rest = {};
    }
    DVec3 x = motion.x, v = math::to_double(motion.v) + math::to_double(motion.v_rest);
    DVec3 w = math::to_double(motion.w) + math::to_double(motion.w_rest);
    DQuat q = motion.q;
    FreeStep step{bodies, fields, settings, b, double(dt) / substeps, substeps};
    step.move(x, v);
    step.turn(q, w);
    clamped_speeds += step.is_clamped;
    if (!(is_place(x) && math::is_finite(q) && math::is_finite(v) && math::is_finite(w))) {
        ++clamped_speeds; // overflow: the body stops where it is
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

void turn_free_body(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t b,
                    double dt, int substeps, DQuat& q, DVec3& w) {
    FreeStep{bodies, fields, settings, b, dt / substeps, substeps}.turn(q, w);
}

} // namespace cairn
