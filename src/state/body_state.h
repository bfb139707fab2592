// What is known of a body: where it is, how it moves, its mass, and the lists that it is in.
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
    float mass = 0, inverse_mass = 0;    // an inverse of 0 means immovable
    math::Vec3 inertia, inverse_inertia; // principal
    math::Quat principal;                // from principal axes to the body's frame
    math::Vec3 center;                   // center of mass in the body's frame
    std::uint8_t isotropic = 1;          // all moments equal: no gyroscopic torque
    std::uint8_t follows_shapes = 1;     // recomputed when shapes change
    std::uint8_t has_given_mass = 0;     // ... scaled to BodySettings::given_mass
    std::uint8_t padding = 0;
};

struct BodySettings {
    float gravity_scale = 1, linear_damping = 0, angular_damping = 0;
    float given_mass = 0;              // kg, if BodyMass::has_given_mass
    BodyType type = BodyType::dynamic; // while it is disabled: static
    std::uint8_t allow_sleep = 1;
    BodyType own_type = BodyType::dynamic; // as users see it
    std::uint8_t enabled = 1;              // 0: no shape of it is in the broad phase, no joint of it is solved
};

// What pushes a body during the step. Double, so that no sum of floats overflows.
enum PushedBy : std::uint64_t { pushed_by_user = 1, pushed_by_fluid = 2 };
struct BodyForces {
    math::DVec3 force, torque;
    std::uint64_t any = 0; // of PushedBy
};

inline constexpr float lag_of_rest = 0.25f; // of the sleep time, for BodyLinks::late, and once more for ::later

struct BodyLinks {
    std::int32_t first_shape = none, last_shape = none;
    std::int32_t island = none; // dynamic bodies only
    std::int32_t next_in_island = none, previous_in_island = none;
    float radius = 0;                                   // of the body about its center of mass; planes not counted
    float quiet_time = 0;                               // s that it has been slower than the sleep speed
    float late = 0, later = 0;                          // J/kg: half of its squared speed meanwhile, as it lags behind
    std::int32_t contact_count = 0;                     // that are solved
    std::uint64_t colors = 0;                           // of its contacts, one bit each
    std::uint64_t joint_colors = 0;                     // likewise
    std::int32_t first_joint = none, last_joint = none; // ends: 2 x joint + side
    std::int32_t joint_count = 0;                       // that are solved
    float inner_radius = 0;                             // m: the smallest half width of its shapes
};

// All bodies; vectors are by body, unless they say what they list.
struct Bodies {
    SlotPool<BodyId> slots;
    std::vector<BodyMotion> motion;
    std::vector<BodyMass> mass;
    std::vector<BodySettings> settings;
    std::vector<BodyForces> forces;
    std::vector<BodyLinks> links;
    std::vector<Travel> travel;           // how far any point of it has moved, at most
    std::vector<CountedPose> counted;     // up to there
    std::vector<Travel> ahead;            // how far a body will have moved after this step, at most
    std::vector<Travel> boxes_until;      // the travel up to which its fat boxes are not looked at
    std::vector<std::int32_t> pushed;     // bodies with any forces
    std::vector<std::int32_t> kinematics; // kinematic bodies, in order of creation
    std::vector<std::uint32_t> dead;      // recycled after the broad phase's update

    BodyId id(std::int32_t body) const { return slots.id(std::uint32_t(body)); }
    bool is_pushed(std::int32_t body) const { return !pushed.empty() && forces[body].any; }
    bool is_dynamic(std::int32_t body) const { return settings[body].type == BodyType::dynamic; }
    bool is_enabled(std::int32_t body) const { return settings[body].enabled != 0; }
};

} // namespace cairn
