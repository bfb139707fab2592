// Everything that a simulation consists of. Bodies, shapes, contacts and islands live in arrays at stable
// indices; stages (one file each) are functions on this state. Handles, names and events live above, in world/.
#pragma once

#include "collision/broad_phase.h"
#include "collision/shape_pose.h"
#include "core/slot_pool.h"
#include "dynamics/direct_sets.h"
#include "dynamics/joint_state.h"
#include "dynamics/solver_scratch.h"
#include "jobs/crew.h"
#include "kernels/kernels.h"
#include "kernels/solver_data.h"
#include "math/vec.h"
#include "shapes/geometry.h"

#include <cairn/world.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace cairn {

inline constexpr std::int32_t none = -1;

// Where a body is and how it moves. Rotations are double: the rounding of a float one gives a free top 0.4 % of
// energy in a minute. The first cache line is what the narrow phase reads.
struct alignas(64) BodyMotion {
    math::DVec3 x; // center of mass, world
    math::Vec3 v, w;
    math::Quat turned; // rotation of the last step, for matching contact points

    math::DQuat q;             // of the body's frame
    math::Vec3 v_rest, w_rest; // what rounding has left over of v and w, while nothing touches the body
    std::uint64_t padding = 0;
};

// Where a body came to rest: while it stays there, the contacts it has need not be found anew.
struct RestingPose {
    math::DVec3 x;
    math::DQuat q;
};

struct alignas(64) BodyMass {
    float mass = 0, inverse_mass = 0;    // an inverse of 0 means immovable
    math::Vec3 inertia, inverse_inertia; // principal
    math::Quat principal;                // from principal axes to the body's frame
    math::Vec3 center;                   // center of mass in the body's frame
    std::uint8_t isotropic = 1;          // all moments equal: no gyroscopic torque
    std::uint8_t follows_shapes = 1;     // recomputed when shapes change
    std::uint8_t has_given_mass = 0;     // ... scaled to BodySettings::given_mass
    std::uint8_t padding = 0;
};

struct BodySettings {
    float gravity_scale = 1, linear_damping = 0, angular_damping = 0;
    float given_mass = 0; // kg, if BodyMass::has_given_mass
    BodyType type = BodyType::dynamic;
    std::uint8_t allow_sleep = 1;
    std::uint8_t padding[2] = {};
};

// What the user pushes with during the next step. Double, so that no sum of floats overflows.
struct BodyForces {
    math::DVec3 force, torque;
    std::uint64_t any = 0;
};

struct BodyLinks {
    std::int32_t first_shape = none, last_shape = none;
    std::int32_t island = none; // dynamic bodies only
    std::int32_t next_in_island = none, previous_in_island = none;
    float radius = 0;                                   // of the body about its center of mass; planes not counted
    float quiet_time = 0;                               // s that it has been slower than the sleep speed
    std::int32_t contact_count = 0;                     // that are solved
    std::uint64_t colors = 0;                           // of its contacts, one bit each
    std::uint64_t joint_colors = 0;                     // likewise
    std::int32_t first_joint = none, last_joint = none; // ends: 2 x joint + side
    std::int32_t joint_count = 0;                       // that are solved
    std::int32_t padding = 0;
};

struct alignas(32) ShapeLinks {
    std::int32_t body = none, next = none, previous = none; // the shapes of a body, in order of creation
    float density = 0;
    math::Vec3 arm; // from the body's center of mass to the shape's origin, world axes
    std::uint32_t padding = 0;
};

// What decides with whom a shape makes contacts.
struct ShapeTraits {
    CollisionFilter filter;
    math::Vec3 surface_velocity; // in the shape's frame, m/s
    std::uint8_t is_trigger = 0;
    std::uint8_t has_surface_velocity = 0;
    std::uint8_t padding[2] = {};
};
inline bool may_meet(const CollisionFilter& a, const CollisionFilter& b) {
    return (a.layers & b.collides_with) != 0 && (b.layers & a.collides_with) != 0;
}

