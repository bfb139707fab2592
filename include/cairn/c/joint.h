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

/// Whether a limit or drive of a general joint acts on a distance or on an angle.
typedef int32_t cairn_joint_axis;
enum {
    CAIRN_JOINT_AXIS_LINEAR = 0, ///< A distance along axes.
    CAIRN_JOINT_AXIS_ANGULAR = 1 ///< An angle about axes.
};

/// How a joint is solved. Both solvers give the same motion; they differ in cost and stiffness.
typedef int32_t cairn_joint_solver;
enum {
    /// The engine chooses. It solves directly: chains, machines, robots with servo-driven angles, and joints under high
    /// mass ratios, as long as this is not too expensive; and all joints that connect to joints with `direct`. All
    /// others are iterative.
    CAIRN_JOINT_SOLVER_AUTOMATIC = 0,
    /// Joints are solved in turn (eight at a time, in SIMD lanes), together with the contacts. For nets, and heaps of
    /// many joints.
    CAIRN_JOINT_SOLVER_ITERATIVE = 1,
    /// All direct joints that connect bodies are solved as one system of equations, including their motors, springs,
    /// friction and limits. For chains, machines, robots, and joints that must not yield. Gears, racks and pulleys
    /// remain iterative, and so do all joints of a net of thousands, whose factorization would take far too long.
    CAIRN_JOINT_SOLVER_DIRECT = 2
};

/// A damped spring. It is integrated implicitly, so that any stiffness is stable.
typedef struct cairn_joint_spring {
    float stiffness; ///< N/m or N m/rad, >= 0.
    float damping; ///< N s/m or N m s/rad, >= 0.
    /// true: stiffness (1/s^2) and damping (1/s) are per unit of the mass (or moment of inertia) that the joint moves
    /// along that axis: they set the motion, whatever the mass. false: they set the force.
    bool is_acceleration;
} cairn_joint_spring;
CAIRN_C_API cairn_joint_spring cairn_default_joint_spring(void);

/// Limits of a position, m or rad. `lower` = `upper` holds it at one value.
typedef struct cairn_joint_range {
    float lower; ///< m or rad, lower <= upper; -infinity: no bound on that side.
    float upper; ///< m or rad, lower <= upper; +infinity: no bound on that side.
    bool has_spring; ///< Whether `spring` is given.
    cairn_joint_spring spring; ///< Pulls back a position that is beyond a bound; absent: the limit is rigid.
} cairn_joint_range;
CAIRN_C_API cairn_joint_range cairn_default_joint_range(void);

/// Drives an axis. With a spring it pulls towards `position` and `velocity`; without one it keeps the velocity, as far
/// as `max_force` allows.
typedef struct cairn_joint_motor {
    float velocity; ///< m/s or rad/s: target velocity.
    float position; ///< m or rad: target position; used only with a spring.
    bool has_spring; ///< Whether `spring` is given.
    cairn_joint_spring spring; ///< Absent: the motor keeps its velocity.
    float max_force; ///< N or N m, >= 0: greatest force or torque of the motor.
} cairn_joint_motor;
CAIRN_C_API cairn_joint_motor cairn_default_joint_motor(void);

/// Limits, motor and friction of one axis of a joint. By default the axis is free.
typedef struct cairn_joint_control {
    bool has_limits; ///< Whether `limits` is given.
    cairn_joint_range limits; ///< Absent: no limits.
    bool has_motor; ///< Whether `motor` is given.
    cairn_joint_motor motor; ///< Absent: no motor.
    float friction; ///< N or N m, >= 0: dry friction. The axis moves only under a greater force or torque.
} cairn_joint_control;
CAIRN_C_API cairn_joint_control cairn_default_joint_control(void);

/// B keeps its position and rotation relative to A.
typedef struct cairn_fixed_joint {
    int unused; ///< Not used: a C struct needs a member.
} cairn_fixed_joint;
CAIRN_C_API cairn_fixed_joint cairn_default_fixed_joint(void);

/// The origins of the two frames coincide; B rotates freely about that point, within the limits.
typedef struct cairn_ball_joint {
    bool has_cone_angle; ///< Whether `cone_angle` is given.
    /// rad, 0 to pi: greatest angle between the x axes of the two frames (swing limit); absent: none.
    float cone_angle;
    bool has_twist; ///< Whether `twist` is given.
    cairn_joint_range twist; ///< rad, -pi to pi: limits of the angle about the x axis; absent: none.
    float friction; ///< N m, >= 0: friction torque about each axis.
} cairn_ball_joint;
CAIRN_C_API cairn_ball_joint cairn_default_ball_joint(void);

