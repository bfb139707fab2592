// The moment within the step at which a contact is found: contacts/touch.h, contacts/midway.h.
#pragma once

#include "collision/manifold.h"
#include "collision/shape_pose.h"
#include "math/vec.h"

namespace cairn {

// The moment of a manifold, and the expected positions of the bodies at that time.
struct Moment {
    float time;            // s from the start of the step
    math::Vec3 arm;        // m: from the center of mass to the origin of the first shape of the test
    math::Vec3 x_a_from_b; // m: center of mass of A minus that of B
    const ShapePose *pose_a, *pose_b;
};

// The expected state of a pair when it touches or, if it passes by within the margin of the contact, when it is
// nearest. The contact of a pair that passes by stops a body that is pushed aside within the step.
struct Touch {
    Moment moment;
    ShapePose pose_a, pose_b;
    math::Vec3 arm_a;       // m: from A's center of mass to the shape's origin
    math::DVec3 passed;     // m: the displacement of A relative to B until then
    bool is_beside = false; // the pair passes by, and has one point
    Manifold manifold;      // the kernel's manifold; of a mesh contact only if is_beside
};

} // namespace cairn