// How a pair of shapes is tested.
enum class PairKind : std::uint8_t {
    // By a wide kernel (pairs.cpp).
    sphere_sphere,
    sphere_box,
    sphere_plane,
    sphere_rectangle,
    sphere_capsule,
    box_box,
    box_plane,
    box_rectangle,
    capsule_capsule,
    box_capsule,
    // One at a time, A first (convex_tests.cpp).
    convex_plane,
    convex_rectangle,
    convex_convex,
    // Against the triangles of a mesh or height field: the contact of the pair is a group, and has patches, contacts of
    // their own, one for each direction in which A touches it (patches.cpp).
    group,
    patch,
};
inline constexpr int wide_kinds = 10, tested_kinds = 14;
inline bool has_one_point(PairKind k) { return k <= PairKind::sphere_capsule; }
inline bool may_be_round(PairKind k) { return k < PairKind::box_box || k > PairKind::box_rectangle; }

// A pose of a body in which all its fat boxes serve; and until they might not, how far its points may move, m, with
// what is looked ahead in either pose. Only saves time: not part of a snapshot.
struct ServedPose {
    RestingPose pose;
    double room = -1;
};

// What is known of a pair of shapes whose bounds overlap, beside its ContactRecord. Body A is dynamic.
struct alignas(64) ContactInfo {
    std::uint32_t shape_a = 0, shape_b = 0;
    std::int32_t body_a = none, body_b = none;
    PairKind kind = PairKind::sphere_sphere;
    std::uint8_t flipped = 0;     // A is the kernel's second shape
    std::uint8_t point_count = 0; // 0: too far apart to be solved
    std::uint8_t color = 255;     // none
    std::uint8_t b_moves = 0;     // B is dynamic
    std::uint8_t touching = 0;    // a begin event was given
    std::uint8_t in_use = 0;
    std::uint8_t bounces = 0;     // has any restitution
    float match_tolerance = 0;    // m: points closer than this to last step's are the same
    float base_margin = 0;        // m
    float force = 0;              // N: the normal force of the last step
    float load = 0;               // N: the sustained one, without impacts
    float substep_time = 0;       // s: that the impulses are for
    std::uint8_t is_trigger = 0;  // never solved: only `touching` counts
    std::uint8_t is_conveyor = 0; // B's surface moves
    std::uint16_t gap = 0;        // between its points at the start of the step (spare_gap)
    std::uint64_t tested_at = 0;  // the pass that last tested the pair; 0: none
    std::int32_t related = none;  // group: its first patch; patch: its group
    std::int32_t next = none;     // patch: the next one of its group
};
inline bool is_group(const ContactInfo& c) { return c.kind == PairKind::group; }

// What need not be tested of a pair that was found apart: it stays so until the ways of its bodies together reach that
// far (State::ahead).
struct ApartPair {
    double until = 0; // m
    std::int32_t body_a = none, body_b = none;
};

inline constexpr float unknown_demand = 1e5f; // high: what joints bear is not known before they are solved
struct Island {
    std::int32_t first_body = none, last_body = none;
    std::int32_t body_count = 0;
    std::int32_t position = none; // in State::awake_islands; none: asleep
    std::int32_t key = none;      // of its tree in the broad phase, if that holds it as sleeping
    std::uint8_t in_use = 0;
    std::uint8_t lost_contact = 0; // may have fallen into parts
    std::uint8_t kept_awake = 0;   // touches something that moves by itself
    std::uint8_t flies = 0;        // in this pass: its joints have nothing to do (flight.cpp)
    std::int32_t flight = 0;   // 1 and the passes it has flown since its joints bore nothing; 0: they bore something
    std::int32_t substeps = 0; // in the last step
    std::int32_t wanted_substeps = 0;    // by what it carries (substeps.cpp)
    std::int32_t joint_count = 0;        // that belong to its bodies
    float weight = 0, greatest_load = 0; // N: of all bodies; on one contact
    float greatest_demand = 0;           // m/s^2: load over the reduced mass of the contact that carries it
    float unrest = 0;                    // m/s: mean square of the speeds about that of the whole, its root
    float joint_demand = unknown_demand; // m/s^2: mean square of the joints' forces over the masses, its root
    std::int32_t joint_substeps = 0;     // that its joints ask for in motion
    std::int32_t rest_substeps = 0;      // of a heap at rest; 0: it is none
    std::int32_t was_tossed = 0;         // 1: it is a heap that was stirred up
    float least_quiet_time = 0, greatest_quiet_time = 0;
};

