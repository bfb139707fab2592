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
    /// Moves with the velocities that it is given, rotating about its origin. Forces and contacts do not change them.
    CAIRN_BODY_TYPE_KINEMATIC = 1,
    CAIRN_BODY_TYPE_DYNAMIC = 2 ///< Moves by forces and contacts.
};

/// What supports a character.
typedef int32_t cairn_character_support;
enum {
    CAIRN_CHARACTER_SUPPORT_NONE = 0, ///< The character is in the air, or flies.
    CAIRN_CHARACTER_SUPPORT_STEEP = 1, ///< It slides down a slope steeper than `CharacterDef.max_slope`.
    CAIRN_CHARACTER_SUPPORT_GROUND = 2 ///< It stands on the ground.
};

/// Mass, center of mass and inertia of a body. With a `mass` of +infinity forces do not translate the body; a zero
/// entry of `inertia_diagonal` keeps torques from rotating it about that principal axis.
typedef struct cairn_mass_properties {
    float mass; ///< kg, > 0; may be infinite.
    cairn_vec3 center_of_mass; ///< Center of mass in the body's frame, meters.
    cairn_vec3 inertia_diagonal; ///< Principal moments about the center of mass, kg m^2.
    cairn_quat inertia_orientation; ///< Rotation from principal axes to the body's frame.
} cairn_mass_properties;
CAIRN_C_API cairn_mass_properties cairn_default_mass_properties(void);

/// Everything that is needed to create a body. Begin from `cairn_default_body_def()`.
typedef struct cairn_body_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_body_def` sets it.
    cairn_body_type type; ///< How it moves.
    cairn_position position; ///< Origin of the body's frame (not its center of mass), meters.
    cairn_quat rotation; ///< Rotation of the body's frame. Normalized on entry; must not be zero.
    cairn_vec3 linear_velocity; ///< Velocity of the center of mass, m/s.
    cairn_vec3 angular_velocity; ///< Angular velocity in world axes, rad/s.
    float linear_damping; ///< 1/s, >= 0: velocity decays as v' = -damping v.
    float angular_damping; ///< 1/s, >= 0: the same for the angular velocity.
    float gravity_scale; ///< Multiplies the world's gravity for this body; any finite value.
    bool allow_sleep; ///< false: the body and its island never fall asleep.
    bool has_mass; ///< Whether `mass` is given.
    /// Total mass in kg, > 0 (+infinity: immovable), to which the mass properties of the shapes are scaled. Absent: the
    /// mass follows from the densities of the shapes.
    float mass;
    bool has_mass_properties; ///< Whether `mass_properties` is given.
    cairn_mass_properties mass_properties; ///< Used in place of `mass` and of the shapes' densities.
    const char* name; ///< For display and `World::find_body`; need not be unique. UTF-8; null: empty.
    uint64_t user_data; ///< Stored for the application; the engine does not use it.
    bool enabled; ///< false: the body does not take part in the simulation until it is enabled.
} cairn_body_def;
CAIRN_C_API cairn_body_def cairn_default_body_def(void);

/// How a character moves. A character is a kinematic body that is moved at the beginning of each step: it slides along
/// walls, climbs steps, stands on slopes, falls, is carried by the body on which it stands, and never passes through
/// anything that its shapes collide with. Only its convex shapes count; a capsule along `up` is usual. It rotates with
/// the body on which it stands (about `up`), and otherwise only if the application rotates it. Begin from
/// `cairn_default_character_def()`.
typedef struct cairn_character_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_character_def` sets it.
    cairn_vec3 up; ///< Direction away from the ground: any non-zero vector; it is normalized.
    /// rad, 0 to 1.57: greatest slope on which the character stands. It slides down steeper slopes and does not walk up
    /// them.
    float max_slope;
    float step_height; ///< m, >= 0: greatest height of a step that it climbs; 0: it climbs none.
    /// m, >= 0: it stays on the ground where this drops by up to this distance within a time step, as on stairs
    /// downwards.
    float stick_distance;
    float skin; ///< m, 1e-4 to 1: the distance that it keeps from all other shapes.
    /// kg, >= 0: the mass with which it acts on dynamic bodies on which it stands or lands, or from which it jumps.
    float mass;
    float max_push_force; ///< N, >= 0: greatest force with which it pushes dynamic bodies that are in its way.
    float air_acceleration; ///< m/s^2, >= 0: greatest acceleration towards the walk velocity while it is in the air.
    /// true: it moves with the walk velocity in all three directions, and gravity, ground and steps do not act on it:
    /// for swimming, ladders, flying.
    bool flies;
} cairn_character_def;
CAIRN_C_API cairn_character_def cairn_default_character_def(void);

