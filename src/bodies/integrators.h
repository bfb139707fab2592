// Motion without contacts: gravity, fields, forces, and the torque-free rotation of bodies with unequal moments of
// inertia. Each integrator yields a change of velocity, and a correction that turns the velocity at the end of the
// substep into the one that moves the pose; contacts work with any of them.
#pragma once

#include "math/rotation.h"
#include "state/state.h"

namespace cairn {

// For contacts, no principal moment of a body is less than this share of its greatest. Contacts on a needle, with a
// moment a millionth of the others, would spin it up without bound in single precision. (A rod 20 times as long as
// thick has 0.5 %.)
inline constexpr float min_contact_moment = 0.005f;

// The least rotation, radians per substep, with a gyroscopic part worth computing. Bodies held by friction tolerate ten
// times as much; the energy of a free top does not.
inline constexpr double min_turn = 1e-6;

struct Increment {
    math::DVec3 velocity, correction;
};

// Clamps the length of v, so that forces of any size leave finite velocities.
math::DVec3 cut(math::DVec3 v, double most);
// q rotated by the rotation vector u, of any length: u is halved until the series holds, and the result squared as
// often.
math::DQuat turned_by(math::DVec3 u, const math::DQuat& q);

struct Spin {
    math::DVec3 moments, inverse_moments; // about the principal axes
    math::DQuat principal;
    math::DVec3 to_world(const math::DQuat& q, math::DVec3 diagonal, math::DVec3 v) const {
        const math::DQuat axes = q * principal;
        return math::rotate(axes, math::scaled(diagonal, math::rotate_back(axes, v)));
    }
};
Spin spin_of(const BodyMass& mass);

// The angular acceleration without a torque, rad/s^2; not zero if the body rotates about no principal axis.
math::DVec3 spin_change(const Bodies& bodies, std::int32_t body, math::DVec3 w, math::DQuat q);
// Whether that angular acceleration moves a contact of the body, which the solver holds constant during the step, by
// more than the depth of a core until the end of the step. The error is dt^3 / 3 times the change, the rate and the
// radius, because the arm rotates while the change acts.
bool gyrates(const Bodies& bodies, std::int32_t body, math::DVec3 w, math::DQuat q, double dt);

// Whether the world inertia at the start of a step is still nearly that at its end, as the solver assumes
// (answer_as_told in kernels/solve/spin.cpp): a rotation about an axis of symmetry changes nothing.
bool keeps_inertia(const Bodies& bodies, std::int32_t body, math::DVec3 w, math::DQuat q, double dt);

// The acceleration of one body by the forces applied in the step, and its response to fields.
struct Load {
    math::DVec3 force_acceleration;
    float gravity_scale, inverse_mass;
};
Load load_on(const Bodies& bodies, std::int32_t body);

Increment linear_increment(const ForceFields& fields, const WorldDef& settings, const Load& load, math::DVec3 x,
                           math::DVec3 v, double h);
// Whether the body has a gyroscopic part: unequal moments, and a rotation per substep of more than min_turn.
bool precesses(const BodyMass& mass, math::DVec3 w, double h);
// The change for a body at rotation q with the angular velocity w and the angular momentum that goes with it.
Increment gyroscopic_increment(const WorldDef& settings, const Spin& spin, const math::DQuat& q, math::DVec3 w,
                               math::DVec3 momentum, math::DVec3 torque, double h);
// The change by the applied torque alone.
Increment torque_increment(const Bodies& bodies, const WorldDef& settings, std::int32_t body, const Spin& spin,
                           const math::DQuat& q, double h);

bool any_field(const ForceFields& fields);
// Whether any field depends on the position.
bool fields_vary(const ForceFields& fields);
// Acceleration by gravity and fields at a point, m/s^2, for a body of that mass and gravity scale.
math::DVec3 field_acceleration(const ForceFields& fields, const WorldDef& settings, math::DVec3 x, float gravity_scale,
                               double inverse_mass);

// Acceleration by gravity and fields at a body's center of mass, m/s^2.
math::DVec3 pull_at(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t body);

// The forces of gravity and fields on bodies.
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

// Acceleration of a body by gravity, fields and the forces applied in this step, m/s^2; 0 if no force can move it.
math::DVec3 acceleration_at(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings,
                            std::int32_t body, math::DVec3 x);

// Whether single-precision bounds can represent this position. A body that would move farther stops where it is.
constexpr double farthest_place = 1e30; // m: the greatest distance from the origin
inline bool is_place(math::DVec3 x) { return math::dot(x, x) <= farthest_place * farthest_place; }

// Approximates exp(-c h) for a damping rate c as one over the first terms of the series of exp(c h), so that it is
// always positive.
float damping_factor(float rate, float h);

// The inverse inertia tensor that contacts and joints use: with the principal moments limited by min_contact_moment.
math::Sym3 contact_inverse_inertia(const BodyMotion& motion, const BodyMass& mass);

} // namespace cairn
