// What steps change of a state, to and from an archive: of snapshots (core/archive.h) or of a ring of them.
#pragma once

#include "bodies/bodies.h"
#include "core/fields.h"
#include "state/state.h"
#include "world/definition_archive.h"

#include <cairn/error.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace cairn {

[[noreturn]] inline void throw_damaged() {
    throw Error(ErrorCode::invalid_file, "Snapshot", "", "is damaged: its checksum does not fit");
}

// Where a shape is if its body was not put elsewhere since the last step.
inline ShapePose expected_pose(const Bodies& bodies, const Shapes& shapes, std::size_t shape) {
    ShapePose pose{};
    if (shape >= shapes.links.size() || shape >= shapes.geometry.size()) return pose;
    const std::int32_t body = shapes.links[shape].body;
    if (std::uint32_t(body) >= bodies.motion.size()) return pose;
    const Geometry& g = shapes.geometry[shape];
    const BodyMotion& motion = bodies.motion[body];
    pose_shape(pose, g, motion.x + math::to_double(shapes.links[shape].arm), math::to_float(motion.q));
    size_shape(pose, g);
    return pose;
}

CAIRN_ARCHIVES_MEMBERS(13, State);
CAIRN_ARCHIVES_MEMBERS(13, Bodies);
CAIRN_ARCHIVES_MEMBERS(8, Shapes);
CAIRN_ARCHIVES_MEMBERS(4, Contacts);
CAIRN_ARCHIVES_MEMBERS(5, Islands);
CAIRN_ARCHIVES_MEMBERS(4, Joints);
CAIRN_ARCHIVES_MEMBERS(2, ForceFields);

template <class Archive> void serialize_bodies(Archive& archive, State& s) {
    archive(s.bodies.motion), archive(s.bodies.forces), archive(s.bodies.pushed), archive(s.bodies.links);
    archive.foretold(s.bodies.counted, [&](std::size_t i) {
        return CountedPose{s.bodies.motion[i].x, s.bodies.motion[i].q};
    });
    archive(s.bodies.travel), archive(s.bodies.ahead), archive(s.bodies.boxes_until);
    archive(s.shapes.links);
    archive.foretold(s.shapes.poses, [&](std::size_t i) { return expected_pose(s.bodies, s.shapes, i); });
    archive(s.islands.all), archive(s.islands.free), archive(s.islands.awake);
    archive(s.islands.falling_asleep), archive(s.islands.waking);
}

template <class Archive> void serialize_contacts(Archive& archive, State& s) {
    archive(s.contacts.records), archive(s.contacts.info), archive(s.contacts.answers), archive(s.contacts.free);
}

static_assert(field_count<JointInfo>() == 25, "JointInfo has another member: if definitions set it, and not steps, "
                                              "moving_part, serialize_joints and serialize_defined_joints name it");
static_assert(field_count<JointAxes>() == 2, "JointAxes has another member: archive it with states or with rules");

// Without what a joint is defined by.
inline JointInfo moving_part(const JointInfo& joint) {
    JointInfo moving = joint;
    moving.anchor_a = moving.anchor_b = moving.ground_a = moving.ground_b = {};
    moving.frame_a = moving.frame_b = {};
    return moving;
}

template <class Archive> void serialize_joints(Archive& archive, State& s) {
    std::vector<JointInfo> moving;
    std::vector<std::array<JointAxisState, max_joint_axes>> states(s.joints.axes.size());
    if constexpr (!Archive::reading) {
        for (const JointInfo& joint : s.joints.info) moving.push_back(moving_part(joint));
        for (std::size_t i = 0; i < states.size(); ++i)
            std::copy_n(s.joints.axes[i].states, max_joint_axes, states[i].begin());
    }
    if constexpr (std::is_same_v<Archive, ArchiveChecker>) {
        if (archive(moving) != s.joints.info.size() || archive(states) != s.joints.axes.size()) throw_damaged();
    } else {
        archive(moving), archive(states);
    }
    if constexpr (Archive::reading && !std::is_same_v<Archive, ArchiveChecker>) {
        if (moving.size() != s.joints.info.size() || states.size() != s.joints.axes.size()) throw_damaged();
        for (std::size_t i = 0; i < moving.size(); ++i) {
            const JointInfo defined = s.joints.info[i];
            JointInfo& joint = s.joints.info[i] = moving[i];
            joint.anchor_a = defined.anchor_a, joint.anchor_b = defined.anchor_b;
            joint.ground_a = defined.ground_a, joint.ground_b = defined.ground_b;
            joint.frame_a = defined.frame_a, joint.frame_b = defined.frame_b;
        }
        for (std::size_t i = 0; i < states.size(); ++i)
            std::copy_n(states[i].begin(), max_joint_axes, s.joints.axes[i].states);
    }
}

// What the last step has counted; the rest of the statistics follows from the state. Times are of one run.
CAIRN_ARCHIVES_MEMBERS(21, Statistics);
template <class Archive> void serialize_counters(Archive& archive, State& s) {
    archive(s.steps), archive(s.time), archive(s.clamped_speeds);
    archive(s.statistics.tested_pairs), archive(s.statistics.max_penetration), archive(s.statistics.swept_pairs);
    archive(s.statistics.impacts), archive(s.statistics.stopped_bodies);
    archive(s.events.ends.next), serialize_fields(archive, s.events.triggers.next);
    serialize_fields(archive, s.events.joints.next), serialize_fields(archive, s.events.sleeps.next);
}

// What a snapshot's bytes are for, in their order.
enum class StatePart : std::uint8_t { bodies, contacts, joints, broad_phase, other };

// Calls `end_part(part)` behind each.
template <class Archive, class F> void serialize_state(Archive& archive, State& s, F&& end_part) {
    serialize_bodies(archive, s), end_part(StatePart::bodies);
    serialize_contacts(archive, s), end_part(StatePart::contacts);
    serialize_joints(archive, s), end_part(StatePart::joints);
    s.broad_phase.serialize(archive), end_part(StatePart::broad_phase);
    serialize_counters(archive, s), end_part(StatePart::other);
}

} // namespace cairn
