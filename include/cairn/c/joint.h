// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#ifndef CAIRN_C_JOINT_H
#define CAIRN_C_JOINT_H

#include <cairn/c/body.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// What a limit or drive of a general joint is about.
typedef int32_t cairn_joint_axis;
enum {
    CAIRN_JOINT_AXIS_LINEAR = 0, ///< A distance along axes.
    CAIRN_JOINT_AXIS_ANGULAR = 1 ///< An angle about axes.
};

/// How a joint is solved. Both give the same motion; they differ in cost and stiffness.
typedef int32_t cairn_joint_solver;
enum {
    /// Direct in chains, machines, robots whose angles servos hold, and under high mass ratios as long as it pays, and
    /// where it hangs together with joints that are asked to be direct; else iterative.
    CAIRN_JOINT_SOLVER_AUTOMATIC = 0,
    /// 8 joints at a time, one after the other, with the contacts. For nets and heaps of many joints.
    CAIRN_JOINT_SOLVER_ITERATIVE = 1,
    /// All direct joints that hang together at once. With their motors, springs, friction and limits. For chains,
    /// machines, robots, and what must not give at all. Gears, racks and pulleys stay iterative; so do all of a net of
    /// thousands of joints, whose factorization would not end.
    CAIRN_JOINT_SOLVER_DIRECT = 2
};

/// A damped spring. It is stepped implicitly: any stiffness is stable.
typedef struct cairn_joint_spring {
    float stiffness; ///< N/m or N m/rad, >= 0.
    float damping; ///< N s/m or N m s/rad, >= 0.
    /// true: both are per unit of the mass (or moment of inertia) that the joint moves along that axis, so that the
    /// motion, not the force, is given.
    bool is_acceleration;
} cairn_joint_spring;
CAIRN_C_API cairn_joint_spring cairn_default_joint_spring(void);

/// The range of a position, m or rad. `lower` = `upper` holds it at one value.
typedef struct cairn_joint_range {
    float lower; ///< lower <= upper; -infinity and +infinity for no bound. (m or rad)
    float upper; ///< lower <= upper; -infinity and +infinity for no bound. (m or rad)
    bool has_spring; ///< Whether `spring` is given.
    cairn_joint_spring spring; ///< Pushes back from beyond a bound; absent: rigid.
} cairn_joint_range;
CAIRN_C_API cairn_joint_range cairn_default_joint_range(void);

/// What drives an axis: with a spring, towards `position` and `velocity`; without one, it holds the velocity.
typedef struct cairn_joint_motor {
    float velocity; ///< m/s or rad/s.
    float position; ///< m or rad; only with a spring.
    bool has_spring; ///< Whether `spring` is given.
    cairn_joint_spring spring; ///< Absent: the motor holds its velocity.
    float max_force; ///< N or N m, >= 0.
} cairn_joint_motor;
CAIRN_C_API cairn_joint_motor cairn_default_joint_motor(void);

/// All that can act along one axis of a joint.
typedef struct cairn_joint_control {
    bool has_limits; ///< Whether `limits` is given.
    cairn_joint_range limits; ///< Absent: no limits.
    bool has_motor; ///< Whether `motor` is given.
    cairn_joint_motor motor; ///< Absent: no motor.
    float friction; ///< N or N m, >= 0: dry friction, which holds until it is overcome.
} cairn_joint_control;
CAIRN_C_API cairn_joint_control cairn_default_joint_control(void);

/// B keeps its place and rotation against A.
typedef struct cairn_fixed_joint {
    int unused; ///< Structs of C have a member.
} cairn_fixed_joint;
CAIRN_C_API cairn_fixed_joint cairn_default_fixed_joint(void);

/// The origins of the frames coincide; B turns freely.
typedef struct cairn_ball_joint {
    bool has_cone_angle; ///< Whether `cone_angle` is given.
    float cone_angle; ///< rad, 0 to pi: greatest angle between the x axes of the two frames.
    bool has_twist; ///< Whether `twist` is given.
    cairn_joint_range twist; ///< Of the angle about the x axis, -pi to pi.
    float friction; ///< N m about each axis, >= 0.
} cairn_ball_joint;
CAIRN_C_API cairn_ball_joint cairn_default_ball_joint(void);

/// B turns about the x axis of A. Its angle is counted on beyond a full turn while a limit, motor or friction acts on
/// it; without any it is between -pi and pi.
typedef struct cairn_hinge_joint {
    cairn_joint_control angle; ///< About the x axis of A.
} cairn_hinge_joint;
CAIRN_C_API cairn_hinge_joint cairn_default_hinge_joint(void);

