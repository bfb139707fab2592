/// \file world.h
/// A world of rigid bodies: its settings, force fields, statistics, and all calls that change, step and query it.
#pragma once

#include <cairn/body.h>
#include <cairn/commands.h>
#include <cairn/debug_lines.h>
#include <cairn/error.h>
#include <cairn/events.h>
#include <cairn/handle.h>
#include <cairn/joint.h>
#include <cairn/math.h>
#include <cairn/query.h>
#include <cairn/shape.h>
#include <cairn/snapshot.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace cairn {

class Communicator;

/// How free motion is integrated over a substep of length h. Contacts work with all of them.
enum class Integrator : std::uint8_t {
    semi_implicit_euler, ///< v += h a, then x += h v. Bounded energy error; the default.
    explicit_euler,      ///< x += h v, then v += h a. Gains energy; kept for teaching.
    rk4,                 ///< Classic fourth-order Runge-Kutta.
};

/// Settings of a world. All may be changed later with `World::set_settings`.
struct WorldDef {
    Vec3 gravity{0.0f, -9.81f, 0.0f}; ///< m/s^2, finite.
    /// Number of solver substeps in a step, 1 to 256; or 0: as many as are needed for substeps of at most 1/360 s (6 at
    /// 60 Hz, 2 at 240 Hz).
    int substeps = 0;
    /// true: more substeps for islands that need them: with joints (substeps of at most 1/660 s), high mass ratios,
    /// tall stacks, or bodies less than 10 cm wide.
    bool adaptive_substeps = true;
    Integrator integrator = Integrator::semi_implicit_euler;
    bool enable_sleep = true;  ///< true: islands at rest fall asleep, and then cost no time.
    float sleep_speed = 0.05f; ///< m/s, >= 0: a body is at rest if no point of its surface is faster.
    float sleep_time = 0.5f; ///< s, >= 0: time at rest before an island falls asleep, unless its speed grows steadily.
    float restitution_speed = 0.02f; ///< m/s, >= 0: slower impacts do not bounce.
    float hit_speed = 1.0f;          ///< m/s, >= 0: least approach speed for a ContactHit.
    float recovery_speed = 3.0f;     ///< m/s, > 0: greatest speed at which overlapping shapes are pushed apart.
    /// m/s, > 0, at most 1e15: higher speeds are reduced to this, and counted (Statistics::clamped_speeds).
    float max_linear_speed = 2000.0f;
    float max_angular_speed = 1000.0f; ///< rad/s, > 0: likewise for angular speeds.
};

/// A field that acts on all dynamic bodies: an acceleration or a force, evaluated at the center of mass of each body,
/// or a fluid.
///
/// A fluid (water, oil, air) fills a box below its surface, which is the plane through `center` perpendicular to the
/// world's gravity. Buoyancy equals the weight of the displaced fluid in the world's gravity (Archimedes). Drag is
/// computed over the surface of a body: a surface element that moves into the fluid with the normal speed s is pushed
/// back with a pressure of drag x density x s^2 / 2, and one that moves along the fluid with the tangential speed t
/// with a shear stress of skin_friction x density x t^2 / 2. A plate thus has the drag coefficient `drag`, and a ball
/// half of it. A part of the fluid moves along with a body (`added_mass`). There are no waves, but a body that bobs
/// loses energy as if it made waves (`wave_damping`). A fluid acts on solid shapes, not on triggers. At the sides of
/// the box it acts on the part of a shape that is inside the box; at its bottom, on shapes whose middle is above the
/// bottom. Where fluids overlap, both act.
struct ForceField {
    enum class Kind : std::uint8_t {
        uniform, ///< `direction` at every place.
        radial,  ///< `strength` x distance^`exponent`, towards `center`.
        fluid,   ///< A fluid with a level surface through `center`, which flows with the velocity `direction`.
    };
    Kind kind = Kind::uniform;
    /// Uniform: acceleration in m/s^2 (or force in N, see `is_force`). Fluid: velocity of its flow, m/s.
    Vec3 direction{0.0f, 0.0f, 0.0f};
    /// Radial: the center of attraction, meters. Fluid: the middle of its surface, meters.
    Position center{0.0, 0.0, 0.0};
    float strength = 0.0f; ///< Radial: acceleration in m/s^2 (or force in N) at a distance of 1 m; negative: repulsion.
    float exponent = 0.0f; ///< Radial: -2 (point gravity), -1, 0 (constant) or 1 (spring).
    bool is_force = false; ///< Uniform, radial: false: an acceleration, the same for all masses; true: a force.
    /// Fluid: half extents of its box along the world axes, from `center`, meters, > 0; may be infinite. Along the axis
    /// closest to the direction of gravity it is the depth.
    Vec3 half_extents{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
                      std::numeric_limits<float>::infinity()};
    float density = 1000.0f;     ///< Fluid: kg/m^3, >= 0. The default is the density of water.
    float drag = 1.0f;           ///< Fluid: coefficient of pressure drag, >= 0.
    float skin_friction = 0.01f; ///< Fluid: coefficient of skin friction, >= 0.
    /// Fluid: mass of fluid that moves along with a body, as a fraction of the displaced mass, >= 0; for a ball it is
    /// 0.5.
    float added_mass = 0.5f;
    float wave_damping = 0.2f; ///< Fluid: damping of bobbing by waves, as a fraction of critical damping, >= 0.
};

