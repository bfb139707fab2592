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

/// What a force field does.
typedef int32_t cairn_force_field_kind;
enum {
    CAIRN_FORCE_FIELD_KIND_UNIFORM = 0, ///< The same everywhere, along `direction`.
    CAIRN_FORCE_FIELD_KIND_RADIAL = 1, ///< Towards `center`, `strength` x distance^`exponent`.
    /// A fluid with a level surface through `center`, which flows with the velocity `direction`.
    CAIRN_FORCE_FIELD_KIND_FLUID = 2
};

/// Settings of a world. All may be changed later through `World::set_settings`. Begin from `cairn_default_world_def()`.
typedef struct cairn_world_def {
    uint32_t struct_size; ///< Bytes, as `cairn_default_world_def` sets it.
    cairn_vec3 gravity; ///< m/s^2, finite.
    /// Solver substeps of one step, 1 to 256; or 0: as many as make them no longer than 1/360 s (6 at 60 Hz, 2 at 240
    /// Hz). (0 to 256)
    int substeps;
    /// Take more in islands that ask for it: with joints (no longer than 1/660 s), high mass ratios, tall stacks,
    /// bodies less than 10 cm wide.
    bool adaptive_substeps;
    cairn_integrator integrator; ///< How free motion is integrated.
    bool enable_sleep; ///< Islands at rest stop costing time.
    float sleep_speed; ///< m/s; a body slower than this at its surface may sleep. >= 0.
    float sleep_time; ///< s at rest before an island sleeps, unless it gains speed steadily. >= 0.
    float restitution_speed; ///< m/s; slower impacts do not bounce. >= 0.
    float hit_speed; ///< m/s; least approach speed for a hit event. >= 0.
    float recovery_speed; ///< m/s; overlaps are pushed apart no faster than this. > 0.
    float max_linear_speed; ///< m/s; faster bodies are slowed to this, and counted. > 0, at most 1e15.
    float max_angular_speed; ///< rad/s; likewise. (> 0)
} cairn_world_def;
CAIRN_C_API cairn_world_def cairn_default_world_def(void);

/// A field that acts on every dynamic body: an acceleration or a force, evaluated at its center of mass, or a fluid,
/// which fills a box below its level surface, lifts what is in it by the weight of what that displaces, and resists
/// motion against it. Begin from `cairn_default_force_field()`.
typedef struct cairn_force_field {
    uint32_t struct_size; ///< Bytes, as `cairn_default_force_field` sets it.
    cairn_force_field_kind kind; ///< What it does.
    /// Uniform: acceleration in m/s^2 (or force in N, see `is_force`). Fluid: m/s. (m/s^2 or N or m/s)
    cairn_vec3 direction;
    cairn_position center; ///< Radial: the point that attracts, meters. Fluid: the middle of its surface.
    float strength; ///< Radial: m/s^2 (or N) at a distance of one meter; negative repels. (m/s^2 or N)
    float exponent; ///< Radial: 0 constant, 1 spring, -1, -2 gravity of a point. One of -2,-1,0,1. (-2, -1, 0 or 1)
    bool is_force; ///< false: an acceleration, equal for all masses; true: a force.
    /// Fluid: how far it reaches from `center` along the axes of the world, meters, > 0; may be infinite. Along the
    /// axis nearest to gravity it is the depth.
    cairn_vec3 half_extents;
    float density; ///< Fluid: kg/m^3, >= 0. The default is that of water.
    float drag; ///< Fluid: coefficient of what is pushed ahead, >= 0. That of a plate; a ball has half of it.
    float skin_friction; ///< Fluid: coefficient of what is dragged along, >= 0.
    float added_mass; ///< Fluid: how much of it moves along, >= 0, of what a body displaces; a ball: 0.5.
    float wave_damping; ///< Fluid: how fast bobbing is lost to waves, >= 0, of critical damping.
} cairn_force_field;
CAIRN_C_API cairn_force_field cairn_default_force_field(void);

/// Wall-clock time of the stages of the last step, in milliseconds.
typedef struct cairn_stage_times {
    double broad_phase; ///< Pairs of bounds. (ms)
    double narrow_phase; ///< Contact points. (ms)
    double islands; ///< What is solved together. (ms)
    double prepare; ///< Rows of the solver. (ms)
    double solve; ///< Substeps. (ms)
    double finalize; ///< New places, events, sleep. (ms)
    double total; ///< The whole step. (ms)
} cairn_stage_times;