/// B moves along the x axis of A without turning.
typedef struct cairn_slider_joint {
    cairn_joint_control translation; ///< Along the x axis of A.
} cairn_slider_joint;
CAIRN_C_API cairn_slider_joint cairn_default_slider_joint(void);

/// B moves along the x axis of A and turns about it.
typedef struct cairn_cylindrical_joint {
    cairn_joint_control translation; ///< Along the x axis of A.
    cairn_joint_control angle; ///< About the x axis of A.
} cairn_cylindrical_joint;
CAIRN_C_API cairn_cylindrical_joint cairn_default_cylindrical_joint(void);

/// A cross of two axes at a right angle: A turns about its x axis, B about its y axis (a Cardan joint).
typedef struct cairn_universal_joint {
    cairn_joint_control first; ///< About the x axis of A.
    cairn_joint_control second; ///< About the y axis of B.
} cairn_universal_joint;
CAIRN_C_API cairn_universal_joint cairn_default_universal_joint(void);

/// The distance between the origins of the frames. A rod has lower = upper, a rope lower = 0, a spring a motor with a
/// spring at its length at rest.
typedef struct cairn_distance_joint {
    cairn_joint_control distance; ///< Between the origins of the frames.
} cairn_distance_joint;
CAIRN_C_API cairn_distance_joint cairn_default_distance_joint(void);

/// A wheel B under a car A. The wheel moves along the x axis of A (the suspension), turns about it (the steering) and
/// spins about its own y axis.
typedef struct cairn_wheel_joint {
    cairn_joint_control suspension; ///< Along the x axis of A.
    bool has_steering; ///< Whether `steering` is given.
    cairn_joint_control steering; ///< Absent: the wheel does not steer.
    cairn_joint_control spin; ///< About the y axis of the wheel.
} cairn_wheel_joint;
CAIRN_C_API cairn_wheel_joint cairn_default_wheel_joint(void);

/// A servo that moves B to a place and rotation in the frame of A.
typedef struct cairn_servo_joint {
    cairn_vec3 position; ///< Of the origin of frame B in frame A, meters.
    cairn_quat rotation; ///< Of frame B in frame A; normalized.
    cairn_joint_spring linear; ///< The spring that pulls B to its place.
    cairn_joint_spring angular; ///< The spring that turns B to its rotation.
    float max_force; ///< N along each axis, >= 0.
    float max_torque; ///< N m about each axis, >= 0.
} cairn_servo_joint;
CAIRN_C_API cairn_servo_joint cairn_default_servo_joint(void);

/// Two turning bodies in mesh: (rate of A about its frame's x axis) + ratio x (rate of B about its own) = 0. With teeth
/// in mesh on the outside of both, about parallel axes, ratio = teeth of B / teeth of A. Rates are those against the
/// world: the bodies that carry the axles must not turn about them.
typedef struct cairn_gear_joint {
    float ratio; ///< Not 0.
} cairn_gear_joint;
CAIRN_C_API cairn_gear_joint cairn_default_gear_joint(void);

/// A pinion A on a rack B: (translation of B along its frame's x axis) = radius x (angle of A about its frame's x
/// axis), as against the world.
typedef struct cairn_rack_joint {
    float radius; ///< m, not 0; negative for the other sense.
} cairn_rack_joint;
CAIRN_C_API cairn_rack_joint cairn_default_rack_joint(void);

/// A rope over two fixed pulleys: length at A + ratio x length at B <= length.
typedef struct cairn_pulley_joint {
    cairn_position ground_a; ///< World points from which the bodies hang.
    cairn_position ground_b; ///< World points from which the bodies hang.
    float ratio; ///< > 0: of a block and tackle.
    bool has_length; ///< Whether `length` is given.
    float length; ///< m, > 0; absent: what it is when the joint is made, which `World::joint_def` then has.
} cairn_pulley_joint;
CAIRN_C_API cairn_pulley_joint cairn_default_pulley_joint(void);

