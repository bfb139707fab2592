#include "joints/joints.h"

#include "islands/coloring.h"
#include "islands/islands.h"
#include "state/joint_links.h"

#include <algorithm>

namespace cairn {

namespace {

void append_end(Bodies& bodies, Joints& joints, std::int32_t body, std::int32_t end) {
    if (body == none) return;
    BodyLinks& links = bodies.links[body];
    JointInfo& joint = joints.info[end / 2];
    joint.previous[end % 2] = links.last_joint;
    joint.next[end % 2] = none;
    if (links.last_joint == none)
        links.first_joint = end;
    else
        joints.info[links.last_joint / 2].next[links.last_joint % 2] = end;
    links.last_joint = end;
}

void remove_end(Bodies& bodies, Joints& joints, std::int32_t body, std::int32_t end) {
    if (body == none) return;
    BodyLinks& links = bodies.links[body];
    const JointInfo& joint = joints.info[end / 2];
    const std::int32_t next = joint.next[end % 2], previous = joint.previous[end % 2];
    if (previous == none)
        links.first_joint = next;
    else
        joints.info[previous / 2].next[previous % 2] = next;
    if (next == none)
        links.last_joint = previous;
    else
        joints.info[next / 2].previous[next % 2] = previous;
}

bool is_solved(const Bodies& bodies, std::int32_t body) { return body != none && bodies.is_dynamic(body); }

// The lowest color free at both bodies. Joints with bodies that forces do not move have separate colors, solved last.
std::uint8_t free_color(const Bodies& bodies, const JointInfo& joint) {
    const bool a = is_solved(bodies, joint.body_a), b = is_solved(bodies, joint.body_b);
    std::uint64_t used = 0;
    if (a) used |= bodies.links[joint.body_a].joint_colors;
    if (b) used |= bodies.links[joint.body_b].joint_colors;
    const std::uint64_t low = (std::uint64_t(1) << first_fixed_color) - 1;
    const std::uint64_t choice = a && b ? low : ~low & ~(std::uint64_t(1) << overflow_color);
    const std::uint64_t free = ~used & choice;
    return free ? std::uint8_t(__builtin_ctzll(free)) : std::uint8_t(overflow_color);
}

} // namespace

void link_joint(Bodies& bodies, Joints& joints, std::uint32_t joint) {
    append_end(bodies, joints, joints.info[joint].body_a, std::int32_t(2 * joint));
    append_end(bodies, joints, joints.info[joint].body_b, std::int32_t(2 * joint + 1));
}

void unlink_joint(Bodies& bodies, Joints& joints, std::uint32_t joint) {
    remove_end(bodies, joints, joints.info[joint].body_a, std::int32_t(2 * joint));
    remove_end(bodies, joints, joints.info[joint].body_b, std::int32_t(2 * joint + 1));
}

void activate_joint(Bodies& bodies, Islands& islands, Joints& joints, StepEvents& events, std::uint32_t index) {
    JointInfo& joint = joints.info[index];
    const std::int32_t owner = joint_owner(bodies, joint);
    ++joints.changes;
    if (owner == none) return;
    joint.color = free_color(bodies, joint);
    const bool a = is_solved(bodies, joint.body_a), b = is_solved(bodies, joint.body_b);
    for (const std::int32_t body : {a ? joint.body_a : none, b ? joint.body_b : none}) {
        if (body == none) continue;
        ++bodies.links[body].joint_count;
        if (joint.color < overflow_color) bodies.links[body].joint_colors |= std::uint64_t(1) << joint.color;
    }
    if (a && b)
        link_islands(bodies, islands, events, joint.body_a, joint.body_b);
    else
        wake_body(bodies, islands, events, owner);
    ++islands.all[bodies.links[owner].island].joint_count;
}

void deactivate_joint(Bodies& bodies, Islands& islands, Joints& joints, StepEvents& events, std::uint32_t index) {
    JointInfo& joint = joints.info[index];
    const std::int32_t owner = joint_owner(bodies, joint);
    ++joints.changes;
    if (owner == none || joint.color == no_color) return;
    wake_body(bodies, islands, events, owner);
    Island& island = islands.all[bodies.links[owner].island];
    --island.joint_count;
    if (is_solved(bodies, joint.body_a) && is_solved(bodies, joint.body_b)) island.lost_contact = 1;
    for (const std::int32_t body : {joint.body_a, joint.body_b}) {
        if (!is_solved(bodies, body)) continue;
        --bodies.links[body].joint_count;
        if (joint.color < overflow_color) bodies.links[body].joint_colors &= ~(std::uint64_t(1) << joint.color);
    }
    joint.color = no_color;
}

namespace {

// Calls f(island) for the islands of the bodies that joints connect to a body, once for each joint.
template <class F> void for_joined_islands(const Bodies& bodies, const Joints& joints, std::int32_t body, F&& f) {
    for_each_joint(bodies, joints, body, [&](std::uint32_t joint, int side) {
        const std::int32_t other = other_body(joints.info[joint], side);
        if (is_solved(bodies, other) && joints.info[joint].enabled) f(bodies.links[other].island);
    });
}

} // namespace

void wake_joined(Bodies& bodies, Islands& islands, const Joints& joints, StepEvents& events, std::int32_t body) {
    for_joined_islands(bodies, joints, body,
                       [&](std::int32_t island) { wake_island(bodies, islands, events, island); });
}

void wake_driven_joints(Bodies& bodies, Islands& islands, const Joints& joints, StepEvents& events) {
    for (const std::int32_t b : bodies.kinematics) {
        const BodyMotion& motion = bodies.motion[b];
        if (bodies.links[b].first_joint == none) continue;
        if (motion.v == math::Vec3{} && motion.w == math::Vec3{}) continue;
        for_joined_islands(bodies, joints, b, [&](std::int32_t island) {
            wake_island(bodies, islands, events, island);
            islands.all[island].kept_awake = 1;
        });
    }
}

} // namespace cairn
