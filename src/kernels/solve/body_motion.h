// Where bodies are. Plain data: kernels use its members alone.
#pragma once

#include "math/vec.h"

#include <cstdint>

namespace cairn {

// Where a body is and how it moves. Rotations are double: the rounding of a float one gives a free top 0.4 % of
// energy in a minute. The first cache line is what the narrow phase reads.
struct alignas(64) BodyMotion {
    math::DVec3 x; // center of mass, world
    math::Vec3 v, w;
    math::Quat turned; // rotation of the last step, for matching contact points

    math::DQuat q;             // of the body's frame
    math::Vec3 v_rest, w_rest; // what rounding has left over of v and w, while nothing touches the body
    std::uint64_t padding = 0;
};

// Half of how far, in a step, and how fast bodies may go.
struct HalfLimits {
    float way, speed, angular_speed;
};

} // namespace cairn