/// The motion and support of a character after the last step.
typedef struct cairn_character_state {
    cairn_character_support support; ///< What supports the character.
    /// m/s, in world axes, including the velocity of the ground. It differs from the velocity of the body, which is the
    /// displacement in the last step divided by its duration: it excludes the height of stairs that were climbed, and
    /// in the air it is the velocity at the end of the step.
    cairn_vec3 velocity;
    /// The shape on which it stands or slides; null in the air, and if that shape was removed.
    cairn_shape_id ground_shape;
    cairn_body_id ground_body; ///< The body of that shape.
    /// Where the character touches that shape, m, world space; valid unless `support` is none.
    cairn_position ground_point;
    cairn_vec3 ground_normal; ///< Unit normal there, out of the ground; valid unless `support` is none.
    cairn_vec3 ground_velocity; ///< m/s: velocity of the ground's material there; valid unless `support` is none.
} cairn_character_state;

/// Creates a body without shapes. Null for `def`: the default. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_create_body(cairn_world* world, const cairn_body_def* def, cairn_body_id* result);

/// Destroys the body with its shapes and joints, and wakes bodies that rested on it. Errors: invalid_handle,
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_destroy_body(cairn_world* world, cairn_body_id body);

/// Whether the handle names a body that exists.
CAIRN_C_API bool cairn_body_is_valid(const cairn_world* world, cairn_body_id body);

/// All bodies, in order of slot index. `count` receives their number; the first `capacity` of them are written. Errors:
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_get_bodies(const cairn_world* world, cairn_body_id* bodies, size_t capacity,
                                                size_t* count);

/// The first body with that name. `found` receives whether there is one. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_find_body(const cairn_world* world, const char* name, cairn_body_id* result,
                                               bool* found);

/// How the body moves. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_type(const cairn_world* world, cairn_body_id body, cairn_body_type* type);

/// The name of the body, as in `BodyDef.name`. `length` receives its length without the terminating zero; text beyond
/// `capacity` bytes is cut off. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_name(const cairn_world* world, cairn_body_id body, char* text, size_t capacity,
                                             size_t* length);

/// The number that the application stored in `BodyDef.user_data`. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_user_data(const cairn_world* world, cairn_body_id body, uint64_t* user_data);

/// Origin of the body's frame, meters. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_position(const cairn_world* world, cairn_body_id body,
                                                 cairn_position* position);

/// Rotation of the body's frame, of unit length. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_rotation(const cairn_world* world, cairn_body_id body, cairn_quat* rotation);

/// Position and rotation of the body's frame. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_transform(const cairn_world* world, cairn_body_id body,
                                                  cairn_transform* transform);

/// Center of mass in world space, meters. For a kinematic body: its origin, unless `BodyDef.mass_properties` gave a
/// center of mass. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_center_of_mass(const cairn_world* world, cairn_body_id body,
                                                       cairn_position* center_of_mass);

/// Velocity of the center of mass, m/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_linear_velocity(const cairn_world* world, cairn_body_id body,
                                                        cairn_vec3* linear_velocity);

/// Angular velocity in world axes, rad/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_angular_velocity(const cairn_world* world, cairn_body_id body,
                                                         cairn_vec3* angular_velocity);

/// Velocity of the body's material at a point in world space, m/s. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_velocity_at(const cairn_world* world, cairn_body_id body, cairn_position point,
                                                    cairn_vec3* velocity_at);

/// Mass, kg; +infinity for static and kinematic bodies. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_mass(const cairn_world* world, cairn_body_id body, float* mass);

/// Mass, center of mass and inertia, as set or computed from the shapes. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_mass_properties(const cairn_world* world, cairn_body_id body,
                                                        cairn_mass_properties* mass_properties);

