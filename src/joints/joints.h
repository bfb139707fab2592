// Links joints with the lists of bodies, islands and colors.
#pragma once

#include "state/joint_links.h"

namespace cairn {

// Adds a joint that is filled in to the lists of its bodies, or removes it.
void link_joint(Bodies& bodies, Joints& joints, std::uint32_t joint);
void unlink_joint(Bodies& bodies, Joints& joints, std::uint32_t joint);
// Starts or stops solving a joint, as its bodies become dynamic or cease to be: color, counts, islands.
void activate_joint(Bodies& bodies, Islands& islands, Joints& joints, StepEvents& events, std::uint32_t joint);
void deactivate_joint(Bodies& bodies, Islands& islands, Joints& joints, StepEvents& events, std::uint32_t joint);

// Wakes the bodies that joints connect to this body.
void wake_joined(Bodies& bodies, Islands& islands, const Joints& joints, StepEvents& events, std::int32_t body);
// Wakes the bodies that joints connect to moving kinematic bodies, and keeps them awake.
void wake_driven_joints(Bodies& bodies, Islands& islands, const Joints& joints, StepEvents& events);

} // namespace cairn
