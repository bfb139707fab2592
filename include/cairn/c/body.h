// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#ifndef CAIRN_C_BODY_H
#define CAIRN_C_BODY_H

#include <cairn/c/shape.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// How a body moves.
typedef int32_t cairn_body_type;
enum {
    CAIRN_BODY_TYPE_STATIC = 0, ///< Never moves by itself.
    /// Moves with the velocity it is given, and turns about its origin; nothing pushes it.
    CAIRN_BODY_TYPE_KINEMATIC = 1,
    CAIRN_BODY_TYPE_DYNAMIC = 2 ///< Moves by forces and contacts.
};

/// What a character is on.
typedef int32_t cairn_character_support;
enum {
    CAIRN_CHARACTER_SUPPORT_NONE = 0, ///< It is in the air, or flies.
    CAIRN_CHARACTER_SUPPORT_STEEP = 1, ///< It slides down something steeper than `CharacterDef.max_slope`.
    CAIRN_CHARACTER_SUPPORT_GROUND = 2 ///< It stands.
};

/// Mass, center of mass and inertia of a body. A `mass` of +infinity, and zero entries of `inertia_diagonal`, stand for
/// what cannot be moved or turned.
typedef struct cairn_mass_properties {
    float mass; ///< kg, > 0; may be infinite.
    cairn_vec3 center_of_mass; ///< In the body's frame, meters.
    cairn_vec3 inertia_diagonal; ///< Principal moments about the center of mass, kg m^2.
    cairn_quat inertia_orientation; ///< Rotation from principal axes to the body's frame.
} cairn_mass_properties;
CAIRN_C_API cairn_mass_properties cairn_default_mass_properties(void);

/// Everything needed to make a body. Begin from `cairn_default_body_def()`.
typedef struct cairn_body_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_body_def` sets it.
    cairn_body_type type; ///< How it moves.
    cairn_position position; ///< Origin of the body's frame (not its center of mass), meters.
    cairn_quat rotation; ///< Normalized on entry; must not be zero.
    cairn_vec3 linear_velocity; ///< Of the center of mass, m/s.
    cairn_vec3 angular_velocity; ///< In world axes, rad/s.
    float linear_damping; ///< 1/s, >= 0: velocity decays as v' = -damping v.
    float angular_damping; ///< 1/s, >= 0.
    float gravity_scale; ///< Multiplies the world's gravity for this body; any finite value.
    bool allow_sleep; ///< false: the body and its island never fall asleep.
    bool has_mass; ///< Whether `mass` is given.
    float mass; ///< kg, > 0 (+infinity: immovable). Absent: from the shapes' densities.
    bool has_mass_properties; ///< Whether `mass_properties` is given.
    cairn_mass_properties mass_properties; ///< Overrides mass and shapes altogether.
    const char* name; ///< For people; need not be unique. UTF-8; null: empty.
    uint64_t user_data; ///< Not touched by the engine.
    bool enabled; ///< false: it takes no part in the world until it is enabled.
} cairn_body_def;
CAIRN_C_API cairn_body_def cairn_default_body_def(void);

/// How a character moves. A character is a kinematic body that is moved at the beginning of each step: it slides along
/// walls, climbs steps, stands on slopes, falls, is carried by what it stands on, and never passes through anything
/// that its shapes collide with. Its shapes must be convex to count; a capsule along `up` is usual. It does not turn by
/// itself, but for what it stands on. Begin from `cairn_default_character_def()`.
typedef struct cairn_character_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_character_def` sets it.
    cairn_vec3 up; ///< Away from the ground; any non-zero vector, it is normalized.
    float max_slope; ///< rad, 0 to 1.57: it slides down what is steeper, and does not walk up there.
    float step_height; ///< m, >= 0: it climbs steps up to this height; 0: none.
    float stick_distance; ///< m, >= 0: it stays on ground that falls away by up to this in a step.
    float skin; ///< m, 1e-4 to 1: the distance that it keeps from everything.
    float mass; ///< kg, >= 0: what dynamic bodies feel that it stands on, lands on or jumps off.
    float max_push_force; ///< N, >= 0: it pushes dynamic bodies out of its way with no more than this.
    float air_acceleration; ///< m/s^2, >= 0: how fast its velocity follows the wanted one in the air.
    /// It moves with the wanted velocity in all directions, without gravity, ground and steps: for swimming, ladders,
    /// flying.
    bool flies;
} cairn_character_def;
CAIRN_C_API cairn_character_def cairn_default_character_def(void);

/// How a character moves, as it stood after the last step.
typedef struct cairn_character_state {
    cairn_character_support support; ///< What it is on.
    /// m/s, in world axes, that of the ground included. Unlike the velocity of its body, which is by how much the last
    /// step moved it, it is without steps that were climbed, and in the air it is that at the end of the step.
    cairn_vec3 velocity;
    cairn_shape_id ground_shape; ///< What it is on; null in the air, and when that was removed.
    cairn_body_id ground_body; ///< Its body.
    cairn_position ground_point; ///< Where it touches that, m; valid unless `support` is none.
    cairn_vec3 ground_normal; ///< Unit, out of it; likewise.
    cairn_vec3 ground_velocity; ///< m/s, of its material there; likewise.
} cairn_character_state;

