// Serialization of the state that steps change, for snapshots (core/archive.h) and for rings of snapshots.
#pragma once

#include "bodies/bodies.h"
#include "core/fields.h"
#include "core/set_aside.h"
#include "core/sound.h"
#include "state/state.h"
#include "world/definition_archive.h"

#include <cairn/error.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace cairn {

[[noreturn]] inline void throw_damaged() {
    throw Error(ErrorCode::invalid_file, "Snapshot", "", "is damaged: its checksum does not fit");
}

// The pose that a shape has unless its body was moved by the user since the last step.
inline ShapePose expected_pose(const Bodies& bodies, const Shapes& shapes, std::size_t shape) {
    ShapePose pose{};
    if (shape >= shapes.links.size() || shape >= shapes.geometry.size()) return pose;
    const std::int32_t body = shapes.links[shape].body;
    if (std::uint32_t(body) >= bodies.motion.size()) return pose;
    const Geometry& g = shapes.geometry[shape];
    const BodyMotion& motion = bodies.motion[body];
    pose_shape(pose, g, motion.x + math::to_double(shapes.links[shape].arm), math::to_float(motion.q));
    size_shape(pose, g, shape);
    return pose;
}

CAIRN_ARCHIVES_MEMBERS(14, State);
CAIRN_ARCHIVES_MEMBERS(13, Bodies);
CAIRN_ARCHIVES_MEMBERS(8, Shapes);
CAIRN_ARCHIVES_MEMBERS(5, Contacts);
CAIRN_ARCHIVES_MEMBERS(6, Islands);
CAIRN_ARCHIVES_MEMBERS(4, Joints);
CAIRN_ARCHIVES_MEMBERS(2, ForceFields);
CAIRN_ARCHIVES_MEMBERS(1, Characters);

template <class Archive> void serialize_bodies(Archive& archive, State& s) {
    archive(s.bodies.motion), archive(s.bodies.forces), archive(s.bodies.pushed), archive(s.bodies.links);
    archive.predicted(s.bodies.counted, [&](std::size_t i) {
        return i < s.bodies.motion.size() ? CountedPose{s.bodies.motion[i].x, s.bodies.motion[i].q} : CountedPose{};
    });
    archive(s.bodies.travel), archive(s.bodies.ahead), archive(s.bodies.boxes_until);
    archive(s.shapes.links);
    archive.predicted(s.shapes.poses, [&](std::size_t i) { return expected_pose(s.bodies, s.shapes, i); });
    archive(s.islands.all), archive(s.islands.free), archive(s.islands.awake);
    archive(s.islands.falling_asleep), archive(s.islands.waking), archive(s.islands.sleep_requests);
    archive(s.characters.all);
}

static_assert(sizeof(ContactRecord) == 192, "ContactRecord has another member: used_record keeps or clears it");

// The contact record reduced to the members in use. Contacts that have separated, unused slots, and contacts that had
// more points before keep stale data until it is overwritten; in a pile this is nearly half of all records.
inline const ContactRecord& used_record(const ContactInfo& c, const ContactRecord& r, ContactRecord& room) {
    if (c.in_use && c.point_count > 1) return r;
    room = {};
    if (!c.in_use) return room;
    if (c.point_count == 1) {
        room = r;
        std::memset(static_cast<void*>(room.more_points), 0, sizeof room.more_points);
        std::memset(static_cast<void*>(room.more_totals), 0, sizeof room.more_totals);
        if (r.radius_a == on_face || r.radius_b == on_face || are_round(r))
            std::copy_n(r.more_points[0], 4, room.more_points[0]);
        return room;
    }
    room.friction = r.friction, room.static_friction = r.static_friction, room.restitution = r.restitution;
    room.rolling_radius = r.rolling_radius, room.torsion_radius = r.torsion_radius;
    room.approach_speed = r.approach_speed;
    if (c.kind == PairKind::box_box || c.kind == PairKind::convex_convex) room.features = r.features;
    if (c.touching || c.kind >= PairKind::convex_plane)
        std::copy_n(r.normal, 3, room.normal); // initial guess of the next test
    if (c.touching) { // touches by an impact, which records a contact point that the solver does not have
        std::copy_n(r.first_point, 4, room.first_point);
        room.first_total = r.first_total;
    }
    return room;
}

