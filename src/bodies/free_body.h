// A body that nothing touches.
#pragma once

#include "state/state.h"

namespace cairn {

// In double. What the rounding of its velocities leaves over is kept. Returns how often a speed was cut.
std::uint64_t move_free_body(Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t body,
                             float dt, int substeps);
// How it turns alone: from a rotation, with an angular velocity, rad/s.
void turn_free_body(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t body,
                    double dt, int substeps, math::DQuat& q, math::DVec3& w);

} // namespace cairn
