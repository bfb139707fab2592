// Anchors and frames of a joint in world space, in double.
#pragma once

#include "state/state.h"

namespace cairn {

struct JointAnchors {
    math::DVec3 arm_a, arm_b, gap; // center of mass to anchor (of the world: zero); anchor A to anchor B
};
struct JointPlacement : JointAnchors {
    math::DQuat frame_a, frame_b; // in the world
};
inline JointAnchors place_anchors(const Bodies& bodies, const JointInfo& joint) {
    JointAnchors p;
    auto place = [&](std::int32_t body, math::DVec3 anchor, math::DVec3& arm) {
        if (body == none) return anchor;
        const BodyMotion& motion = bodies.motion[body];
        arm = math::rotate(motion.q, anchor - math::to_double(bodies.mass[body].center));
        return motion.x + arm;
    };
    const math::DVec3 at_a = place(joint.body_a, joint.anchor_a, p.arm_a);
    p.gap = place(joint.body_b, joint.anchor_b, p.arm_b) - at_a;
    return p;
}
JointPlacement place_joint(const Bodies& bodies, const JointInfo& joint);

// An axis of a frame.
inline math::DVec3 exact_frame_axis(const math::DQuat& frame, int i) {
    math::DVec3 e;
    e[i] = 1;
    return math::rotate(frame, e);
}
inline math::Vec3 frame_axis(const math::DQuat& frame, int i) { return math::to_float(exact_frame_axis(frame, i)); }

// The rotation of frame B relative to frame A, in world axes.
inline math::DQuat turn_of(const JointPlacement& p) { return math::normalized(p.frame_b * math::conjugate(p.frame_a)); }

// The vector from the ground point of a pulley to the anchor on that side.
math::Vec3 pulley_reach(const Bodies& bodies, const JointInfo& joint, int side, const JointPlacement& p);

} // namespace cairn
