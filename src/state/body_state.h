// The state of bodies: pose and motion, mass, settings, and the lists that they are in.
#pragma once

#include "core/slot_pool.h"
#include "kernels/solve/body_motion.h"
#include "math/vec.h"
#include "state/none.h"
#include "state/travel.h"

#include <cairn/world.h>

#include <cstdint>
#include <vector>

namespace cairn {

struct alignas(64) BodyMass {
    float mass = 0, inverse_mass = 0;    // an inverse of 0: immovable
    math::Vec3 inertia, inverse_inertia; // about the principal axes
    math::Quat principal;                // rotation from the principal axes to the body's frame
    math::Vec3 center;                   // center of mass in the body's frame
    std::uint8_t isotropic = 1;          // all moments equal: no gyroscopic torque
    std::uint8_t follows_shapes = 1;     // recomputed when shapes change
    std::uint8_t has_given_mass = 0;     // if follows_shapes: scaled to BodySettings::given_mass
    std::uint8_t padding = 0;
};

struct BodySettings {
    float gravity_scale = 1, linear_damping = 0, angular_damping = 0;
    float given_mass = 0;              // kg, if BodyMass::has_given_mass
    BodyType type = BodyType::dynamic; // static while the body is disabled
    std::uint8_t allow_sleep = 1;
    BodyType own_type = BodyType::dynamic; // the type that users set
    std::uint8_t enabled = 1;              // 0: its shapes are not in the broad phase, and its joints are not solved
};

// The external forces on a body in this step. In double precision, so that no sum of floats overflows.
enum PushedBy : std::uint64_t { pushed_by_user = 1, pushed_by_fluid = 2 };
struct BodyForces {
    math::DVec3 force, torque;
    std::uint64_t any = 0; // bits of PushedBy; 0: no forces
};

// Time constant of the low-pass filters of BodyLinks::late and ::later, as a share of the sleep time.
inline constexpr float lag_of_rest = 0.25f;

struct BodyLinks {
    std::int32_t first_shape = none, last_shape = none;
    std::int32_t island = none; // of dynamic bodies only
    std::int32_t next_in_island = none, previous_in_island = none;
    float radius = 0;               // m: of the body about its center of mass, without its planes
    float quiet_time = 0;           // s: how long it has been slower than the sleep speed
    float late = 0, later = 0;      // J/kg: half of the squared speed, low-pass filtered once and twice
    std::int32_t contact_count = 0; // of contacts that are solved
    std::uint64_t colors = 0;       // of its contacts: one bit per color
    std::uint64_t joint_colors = 0; // of its joints
    std::int32_t first_joint = none, last_joint = none; // joint ends: 2 x joint + side
    std::int32_t joint_count = 0;                       // of joints that are solved
    float inner_radius = 0;                             // m: the smallest half width of its shapes
};

// All bodies. Vectors are indexed by body, unless their comment says what they list.
struct Bodies {
    SlotPool<BodyId> slots;
    std::vector<BodyMotion> motion;
    std::vector<BodyMass> mass;
    std::vector<BodySettings> settings;
    std::vector<BodyForces> forces;
    std::vector<BodyLinks> links;
    std::vector<Travel> travel;           // the greatest distance that any point of the body has moved
    std::vector<CountedPose> counted;     // the poses up to which `travel` is counted
    std::vector<Travel> ahead;            // an upper bound of `travel` at the end of this step
    std::vector<Travel> boxes_until;      // the travel up to which fat boxes need no check
    std::vector<std::int32_t> pushed;     // bodies with external forces
    std::vector<std::int32_t> kinematics; // kinematic bodies, in order of creation
    std::vector<std::uint32_t> dead;      // bodies whose slots are recycled after the broad phase's update

    BodyId id(std::int32_t body) const { return slots.id(std::uint32_t(body)); }
    bool is_pushed(std::int32_t body) const { return !pushed.empty() && forces[body].any; }
    bool is_dynamic(std::int32_t body) const { return settings[body].type == BodyType::dynamic; }
    bool is_enabled(std::int32_t body) const { return settings[body].enabled != 0; }
};

} // namespace cairn