/// Wall-clock time of the stages of the last step, in milliseconds. Not part of snapshots: 0 after `World::restore`.
struct StageTimes {
    double broad_phase = 0, narrow_phase = 0, islands = 0, prepare = 0, solve = 0, finalize = 0, total = 0;
};

/// Counts and times of the last step.
struct Statistics {
    std::uint64_t steps = 0; ///< Steps since the world was created.
    double time = 0;         ///< Simulated time since then, s.
    std::size_t bodies = 0, dynamic_bodies = 0, awake_bodies = 0, shapes = 0;
    std::size_t candidate_pairs = 0; ///< Pairs of shapes whose bounds overlap.
    /// How many of these pairs the narrow phase tested in the last step. The others were well separated or asleep, or
    /// their bodies have moved by at most a few millimeters since their last test.
    std::size_t tested_pairs = 0;
    std::size_t contacts = 0;       ///< Touching pairs of shapes, including sleeping ones.
    std::size_t contact_points = 0; ///< Contact points of these pairs.
    std::size_t islands = 0;        ///< Awake islands.
    std::size_t sleeping_islands = 0;
    std::size_t colors = 0;
    /// Contacts for which no color of the constraint graph was free; they are solved one by one.
    std::size_t overflow_contacts = 0;
    /// How many times since the world was created a speed was reduced to the maximum.
    std::uint64_t clamped_speeds = 0;
    int max_substeps = 0;       ///< Greatest number of substeps of any awake island.
    double max_penetration = 0; ///< Deepest overlap, meters, >= 0.
    /// Pairs tested along their paths in the last step, because one of the bodies moved far.
    std::size_t swept_pairs = 0;
    std::size_t impacts = 0; ///< Impacts of bodies in free flight in the last step; one body may have several.
    /// Bodies that were stopped in the last step where they met a shape with which the solver had no contact.
    std::size_t stopped_bodies = 0;
    StageTimes times;
};

/// The instruction set that the kernels of this process use: "avx512", "avx2", "sse2", "neon", "simd128" or "scalar".
/// Chosen at start-up from what the CPU offers; the environment variable CAIRN_ISA forces one. Results do not depend on
/// it.
std::string_view instruction_set() noexcept;

/// The number of hardware threads of this machine, 1 to 256: a good argument for `World::set_threads`.
int hardware_threads() noexcept;