template <class Archive> void serialize_contacts(Archive& archive, State& s) {
    const Contacts& contacts = s.contacts;
    const auto used = [&](auto& list) {
        return [&](std::size_t i, auto& room) -> const auto& {
            if (contacts.info[i].in_use) return list[i];
            return room = {};
        };
    };
    archive.live_part(s.contacts.records.whole(), [&](std::size_t i, ContactRecord& room) -> const ContactRecord& {
        return used_record(contacts.info[i], contacts.records[i], room);
    });
    archive.live_part(s.contacts.info, used(contacts.info)),
        archive.live_part(s.contacts.separation_budgets, used(contacts.separation_budgets));
    archive(s.contacts.free);
}

static_assert(field_count<JointInfo>() == 26, "JointInfo has another member: if definitions set it, and not steps, "
                                              "moving_part, serialize_joints and serialize_defined_joints name it");
static_assert(field_count<JointAxes>() == 2, "JointAxes has another member: archive it with states or with rules");

// A joint without the members that its definition determines.
inline JointInfo moving_part(const JointInfo& joint) {
    JointInfo moving = joint;
    moving.anchor_a = moving.anchor_b = moving.ground_a = moving.ground_b = {};
    moving.frame_a = moving.frame_b = {};
    return moving;
}

inline void serialize_joints(SetAside& aside, State& s) { aside.in_part(s.joints.info), aside.in_part(s.joints.axes); }
template <class Archive> void serialize_joints(Archive& archive, State& s) {
    std::vector<JointInfo> moving;
    std::vector<std::array<JointAxisState, max_joint_axes>> states(s.joints.axes.size());
    if constexpr (!Archive::reading) {
        for (const JointInfo& joint : s.joints.info) moving.push_back(moving_part(joint));
        for (std::size_t i = 0; i < states.size(); ++i)
            std::copy_n(s.joints.axes[i].states, max_joint_axes, states[i].begin());
    }
    archive(moving), archive(states);
    if constexpr (Archive::reading) {
        require_count("joints.info", moving.size(), s.joints.info.size());
        require_count("joints.axes", states.size(), s.joints.axes.size());
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

// Counters of the last step. Other statistics follow from the state, and times differ from run to run.
CAIRN_ARCHIVES_MEMBERS(21, Statistics);
template <class Archive> void serialize_counters(Archive& archive, State& s) {
    archive(s.steps), archive(s.time), archive(s.clamped_speeds);
    archive(s.statistics.tested_pairs), archive(s.statistics.max_penetration), archive(s.statistics.swept_pairs);
    archive(s.statistics.impacts), archive(s.statistics.stopped_bodies);
    serialize_fields(archive, s.events.ends.next), serialize_fields(archive, s.events.triggers.next);
    serialize_fields(archive, s.events.joints.next), serialize_fields(archive, s.events.sleeps.next);
}

// Sets the world number in the handles of events that were read, as handles are saved without it.
inline void name_world_in_events(State& s) {
    const auto name = [world = s.bodies.slots.world()](auto&... ids) { (name_world(ids, world), ...); };
    for (ContactEnd& e : s.events.ends.next) name(e.shape_a, e.shape_b, e.body_a, e.body_b);
    for (TriggerEvent& e : s.events.triggers.next) name(e.trigger, e.other, e.trigger_body, e.other_body);
    for (JointEvent& e : s.events.joints.next) name(e.joint, e.body_a, e.body_b);
    for (SleepEvent& e : s.events.sleeps.next) name(e.body);
}

// The parts of a snapshot's bytes, in order.
enum class StatePart : std::uint8_t { bodies, contacts, joints, broad_phase, other };

// Calls `end_part(part)` after each part.
template <class Archive, class F> void serialize_state(Archive& archive, State& s, F&& end_part) {
    serialize_bodies(archive, s), end_part(StatePart::bodies);
    serialize_contacts(archive, s), end_part(StatePart::contacts);
    serialize_joints(archive, s), end_part(StatePart::joints);
    s.broad_phase.serialize(archive), end_part(StatePart::broad_phase);
    serialize_counters(archive, s), end_part(StatePart::other);
}

} // namespace cairn