/// Inertia tensor about the center of mass, world axes, kg m^2. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_world_inertia(const cairn_world* world, cairn_body_id body,
                                                      cairn_mat3* world_inertia);

/// Angular momentum about the center of mass, kg m^2/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_angular_momentum(const cairn_world* world, cairn_body_id body,
                                                         cairn_vec3* angular_momentum);

/// Linear and rotational kinetic energy, J; 0 for static and kinematic bodies. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_kinetic_energy(const cairn_world* world, cairn_body_id body,
                                                       double* kinetic_energy);

/// The factor by which gravity is multiplied for this body. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_gravity_scale(const cairn_world* world, cairn_body_id body,
                                                      float* gravity_scale);

/// Damping of the linear velocity, 1/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_linear_damping(const cairn_world* world, cairn_body_id body,
                                                       float* linear_damping);

/// Damping of the angular velocity, 1/s. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_angular_damping(const cairn_world* world, cairn_body_id body,
                                                        float* angular_damping);

/// Whether the body is awake. A static or disabled body never is; a kinematic body is while one of its velocities is
/// not zero. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_is_awake(const cairn_world* world, cairn_body_id body, bool* result);

/// Whether the body may fall asleep. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_allow_sleep(const cairn_world* world, cairn_body_id body, bool* allow_sleep);

/// Whether the body takes part in the simulation. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_enabled(const cairn_world* world, cairn_body_id body, bool* enabled);

/// The shapes of the body, oldest first. `count` receives their number; the first `capacity` of them are written.
/// Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_shapes(const cairn_world* world, cairn_body_id body, cairn_shape_id* shapes,
                                               size_t capacity, size_t* count);

/// Teleports the body: its velocities stay, and its contacts are detected afresh in the next step. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_transform(cairn_world* world, cairn_body_id body, cairn_position position,
                                                  cairn_quat rotation);

/// Teleports the origin of the body's frame: velocities stay, and contacts are detected afresh in the next step.
/// Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_position(cairn_world* world, cairn_body_id body, cairn_position position);

/// Rotates the body about its origin at once: velocities stay, and contacts are detected afresh in the next step.
/// Normalized on entry; must not be zero. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_rotation(cairn_world* world, cairn_body_id body, cairn_quat rotation);

/// Sets the velocity of the center of mass, m/s. Refused (wrong_state) for static bodies. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_linear_velocity(cairn_world* world, cairn_body_id body, cairn_vec3 velocity);

/// Sets the angular velocity, rad/s, world axes. Refused (wrong_state) for static bodies. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_angular_velocity(cairn_world* world, cairn_body_id body, cairn_vec3 velocity);

/// Sets the velocities of a kinematic body such that it reaches `target` after `seconds` (> 0). It keeps these
/// velocities afterwards. Refused (wrong_state) for bodies of other types. Errors: invalid_handle, invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_body_move_to(cairn_world* world, cairn_body_id body, cairn_transform target,
                                            float seconds);

/// Sets the factor by which gravity is multiplied for this body; any finite value. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_gravity_scale(cairn_world* world, cairn_body_id body, float scale);

/// Sets the damping of the linear and angular velocity, 1/s, >= 0: velocities decay as v' = -damping v. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_damping(cairn_world* world, cairn_body_id body, float linear, float angular);

/// false: the body and its island never fall asleep. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_allow_sleep(cairn_world* world, cairn_body_id body, bool allow);

/// Makes the body static, kinematic or dynamic. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_type(cairn_world* world, cairn_body_id body, cairn_body_type type);

/// Takes the body out of the simulation (false) or puts it back (true), and keeps its shapes, joints and handles. This
/// suits bodies that are reused often, or that are needed only later. A disabled body does not move but keeps its
/// velocities; it has no contacts, queries do not find it, its joints do not act, and energies and momenta of the world
/// exclude it. Its properties may be changed, but forces and impulses are refused (wrong_state). When it is disabled,
/// its contacts end with a ContactEnd, and the bodies that it touched wake. If it overlaps others when it is enabled,
/// it is pushed out of them like a newly created body. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_enabled(cairn_world* world, cairn_body_id body, bool enabled);