/// B rotates about the x axis of A. While a limit, motor or friction acts on the angle, it counts full turns; otherwise
/// it is between -pi and pi.
typedef struct cairn_hinge_joint {
    cairn_joint_control angle; ///< Angle about the x axis of A.
} cairn_hinge_joint;
CAIRN_C_API cairn_hinge_joint cairn_default_hinge_joint(void);

/// B moves along the x axis of A and does not rotate relative to A.
typedef struct cairn_slider_joint {
    cairn_joint_control translation; ///< Translation along the x axis of A.
} cairn_slider_joint;
CAIRN_C_API cairn_slider_joint cairn_default_slider_joint(void);

/// B moves along the x axis of A and rotates about it.
typedef struct cairn_cylindrical_joint {
    cairn_joint_control translation; ///< Translation along the x axis of A.
    cairn_joint_control angle; ///< Angle about the x axis of A.
} cairn_cylindrical_joint;
CAIRN_C_API cairn_cylindrical_joint cairn_default_cylindrical_joint(void);

/// A universal (Cardan) joint: a cross with two axes at a right angle, the x axis of A and the y axis of B, about which
/// the bodies rotate.
typedef struct cairn_universal_joint {
    cairn_joint_control first; ///< Rotation about the x axis of A.
    cairn_joint_control second; ///< Rotation about the y axis of B.
} cairn_universal_joint;
CAIRN_C_API cairn_universal_joint cairn_default_universal_joint(void);

/// Controls the distance (m) between the origins of the two frames. For a rod, set limits with lower = upper; for a
/// rope, lower = 0; for a spring, a motor with a spring and `position` = its rest length.
typedef struct cairn_distance_joint {
    cairn_joint_control distance; ///< Distance between the origins of the two frames.
} cairn_distance_joint;
CAIRN_C_API cairn_distance_joint cairn_default_distance_joint(void);

/// A wheel B under a car A. The wheel moves along the x axis of A (suspension), rotates about it (steering), and spins
/// about its own y axis.
typedef struct cairn_wheel_joint {
    cairn_joint_control suspension; ///< Translation along the x axis of A.
    bool has_steering; ///< Whether `steering` is given.
    cairn_joint_control steering; ///< Angle about the x axis of A. Absent: the wheel does not steer.
    cairn_joint_control spin; ///< Rotation about the y axis of the wheel.
} cairn_wheel_joint;
CAIRN_C_API cairn_wheel_joint cairn_default_wheel_joint(void);

/// A servo that pulls B to a target position and rotation in the frame of A.
typedef struct cairn_servo_joint {
    cairn_vec3 position; ///< Target of the origin of frame B, in frame A, meters.
    cairn_quat rotation; ///< Target of the rotation of frame B in frame A; normalized.
    cairn_joint_spring linear; ///< Spring that pulls B to the target position.
    cairn_joint_spring angular; ///< Spring that rotates B to the target rotation.
    float max_force; ///< N, >= 0: greatest force along each axis.
    float max_torque; ///< N m, >= 0: greatest torque about each axis.
} cairn_servo_joint;
CAIRN_C_API cairn_servo_joint cairn_default_servo_joint(void);

/// Two meshing gears: (angular speed of A about the x axis of its frame) + ratio x (angular speed of B about that of
/// its frame) = 0. For external gears on parallel axes, ratio = teeth of B / teeth of A. Angular speeds are relative to
/// the world, so the bodies that carry the axles must not rotate about them.
typedef struct cairn_gear_joint {
    float ratio; ///< Not 0; negative: both rotate in the same sense.
} cairn_gear_joint;
CAIRN_C_API cairn_gear_joint cairn_default_gear_joint(void);

/// A pinion A on a rack B: (translation of B along the x axis of its frame) = radius x (angle of A about the x axis of
/// its frame), both relative to the world.
typedef struct cairn_rack_joint {
    float radius; ///< m, not 0; negative: the rack moves in the opposite sense.
} cairn_rack_joint;
CAIRN_C_API cairn_rack_joint cairn_default_rack_joint(void);

