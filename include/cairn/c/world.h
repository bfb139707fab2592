// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#ifndef CAIRN_C_WORLD_H
#define CAIRN_C_WORLD_H

#include <cairn/c/events.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// How free motion is integrated over a substep of length h. Contacts work with all of them.
typedef int32_t cairn_integrator;
enum {
    CAIRN_INTEGRATOR_SEMI_IMPLICIT_EULER = 0, ///< v += h a, then x += h v. Bounded energy error; the default.
    CAIRN_INTEGRATOR_EXPLICIT_EULER = 1, ///< x += h v, then v += h a. Gains energy; kept for teaching.
    CAIRN_INTEGRATOR_RK4 = 2 ///< Classic fourth-order Runge-Kutta.
};

/// The kind of a force field.
typedef int32_t cairn_force_field_kind;
enum {
    CAIRN_FORCE_FIELD_KIND_UNIFORM = 0, ///< `direction` at every place.
    CAIRN_FORCE_FIELD_KIND_RADIAL = 1, ///< `strength` x distance^`exponent`, towards `center`.
    /// A fluid with a level surface through `center`, which flows with the velocity `direction`.
    CAIRN_FORCE_FIELD_KIND_FLUID = 2
};

/// Settings of a world. All may be changed later with `World::set_settings`. Begin from `cairn_default_world_def()`.
typedef struct cairn_world_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_world_def` sets it.
    cairn_vec3 gravity; ///< Acceleration of gravity, m/s^2, finite.
    /// Number of solver substeps in a step, 0 to 256. 0: as many as are needed for substeps of at most 1/360 s (6 at 60
    /// Hz, 2 at 240 Hz).
    int substeps;
    /// true: more substeps for islands that need them: with joints (substeps of at most 1/660 s), high mass ratios,
    /// tall stacks, or bodies less than 10 cm wide.
    bool adaptive_substeps;
    cairn_integrator integrator; ///< How free motion is integrated.
    bool enable_sleep; ///< true: islands at rest fall asleep, and then cost no time.
    float sleep_speed; ///< m/s, >= 0: a body is at rest if no point of its surface is faster.
    float sleep_time; ///< s, >= 0: time at rest before an island falls asleep, unless its speed grows steadily.
    float restitution_speed; ///< m/s, >= 0: slower impacts do not bounce.
    float hit_speed; ///< m/s, >= 0: least approach speed for a hit event.
    float recovery_speed; ///< m/s, > 0: greatest speed at which overlapping shapes are pushed apart.
    /// m/s, > 0, at most 1e15: higher speeds are reduced to this, and counted (`Statistics.clamped_speeds`).
    float max_linear_speed;
    float max_angular_speed; ///< rad/s, > 0: higher angular speeds are reduced to this, and counted.
} cairn_world_def;
CAIRN_C_API cairn_world_def cairn_default_world_def(void);

/// A field that acts on all dynamic bodies: an acceleration or a force, evaluated at the center of mass of each body,
/// or a fluid. A fluid (water, oil, air) fills a box below its surface, which is the plane through `center`
/// perpendicular to the world's gravity. Buoyancy equals the weight of the displaced fluid in the world's gravity
/// (Archimedes). Drag is computed over the surface of a body: a surface element that moves into the fluid with the
/// normal speed s is pushed back with a pressure of drag x density x s^2 / 2, and one that moves along the fluid with
/// the tangential speed t with a shear stress of skin_friction x density x t^2 / 2. A part of the fluid moves along
/// with a body (`added_mass`). There are no waves, but a body that bobs loses energy as if it made waves
/// (`wave_damping`). A fluid acts on solid shapes, not on triggers. At the sides of the box it acts on the part of a
/// shape that is inside the box; at its bottom, on shapes whose middle is above the bottom. Where fluids overlap, both
/// act. Begin from `cairn_default_force_field()`.
typedef struct cairn_force_field {
    uint32_t struct_size; ///< Bytes, as `cairn_default_force_field` sets it.
    cairn_force_field_kind kind; ///< The kind of the field.
    /// m/s^2 or N or m/s. Uniform: acceleration, or force if `is_force`. Fluid: velocity of its flow.
    cairn_vec3 direction;
    cairn_position center; ///< Radial: the center of attraction, meters. Fluid: the middle of its surface, meters.
    float strength; ///< Radial: acceleration or force (m/s^2 or N) at a distance of 1 m; negative: repulsion.
    float exponent; ///< Radial: -2, -1, 0 or 1. -2 is point gravity, 0 is constant, 1 is a spring.
    bool is_force; ///< Uniform, radial: false: an acceleration, the same for all masses; true: a force.
    /// Fluid: half extents of its box along the world axes, from `center`, meters, > 0; may be infinite. Along the axis
    /// closest to the direction of gravity it is the depth.
    cairn_vec3 half_extents;
    float density; ///< Fluid: kg/m^3, >= 0. The default is the density of water.
    float drag; ///< Fluid: coefficient of pressure drag, >= 0. A plate has this drag coefficient, a ball half of it.
    float skin_friction; ///< Fluid: coefficient of skin friction, >= 0.
    /// Fluid: mass of fluid that moves along with a body, as a fraction of the displaced mass, >= 0; for a ball it is
    /// 0.5.
    float added_mass;
    float wave_damping; ///< Fluid: damping of bobbing by waves, as a fraction of critical damping, >= 0.
} cairn_force_field;
CAIRN_C_API cairn_force_field cairn_default_force_field(void);

/// Wall-clock time of the stages of the last step, in milliseconds. Not part of snapshots: 0 after a world is restored.
typedef struct cairn_stage_times {
    double broad_phase; ///< Broad phase: pairs of shapes whose bounds overlap, ms.
    double narrow_phase; ///< Narrow phase: contact points, ms.
    double islands; ///< Islands: bodies that are solved together, ms.
    double prepare; ///< Preparation of constraint rows, ms.
    double solve; ///< Substeps of the solver, ms.
    double finalize; ///< New poses of bodies, events, sleeping, ms.
    double total; ///< The whole step, ms.
} cairn_stage_times;

/// Counts and times of the last step. Begin from `cairn_default_statistics()`.
typedef struct cairn_statistics {
    uint32_t struct_size; ///< Bytes, as `cairn_default_statistics` sets it.
    uint64_t steps; ///< Steps since the world was created.
    double time; ///< Simulated time since then, s.
    size_t bodies; ///< Number of bodies.
    size_t dynamic_bodies; ///< Number of dynamic bodies.
    size_t awake_bodies; ///< Number of bodies that are awake.
    size_t shapes; ///< Number of shapes.
    size_t candidate_pairs; ///< Pairs of shapes whose bounds overlap.
    /// How many of these pairs the narrow phase tested in the last step. The others were well separated or asleep, or
    /// their bodies have moved by at most a few millimeters since their last test.
    size_t tested_pairs;
    size_t contacts; ///< Touching pairs of shapes, including sleeping ones.
    size_t contact_points; ///< Contact points of these pairs.
    size_t islands; ///< Awake islands.
    size_t sleeping_islands; ///< Islands that are asleep.
    size_t colors; ///< Colors of the constraint graph; contacts of different colors are solved in turn.
    /// Contacts for which no color of the constraint graph was free; they are solved one by one.
    size_t overflow_contacts;
    uint64_t clamped_speeds; ///< How many times since the world was created a speed was reduced to the maximum.
    int max_substeps; ///< Greatest number of substeps of any awake island.
    double max_penetration; ///< Deepest overlap, meters, >= 0.
    size_t swept_pairs; ///< Pairs tested along their paths in the last step, because one of the bodies moved far.
    size_t impacts; ///< Impacts of bodies in free flight in the last step; one body may have several.
    /// Bodies that were stopped in the last step where they met a shape with which the solver had no contact.
    size_t stopped_bodies;
    cairn_stage_times times; ///< Times of the stages of the last step.
} cairn_statistics;
CAIRN_C_API cairn_statistics cairn_default_statistics(void);

/// How the size of a snapshot, in bytes, is made up.
typedef struct cairn_snapshot_sizes {
    /// Dynamic state of the bodies and their shapes: position, rotation, velocities, the pose at which they came to
    /// rest, island, time at rest, forces. (bytes)
    size_t bodies;
    size_t contacts; ///< Pairs of shapes: contact points, and the impulses for warm starting the next step. (bytes)
    size_t joints; ///< Impulses for warm starting the next step, and positions. (bytes)
    size_t broad_phase; ///< Bounding boxes, their trees, and the list of pairs. (bytes)
    size_t other; ///< Header, counters, and events that the next step will report. (bytes)
    size_t definitions; ///< The definitions, which many snapshots may share. (bytes)
} cairn_snapshot_sizes;

/// The arrays to which `cairn_world_read_bodies` writes. An array that is null is not written. Strides are the
/// distances from one body to the next, in bytes; 0: the elements are contiguous. Begin from
/// `cairn_default_body_arrays()`.
typedef struct cairn_body_arrays {
    uint32_t struct_size; ///< Bytes, as `cairn_default_body_arrays` sets it.
    double* positions; ///< x, y, z of the origin of each body's frame, meters, world space.
    size_t position_stride; ///< Bytes: 0, or at least 24.
    float* rotations; ///< x, y, z, w of each body's rotation, a unit quaternion.
    size_t rotation_stride; ///< Bytes: 0, or at least 16.
    float* linear_velocities; ///< x, y, z of the velocity of each center of mass, m/s.
    size_t linear_velocity_stride; ///< Bytes: 0, or at least 12.
    float* angular_velocities; ///< x, y, z of each angular velocity in world axes, rad/s.
    size_t angular_velocity_stride; ///< Bytes: 0, or at least 12.
} cairn_body_arrays;
CAIRN_C_API cairn_body_arrays cairn_default_body_arrays(void);

/// The present settings of the world. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_settings(const cairn_world* world, cairn_world_def* settings);

/// Replaces the settings. Wakes all bodies if gravity changes. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_settings(cairn_world* world, const cairn_world_def* def);

/// The number of substeps in a step of `dt` seconds for islands that need no more: `WorldDef.substeps`, or, if that is
/// 0, the number for which it stands. Refused (invalid_value) unless `dt` is finite and > 0. Errors: invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_usual_substeps(const cairn_world* world, float dt, int* result);

/// Sets the number of threads that a step may use, 1 to 256: the caller's, and `count` - 1 that the world keeps.
/// Default: 1. Results do not depend on it, and it is not part of snapshots. Refused (invalid_value) outside that
/// range, and (unsupported) if the system cannot create the threads. Errors: invalid_value, wrong_state, unsupported.
CAIRN_C_API cairn_result cairn_world_set_threads(cairn_world* world, int count);

/// The number of threads that a step may use. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_threads(const cairn_world* world, int* threads);

/// Adds a force field, which acts on all dynamic bodies from the next step on. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_add_force_field(cairn_world* world, const cairn_force_field* field,
                                                     cairn_force_field_id* result);

/// Replaces a force field by another. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_force_field(cairn_world* world, cairn_force_field_id id,
                                                     const cairn_force_field* field);

/// Removes a force field from the world. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_remove_force_field(cairn_world* world, cairn_force_field_id id);

/// The present definition of a force field. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_force_field(const cairn_world* world, cairn_force_field_id id,
                                                     cairn_force_field* force_field);

/// All force fields, in order of slot index. `count` receives their number; the first `capacity` of them are written.
/// Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_force_fields(const cairn_world* world, cairn_force_field_id* force_fields,
                                                      size_t capacity, size_t* count);

/// Whether the handle names a force field that exists.
CAIRN_C_API bool cairn_force_field_is_valid(const cairn_world* world, cairn_force_field_id id);

/// Advances the simulation by `dt` seconds (> 0, finite). A constant `dt` gives the best results. Errors:
/// invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_step(cairn_world* world, float dt);

/// Number of steps since the world was created. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_step_count(const cairn_world* world, uint64_t* step_count);

/// Simulated time since the world was created, seconds. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_time(const cairn_world* world, double* time);

/// Kinetic energy of all dynamic bodies, J. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_kinetic_energy(const cairn_world* world, double* kinetic_energy);

/// Potential energy in the world's gravity, relative to the origin, J. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_potential_energy(const cairn_world* world, double* potential_energy);

/// Linear momentum of all dynamic bodies, kg m/s. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_linear_momentum(const cairn_world* world, cairn_dvec3* linear_momentum);

/// Angular momentum of all dynamic bodies about the origin, kg m^2/s. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_angular_momentum(const cairn_world* world, cairn_dvec3* angular_momentum);

/// A hash of the bits of all positions, rotations and velocities. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_state_hash(const cairn_world* world, uint64_t* state_hash);

/// Counts and times of the last step. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_statistics(const cairn_world* world, cairn_statistics* statistics);

/// Creates an empty world. Null for `def`: the default settings. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_create(const cairn_world_def* def, cairn_world** world);

/// Destroys a world with all its contents. No effect on null. Must not be called while another thread uses the world.
CAIRN_C_API void cairn_world_destroy(cairn_world* world);

/// Runs `count` steps of `dt` seconds each. The events are those of the last step. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_steps(cairn_world* world, float dt, size_t count);

/// Writes positions, rotations and velocities of many bodies to the caller's arrays. Null for `bodies`: all bodies, in
/// order of slot index; `count` must then be their number. If a handle is invalid, nothing is written. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_read_bodies(const cairn_world* world, const cairn_body_id* bodies, size_t count,
                                                 const cairn_body_arrays* arrays);

/// Saves the complete state of the world. A world restored from it continues bit for bit as the original would have.
/// Free the snapshot with `cairn_snapshot_release`. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_save(const cairn_world* world, cairn_snapshot** snapshot);

/// Restores the state that was saved. Handles of that time are valid again. Handles of objects that were created since
/// are stale, until objects that are created next get the same handles. Refused (invalid_file, unsupported) for a
/// damaged or foreign snapshot; the world then stays as it was. Errors: invalid_file, invalid_value, wrong_state,
/// unsupported.
CAIRN_C_API cairn_result cairn_world_restore(cairn_world* world, const cairn_snapshot* snapshot);

/// How the size of a snapshot, in bytes, is made up. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_snapshot_get_sizes(const cairn_snapshot* snapshot, cairn_snapshot_sizes* sizes);

/// Frees a snapshot. No effect on null.
CAIRN_C_API void cairn_snapshot_release(cairn_snapshot* snapshot);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_WORLD_H
