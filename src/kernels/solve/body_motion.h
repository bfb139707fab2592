// Poses and velocities of bodies. Plain data: kernels use the members only, no functions.
#pragma once

#include "math/vec.h"

#include <cstdint>

namespace cairn {

// Pose and velocities of a body. Rotations are double: with float, rounding adds 0.4 % to the energy of a free top in a
// minute. The narrow phase reads the first cache line only.
struct alignas(64) BodyMotion {
    math::DVec3 x; // center of mass, world
    math::Vec3 v, w;
    math::Quat turned; // rotation of the last step, for matching contact points

    math::DQuat q;             // rotation of the body's frame
    math::Vec3 v_rest, w_rest; // the low-order parts of v and w, which float loses, while nothing touches the body
    std::uint64_t padding = 0;
};

// Half of the limits on a body's displacement in a step (m), speed (m/s) and angular speed (rad/s).
struct HalfLimits {
    float way, speed, angular_speed;
};

} // namespace cairn