struct State {
    WorldDef settings;
    std::uint64_t steps = 0;
    std::uint64_t passes = 0;     // a step is one pass, or several (world/step.cpp)
    int split = 1;                // passes of the step under way
    std::uint64_t first_pass = 0; // of the step under way: `passes` at its start
    double time = 0;

    SlotPool body_slots;
    std::vector<BodyMotion> motion;
    std::vector<BodyMass> mass;
    std::vector<BodySettings> body_settings;
    std::vector<BodyForces> forces;
    std::vector<std::int32_t> pushed; // bodies with any
    std::vector<BodyLinks> bodies;
    std::vector<RestingPose> resting;
    std::vector<std::uint64_t> left_at; // the pass before which a body was last seen away from its resting pose
    std::vector<RestingPose> near;      // likewise, for contacts that are moved along while the body stays near
    std::vector<std::uint64_t> strayed_at;
    // How far any point of a body has moved since it was made, m, at most; and how far it will have after this pass.
    std::vector<double> way, ahead;
    std::vector<ServedPose> served;
    std::vector<std::int32_t> kinematics; // kinematic bodies, in order of creation

    SlotPool shape_slots;
    std::vector<Geometry> geometry;
    std::vector<ShapeData> shape_data;
    std::vector<ShapePose> shape_poses;
    std::vector<ShapeLinks> shapes;
    std::vector<Material> materials;
    std::vector<ShapeTraits> shape_traits;

    std::vector<ContactRecord> records;
    std::vector<ContactInfo> contacts;
    std::vector<ApartPair> apart_pairs; // by contact
    std::vector<std::uint32_t> free_contacts;

    std::vector<Island> islands;
    std::vector<std::int32_t> free_islands;
    std::vector<std::int32_t> awake_islands;
    std::vector<std::int32_t> falling_asleep; // islands that the broad phase still holds as awake
    std::vector<std::int32_t> waking;         // keys that it still holds as sleeping

    SlotPool joint_slots;
    std::vector<JointInfo> joints;
    std::vector<JointAxes> joint_axes; // by joint

    SlotPool field_slots;
    std::vector<ForceField> fields;
    std::vector<std::uint32_t> dead_bodies, dead_shapes; // recycled after the broad phase's update

    BroadPhase broad_phase{kernels().broad};

    // --- of the last step
    std::vector<ContactBegin> begins;
    std::vector<ContactEnd> ends;
    std::vector<ContactHit> hits;
    std::vector<TriggerEvent> triggers;
    std::vector<JointEvent> joint_events;
    std::vector<SleepEvent> sleeps;
    std::vector<std::uint32_t> overloaded_joints; // in ascending order
    // What will be read of the next step: what changes between two steps counts to the later one.
    std::vector<ContactEnd> next_ends;
    std::vector<TriggerEvent> next_triggers;
    std::vector<JointEvent> next_joint_events;
    std::vector<SleepEvent> next_sleeps;
    std::uint64_t clamped_speeds = 0;
    Statistics statistics;

    // --- working memory of a step, not state
    NarrowScratch narrow;
    std::vector<std::uint32_t> solved; // contacts to solve in this step
    SolverScratch solver;
    DirectSets direct;
    std::uint64_t joint_changes = 0; // of joints, and of the masses of what is jointed
    std::unique_ptr<Crew> crew = std::make_unique<Crew>(1);

    BodyId body_id(std::int32_t body) const {
        return BodyId::make(std::uint32_t(body), body_slots.generation(std::uint32_t(body)), world_id);
    }
    ShapeId shape_id(std::uint32_t shape) const {
        return ShapeId::make(shape, shape_slots.generation(shape), world_id);
    }
    JointId joint_id(std::uint32_t joint) const {
        return JointId::make(joint, joint_slots.generation(joint), world_id);
    }
    // Of the given number in a step, how many a pass takes.
    int in_pass(int substeps) const { return (substeps + split - 1) / split; }
    bool is_pushed(std::int32_t body) const { return !pushed.empty() && forces[std::size_t(body)].any; }
    bool is_dynamic(std::int32_t body) const { return body_settings[std::size_t(body)].type == BodyType::dynamic; }
    bool is_awake(std::int32_t body) const {
        const std::int32_t island = bodies[std::size_t(body)].island;
        return island != none && islands[std::size_t(island)].position != none;
    }
    std::uint32_t world_id = 0;
};

} // namespace cairn
