// The motion of a body without contacts and joints.
#pragma once

#include "state/state.h"

namespace cairn {

// Moves the body through all substeps in double precision. The rounding errors of its float velocities are kept for the
// next step. Returns how often a speed was clamped.
std::uint64_t move_free_body(Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t body,
                             float dt, int substeps);
// Only the rotation: advances q and the angular velocity w (rad/s) over `dt`.
void turn_free_body(const Bodies& bodies, const ForceFields& fields, const WorldDef& settings, std::int32_t body,
                    double dt, int substeps, math::DQuat& q, math::DVec3& w);

} // namespace cairn
