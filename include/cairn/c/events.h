// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#ifndef CAIRN_C_EVENTS_H
#define CAIRN_C_EVENTS_H

#include <cairn/c/query.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Two shapes began to touch.
typedef struct cairn_contact_begin {
    cairn_shape_id shape_a;
    cairn_shape_id shape_b;
    cairn_body_id body_a;
    cairn_body_id body_b;
} cairn_contact_begin;

/// Two shapes ceased to touch, or one of them was removed (its handle is then stale).
typedef struct cairn_contact_end {
    cairn_shape_id shape_a;
    cairn_shape_id shape_b;
    cairn_body_id body_a;
    cairn_body_id body_b;
} cairn_contact_end;

/// Two shapes began to touch with an approach speed of at least `WorldDef.hit_speed`.
typedef struct cairn_contact_hit {
    cairn_shape_id shape_a;
    cairn_shape_id shape_b;
    cairn_body_id body_a;
    cairn_body_id body_b;
    cairn_position point; ///< Point of contact, meters, world space.
    cairn_vec3 normal; ///< Unit normal, from A to B.
    float approach_speed; ///< Approach speed, m/s, > 0.
    /// Time of the hit: seconds after the beginning of the last step, 0 to the step's length (except for rounding).
    /// Hits are not sorted by it. For bodies that bounce, or that move far within the step, it is the time of impact on
    /// a straight path through the step; at 60 Hz under gravity this path is within 0.4 mm of the true one. For bodies
    /// that come to rest, that already touch others, or that have joints, it is the time at which the gap would close
    /// at the approach speed at the beginning of the step (of the current pass through the step where a body spins),
    /// ignoring forces and other contacts until then. It is then limited to the end of the step, because the solver may
    /// stop the approach a substep early, and is 0 if the shapes overlapped at the beginning.
    float time;
    /// Number of the material of the mesh or height field where it was hit (0: the material of the shape); 0 for other
    /// shapes.
    int surface_material;
} cairn_contact_hit;

/// A shape began or ceased to overlap a trigger (`ShapeDef.is_trigger`). Every trigger detects shapes of dynamic and
/// kinematic bodies, including characters; triggers on dynamic and kinematic bodies detect shapes of static bodies as
/// well. Triggers do not detect each other. Overlaps are tested at the beginning of each step, so that a shape that
/// enters in one step is reported by the next. A shape that enters and leaves within one step has both events in that
/// step; these are listed after those found at its beginning, sorted by time. Handles of removed shapes are stale.
typedef struct cairn_trigger_event {
    cairn_shape_id trigger;
    cairn_shape_id other;
    cairn_body_id trigger_body;
    cairn_body_id other_body;
    bool inside; ///< true: the shape entered; false: it left, or one of the two shapes was removed.
    /// Seconds after the beginning of the last step, 0 to the step's length. It is 0 for overlaps found at the
    /// beginning; for a shape that passes through within the step, it is the time at which the shape, on its path,
    /// entered or left.
    float time;
} cairn_trigger_event;

/// A joint was removed by the engine: it broke under its load, or one of its bodies was destroyed. Its handle is stale.
typedef struct cairn_joint_event {
    cairn_joint_id joint;
    cairn_body_id body_a; ///< Null stands for the world.
    cairn_body_id body_b; ///< Null stands for the world.
    bool broke; ///< true: it exceeded its break force or torque; false: one of its bodies was destroyed.
    float force; ///< N: force at which it broke.
    float torque; ///< N m: torque at which it broke.
    uint64_t user_data; ///< The `user_data` from the definition of the joint.
} cairn_joint_event;

/// A body fell asleep or woke up.
typedef struct cairn_sleep_event {
    cairn_body_id body;
    bool asleep; ///< true: it fell asleep; false: it woke up.
} cairn_sleep_event;

/// One contact point of a contact manifold.
typedef struct cairn_contact_point {
    cairn_position point; ///< Midway between the two surfaces, meters, world space.
    float separation; ///< Meters; negative when the shapes overlap.
    /// N s: normal impulse during the last step, >= 0. Divided by the length of the step it is the mean force.
    float normal_impulse;
} cairn_contact_point;

/// A contact manifold of a touching pair of shapes, after the last step. A shape that touches a mesh or height field
/// may have several manifolds with it, one for each normal and material.
typedef struct cairn_contact {
    cairn_shape_id shape_a;
    cairn_shape_id shape_b;
    cairn_body_id body_a;
    cairn_body_id body_b;
    cairn_vec3 normal; ///< Unit normal, from A to B.
    cairn_vec3 friction_impulse; ///< N s: friction impulse on B during the last step, world axes.
    int point_count; ///< Number of contact points, 1 to 4.
    cairn_contact_point points[4]; ///< The contact points; only the first `point_count` elements are valid.
    /// Number of the material of the mesh or height field at the contact (0: the material of the shape); 0 for other
    /// shapes.
    int surface_material;
} cairn_contact;

/// Pairs of shapes that began to touch in the last step. `count` receives their number; the first `capacity` of them
/// are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_contact_begins(const cairn_world* world, cairn_contact_begin* contact_begins,
                                                        size_t capacity, size_t* count);

/// Pairs of shapes that ceased to touch in the last step. `count` receives their number; the first `capacity` of them
/// are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_contact_ends(const cairn_world* world, cairn_contact_end* contact_ends,
                                                      size_t capacity, size_t* count);

/// Pairs of shapes that hit each other in the last step with an approach speed of at least `WorldDef.hit_speed`.
/// `count` receives their number; the first `capacity` of them are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_contact_hits(const cairn_world* world, cairn_contact_hit* contact_hits,
                                                      size_t capacity, size_t* count);

/// Shapes that entered or left triggers in the last step. `count` receives their number; the first `capacity` of them
/// are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_trigger_events(const cairn_world* world, cairn_trigger_event* trigger_events,
                                                        size_t capacity, size_t* count);

/// Joints that broke, or of which a body was destroyed, in the last step or since then. `count` receives their number;
/// the first `capacity` of them are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_joint_events(const cairn_world* world, cairn_joint_event* joint_events,
                                                      size_t capacity, size_t* count);

/// Bodies that fell asleep or woke up in the last step. `count` receives their number; the first `capacity` of them are
/// written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_sleep_events(const cairn_world* world, cairn_sleep_event* sleep_events,
                                                      size_t capacity, size_t* count);

/// The contact manifolds of all touching pairs of shapes. `count` receives their number; the first `capacity` of them
/// are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_contacts(const cairn_world* world, cairn_contact* contacts, size_t capacity,
                                                  size_t* count);

/// The contact manifolds of one body. `count` receives their number; the first `capacity` of them are written. Errors:
/// invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_contacts(const cairn_world* world, cairn_body_id body, cairn_contact* contacts,
                                                 size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_EVENTS_H