/// Sets the name, for display and `World::find_body`; it need not be unique. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_name(cairn_world* world, cairn_body_id body, const char* name);

/// Sets the mass properties, which then do not follow the shapes. Dynamic bodies only; refused (wrong_state) for
/// others. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_mass_properties(cairn_world* world, cairn_body_id body,
                                                        const cairn_mass_properties* properties);

/// Makes the mass properties follow the densities of the shapes again, scaled to a total of `mass` (kg, > 0) if it is
/// given. Dynamic bodies only; refused (wrong_state) for others. Null for `mass`: absent. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_mass_from_shapes(cairn_world* world, cairn_body_id body, const float* mass);

/// Wakes the body and its island. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_wake(cairn_world* world, cairn_body_id body);

/// Sets the velocities of a dynamic body to zero and puts it to sleep at the beginning of the next step, at its present
/// place, even in the air. This requires that `sleep` was called for all bodies of its island, that is, also for those
/// that it touches or is joined to, and that all of them may sleep. A level that is created asleep costs no time until
/// something wakes it; then it settles like newly created bodies. Calls that move or push the body before that step
/// wake it as usual. No effect on other types of bodies, and where `WorldDef.enable_sleep` is false. Errors:
/// invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_sleep(cairn_world* world, cairn_body_id body);

/// Adds a force, N, at the center of mass; it acts during the next step only. Errors: invalid_handle, invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_body_add_force(cairn_world* world, cairn_body_id body, cairn_vec3 force);

/// Adds a force, N, at a point in world space; it acts during the next step only. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_add_force_at(cairn_world* world, cairn_body_id body, cairn_vec3 force,
                                                 cairn_position point);

/// Adds a torque, N m; it acts during the next step only. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_add_torque(cairn_world* world, cairn_body_id body, cairn_vec3 torque);

/// Applies an impulse, N s, at the center of mass; it changes the velocity at once. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_apply_impulse(cairn_world* world, cairn_body_id body, cairn_vec3 impulse);

/// Applies an impulse, N s, at a point in world space; it changes the velocities at once. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_apply_impulse_at(cairn_world* world, cairn_body_id body, cairn_vec3 impulse,
                                                     cairn_position point);

/// Applies an angular impulse, N m s; it changes the angular velocity at once. Errors: invalid_handle, invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_body_apply_angular_impulse(cairn_world* world, cairn_body_id body, cairn_vec3 impulse);

/// Whether the body is a character. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_is_character(const cairn_world* world, cairn_body_id body, bool* result);

/// The definition of the character. Refused (wrong_state) if the body is no character. Errors: invalid_handle,
/// wrong_state.
CAIRN_C_API cairn_result cairn_body_get_character(const cairn_world* world, cairn_body_id body,
                                                  cairn_character_def* character);

/// Makes a kinematic body a character, or changes the definition of a character. From then on each step sets the
/// velocities of the body to those with which it moves the character. Setting its linear velocity then throws the
/// character: with an upward velocity, it leaves the ground. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_set_character(cairn_world* world, cairn_body_id body,
                                                  const cairn_character_def* def);

/// Makes the character an ordinary kinematic body again, at rest. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_remove_character(cairn_world* world, cairn_body_id body);

/// The velocity with which the character tries to move, m/s, relative to the ground. Refused (wrong_state) if the body
/// is no character. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_walk_velocity(const cairn_world* world, cairn_body_id body,
                                                      cairn_vec3* walk_velocity);

/// Sets the velocity with which a character tries to move, m/s, relative to the ground; it holds until the next call.
/// The character moves along the ground with this speed, in this direction as seen from above. The component along
/// `CharacterDef.up` is used only if the character flies (`CharacterDef.flies`). Errors: invalid_handle, invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_body_set_walk_velocity(cairn_world* world, cairn_body_id body, cairn_vec3 velocity);

/// A character that stands on the ground leaves it in the next step with this upward speed, m/s, > 0. No effect on a
/// character that does not stand then. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_body_jump(cairn_world* world, cairn_body_id body, float speed);

/// The motion and support of the character after the last step. Refused (wrong_state) if the body is no character.
/// Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_character_state(const cairn_world* world, cairn_body_id body,
                                                    cairn_character_state* result);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_BODY_H
