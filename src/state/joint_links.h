// The joints of a body, and the bodies of a joint.
#pragma once

#include "state/state.h"

namespace cairn {

// The body that a joint counts to, in whose island it is; none if neither is dynamic.
inline std::int32_t joint_owner(const State& s, const JointInfo& joint) {
    if (joint.body_a != none && s.bodies.is_dynamic(joint.body_a)) return joint.body_a;
    return joint.body_b != none && s.bodies.is_dynamic(joint.body_b) ? joint.body_b : none;
}
// Calls f(joint, side) for the joints of a body, oldest first. f may not remove any.
template <class F> void for_each_joint(const State& s, std::int32_t body, F&& f) {
    for (std::int32_t end = s.bodies.links[body].first_joint; end != none; end = s.joints.info[end / 2].next[end % 2])
        f(std::uint32_t(end / 2), end % 2);
}
inline std::int32_t other_body(const JointInfo& joint, int side) { return side == 0 ? joint.body_b : joint.body_a; }

// Whether some joint of two bodies keeps them from colliding.
inline bool joint_forbids_contact(const State& s, std::int32_t body_a, std::int32_t body_b) {
    if (s.bodies.links[body_a].first_joint == none) return false;
    bool forbids = false;
    for_each_joint(s, body_a, [&](std::uint32_t joint, int side) {
        const JointInfo& info = s.joints.info[joint];
        forbids |= !info.enable_collision && other_body(info, side) == body_b;
    });
    return forbids;
}

} // namespace cairn
