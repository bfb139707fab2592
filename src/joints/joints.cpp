#include "joints/joints.h"

#include "islands/coloring.h"
#include "islands/islands.h"
#include "state/joint_links.h"

#include <algorithm>

namespace cairn {

namespace {

void append_end(State& s, std::int32_t body, std::int32_t end) {
    if (body == none) return;
    BodyLinks& links = s.bodies.links[body];
    JointInfo& joint = s.joints.info[end / 2];
    joint.previous[end % 2] = links.last_joint;
    joint.next[end % 2] = none;
    if (links.last_joint == none)
        links.first_joint = end;
    else
        s.joints.info[links.last_joint / 2].next[links.last_joint % 2] = end;
    links.last_joint = end;
}

void remove_end(State& s, std::int32_t body, std::int32_t end) {
    if (body == none) return;
    BodyLinks& links = s.bodies.links[body];
    const JointInfo& joint = s.joints.info[end / 2];
    const std::int32_t next = joint.next[end % 2], previous = joint.previous[end % 2];
    if (previous == none)
        links.first_joint = next;
    else
        s.joints.info[previous / 2].next[previous % 2] = next;
    if (next == none)
        links.last_joint = previous;
    else
        s.joints.info[next / 2].previous[next % 2] = previous;
}

bool is_solved(const State& s, std::int32_t body) { return body != none && s.bodies.is_dynamic(body); }

// The lowest color that is free at both bodies; joints with what does not move have colors of their own, solved last.
std::uint8_t free_color(const State& s, const JointInfo& joint) {
    const bool a = is_solved(s, joint.body_a), b = is_solved(s, joint.body_b);
    std::uint64_t used = 0;
    if (a) used |= s.bodies.links[joint.body_a].joint_colors;
    if (b) used |= s.bodies.links[joint.body_b].joint_colors;
    const std::uint64_t low = (std::uint64_t(1) << first_fixed_color) - 1;
    const std::uint64_t choice = a && b ? low : ~low & ~(std::uint64_t(1) << overflow_color);
    const std::uint64_t free = ~used & choice;
    return free ? std::uint8_t(__builtin_ctzll(free)) : std::uint8_t(overflow_color);
}

} // namespace

void link_joint(State& s, std::uint32_t joint) {
    append_end(s, s.joints.info[joint].body_a, std::int32_t(2 * joint));
    append_end(s, s.joints.info[joint].body_b, std::int32_t(2 * joint + 1));
}

void unlink_joint(State& s, std::uint32_t joint) {
    remove_end(s, s.joints.info[joint].body_a, std::int32_t(2 * joint));
    remove_end(s, s.joints.info[joint].body_b, std::int32_t(2 * joint + 1));
}

void activate_joint(State& s, std::uint32_t index) {
    JointInfo& joint = s.joints.info[index];
    const std::int32_t owner = joint_owner(s, joint);
    ++s.joints.changes;
    if (owner == none) return;
    joint.color = free_color(s, joint);
    const bool a = is_solved(s, joint.body_a), b = is_solved(s, joint.body_b);
    for (const std::int32_t body : {a ? joint.body_a : none, b ? joint.body_b : none}) {
        if (body == none) continue;
        ++s.bodies.links[body].joint_count;
        if (joint.color < overflow_color) s.bodies.links[body].joint_colors |= std::uint64_t(1) << joint.color;
    }
    if (a && b)
        link_islands(s, joint.body_a, joint.body_b);
    else
        wake_body(s, owner);
    ++s.islands.all[s.bodies.links[owner].island].joint_count;
}

void deactivate_joint(State& s, std::uint32_t index) {
    JointInfo& joint = s.joints.info[index];
    const std::int32_t owner = joint_owner(s, joint);
    ++s.joints.changes;
    if (owner == none || joint.color == no_color) return;
    wake_body(s, owner);
    Island& island = s.islands.all[s.bodies.links[owner].island];
    --island.joint_count;
    if (is_solved(s, joint.body_a) && is_solved(s, joint.body_b)) island.lost_contact = 1;
    for (const std::int32_t body : {joint.body_a, joint.body_b}) {
        if (!is_solved(s, body)) continue;
        --s.bodies.links[body].joint_count;
        if (joint.color < overflow_color) s.bodies.links[body].joint_colors &= ~(std::uint64_t(1) << joint.color);
    }
    joint.color = no_color;
}

void wake_driven_joints(State& s) {
    for (const std::int32_t b : s.bodies.kinematics) {
        const BodyMotion& motion = s.bodies.motion[b];
        if (s.bodies.links[b].first_joint == none) continue;
        if (motion.v == math::Vec3{} && motion.w == math::Vec3{}) continue;
        for_each_joint(s, b, [&](std::uint32_t joint, int side) {
            const std::int32_t other = other_body(s.joints.info[joint], side);
            if (!is_solved(s, other)) return;
            wake_island(s, s.bodies.links[other].island);
            s.islands.all[s.bodies.links[other].island].kept_awake = 1;
        });
    }
}

} // namespace cairn