/// Counts and times of the last step. Begin from `cairn_default_statistics()`.
typedef struct cairn_statistics {
    uint32_t struct_size; ///< Bytes, as `cairn_default_statistics` sets it.
    uint64_t steps; ///< Steps since the world was made.
    double time; ///< Simulated seconds since then.
    size_t bodies; ///< All of them.
    size_t dynamic_bodies; ///< Those that forces move.
    size_t awake_bodies; ///< Those that are not asleep.
    size_t shapes; ///< All of them.
    size_t candidate_pairs; ///< Pairs whose bounds overlap.
    /// Of those, how many the last step has tested. The others were well apart or asleep, or their bodies have moved by
    /// a few millimeters at most since they were.
    size_t tested_pairs;
    size_t contacts; ///< Touching pairs of shapes, asleep ones included.
    size_t contact_points; ///< Their points.
    size_t islands; ///< Awake islands.
    size_t sleeping_islands; ///< Islands that are asleep.
    size_t colors; ///< Colors of contacts, which are solved one after the other.
    size_t overflow_contacts; ///< Contacts that found no free color, solved one by one.
    uint64_t clamped_speeds; ///< Since the world was made: velocities cut to the maximum.
    int max_substeps; ///< Most substeps that any island took.
    double max_penetration; ///< Deepest overlap, meters, >= 0.
    size_t swept_pairs; ///< In the last step: pairs looked at along their ways, as one moved far.
    size_t impacts; ///< In the last step: impacts of bodies in flight, several of one body included.
    size_t stopped_bodies; ///< In the last step: bodies held where they met what the solver did not know.
    cairn_stage_times times; ///< Of the last step.
} cairn_statistics;
CAIRN_C_API cairn_statistics cairn_default_statistics(void);

/// What the bytes of a snapshot are for.
typedef struct cairn_snapshot_sizes {
    /// The dynamic state of the bodies and their shapes: place, rotation, velocities, where they came to rest, island,
    /// time to sleep, forces. (bytes)
    size_t bodies;
    size_t contacts; ///< Pairs of shapes: points, and the impulses that the next step starts from. (bytes)
    size_t joints; ///< Impulses that the next step starts from, and positions. (bytes)
    size_t broad_phase; ///< Boxes, their tree, and the list of pairs. (bytes)
    size_t other; ///< Header, counters, events that the next step will report. (bytes)
    size_t definitions; ///< Once for all snapshots that share them. (bytes)
} cairn_snapshot_sizes;

/// Where `cairn_world_read_bodies` writes to. Null: that is not read. Strides are in bytes from one body to the next;
/// 0: one after the other. Begin from `cairn_default_body_arrays()`.
typedef struct cairn_body_arrays {
    uint32_t struct_size; ///< Bytes, as `cairn_default_body_arrays` sets it.
    double* positions; ///< x, y, z of the origin of each body's frame, meters.
    size_t position_stride; ///< 0, or at least 24.
    float* rotations; ///< x, y, z, w of each body's rotation, of unit length.
    size_t rotation_stride; ///< 0, or at least 16.
    float* linear_velocities; ///< x, y, z of each center of mass, m/s.
    size_t linear_velocity_stride; ///< 0, or at least 12.
    float* angular_velocities; ///< x, y, z in world axes, rad/s.
    size_t angular_velocity_stride; ///< 0, or at least 12.
} cairn_body_arrays;
CAIRN_C_API cairn_body_arrays cairn_default_body_arrays(void);

/// What the world was made with, or was last set to. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_settings(const cairn_world* world, cairn_world_def* settings);

/// Replaces the settings. Wakes everything if gravity changes. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_settings(cairn_world* world, const cairn_world_def* def);

/// The substeps of a step of `dt` seconds, finite and > 0, where no island asks for more: `WorldDef::substeps`, or what
/// its 0 stands for. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_usual_substeps(const cairn_world* world, float dt, int* result);

