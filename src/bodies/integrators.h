// Motion without contacts: gravity, fields, forces, and the torque-free turning of bodies with unequal moments of
// inertia. Each integrator yields a change of velocity ("drive"), and a correction that turns the velocity at the
// end of the substep into the one that moves the pose; contacts work with any of them.
#pragma once

#include "math/rotation.h"
#include "state/state.h"

namespace cairn {

// Contacts on a needle, with a moment a millionth of the others, would spin it up without end in single precision: for
// them no moment is less than this share of the greatest. (A rod 20 times as long as thick has 0.5 %.)
inline constexpr float min_contact_moment = 0.005f;

// Slower rotations (radians per substep) have no gyroscopic part worth computing. What is held by friction bears ten
// times as much; the energy of a free top does not.
inline constexpr double min_turn = 1e-6;

struct Increment {
    math::DVec3 velocity, correction;
};

// Cut, so that forces of any size leave finite velocities.
math::DVec3 cut(math::DVec3 v, double most);
// q turned about one axis, by any angle: by a part of it, squared as often as it was halved.
math::DQuat turned_by(math::DVec3 u, const math::DQuat& q);

struct Spin {
    math::DVec3 moments, inverse_moments; // principal
    math::DQuat principal;
    math::DVec3 to_world(const math::DQuat& q, math::DVec3 diagonal, math::DVec3 v) const {
        const math::DQuat axes = q * principal;
        return math::rotate(axes, math::scaled(diagonal, math::rotate_back(axes, v)));
    }
};
Spin spin_of(const BodyMass& mass);

// How the turn of a body that no torque acts on changes, rad/s^2: of one that spins about no principal axis.
math::DVec3 spin_change(const Bodies& bodies, std::int32_t body, math::DVec3 w, math::DQuat q);
// Whether a contact of it that stays as it is in a step is off by more than a core is deep at the end, for that change:
// by the time that acts, the arm has turned, too. dt^3 / 3 times the change, the rate and the radius.
bool gyrates(const Bodies& bodies, std::int32_t body, math::DVec3 w, math::DQuat q, double dt);

// Whether the inertia of the start of a step is still nearly that in its end, as the solver takes it (answer_as_told in
// kernels/solve/spin.cpp): a turn about an axis of symmetry changes nothing.
bool keeps_inertia(const Bodies& bodies, std::int32_t body, math::DVec3 w, math::DQuat q, double dt);

// What acts on one body, apart from contacts.
struct Load {
    math::DVec3 force_acceleration;
    float gravity_scale, inverse_mass;
};
Load load_on(const Bodies& bodies, std::int32_t body);

Increment linear_increment(const ForceFields& fields, const WorldDef& settings, const Load& load, math::DVec3 x,
                           math::DVec3 v, double h);
// Whether a body has a gyroscopic part: unequal moments, and turns faster than `least` in a substep.
bool precesses(const BodyMass& mass, math::DVec3 w, double h);
// For a body at rotation q with the angular velocity w and the angular momentum that goes with it.
Increment gyroscopic_increment(const WorldDef& settings, const Spin& spin, const math::DQuat& q, math::DVec3 w,
                               math::DVec3 momentum, math::DVec3 torque, double h);
// The torque alone.
Increment torque_increment(const Bodies& bodies, const WorldDef& settings, std::int32_t body, const Spin& spin,
                           const math::DQuat& q, double h);

bool any_field(const ForceFields& fields);
// Whether forces depend on the position.
bool fields_vary(const ForceFields& fields);
// Gravity and fields at a point, m/s^2 (for a body of that mass and gravity scale).
math::DVec3 field_acceleration(const ForceFields& fields, const WorldDef& settings, math::DVec3 x, float gravity_scale,
                               double inverse_mass);

// m/s^2: of gravity and fields, at a body.
math::DVec3 pull_at(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t body);

// How much gravity and fields pull at bodies.
class BodyWeights {
  public:
    BodyWeights(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings);
    float operator()(std::int32_t body) const;  // N
    math::DVec3 pull(std::int32_t body) const { // m/s^2
        return any_field_ ? pull_at(bodies_, fields_, settings_, body)
                          : double(bodies_.settings[body].gravity_scale) * along_;
    }

  private:
    const Bodies& bodies_;
    const ForceFields& fields_;
    const WorldDef& settings_;
    bool any_field_;
    float gravity_;
    math::DVec3 along_; // m/s^2: gravity
};

// Of gravity, fields and what pushes the body in this step, m/s^2; 0 if nothing can move it.
math::DVec3 acceleration_at(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings,
                            std::int32_t body, math::DVec3 x);

// Whether that is a place that bounds in single precision can be around. What is to go farther stops where it is.
constexpr double farthest_place = 1e30; // m
inline bool is_place(math::DVec3 x) { return math::dot(x, x) <= farthest_place * farthest_place; }

// The factor exp(-c h) for a damping rate c: one over the first terms of exp(c h), so it never changes sign.
float damping_factor(float rate, float h);

// The tensor that contacts and joints act on.
math::Sym3 contact_inverse_inertia(const BodyMotion& motion, const BodyMass& mass);

} // namespace cairn