/// Keeps a distance (m) or an angle (rad) between the two frames in a range. With one axis: along or about it; with
/// two: from the line of the remaining axis, or of the cone about it; with three: of points, or any turn.
typedef struct cairn_joint_limit {
    cairn_joint_axis kind; ///< Whether it is about distances or angles.
    bool axes[3]; ///< x, y and z of frame A; one to three of them.
    bool has_min; ///< Whether `min` is given.
    float min; ///< Absent: no bound on that side. min <= max.
    bool has_max; ///< Whether `max` is given.
    float max; ///< Absent: no bound on that side. min <= max.
    bool has_stiffness; ///< Whether `stiffness` is given.
    float stiffness; ///< N/m or N m/rad, >= 0; absent: rigid.
    float damping; ///< N s/m or N m s/rad, >= 0; with a stiffness only.
} cairn_joint_limit;
CAIRN_C_API cairn_joint_limit cairn_default_joint_limit(void);

/// A damped spring or motor along or about one axis: pushes with stiffness x (position_target - position) + damping x
/// (velocity_target - velocity).
typedef struct cairn_joint_drive {
    cairn_joint_axis kind; ///< Whether it is about distances or angles.
    bool is_acceleration; ///< true: the above is an acceleration; false: a force or torque.
    int axis; ///< 0, 1 or 2, of frame A.
    bool has_max_force; ///< Whether `max_force` is given.
    float max_force; ///< N or N m, >= 0; absent: no bound.
    float position_target; ///< Where the spring pulls to. (m or rad)
    float velocity_target; ///< What the damping aims at. (m/s or rad/s)
    float stiffness; ///< Of the spring, >= 0. (N/m or N m/rad)
    float damping; ///< Of the spring, >= 0. (N s/m or N m s/rad)
} cairn_joint_drive;
CAIRN_C_API cairn_joint_drive cairn_default_joint_drive(void);

/// The joint of the glTF draft KHR_physics_rigid_bodies: six degrees of freedom, and any of them limited or driven. At
/// most eight limits and drives that are not plain locks.
typedef struct cairn_general_joint {
    const cairn_joint_limit* limits; ///< What is kept in a range.
    size_t limit_count;
    const cairn_joint_drive* drives; ///< What is driven.
    size_t drive_count;
} cairn_general_joint;
CAIRN_C_API cairn_general_joint cairn_default_general_joint(void);

typedef int32_t cairn_joint_kind;
enum {
    CAIRN_JOINT_FIXED = 0,
    CAIRN_JOINT_BALL = 1,
    CAIRN_JOINT_HINGE = 2,
    CAIRN_JOINT_SLIDER = 3,
    CAIRN_JOINT_CYLINDRICAL = 4,
    CAIRN_JOINT_UNIVERSAL = 5,
    CAIRN_JOINT_DISTANCE = 6,
    CAIRN_JOINT_WHEEL = 7,
    CAIRN_JOINT_SERVO = 8,
    CAIRN_JOINT_GEAR = 9,
    CAIRN_JOINT_RACK = 10,
    CAIRN_JOINT_PULLEY = 11,
    CAIRN_JOINT_GENERAL = 12
};

/// Any joint.
typedef struct cairn_joint {
    cairn_joint_kind kind;
    union {
        cairn_fixed_joint fixed;
        cairn_ball_joint ball;
        cairn_hinge_joint hinge;
        cairn_slider_joint slider;
        cairn_cylindrical_joint cylindrical;
        cairn_universal_joint universal;
        cairn_distance_joint distance;
        cairn_wheel_joint wheel;
        cairn_servo_joint servo;
        cairn_gear_joint gear;
        cairn_rack_joint rack;
        cairn_pulley_joint pulley;
        cairn_general_joint general;
        unsigned char reserved[512];
    } as; ///< The member that `kind` names.
} cairn_joint;
/// The default of a kind; of an unknown one the first.
CAIRN_C_API cairn_joint cairn_default_joint(cairn_joint_kind kind);