/// A rope over two fixed pulleys: length at A + ratio x length at B <= length.
typedef struct cairn_pulley_joint {
    cairn_position ground_a; ///< The pulley on the side of A, meters, world space.
    cairn_position ground_b; ///< The pulley on the side of B, meters, world space.
    float ratio; ///< > 0: ratio of the block and tackle on the side of B.
    bool has_length; ///< Whether `length` is given.
    float length; ///< m, > 0; absent: the length when the joint is created, which `World::joint_def` then returns.
} cairn_pulley_joint;
CAIRN_C_API cairn_pulley_joint cairn_default_pulley_joint(void);

/// Limits a distance (m) or an angle (rad) between the two frames. With one axis it is the position along, or the angle
/// about, that axis. With two axes it is the distance from the line of the third axis, or the angle between the third
/// axes of both frames (a cone). With three axes it is the distance of the two origins, or the angle of the whole
/// rotation.
typedef struct cairn_joint_limit {
    cairn_joint_axis kind; ///< Whether it limits a distance or an angle.
    bool axes[3]; ///< Which of the axes x, y and z of frame A; one to three of them.
    bool has_min; ///< Whether `min` is given.
    float min; ///< m or rad, min <= max; absent: no bound on that side.
    bool has_max; ///< Whether `max` is given.
    float max; ///< m or rad, min <= max; absent: no bound on that side.
    bool has_stiffness; ///< Whether `stiffness` is given.
    float stiffness; ///< N/m or N m/rad, >= 0; absent: rigid.
    float damping; ///< N s/m or N m s/rad, >= 0; used only with a stiffness.
} cairn_joint_limit;
CAIRN_C_API cairn_joint_limit cairn_default_joint_limit(void);

/// A damped spring or motor along or about one axis. Its force (or torque) is stiffness x (position_target - position)
/// + damping x (velocity_target - velocity).
typedef struct cairn_joint_drive {
    cairn_joint_axis kind; ///< Whether it drives a distance or an angle.
    bool is_acceleration; ///< true: the formula gives an acceleration; false: a force or torque.
    int axis; ///< 0, 1 or 2: x, y or z of frame A.
    bool has_max_force; ///< Whether `max_force` is given.
    float max_force; ///< N or N m, >= 0: greatest force or torque; absent: no bound.
    float position_target; ///< m or rad: target position of the spring.
    float velocity_target; ///< m/s or rad/s: target velocity of the damping.
    float stiffness; ///< N/m or N m/rad, >= 0: stiffness of the spring.
    float damping; ///< N s/m or N m s/rad, >= 0: damping of the spring.
} cairn_joint_drive;
CAIRN_C_API cairn_joint_drive cairn_default_joint_drive(void);

