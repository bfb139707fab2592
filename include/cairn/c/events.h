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

/// Two shapes no longer touch, or one of them was removed (its handles are stale then).
typedef struct cairn_contact_end {
    cairn_shape_id shape_a;
    cairn_shape_id shape_b;
    cairn_body_id body_a;
    cairn_body_id body_b;
} cairn_contact_end;

/// Two shapes began to touch with an approach speed of at least WorldDef::hit_speed.
typedef struct cairn_contact_hit {
    cairn_shape_id shape_a;
    cairn_shape_id shape_b;
    cairn_body_id body_a;
    cairn_body_id body_b;
    cairn_position point; ///< Meters, world space.
    cairn_vec3 normal; ///< Unit, from A to B.
    float approach_speed; ///< m/s, > 0.
    /// When they met: seconds after the beginning of the last step, 0 to its length (but for rounding). Of what bounces
    /// or passes far in a step, the moment of the impact, on a straight way through the step: with gravity at 60 Hz
    /// that is within 0.4 mm of the true way. Of what comes to rest on something, and of bodies that touch others
    /// already or hang on joints: when the gap would close at the approach speed with which the step (or the pass of
    /// it, where something spins) began, without what forces and other contacts do until then; at the end of it at the
    /// latest, as the solver may stop it a substep early, and at its beginning if they overlapped by then. Hits are not
    /// listed in its order. (0 to the step)
    float time;
    /// Of a mesh or height field, where it was hit: the number of its material there (0: that of the shape). Of other
    /// shapes 0.
    int surface_material;
} cairn_contact_hit;

/// A shape began or ceased to overlap a trigger (ShapeDef::is_trigger). Triggers see what is on dynamic and kinematic
/// bodies, characters too; those on dynamic and kinematic bodies see static ones as well. They do not see each other.
/// It is seen at the beginning of each step: what comes in is told after the next one. What passes through within a
/// step has both events in that one, behind those of the beginning, in the order of their times. Handles of what was
/// removed are stale.
typedef struct cairn_trigger_event {
    cairn_shape_id trigger;
    cairn_shape_id other;
    cairn_body_id trigger_body;
    cairn_body_id other_body;
    bool inside; ///< true: it came in; false: it left, or one of the two was removed.
    /// Seconds after the beginning of the last step, 0 to its length: 0 for what is seen there; of what passes within
    /// it, when it came in and when it left, on the way that it took. (0 to the step)
    float time;
} cairn_trigger_event;

/// A joint is gone: it broke under its load, or one of its bodies was destroyed. Its handle is stale.
typedef struct cairn_joint_event {
    cairn_joint_id joint;
    cairn_body_id body_a; ///< Null: the world.
    cairn_body_id body_b; ///< Null: the world.
    bool broke; ///< false: a body was destroyed.
    float force; ///< N: at which it broke.
    float torque; ///< N m: likewise.
    uint64_t user_data; ///< Of its definition.
} cairn_joint_event;

/// A body fell asleep or woke up.
typedef struct cairn_sleep_event {
    cairn_body_id body;
    bool asleep; ///< false: it woke up.
} cairn_sleep_event;

/// One point of a contact.
typedef struct cairn_contact_point {
    cairn_position point; ///< Midway between the two surfaces, meters.
    float separation; ///< Meters; negative when the shapes overlap.
    float normal_impulse; ///< N s during the last step, >= 0. Divide by the step for the mean force.
} cairn_contact_point;

/// A touching pair of shapes as it stood after the last step. A shape may touch a mesh or height field, and the
/// surfaces of several of its faces, in several of these, one for each normal and material.
typedef struct cairn_contact {
    cairn_shape_id shape_a;
    cairn_shape_id shape_b;
    cairn_body_id body_a;
    cairn_body_id body_b;
    cairn_vec3 normal; ///< Unit, from A to B.
    cairn_vec3 friction_impulse; ///< N s on B during the last step, world axes.
    int point_count; ///< 1 to 4.
    cairn_contact_point points[4]; ///< The first `point_count` of them.
    /// Of a mesh or height field there: the number of its material (0: that of the shape). Of other shapes 0.
    int surface_material;
} cairn_contact;

/// Shapes that began to touch in the last step. `count` gets how many there are; the first `capacity` of them are
/// written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_contact_begins(const cairn_world* world, cairn_contact_begin* contact_begins,
                                                        size_t capacity, size_t* count);

/// Shapes that ceased to touch in the last step. `count` gets how many there are; the first `capacity` of them are
/// written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_contact_ends(const cairn_world* world, cairn_contact_end* contact_ends,
                                                      size_t capacity, size_t* count);

/// Shapes that hit each other in the last step, at `WorldDef.hit_speed` or more. `count` gets how many there are; the
/// first `capacity` of them are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_contact_hits(const cairn_world* world, cairn_contact_hit* contact_hits,
                                                      size_t capacity, size_t* count);

/// What came into triggers and left them in the last step. `count` gets how many there are; the first `capacity` of
/// them are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_trigger_events(const cairn_world* world, cairn_trigger_event* trigger_events,
                                                        size_t capacity, size_t* count);

/// Joints that broke or lost a body in the last step, or since. `count` gets how many there are; the first `capacity`
/// of them are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_joint_events(const cairn_world* world, cairn_joint_event* joint_events,
                                                      size_t capacity, size_t* count);

/// Bodies that fell asleep or woke up in the last step. `count` gets how many there are; the first `capacity` of them
/// are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_sleep_events(const cairn_world* world, cairn_sleep_event* sleep_events,
                                                      size_t capacity, size_t* count);

/// All touching pairs. `count` gets how many there are; the first `capacity` of them are written. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_contacts(const cairn_world* world, cairn_contact* contacts, size_t capacity,
                                                  size_t* count);

/// Those of one body. `count` gets how many there are; the first `capacity` of them are written. Errors:
/// invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_contacts(const cairn_world* world, cairn_body_id body, cairn_contact* contacts,
                                                 size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_EVENTS_H
