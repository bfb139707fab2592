// What the positions of a joint's axes are, outside of a step.
#pragma once

#include "state/state.h"

namespace cairn {

// The positions of a joint's axes, the gap between its anchors and the rotation error, as the bodies stand.
struct JointPositions {
    float axes[max_joint_axes];
    math::Vec3 gap, turn; // of what it locks
};
JointPositions joint_positions(const Bodies& bodies, const Joints& joints, std::uint32_t joint);

} // namespace cairn
