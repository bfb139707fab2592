// At which moment of the step a contact is found: contacts/touch.h, contacts/midway.h.
#pragma once

#include "collision/manifold.h"
#include "collision/shape_pose.h"
#include "math/vec.h"

namespace cairn {

// The moment that a manifold is of, and where its bodies are expected then.
struct Moment {
    float time;            // s from the start of the step
    math::Vec3 arm;        // from the center of mass to the origin of the first shape of the test, m
    math::Vec3 x_a_from_b; // m
    const ShapePose *pose_a, *pose_b;
};

// A pair as it will be when it touches, or passes by within the margin of the contact: where it is nearest then. So
// what is pushed aside within the step meets it all the same.
struct Touch {
    Moment moment;
    ShapePose pose_a, pose_b;
    math::Vec3 arm_a;       // from A's center of mass to the shape's origin
    math::DVec3 passed;     // how far A will have passed B, m
    bool is_beside = false; // it passes by, and has one point
    Manifold manifold;      // as the kernel of the pair would find it; of a group, only if it passes by
};

} // namespace cairn