/// Makes a body without shapes. Null for `def`: the default. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_create_body(cairn_world* world, const cairn_body_def* def, cairn_body_id* result);

/// With its shapes and joints; wakes what rested on it. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_destroy_body(cairn_world* world, cairn_body_id body);

/// Whether the handle names a body that exists.
CAIRN_C_API bool cairn_body_is_valid(const cairn_world* world, cairn_body_id body);

/// All, in order of slot index. `count` gets how many there are; the first `capacity` of them are written. Errors:
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_get_bodies(const cairn_world* world, cairn_body_id* bodies, size_t capacity,
                                                size_t* count);

/// The first of that name. `found` gets whether there is any. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_find_body(const cairn_world* world, const char* name, cairn_body_id* result,
                                               bool* found);

/// How the body moves. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_type(const cairn_world* world, cairn_body_id body, cairn_body_type* type);

/// The name of its definition. `length` gets its length without the final zero; what has no room in `capacity` bytes is
/// cut off. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_name(const cairn_world* world, cairn_body_id body, char* text, size_t capacity,
                                             size_t* length);

/// The number of its definition. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_user_data(const cairn_world* world, cairn_body_id body, uint64_t* user_data);

/// Origin of the body's frame, meters. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_position(const cairn_world* world, cairn_body_id body,
                                                 cairn_position* position);

/// Rotation of the body's frame, of unit length. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_rotation(const cairn_world* world, cairn_body_id body, cairn_quat* rotation);

/// Place and rotation of the body's frame. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_transform(const cairn_world* world, cairn_body_id body,
                                                  cairn_transform* transform);

/// In world space, meters; of kinematic bodies, their origin, if not given. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_center_of_mass(const cairn_world* world, cairn_body_id body,
                                                       cairn_position* center_of_mass);

/// Of the center of mass, m/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_linear_velocity(const cairn_world* world, cairn_body_id body,
                                                        cairn_vec3* linear_velocity);

/// rad/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_angular_velocity(const cairn_world* world, cairn_body_id body,
                                                         cairn_vec3* angular_velocity);

/// Of the body's material at a world point, m/s. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_velocity_at(const cairn_world* world, cairn_body_id body, cairn_position point,
                                                    cairn_vec3* velocity_at);

/// kg; +infinity for static and kinematic bodies. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_mass(const cairn_world* world, cairn_body_id body, float* mass);

/// Mass, center of mass and inertia, as set or computed from the shapes. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_mass_properties(const cairn_world* world, cairn_body_id body,
                                                        cairn_mass_properties* mass_properties);

/// About the center of mass, world axes, kg m^2. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_world_inertia(const cairn_world* world, cairn_body_id body,
                                                      cairn_mat3* world_inertia);

/// About the center of mass, kg m^2/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_angular_momentum(const cairn_world* world, cairn_body_id body,
                                                         cairn_vec3* angular_momentum);

/// Linear and rotational, J; 0 for static and kinematic bodies. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_kinetic_energy(const cairn_world* world, cairn_body_id body,
                                                       double* kinetic_energy);

/// What gravity is multiplied with for this body. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_gravity_scale(const cairn_world* world, cairn_body_id body,
                                                      float* gravity_scale);

/// 1/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_linear_damping(const cairn_world* world, cairn_body_id body,
                                                       float* linear_damping);

/// 1/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_angular_damping(const cairn_world* world, cairn_body_id body,
                                                        float* angular_damping);

/// Static bodies never are; kinematic ones are while they move. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_is_awake(const cairn_world* world, cairn_body_id body, bool* result);

/// Whether it may fall asleep. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_allow_sleep(const cairn_world* world, cairn_body_id body, bool* allow_sleep);

/// Whether it takes part in the world. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_enabled(const cairn_world* world, cairn_body_id body, bool* enabled);

/// Its shapes, oldest first. `count` gets how many there are; the first `capacity` of them are written. Errors:
/// invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_shapes(const cairn_world* world, cairn_body_id body, cairn_shape_id* shapes,
                                               size_t capacity, size_t* count);

/// Teleports the body: velocities stay, contacts are found anew. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_transform(cairn_world* world, cairn_body_id body, cairn_position position,
                                                  cairn_quat rotation);

/// Teleports the origin of the body's frame: velocities stay, contacts are found anew. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_position(cairn_world* world, cairn_body_id body, cairn_position position);

/// Turns the body in place: velocities stay, contacts are found anew. Normalized on entry; must not be zero. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_rotation(cairn_world* world, cairn_body_id body, cairn_quat rotation);

