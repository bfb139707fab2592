// Where a pair that moves far in a step will touch (contacts/touch.h).
#pragma once

#include "collision/manifold.h"
#include "collision/shape_pose.h"
#include "math/vec.h"

namespace cairn {

// A pair as it will be when it touches, or passes by within the margin of the contact: where it is nearest then. So
// what is pushed aside within the step meets it all the same.
struct Touch {
    float time = 0; // s from the start of the step
    ShapePose pose_a, pose_b;
    math::Vec3 arm_a;             // from A's center of mass to the shape's origin
    math::DVec3 moved_a, moved_b; // of the centers of mass, since the start of the step
    math::DQuat turned_a, turned_b;
    bool is_beside = false; // it passes by, and has one point
    Manifold manifold;      // as the kernel of the pair would find it; of a group, only if it passes by
};

} // namespace cairn
