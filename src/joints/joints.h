// Joints: their place in the lists of bodies, islands and colors.
#pragma once

#include "state/joint_links.h"

namespace cairn {

// A joint that is filled in joins the lists of its bodies; and leaves them.
void link_joint(Bodies& bodies, Joints& joints, std::uint32_t joint);
void unlink_joint(Bodies& bodies, Joints& joints, std::uint32_t joint);
// It begins and ceases to be solved, as bodies become dynamic or cease to be: color, counts, islands.
void activate_joint(Bodies& bodies, Islands& islands, Joints& joints, StepEvents& events, std::uint32_t joint);
void deactivate_joint(Bodies& bodies, Islands& islands, Joints& joints, StepEvents& events, std::uint32_t joint);

// What hangs on a body wakes.
void wake_joined(Bodies& bodies, Islands& islands, const Joints& joints, StepEvents& events, std::int32_t body);
// What hangs on a kinematic body that moves is awake, and stays so.
void wake_driven_joints(Bodies& bodies, Islands& islands, const Joints& joints, StepEvents& events);

} // namespace cairn
