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
    CAIRN_BODY_TYPE_KINEMATIC = 1, ///< Moves with the velocity it is given; nothing pushes it.
    CAIRN_BODY_TYPE_DYNAMIC = 2 ///< Moves by forces and contacts.
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
} cairn_body_def;
CAIRN_C_API cairn_body_def cairn_default_body_def(void);

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

/// In world space, meters. Errors: invalid_handle, wrong_state.
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

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_BODY_H
