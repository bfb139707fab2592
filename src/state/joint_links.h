// Access to the joints of a body, and to the bodies of a joint.
#pragma once

#include "state/state.h"

namespace cairn {

// The body that a joint is counted with, in whose island it is; none if the joint is not solved: neither body is
// dynamic, or the joint or one of its bodies is disabled.
inline std::int32_t joint_owner(const Bodies& bodies, const JointInfo& joint) {
    if (!joint.enabled) return none;
    for (const std::int32_t body : {joint.body_a, joint.body_b})
        if (body != none && !bodies.is_enabled(body)) return none;
    if (joint.body_a != none && bodies.is_dynamic(joint.body_a)) return joint.body_a;
    return joint.body_b != none && bodies.is_dynamic(joint.body_b) ? joint.body_b : none;
}
// Calls f(joint, side) for the joints of a body, oldest first. f may not remove any.
template <class F> void for_each_joint(const Bodies& bodies, const Joints& joints, std::int32_t body, F&& f) {
    for (std::int32_t end = bodies.links[body].first_joint; end != none; end = joints.info[end / 2].next[end % 2])
        f(std::uint32_t(end / 2), end % 2);
}
inline std::int32_t other_body(const JointInfo& joint, int side) { return side == 0 ? joint.body_b : joint.body_a; }

// Whether a joint between two bodies disables their collision.
inline bool joint_forbids_contact(const Bodies& bodies, const Joints& joints, std::int32_t body_a,
                                  std::int32_t body_b) {
    if (bodies.links[body_a].first_joint == none) return false;
    bool forbids = false;
    for_each_joint(bodies, joints, body_a, [&](std::uint32_t joint, int side) {
        const JointInfo& info = joints.info[joint];
        forbids |= info.enabled && !info.enable_collision && other_body(info, side) == body_b;
    });
    return forbids;
}

} // namespace cairn