/// The number of threads that a step may use: that of the caller, and `count` - 1 more that the world keeps. 1 to 256;
/// default 1. Results do not depend on it. Snapshots do not hold it. Throws outside that range, or when the system has
/// no more threads. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_threads(cairn_world* world, int count);

/// The number of threads that a step may use. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_threads(const cairn_world* world, int* threads);

/// Adds a field that acts on every dynamic body from the next step on. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_add_force_field(cairn_world* world, const cairn_force_field* field,
                                                     cairn_force_field_id* result);

/// Replaces a field by another one. Errors: invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_set_force_field(cairn_world* world, cairn_force_field_id id,
                                                     const cairn_force_field* field);

/// Takes a field out of the world. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_remove_force_field(cairn_world* world, cairn_force_field_id id);

/// A field, as it is now. Errors: invalid_handle, wrong_state.
CAIRN_C_API cairn_result cairn_world_get_force_field(const cairn_world* world, cairn_force_field_id id,
                                                     cairn_force_field* force_field);

/// All, in order of slot index. `count` gets how many there are; the first `capacity` of them are written. Errors:
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_get_force_fields(const cairn_world* world, cairn_force_field_id* force_fields,
                                                      size_t capacity, size_t* count);

/// Whether the handle names a field that exists.
CAIRN_C_API bool cairn_force_field_is_valid(const cairn_world* world, cairn_force_field_id id);

/// Advances by `dt` seconds (> 0, finite). The same dt every time gives the best results. Errors: invalid_value,
/// wrong_state.
CAIRN_C_API cairn_result cairn_world_step(cairn_world* world, float dt);

/// Steps since the world was made. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_step_count(const cairn_world* world, uint64_t* step_count);

/// Simulated seconds. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_time(const cairn_world* world, double* time);

/// J, of all dynamic bodies. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_kinetic_energy(const cairn_world* world, double* kinetic_energy);

/// J in the world's gravity, relative to the origin. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_potential_energy(const cairn_world* world, double* potential_energy);

/// kg m/s, of all dynamic bodies. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_linear_momentum(const cairn_world* world, cairn_dvec3* linear_momentum);

/// kg m^2/s about the origin, of all dynamic bodies. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_angular_momentum(const cairn_world* world, cairn_dvec3* angular_momentum);

/// Of positions, rotations and velocities, by bits. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_state_hash(const cairn_world* world, uint64_t* state_hash);

/// Counts and times of the last step. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_get_statistics(const cairn_world* world, cairn_statistics* statistics);

/// Makes an empty world. Null for `def`: the default one. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_create(const cairn_world_def* def, cairn_world** world);

/// Ends a world with all that is in it. Null: nothing happens. Not while another thread uses it.
CAIRN_C_API void cairn_world_destroy(cairn_world* world);

/// `count` steps of `dt` seconds each. Events are those of the last one. Errors: invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_steps(cairn_world* world, float dt, size_t count);

/// Writes places, rotations and velocities of many bodies into the caller's arrays. Null for `bodies`: all of them, in
/// order of slot index, and `count` must be their number. Where a handle is not valid, nothing is written. Errors:
/// invalid_handle, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_read_bodies(const cairn_world* world, const cairn_body_id* bodies, size_t count,
                                                 const cairn_body_arrays* arrays);

/// The whole state of the world, to go back to: a world restored from it goes on bit for bit. `cairn_snapshot_release`
/// when it is no longer needed. Errors: wrong_state.
CAIRN_C_API cairn_result cairn_world_save(const cairn_world* world, cairn_snapshot** snapshot);

/// Makes this world the one that was saved. Handles from then are valid again; those of what was made since are stale,
/// until the same ones name what is made next. Errors: invalid_file, invalid_value, wrong_state.
CAIRN_C_API cairn_result cairn_world_restore(cairn_world* world, const cairn_snapshot* snapshot);

/// What the bytes of a snapshot are for. Errors: invalid_value.
CAIRN_C_API cairn_result cairn_snapshot_get_sizes(const cairn_snapshot* snapshot, cairn_snapshot_sizes* sizes);

/// Gives a snapshot back. Null: nothing happens.
CAIRN_C_API void cairn_snapshot_release(cairn_snapshot* snapshot);

#ifdef __cplusplus
}
#endif

#endif // CAIRN_C_WORLD_H
