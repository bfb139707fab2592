// Contacts of what moves far in a step: at the poses at which the shapes will touch.
#pragma once

#include "state/state.h"

namespace cairn {

// A pair as it will be when it touches, or passes by within the margin of the contact: where it is nearest then. So
// what is pushed aside within the step meets it all the same.
struct Touch {
    float time = 0; // s from the start of the step
    ShapePose pose_a, pose_b;
    math::Vec3 arm_a;             // from A's center of mass to the shape's origin
    math::DVec3 moved_a, moved_b; // of the centers of mass, since the start of the step
    math::DQuat turned_a, turned_b;
    Manifold manifold; // as the kernel of the pair would find it
};

// Whether two shapes, which are apart at the start of the step, slide or turn so far before they touch where the
// manifold says that they may touch otherwise, or not at all. Bodies with joints do not move as their velocities say.
bool moves_far(const State& state, const ContactInfo& contact, const Manifold& manifold, float dt);

enum class Approach { passes, now, later };
// When and where the two will touch or be nearest, as their velocities and forces say; `touch` is written if that is
// later.
// `margin`: how far apart points may be at the touch to count.
Approach find_touch(const State& state, const ContactInfo& contact, float dt, float margin, Touch& touch);

} // namespace cairn