/// A world. Handles contain the number of their world; numbers repeat after 65,535 worlds, and a restored world takes
/// the number of the saved one. A `Body` accessor refers to the World object: its calls throw (wrong_state) after the
/// World was moved, and it must not be used after the World was destroyed. Worlds are independent of each other. One
/// world must not be used by two threads at the same time, except for const members, which may run on many threads
/// while no non-const member runs; calls that would change a world during a step throw (wrong_state). If memory runs
/// out, calls throw std::bad_alloc; the world then is as it was, or refuses all calls (wrong_state) until `restore`. A
/// world that was moved from may be destroyed and assigned to; for it, `is_valid` is false for all handles, and every
/// other call throws (wrong_state).
class World {
  public:
    explicit World(const WorldDef& def = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    const WorldDef& settings() const;
    /// Throws (invalid_value) on an invalid value. Wakes all bodies if gravity changes.
    void set_settings(const WorldDef& def);
    /// The number of substeps in a step of `dt` seconds for islands that need no more: `WorldDef::substeps`, or, if
    /// that is 0, the number for which it stands. Throws (invalid_value) unless `dt` is finite and > 0.
    int usual_substeps(float dt) const;

    /// Sets the number of threads that a step may use, 1 to 256: the caller's, and `count` - 1 that the world keeps.
    /// Default: 1. Results do not depend on it, and it is not part of snapshots. Throws invalid_value outside that
    /// range, and unsupported if the system cannot create the threads.
    void set_threads(int count);
    int threads() const;

    /// Sets the processes (ranks) that step this world together from now on (docs/scale.md); null, or a communicator of
    /// size 1: only this process. All ranks must have made the same calls since the world was empty or restored, and
    /// must make the same calls from then on; they call `step` together. Every rank has all bodies, but points and
    /// impulses only of its own contacts. `contacts`, `save`, `restore`, `SnapshotRing::push` and `set_communicator`
    /// itself exchange these between ranks; so all ranks must call them, each on one thread at a time. Results do not
    /// depend on the number of ranks. It is not part of snapshots. Throws (invalid_value) if the rank is not below the
    /// size.
    void set_communicator(std::shared_ptr<Communicator> communicator);

    // --- bodies and shapes
    BodyId create_body(const BodyDef& def = {});
    /// Destroys the body with its shapes and joints, and wakes bodies that rested on it.
    void destroy_body(BodyId body);
    bool is_valid(BodyId body) const noexcept;
    Body body(BodyId body);
    const Body body(BodyId body) const;
    std::vector<BodyId> bodies() const;                           ///< All, in order of slot index.
    std::optional<BodyId> find_body(std::string_view name) const; ///< The first of that name.

    /// Adds a shape to a body and, unless its mass properties were given, updates these. A dynamic body whose shapes
    /// have no mass has its given mass, or 1 kg, at a point, and does not rotate. Planes, meshes and height fields are
    /// refused on dynamic bodies (wrong_state).
    ShapeId add_shape(BodyId body, const Shape& shape, const ShapeDef& def = {});
    void remove_shape(ShapeId shape);
    /// Replaces the geometry of a shape; its handle and its definition stay. The mass of the body is updated as in
    /// `add_shape`. If the new geometry is of the same type, contacts with shapes that it still touches continue
    /// without events; otherwise its contacts end and begin anew. Shapes that overlap the new geometry are pushed out
    /// with at most `WorldDef::recovery_speed`. Rising ground therefore carries the bodies on it if it rises more
    /// slowly than that, and in one call by less than the height of the body. Wakes the body of the shape, and bodies
    /// around the old and the new geometry.
    void set_shape(ShapeId shape, const Shape& geometry);
    /// Replaces the definition of a shape in the same way: its pose on the body, density, material, filter, and so on.
    /// Its contacts end and begin anew if `is_trigger` or `filter` changes.
    void set_shape_def(ShapeId shape, const ShapeDef& def);
    bool is_valid(ShapeId shape) const noexcept;
    BodyId body_of(ShapeId shape) const;
    const Shape& shape(ShapeId shape) const;
    const ShapeDef& shape_def(ShapeId shape) const;
    Transform shape_transform(ShapeId shape) const; ///< In world space.
    Bounds shape_bounds(ShapeId shape) const; ///< Tight axis-aligned bounds, meters; infinite for infinite planes.
    void set_material(ShapeId shape, const Material& material);
    void set_filter(ShapeId shape, const CollisionFilter& filter);
    /// See ShapeDef::surface_velocity. Throws (wrong_state) for a shape of a dynamic body.
    void set_surface_velocity(ShapeId shape, const Vec3& velocity);

    // --- joints
    /// Joins two bodies, or a body and the world, and wakes them.
    JointId create_joint(const JointDef& def);
    /// Returns the definition of a joint whose two frames coincide, for the present poses of the bodies: with their
    /// origin at `anchor` (world space, meters) and x along `axis` (world space, any non-zero vector). The y and z axes
    /// result from the shortest rotation that takes the world's x axis to `axis`: for an `axis` along +y, they are -x
    /// and z.
    JointDef joint_at(BodyId body_a, BodyId body_b, const Position& anchor, const Vec3& axis, const Joint& joint) const;
    void destroy_joint(JointId joint);
    bool is_valid(JointId joint) const noexcept;
    const JointDef& joint_def(JointId joint) const;
    /// Replaces the type-specific part of a joint: limits, motors, springs, or its type. Wakes its bodies.
    void set_joint(JointId id, const Joint& joint);
    void set_joint_strength(JointId joint, float break_force, float break_torque); ///< N and N m, > 0; may be infinite.
    /// Disables or enables a joint. A disabled joint keeps its definition and its handle but does not act: its bodies
    /// move and collide as if it had been destroyed. When it is enabled, it starts with zero impulses, and pulls its
    /// bodies together if they have moved apart. Both wake its bodies.
    void set_joint_enabled(JointId joint, bool enabled);
    JointState joint_state(JointId joint) const;
    std::vector<JointId> joints() const;                            ///< All, in order of slot index.
    std::vector<JointId> joints(BodyId body) const;                 ///< The joints of one body, oldest first.
    std::optional<JointId> find_joint(std::string_view name) const; ///< The first of that name.

    // --- force fields
    ForceFieldId add_force_field(const ForceField& field);
    void set_force_field(ForceFieldId id, const ForceField& field);
    void remove_force_field(ForceFieldId id);
    bool is_valid(ForceFieldId id) const noexcept;
    const ForceField& force_field(ForceFieldId id) const;
    std::vector<ForceFieldId> force_fields() const; ///< All, in order of slot index.

    // --- time
    /// Advances the simulation by `dt` seconds (> 0, finite). A constant `dt` gives the best results.
    void step(float dt);
    std::uint64_t step_count() const;
    double time() const; ///< Simulated seconds.

    // --- what happened
    std::span<const ContactBegin> contact_begins() const;
    std::span<const ContactEnd> contact_ends() const;
    std::span<const ContactHit> contact_hits() const;
    std::span<const TriggerEvent> trigger_events() const;
    std::span<const JointEvent> joint_events() const;
    std::span<const SleepEvent> sleep_events() const;
    std::vector<Contact> contacts() const;            ///< All contact manifolds of touching pairs.
    std::vector<Contact> contacts(BodyId body) const; ///< The contact manifolds of one body.

    // --- queries; `filter`: which shapes they see. Throws (invalid_handle) if it ignores a body that does not exist.
    /// The nearest intersection of a ray with a shape within `max_distance` (meters). `direction` need not have unit
    /// length. A ray that starts inside a shape does not hit that shape; only one that starts below an infinite plane
    /// hits it, at distance 0.
    std::optional<RayHit> cast_ray(const Position& origin, const Vec3& direction, double max_distance,
                                   const QueryFilter& filter = {}) const;
    /// The intersections of the ray with all shapes, nearest first.
    std::vector<RayHit> cast_ray_all(const Position& origin, const Vec3& direction, double max_distance,
                                     const QueryFilter& filter = {}) const;
    /// The first shape that the given convex shape hits when it moves by `translation` (meters) from `start` without
    /// rotation. The accuracy is a millionth of the size of the smaller shape. If they overlap at the start, the
    /// fraction is 0, and point and normal are those of the smallest separating translation; if several shapes overlap,
    /// the one with the lowest slot index is returned. Planes, meshes and height fields are hit from outside only, and
    /// cannot be cast (invalid_value).
    std::optional<ShapeCastHit> cast_shape(const Shape& shape, const Transform& start, const Vec3& translation,
                                           const QueryFilter& filter = {}) const;
    /// The shape nearest to a point, at most `max_distance` (meters, >= 0) away. Points below a plane are inside it;
    /// meshes and height fields have no inside.
    std::optional<ClosestPoint> closest_point(const Position& point, double max_distance,
                                              const QueryFilter& filter = {}) const;
    /// All shapes that have a point in common with the given shape at `pose` (touching counts), in order of slot index.
    /// A plane is solid below. Rectangles, strips, double-sided planes, meshes and height fields are surfaces without
    /// thickness: a shape that touches or crosses them from any side overlaps them; a shape entirely below does not.
    /// Two surfaces never overlap.
    std::vector<ShapeId> overlap(const Shape& shape, const Transform& pose, const QueryFilter& filter = {}) const;
    /// Shapes whose tight bounds overlap the box, in order of slot index.
    std::vector<ShapeId> overlap_bounds(const Bounds& bounds, const QueryFilter& filter = {}) const;

    /// The present nodes of the broad phase down to `max_depth` (>= 0), in order of depth, at most `max_count` (>= 0):
    /// for visualization, and to find out why a scene is slow.
    std::vector<BroadPhaseNode> broad_phase_nodes(int max_depth, int max_count) const;

    /// How each touching pair of shapes is solved, in the order of `contacts()`.
    std::vector<SolverContact> solver_contacts() const;

    /// The contents of the world as lines, for programs with their own renderer: bodies in order of slot index, then
    /// contacts, then joints. There is a line for each edge, which takes time for large meshes and height fields.
    std::vector<DebugLine> debug_lines(const DebugLinesDef& what = {}) const;

    // --- bulk reads, for renderers and bindings
    /// Writes the transforms of the bodies `ids` to `out`, which must have the same size.
    void read_transforms(std::span<const BodyId> ids, std::span<Transform> out) const;

    // --- whole-world measures
    double kinetic_energy() const;       ///< J, of all dynamic bodies.
    double potential_energy() const;     ///< J in the world's gravity, relative to the origin.
    glm::dvec3 linear_momentum() const;  ///< kg m/s, of all dynamic bodies.
    glm::dvec3 angular_momentum() const; ///< kg m^2/s about the origin, of all dynamic bodies.
    std::uint64_t state_hash() const;    ///< A hash of the bits of all positions, rotations and velocities.
    StateDigest state_digest() const;    ///< The same data as sums over the bodies.
    /// The bodies in which this world differs from a world with the digest `other`, if these are one or two. Empty if
    /// the worlds do not differ, and also if they differ in more bodies or in one that does not exist here; comparing
    /// the digests distinguishes these cases.
    std::vector<BodyId> bodies_that_differ(const StateDigest& other) const;
    Statistics statistics() const;

    // --- snapshots
    Snapshot save() const;
    /// Restores the state that was saved. Handles of that time are valid again. Handles of objects that were created
    /// since are stale, until objects that are created next get the same handles. Throws (invalid_file, unsupported) on
    /// a damaged or foreign snapshot, and leaves the world as it was.
    void restore(const Snapshot& snapshot);

    // --- commands (commands.h)
    /// Sets the listener that receives every change from now on; null: none. It first receives the present state: the
    /// settings of the world if it is empty and unused, else a snapshot. Changes of the number of threads are not
    /// reported; `restore` is, like any other change. The listener is not part of snapshots. If it throws while
    /// receiving the present state, the exception is rethrown here, and no listener is set.
    void set_command_listener(std::shared_ptr<CommandListener> listener);
    /// Executes a command that a listener has received, in this world or another one. Handles in the command refer to
    /// the objects with the same slot and generation in this world. Throws `Error`: as the encoded call does,
    /// `invalid_file` if the bytes are not a command, `unsupported` if the command is from a later version. The world
    /// then stays as it was.
    void execute(std::span<const std::byte> command, CommandSource& source);

  private:
    friend class Body;
    friend class WorldPool;
    friend class SnapshotRing;
    struct Impl;
    void restore_image(const struct StateImage& image, const std::shared_ptr<const SnapshotDefinitions>& definitions);
    // The memory of the world, as long as it has any.
    class Owned {
      public:
        Owned(std::unique_ptr<Impl> impl) noexcept; // where Impl is known
        Impl* operator->() const {
            if (!impl_) throw_moved_from();
            return impl_.get();
        }
        Impl& operator*() const { return *operator->(); }
        explicit operator bool() const noexcept { return impl_ != nullptr; }

      private:
        std::unique_ptr<Impl> impl_;
    };
    [[noreturn]] static void throw_moved_from();
    Owned impl_;
};

} // namespace cairn
