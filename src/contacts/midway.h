// Contacts of shapes that already touch are found at the poses that are expected in the middle of the step.
#pragma once

#include "contacts/contact_update.h"
#include "contacts/convex_tests.h"
#include "contacts/flight.h"
#include "contacts/round_touch.h"

namespace cairn {

// The time, s from the start of the step, at which contacts are found: the mean of the times at which the substeps
// begin. A contact is found once and acts in each substep. The contact points of a rocking body move all the time: if
// they are found at the start of the step, they lag by this time and feed energy into the motion
// (tests/physics/rocking_test.cpp).
inline float midway_time(int substeps, float dt) { return dt * float(substeps - 1) / float(2 * substeps); }

// Computes the poses in the middle of the step, for all shapes of the moving bodies that have a pair to test.
void pose_midway(const Bodies& bodies, const Shapes& shapes, NarrowScratch& narrow, ThreadPool& thread_pool,
                 float time);

// Whether the contact of two bodies may be found in the middle of the step: one of them moves, and their relative
// displacement until then is at most `farthest`, m. With one substep, the middle of the step is its start.
inline bool may_be_midway(const NarrowScratch& narrow, const ContactInfo& c, float time, float farthest) {
    if (!(time > 0) || c.is_trigger) return false;
    const MotionAhead &a = narrow.motion_ahead[std::size_t(c.body_a)], &b = narrow.motion_ahead[std::size_t(c.body_b)];
    if (!a.moves && !b.moves) return false;
    const math::Vec3 passing = time * (b.v - a.v);
    return math::dot(passing, passing) <= farthest * farthest;
}
// Whether a body rotates by a large angle until the middle of the step.
inline bool turns_until_midway(math::Vec3 w, float time) {
    constexpr float small = 0.25f; // rad, until the middle of the step: rotations up to this keep a contact's normal
    return time * time * math::dot(w, w) > small * small;
}
// Whether one of the bodies rotates that far, or may not be where its velocities predict because it has joints. Then
// only contacts that keep their normals are found in the middle of the step.
inline bool may_leave_predicted_path(const NarrowScratch& narrow, const ContactInfo& c, float time) {
    for (const std::int32_t b : {c.body_a, c.body_b}) {
        const MotionAhead& motion = narrow.motion_ahead[std::size_t(b)];
        if (motion.has_joints || turns_until_midway(motion.w, time)) return true;
    }
    return false;
}
// Whether a contact keeps its normal: it was last that of a face or of two edges, and these tilt little.
inline bool keeps_normal(const Bodies& bodies, const Shapes& shapes, const ContactInfo& c, const ContactRecord& r,
                         float time) {
    if (!has_own_normal(shapes, c, r)) return false;
    const math::Vec3 normal = math::to_vec(r.normal);
    for (const std::uint32_t shape : {c.shape_a, c.shape_b}) {
        const math::Vec3 w = bodies.motion[shapes.links[shape].body].w;
        if (turns_until_midway(tilting_part(shapes.geometry[shape], shapes.poses[shape], w, normal), time))
            return false;
    }
    return true;
}

// Whether a pair is tested in the middle of the step: it touches, and its relative displacement until then is within
// the margin. A shape that slides or rolls fast may be over another shape by then. Pairs of round surfaces need no such
// test: the solver updates their normal in each substep.
inline bool is_looked_for_midway(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts,
                                 const NarrowScratch& narrow, std::uint32_t id, float time) {
    const ContactInfo& c = contacts.info[id];
    if (!c.touching || c.point_count == 0 || (c.point_count == 1 && c.is_round_touch) ||
        !may_be_midway(narrow, c, time, c.base_margin))
        return false;
    return !may_leave_predicted_path(narrow, c, time) || keeps_normal(bodies, shapes, c, contacts.records[id], time);
}

inline const ShapePose& midway_pose(const Shapes& shapes, const NarrowScratch& narrow, std::uint32_t shape,
                                    std::int32_t body) {
    return narrow.motion_ahead[std::size_t(body)].moves ? narrow.midway_poses[shape] : shapes.poses[shape];
}
inline PosedShape shape_midway(const Shapes& shapes, const NarrowScratch& narrow, std::uint32_t shape,
                               std::int32_t body) {
    return {shapes.geometry[shape], shapes.data[shape], midway_pose(shapes, narrow, shape, body),
            narrow.motion_ahead[std::size_t(body)].moves ? narrow.midway_arms[shape] : shapes.links[shape].arm};
}

inline Moment moment_midway(const Bodies& bodies, const Shapes& shapes, const NarrowScratch& narrow,
                            const ContactInfo& c, float time) {
    const BodyMotion &a = bodies.motion[c.body_a], &b = bodies.motion[c.body_b];
    const PosedShape first = c.flipped ? shape_midway(shapes, narrow, c.shape_b, c.body_b)
                                       : shape_midway(shapes, narrow, c.shape_a, c.body_a);
    return {time, first.arm, math::to_float(a.x - b.x) + time * (a.v - b.v),
            &midway_pose(shapes, narrow, c.shape_a, c.body_a), &midway_pose(shapes, narrow, c.shape_b, c.body_b)};
}

} // namespace cairn
