// Positions of a joint's axes, computed outside of a step.
#pragma once

#include "state/state.h"

namespace cairn {

// The positions of a joint's axes, the gap between its anchors and its rotation error, at the present poses.
struct JointPositions {
    float axes[max_joint_axes];
    math::Vec3 gap, turn; // in the locked directions
};
JointPositions joint_positions(const Bodies& bodies, const Joints& joints, std::uint32_t joint);

} // namespace cairn
