// Contacts of what touches already: in the middle of the step.
#pragma once

#include "contacts/contact_update.h"
#include "contacts/convex_tests.h"
#include "contacts/flight.h"
#include "contacts/round_touch.h"

namespace cairn {

// s from the start of the step: the mean of the times at which its substeps begin. A contact acts in each of them as it
// is found once. What rocks moves its place of touch all the time: found at the start, it is late by this, and feeds
// the motion (tests/physics/rocking_test.cpp).
inline float midway_time(int substeps, float dt) { return dt * float(substeps - 1) / float(2 * substeps); }

// What will have moved by less than a micrometer is where it is.
inline bool moves_until_midway(const Bodies& bodies, std::int32_t body) {
    constexpr double still = 2e-6; // m, in the whole step
    return moves(bodies, body) && bodies.ahead[body] - bodies.travel[body] > budget_of(still);
}

// Poses all shapes of the bodies that move and have met something.
void pose_midway(const Bodies& bodies, const Shapes& shapes, NarrowScratch& narrow, ThreadPool& thread_pool,
                 float time);

// Whether what touches, with that normal, may be looked for there: it moves, tilts little until then, and does not pass
// the other by more than `farthest`, m. The middle of a step of one substep is its start. Normal 0: of several.
inline bool may_be_midway(const Bodies& bodies, const Shapes& shapes, const ContactInfo& c, math::Vec3 normal,
                          float time, float farthest) {
    if (!(time > 0) || c.is_trigger) return false;
    if (!moves_until_midway(bodies, c.body_a) && !moves_until_midway(bodies, c.body_b)) return false;
    const auto is_far = [&](math::Vec3 w) {
        constexpr float small = 0.25f; // rad
        return time * time * math::dot(w, w) > small * small;
    };
    for (const std::uint32_t shape : {c.shape_a, c.shape_b}) {
        const math::Vec3 w = bodies.motion[shapes.links[shape].body].w;
        if (is_far(w) && is_far(tilting_part(shapes.geometry[shape], shapes.poses[shape], w, normal))) return false;
    }
    const math::Vec3 passing = time * (bodies.motion[c.body_b].v - bodies.motion[c.body_a].v);
    return math::dot(passing, passing) <= farthest * farthest;
}

// Bodies with joints may be elsewhere by then than their velocities say: what would have another normal there is asked
// where it is.
inline bool is_led_by_joints(const Bodies& bodies, const ContactInfo& c) {
    return bodies.links[c.body_a].joint_count > 0 || bodies.links[c.body_b].joint_count > 0;
}

// Whether a pair is looked for there: it has met, and does not pass by more than the margin. What slides or rolls on in
// haste may be over another shape by then.
inline bool is_looked_for_midway(const Bodies& bodies, const Shapes& shapes, const Contacts& contacts, std::uint32_t id,
                                 float time) {
    const ContactInfo& c = contacts.info[id];
    if (!c.touching || c.point_count == 0) return false;
    const ContactRecord& r = contacts.records[id];
    return may_be_midway(bodies, shapes, c, math::to_vec(r.normal), time, c.base_margin) &&
           (!is_led_by_joints(bodies, c) || has_own_normal(shapes, c, r));
}

inline const ShapePose& midway_pose(const Bodies& bodies, const Shapes& shapes, const NarrowScratch& narrow,
                                    std::uint32_t shape) {
    return moves_until_midway(bodies, shapes.links[shape].body) ? narrow.midway_poses[shape] : shapes.poses[shape];
}
inline PosedShape shape_midway(const Bodies& bodies, const Shapes& shapes, const NarrowScratch& narrow,
                               std::uint32_t shape) {
    const bool is_moving = moves_until_midway(bodies, shapes.links[shape].body);
    return {shapes.geometry[shape], shapes.data[shape], midway_pose(bodies, shapes, narrow, shape),
            is_moving ? narrow.midway_arms[shape] : shapes.links[shape].arm};
}

inline Moment moment_midway(const Bodies& bodies, const Shapes& shapes, const NarrowScratch& narrow,
                            const ContactInfo& c, float time) {
    const BodyMotion &a = bodies.motion[c.body_a], &b = bodies.motion[c.body_b];
    return {time, shape_midway(bodies, shapes, narrow, c.flipped ? c.shape_b : c.shape_a).arm,
            math::to_float(a.x - b.x) + time * (a.v - b.v), &midway_pose(bodies, shapes, narrow, c.shape_a),
            &midway_pose(bodies, shapes, narrow, c.shape_b)};
}

} // namespace cairn