/// The joint of the glTF draft KHR_physics_rigid_bodies: six degrees of freedom, any of which may have limits and
/// drives. It may have at most eight limits and drives, not counting limits that just lock axes.
typedef struct cairn_general_joint {
    const cairn_joint_limit* limits; ///< Limits of distances and angles.
    size_t limit_count;
    const cairn_joint_drive* drives; ///< Drives of distances and angles.
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
/// The default values of a kind; those of the first kind if `kind` is unknown.
CAIRN_C_API cairn_joint cairn_default_joint(cairn_joint_kind kind);

/// Everything that is needed to create a joint. Begin from `cairn_default_joint_def()`.
typedef struct cairn_joint_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_joint_def` sets it.
    cairn_body_id body_a; ///< Null: the world. The two bodies must differ, and at least one must be dynamic.
    cairn_body_id body_b; ///< Null: the world. The two bodies must differ, and at least one must be dynamic.
    cairn_transform frame_a; ///< Pose of the joint's frame relative to the frame of body A, or relative to the world.
    cairn_transform frame_b; ///< Pose of the joint's frame relative to the frame of body B, or relative to the world.
    cairn_joint joint; ///< The type of joint, with its limits, motors and springs.
    bool enable_collision; ///< true: the two bodies collide with each other.
    float break_force; ///< N, > 0: the joint breaks if its mean force in a step exceeds this.
    float break_torque; ///< N m, > 0: the joint breaks if its mean torque in a step exceeds this.
    cairn_joint_solver solver; ///< How the joint is solved.
    const char* name; ///< For display and `World::find_joint`; need not be unique. UTF-8; null: empty.
    uint64_t user_data; ///< Stored for the application; the engine does not use it.
    bool enabled; ///< false: the joint does not act until `World::set_joint_enabled`.
} cairn_joint_def;
CAIRN_C_API cairn_joint_def cairn_default_joint_def(void);

/// Forces, positions and errors of a joint in the last step.
typedef struct cairn_joint_state {
    cairn_vec3 force; ///< N: mean force on B, world axes.
    cairn_vec3 torque; ///< N m: mean torque on B about the origin of its frame, world axes.
    /// Positions of its axes (m or rad), in the order of the members of its type: for a hinge its angle; for a
    /// cylindrical joint translation and angle; for a general joint one for each of its limits and drives, except
    /// limits that just lock axes.
    float positions[8];
    int position_count; ///< Number of valid elements of `positions`.
    float linear_error; ///< m: distance between the points that the joint holds together.
    float angular_error; ///< rad: rotation of B about the axes that the joint locks.
} cairn_joint_state;

/// Joins two bodies, or a body and the world, and wakes them. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_create_joint(cairn_world* world, const cairn_joint_def* def,
                                                  cairn_joint_id* result);

/// Returns the definition of a joint whose two frames coincide, for the present poses of the bodies: with their origin
/// at `anchor` (world space, meters) and x along `axis` (world space, any non-zero vector). The y and z axes result
/// from the shortest rotation that takes the world's x axis to `axis`: for an `axis` along +y, they are -x and z.
/// Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_joint_at(const cairn_world* world, cairn_body_id body_a, cairn_body_id body_b,
                                              cairn_position anchor, cairn_vec3 axis, const cairn_joint* joint,
                                              cairn_joint_def* result);

/// Destroys a joint and wakes its bodies. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_destroy_joint(cairn_world* world, cairn_joint_id joint);

/// Whether the handle names a joint that exists.
CAIRN_C_API bool cairn_joint_is_valid(const cairn_world* world, cairn_joint_id joint);

/// The present definition of a joint. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_joint_def(const cairn_world* world, cairn_joint_id joint,
                                                   cairn_joint_def* joint_def);

/// Replaces the type-specific part of a joint: limits, motors, springs, or its type. Wakes its bodies. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_joint(cairn_world* world, cairn_joint_id id, const cairn_joint* joint);

/// Sets the force (N) and torque (N m) at which a joint breaks, > 0; may be infinite. Errors: invalid_handle,
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_joint_strength(cairn_world* world, cairn_joint_id joint, float break_force,
                                                        float break_torque);

/// Disables or enables a joint. A disabled joint keeps its definition and its handle but does not act: its bodies move
/// and collide as if it had been destroyed. When it is enabled, it starts with zero impulses, and pulls its bodies
/// together if they have moved apart. Both wake its bodies. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_joint_enabled(cairn_world* world, cairn_joint_id joint, bool enabled);

/// Forces, positions and errors of a joint in the last step. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_joint_state(const cairn_world* world, cairn_joint_id joint,
                                                     cairn_joint_state* joint_state);

/// All joints, in order of slot index. `count` receives their number; the first `capacity` of them are written. Errors:
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_get_joints(const cairn_world* world, cairn_joint_id* joints, size_t capacity,
                                                size_t* count);

/// The joints of one body, oldest first. `count` receives their number; the first `capacity` of them are written.
/// Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_body_get_joints(const cairn_world* world, cairn_body_id body, cairn_joint_id* joints,
                                               size_t capacity, size_t* count);

/// The first joint with that name. `found` receives whether there is one. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_find_joint(const cairn_world* world, const char* name, cairn_joint_id* result,
                                                bool* found);

/// The name of a joint, which `cairn_world_get_joint_def` omits. `length` receives its length without the terminating
/// zero; text beyond `capacity` bytes is cut off. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_joint_get_name(const cairn_world* world, cairn_joint_id joint, char* text,
                                              size_t capacity, size_t* length);

/// The limits of a general joint, of which `cairn_world_get_joint_def` gives only the number; none for other joints.
/// Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_joint_get_limits(const cairn_world* world, cairn_joint_id joint,
                                                cairn_joint_limit* limits, size_t capacity, size_t* count);

/// The drives of a general joint, of which `cairn_world_get_joint_def` gives only the number; none for other joints.
/// Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_joint_get_drives(const cairn_world* world, cairn_joint_id joint,
                                                cairn_joint_drive* drives, size_t capacity, size_t* count);

/// The spring with which the bodies oscillate at a natural frequency of `hertz` (Hz, > 0), with that damping ratio (>=
/// 0; 1: critical damping).
CAIRN_C_API cairn_joint_spring cairn_spring_from_frequency(float hertz, float damping_ratio);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_JOINT_H