/// Everything needed to make a joint. Begin from `cairn_default_joint_def()`.
typedef struct cairn_joint_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_joint_def` sets it.
    cairn_body_id body_a; ///< Null: the world. At least one must be dynamic; not the same body.
    cairn_body_id body_b; ///< Null: the world. At least one must be dynamic; not the same body.
    cairn_transform frame_a; ///< In the frames of the bodies; of the world, in its own.
    cairn_transform frame_b; ///< In the frames of the bodies; of the world, in its own.
    cairn_joint joint; ///< What kind of joint, and how it is limited and driven.
    bool enable_collision; ///< Whether the two bodies collide with each other.
    float break_force; ///< N, > 0: the joint breaks beyond it.
    float break_torque; ///< N m, > 0.
    cairn_joint_solver solver; ///< How it is solved.
    const char* name; ///< For people; need not be unique. UTF-8; null: empty.
    uint64_t user_data; ///< Not touched by the engine.
    bool enabled; ///< false: it acts on nothing, as if it were not there.
} cairn_joint_def;
CAIRN_C_API cairn_joint_def cairn_default_joint_def(void);

/// What a joint did in the last step.
typedef struct cairn_joint_state {
    cairn_vec3 force; ///< N: mean force on B, world axes.
    cairn_vec3 torque; ///< N m: mean torque on B about the origin of its frame, world axes.
    /// The positions of its axes (m or rad), in the order of the fields of its type: of a hinge the angle, of a
    /// cylindrical joint translation and angle, of a general joint those of its limits and drives that are not plain
    /// locks.
    float positions[8];
    int position_count; ///< How many of `positions` there are.
    float linear_error; ///< m: how far the points that it holds together are apart.
    float angular_error; ///< rad: how far B has turned about the axes that it locks.
} cairn_joint_state;

/// Joins two bodies, or a body and the world. Wakes them. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_create_joint(cairn_world* world, const cairn_joint_def* def,
                                                  cairn_joint_id* result);

/// The definition of a joint whose frames both lie at `anchor`, with x along `axis` (any non-zero vector; world space),
/// and y and z as the shortest turn from those of the world has them: -x and z if `axis` points up. As the bodies stand
/// now. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_joint_at(const cairn_world* world, cairn_body_id body_a, cairn_body_id body_b,
                                              cairn_position anchor, cairn_vec3 axis, const cairn_joint* joint,
                                              cairn_joint_def* result);

/// Takes a joint out of the world and wakes its bodies. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_destroy_joint(cairn_world* world, cairn_joint_id joint);

/// Whether the handle names a joint that exists.
CAIRN_C_API bool cairn_joint_is_valid(const cairn_world* world, cairn_joint_id joint);

/// The definition of a joint, as it is now. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_joint_def(const cairn_world* world, cairn_joint_id joint,
                                                   cairn_joint_def* joint_def);

/// Changes limits, motors, springs, or the kind of the joint. Wakes its bodies. Errors: invalid_handle, invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_set_joint(cairn_world* world, cairn_joint_id id, const cairn_joint* joint);

/// N and N m, > 0; may be infinite. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_joint_strength(cairn_world* world, cairn_joint_id joint, float break_force,
                                                        float break_torque);

/// A joint that is disabled keeps its definition and its handle, and acts on nothing: its bodies move, and collide, as
/// if it had been destroyed. Enabled again it begins without impulses, and brings its bodies together where they have
/// parted. Both wake them. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_joint_enabled(cairn_world* world, cairn_joint_id joint, bool enabled);

/// What a joint did in the last step. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_joint_state(const cairn_world* world, cairn_joint_id joint,
                                                     cairn_joint_state* joint_state);

/// All, in order of slot index. `count` gets how many there are; the first `capacity` of them are written. Errors:
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_get_joints(const cairn_world* world, cairn_joint_id* joints, size_t capacity,
                                                size_t* count);

/// Those of one body, oldest first. `count` gets how many there are; the first `capacity` of them are written. Errors:
/// invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_joints(const cairn_world* world, cairn_body_id body, cairn_joint_id* joints,
                                               size_t capacity, size_t* count);

/// The first of that name. `found` gets whether there is any. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_find_joint(const cairn_world* world, const char* name, cairn_joint_id* result,
                                                bool* found);

/// The name of its definition, which `cairn_world_get_joint_def` leaves out. `length` gets its length without the final
/// zero; what has no room in `capacity` bytes is cut off. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_joint_get_name(const cairn_world* world, cairn_joint_id joint, char* text,
                                              size_t capacity, size_t* length);

/// The limits of a general joint, of which `cairn_world_get_joint_def` has the number alone; of other joints none.
/// Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_joint_get_limits(const cairn_world* world, cairn_joint_id joint,
                                                cairn_joint_limit* limits, size_t capacity, size_t* count);

/// The drives of a general joint, of which `cairn_world_get_joint_def` has the number alone; of other joints none.
/// Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_joint_get_drives(const cairn_world* world, cairn_joint_id joint,
                                                cairn_joint_drive* drives, size_t capacity, size_t* count);

/// The spring with which what a joint moves swings at `hertz` (> 0) with that ratio to critical damping (>= 0).
CAIRN_C_API cairn_joint_spring cairn_spring_from_frequency(float hertz, float damping_ratio);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_JOINT_H
