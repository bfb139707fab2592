
#include "bodies/free_body.h"

#include "bodies/bodies.h"
#include "bodies/integrators.h"

#include <algorithm>

namespace cairn {

using math::DQuat;
using math::DVec3;

namespace {

constexpr double max_even_turn = 0.25; // rad

} // namespace

std::uint64_t move_free_body(Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t b,
                             float dt, int substeps) {
    std::uint64_t clamped_speeds = 0;
    BodyMotion& motion = bodies.motion[b];
    const BodyMass& mass = bodies.mass[b];
    const BodySettings& own = bodies.settings[b];
    if (clamp_velocity(settings, motion.v, motion.w)) {
        ++clamped_speeds;
        motion.v_rest = motion.w_rest = {};
    }
    const double h = double(dt) / substeps;
    const double linear = damping_factor(own.linear_damping, float(h));
    const double angular = damping_factor(own.angular_damping, float(h));
    const Load load = load_on(bodies, b);
    const Spin spin = spin_of(mass);
    const DVec3 torque = bodies.forces[b].torque;
    DVec3 x = motion.x, v = math::to_double(motion.v) + math::to_double(motion.v_rest);
    DVec3 w = math::to_double(motion.w) + math::to_double(motion.w_rest);
    DQuat q = motion.q;
    const double max_v = settings.max_linear_speed, max_w = settings.max_angular_speed;
    bool clamped = false;
    auto limited = [&](DVec3 u, double most) {
        clamped |= math::dot(u, u) > most * most;
        return cut(u, most);
    };
    const bool force_varies = fields_vary(fields);
    // About one axis: by one rotation, where its series holds to rounding.
    const bool turns_evenly = !(angular < 1) && !bodies.is_pushed(b) && !precesses(mass, w, h) &&
                              double(dt) * double(dt) * math::dot(w, w) < max_even_turn * max_even_turn;
    const auto linear_change = [&] {
        const Increment change = linear_increment(fields, settings, load, x, v, h);
        return Increment{cut(change.velocity, max_v), cut(change.correction, max_v)};
    };
    Increment change = linear_change();
    for (int substep = 0; substep < substeps; ++substep) {
        if (mass.inverse_mass > 0) {
            if (force_varies && substep > 0) change = linear_change();
            v = limited(linear * (v + change.velocity), max_v);
            x += h * (v + change.correction);
        }
        if (turns_evenly) continue;
        const Increment turn =
            precesses(mass, w, h)
                ? gyroscopic_increment(settings, spin, q, w, spin.to_world(q, spin.moments, w), torque, h)
                : torque_increment(bodies, settings, b, spin, q, h);
        w = limited(angular * (w + cut(turn.velocity, max_w)), max_w);
        q = turned_by(h * (w + cut(turn.correction, max_w)), q);
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