/// Sets the velocity of the center of mass, m/s. Not of static bodies. Errors: invalid_handle, invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_body_set_linear_velocity(cairn_world* world, cairn_body_id body, cairn_vec3 velocity);

/// Sets the angular velocity, rad/s, world axes. Not of static bodies. Errors: invalid_handle, invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_body_set_angular_velocity(cairn_world* world, cairn_body_id body, cairn_vec3 velocity);

/// Kinematic bodies: sets the velocities that bring the body to `target` in `seconds` (> 0). Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_move_to(cairn_world* world, cairn_body_id body, cairn_transform target,
                                            float seconds);

/// Multiplies gravity for this body; any finite value. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_gravity_scale(cairn_world* world, cairn_body_id body, float scale);

/// 1/s, >= 0: the velocities decay as v' = -damping v. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_damping(cairn_world* world, cairn_body_id body, float linear, float angular);

/// false: the body and its island never fall asleep. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_allow_sleep(cairn_world* world, cairn_body_id body, bool allow);

/// Makes the body static, kinematic or dynamic. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_type(cairn_world* world, cairn_body_id body, cairn_body_type type);

/// Takes a body out of the world and puts it back, with its shapes, joints and handles as they are: for what is used
/// again and again, or not yet. What is disabled does not move and keeps its velocities; nothing touches it, queries do
/// not see it, its joints do not act, and energies and momenta are without it. All of it may be changed, but nothing
/// can push it: forces and impulses are refused (wrong_state). What it touched ends with a ContactEnd, and wakes; where
/// it is put back into something, it is pushed out as what is made there. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_enabled(cairn_world* world, cairn_body_id body, bool enabled);

/// For people; need not be unique. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_name(cairn_world* world, cairn_body_id body, const char* name);

/// Replaces the mass properties; they no longer follow the shapes. Dynamic bodies only. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_mass_properties(cairn_world* world, cairn_body_id body,
                                                        const cairn_mass_properties* properties);

/// Mass properties follow the shapes' densities again, scaled to `mass` if given. Null for `mass`: absent. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_mass_from_shapes(cairn_world* world, cairn_body_id body, const float* mass);

/// Wakes the body and its island. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_wake(cairn_world* world, cairn_body_id body);

/// Brings a dynamic body to rest and lets it sleep from the next step on, as it is, even in the air: before anything
/// moves, provided that all that touches it or is joined to it was told so, too, and may sleep. A level that is made
/// asleep costs nothing until something comes; then it settles like anything that is made. What moves or pushes the
/// body in between wakes it, as ever. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_sleep(cairn_world* world, cairn_body_id body);

/// N, at the center of mass; acts during the next step only. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_add_force(cairn_world* world, cairn_body_id body, cairn_vec3 force);

/// N, at a world point; next step only. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_add_force_at(cairn_world* world, cairn_body_id body, cairn_vec3 force,
                                                 cairn_position point);

/// N m; next step only. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_add_torque(cairn_world* world, cairn_body_id body, cairn_vec3 torque);

/// N s, at the center of mass; changes the velocity at once. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_apply_impulse(cairn_world* world, cairn_body_id body, cairn_vec3 impulse);

/// N s, at a world point. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_apply_impulse_at(cairn_world* world, cairn_body_id body, cairn_vec3 impulse,
                                                     cairn_position point);

/// N m s. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_apply_angular_impulse(cairn_world* world, cairn_body_id body, cairn_vec3 impulse);

/// Whether the body is a character. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_is_character(const cairn_world* world, cairn_body_id body, bool* result);

/// How the character moves (wrong_state unless it is one). Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_character(const cairn_world* world, cairn_body_id body,
                                                  cairn_character_def* character);

/// Makes a kinematic body a character, or changes how one moves. From then on its velocities are those with which each
/// step moves it, and setting its linear velocity throws it: upwards, it leaves the ground. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_character(cairn_world* world, cairn_body_id body,
                                                  const cairn_character_def* def);

/// It is an ordinary kinematic body again, at rest. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_remove_character(cairn_world* world, cairn_body_id body);

/// Where the character wants to go, m/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_walk_velocity(const cairn_world* world, cairn_body_id body,
                                                      cairn_vec3* walk_velocity);

/// Where a character wants to go, m/s, until it is set anew: over the ground, with this speed and, seen from above, in
/// this direction, beside the motion of the ground itself. What of it leads up or down counts for those alone that fly.
/// Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_walk_velocity(cairn_world* world, cairn_body_id body, cairn_vec3 velocity);

/// In the next step, a character that stands on the ground leaves it with this speed, m/s, > 0; others do not. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_jump(cairn_world* world, cairn_body_id body, float speed);

/// How the character moves and what it is on, as it stood after the last step. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_character_state(const cairn_world* world, cairn_body_id body,
                                                    cairn_character_state* result);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_BODY_H
