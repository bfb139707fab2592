/// \file world.h
/// A world of rigid bodies.
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

/// Settings of a world. All may be changed later through `World::set_settings`.
struct WorldDef {
    Vec3 gravity{0.0f, -9.81f, 0.0f}; ///< m/s^2, finite.
    int substeps = 0;                 ///< Solver substeps of one step, 1 to 256; or 0: as many as make them no
                                      ///< longer than 1/360 s (6 at 60 Hz, 2 at 240 Hz).
    bool adaptive_substeps = true;    ///< Take more in islands that ask for it: with joints (no longer than 1/660 s),
                                      ///< high mass ratios, tall stacks, bodies less than 10 cm wide.
    Integrator integrator = Integrator::semi_implicit_euler;
    bool enable_sleep = true;          ///< Islands at rest stop costing time.
    float sleep_speed = 0.05f;         ///< m/s; a body slower than this at its surface may sleep. >= 0.
    float sleep_time = 0.5f;           ///< s at rest before an island sleeps, unless it gains speed steadily. >= 0.
    float restitution_speed = 0.02f;   ///< m/s; slower impacts do not bounce. >= 0.
    float hit_speed = 1.0f;            ///< m/s; least approach speed for a hit event. >= 0.
    float recovery_speed = 3.0f;       ///< m/s; overlaps are pushed apart no faster than this. > 0.
    float max_linear_speed = 2000.0f;  ///< m/s; faster bodies are slowed to this, and counted. > 0, at most 1e15.
    float max_angular_speed = 1000.0f; ///< rad/s; likewise.
};

/// A field that acts on every dynamic body: an acceleration or a force, evaluated at its center of mass, or a fluid.
///
/// A fluid (water, oil, air) fills a box below its surface, which is level: perpendicular to the world's gravity,
/// through `center`. It lifts what is in it by the weight of what that displaces (Archimedes), in the world's gravity,
/// and resists motion against it: each piece of a body's surface that moves against the fluid with the speed s along
/// its normal is pushed back by drag x density x s^2 / 2 for each square meter, and each piece that slides along it
/// with the speed t by skin_friction x density x t^2 / 2. So a plate has a drag coefficient of `drag`, a ball one of
/// half of that. Some of the fluid moves along with a body (`added_mass`). There are no waves, but what bobs loses its
/// motion as if there were (`wave_damping`). It acts on solids, not on triggers; at the sides of the box on what is
/// within, at its bottom on shapes with their middle above that. Where fluids overlap, both act.
struct ForceField {
    enum class Kind : std::uint8_t {
        uniform, ///< The same everywhere, along `direction`.
        radial,  ///< Towards `center`, `strength` x distance^`exponent`.
        fluid,   ///< A fluid with a level surface through `center`, which flows with the velocity `direction`.
    };
    Kind kind = Kind::uniform;
    Vec3 direction{0.0f, 0.0f, 0.0f}; ///< Uniform: acceleration in m/s^2 (or force in N, see `is_force`). Fluid: m/s.
    Position center{0.0, 0.0, 0.0};   ///< Radial: the point that attracts, meters. Fluid: the middle of its surface.
    float strength = 0.0f;            ///< Radial: m/s^2 (or N) at a distance of one meter; negative repels.
    float exponent = 0.0f;            ///< Radial: 0 constant, 1 spring, -1, -2 gravity of a point. One of -2,-1,0,1.
    bool is_force = false;            ///< false: an acceleration, equal for all masses; true: a force.
    /// Fluid: how far it reaches from `center` along the axes of the world, meters, > 0; may be infinite. Along the
    /// axis nearest to gravity it is the depth.
    Vec3 half_extents{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
                      std::numeric_limits<float>::infinity()};
    float density = 1000.0f;     ///< Fluid: kg/m^3, >= 0. The default is that of water.
    float drag = 1.0f;           ///< Fluid: coefficient of what is pushed ahead, >= 0.
    float skin_friction = 0.01f; ///< Fluid: coefficient of what is dragged along, >= 0.
    float added_mass = 0.5f;     ///< Fluid: how much of it moves along, >= 0, of what a body displaces; a ball: 0.5.
    float wave_damping = 0.2f;   ///< Fluid: how fast bobbing is lost to waves, >= 0, of critical damping.
};

/// Wall-clock time of the stages of the last step, in milliseconds. Snapshots do not keep it: 0 after `World::restore`.
struct StageTimes {
    double broad_phase = 0, narrow_phase = 0, islands = 0, prepare = 0, solve = 0, finalize = 0, total = 0;
};

/// Counts and times of the last step.
struct Statistics {
    std::uint64_t steps = 0; ///< Steps since the world was made.
    double time = 0;         ///< Simulated seconds since then.
    std::size_t bodies = 0, dynamic_bodies = 0, awake_bodies = 0, shapes = 0;
    std::size_t candidate_pairs = 0; ///< Pairs whose bounds overlap.
    /// Of those, how many the last step has tested. The others were well apart or asleep, or their bodies have moved by
    /// a few millimeters at most since they were.
    std::size_t tested_pairs = 0;
    std::size_t contacts = 0;       ///< Touching pairs of shapes, asleep ones included.
    std::size_t contact_points = 0; ///< Their points.
    std::size_t islands = 0;        ///< Awake islands.
    std::size_t sleeping_islands = 0;
    std::size_t colors = 0;
    std::size_t overflow_contacts = 0; ///< Contacts that found no free color, solved one by one.
    std::uint64_t clamped_speeds = 0;  ///< Since the world was made: velocities cut to the maximum.
    int max_substeps = 0;              ///< Most substeps that any island took.
    double max_penetration = 0;        ///< Deepest overlap, meters, >= 0.
    std::size_t swept_pairs = 0;       ///< In the last step: pairs looked at along their ways, as one moved far.
    std::size_t impacts = 0;           ///< In the last step: impacts of bodies in flight, several of one body included.
    std::size_t stopped_bodies = 0;    ///< In the last step: bodies held where they met what the solver did not know.
    StageTimes times;
};

/// Which instruction set the kernels of this process use: "avx512", "avx2", "sse2", "neon", "simd128" or "scalar".
/// Chosen at start-up from what the CPU offers; the environment variable CAIRN_ISA forces one. Results do not depend on
/// it.
std::string_view instruction_set() noexcept;

/// The number of threads that this machine runs at a time, 1 to 256: a good argument for `World::set_threads`.
int hardware_threads() noexcept;

/// A world. Handles carry the number of their world; numbers repeat after 65,535 worlds, and a restored world has that
/// of the one that was saved. A `Body` accessor refers to the World object: it is of no use after that was moved,
/// and must not be used after it was destroyed. Worlds are independent of each other; one world must not be used by two
/// threads at a time, except for the const members, which may run on many threads while no non-const member runs: calls
/// that would change a world in mid-step throw (wrong_state). Where memory runs out, std::bad_alloc arrives, and the
/// world is either as it was, or refuses everything (wrong_state) until `restore` makes it whole again. A world that
/// was moved from may be destroyed and assigned to; `is_valid` is false of all handles, and every other call throws
/// (wrong_state), those of its `Body` accessors, too.
class World {
  public:
    explicit World(const WorldDef& def = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    const WorldDef& settings() const;
    void set_settings(const WorldDef& def); ///< Throws on a bad value. Wakes everything if gravity changes.
    /// The substeps of a step of `dt` seconds, where no island asks for more: `WorldDef::substeps`, or what its 0
    /// stands for. Throws unless `dt` is finite and > 0.
    int usual_substeps(float dt) const;

    /// The number of threads that a step may use: that of the caller, and `count` - 1 more that the world keeps. 1 to
    /// 256; default 1. Results do not depend on it. Snapshots do not hold it. Throws outside that range, or when the
    /// system has no more threads.
    void set_threads(int count);
    int threads() const;

    /// The processes that step this world together from now on; null, or one of size 1: this one alone. Each shall have
    /// made the same calls since the world was empty or restored, and makes the same calls from then on, `step` in all
    /// of them at a time. Each has all bodies, but the points and impulses of its own contacts alone: `contacts`,
    /// `save`, `restore`, `SnapshotRing::push` and `set_communicator` itself ask the others for theirs, and are called
    /// by all of them, too, by one thread at a time. Results do not depend on how many there are. Snapshots do not hold
    /// it. Throws on a rank that is not below the size (docs/scale.md).
    void set_communicator(std::shared_ptr<Communicator> communicator);

    // --- bodies and shapes
    BodyId create_body(const BodyDef& def = {});
    void destroy_body(BodyId body); ///< With its shapes and joints; wakes what rested on it.
    bool is_valid(BodyId body) const noexcept;
    Body body(BodyId body);
    const Body body(BodyId body) const;
    std::vector<BodyId> bodies() const;                           ///< All, in order of slot index.
    std::optional<BodyId> find_body(std::string_view name) const; ///< The first of that name.

    /// Adds a shape to a body and, unless its mass properties were given, updates them. A dynamic body whose shapes
    /// have no mass at all is a point of its given mass, or of 1 kg, that does not turn. Planes are refused on
    /// dynamic bodies.
    ShapeId add_shape(BodyId body, const Shape& shape, const ShapeDef& def = {});
    void remove_shape(ShapeId shape);
    /// Gives a shape another geometry, in place: its handle and all that its definition says stay. The mass of the body
    /// follows as in `add_shape`. What it touches then goes on touching it, without events, as long as it is of the
    /// same type; else its contacts end and begin anew. What overlaps it then is pushed out, no faster than
    /// `WorldDef::recovery_speed`: ground that rises carries what is on it if it rises more slowly than that, and by
    /// less than the height of that in one call. Wakes its body and what is around the shape, before and after.
    void set_shape(ShapeId shape, const Shape& geometry);
    /// Likewise gives it another definition: place on its body, density, material, filter, and what else that says. Its
    /// contacts end and begin anew where `is_trigger` or `filter` is not what it was.
    void set_shape_def(ShapeId shape, const ShapeDef& def);
    bool is_valid(ShapeId shape) const noexcept;
    BodyId body_of(ShapeId shape) const;
    const Shape& shape(ShapeId shape) const;
    const ShapeDef& shape_def(ShapeId shape) const;
    Transform shape_transform(ShapeId shape) const; ///< In world space.
    Bounds shape_bounds(ShapeId shape) const;       ///< Tight; infinite for infinite planes.
    void set_material(ShapeId shape, const Material& material);
    void set_filter(ShapeId shape, const CollisionFilter& filter);
    /// See ShapeDef::surface_velocity. Throws (wrong_state) for a shape of a dynamic body.
    void set_surface_velocity(ShapeId shape, const Vec3& velocity);

    // --- joints
    /// Joins two bodies, or a body and the world. Wakes them.
    JointId create_joint(const JointDef& def);
    /// The definition of a joint whose frames both lie at `anchor`, with x along `axis` (any non-zero vector; world
    /// space), and y and z as the shortest turn from those of the world has them: -x and z if `axis` points up. As the
    /// bodies stand now.
    JointDef joint_at(BodyId body_a, BodyId body_b, const Position& anchor, const Vec3& axis, const Joint& joint) const;
    void destroy_joint(JointId joint);
    bool is_valid(JointId joint) const noexcept;
    const JointDef& joint_def(JointId joint) const;
    /// Changes limits, motors, springs, or the kind of the joint. Wakes its bodies.
    void set_joint(JointId id, const Joint& joint);
    void set_joint_strength(JointId joint, float break_force, float break_torque); ///< N and N m, > 0; may be infinite.
    /// A joint that is disabled keeps its definition and its handle, and acts on nothing: its bodies move, and collide,
    /// as if it had been destroyed. Enabled again it begins without impulses, and brings its bodies together where they
    /// have parted. Both wake them.
    void set_joint_enabled(JointId joint, bool enabled);
    JointState joint_state(JointId joint) const;
    std::vector<JointId> joints() const;                            ///< All, in order of slot index.
    std::vector<JointId> joints(BodyId body) const;                 ///< Those of one body, oldest first.
    std::optional<JointId> find_joint(std::string_view name) const; ///< The first of that name.

    // --- force fields
    ForceFieldId add_force_field(const ForceField& field);
    void set_force_field(ForceFieldId id, const ForceField& field);
    void remove_force_field(ForceFieldId id);
    bool is_valid(ForceFieldId id) const noexcept;
    const ForceField& force_field(ForceFieldId id) const;
    std::vector<ForceFieldId> force_fields() const; ///< All, in order of slot index.

    // --- time
    /// Advances by `dt` seconds (> 0, finite). The same dt every time gives the best results.
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
    std::vector<Contact> contacts() const;            ///< All touching pairs.
    std::vector<Contact> contacts(BodyId body) const; ///< Those of one body.

    // --- queries; `filter`: which shapes they see. Throws (invalid_handle) if it ignores a body that does not exist.
    /// The nearest shape that the ray meets within `max_distance`. `direction` need not be unit length. A ray
    /// that starts inside a shape does not meet that shape's surface from within, except planes' solid side.
    std::optional<RayHit> cast_ray(const Position& origin, const Vec3& direction, double max_distance,
                                   const QueryFilter& filter = {}) const;
    /// Every shape that the ray meets, nearest first.
    std::vector<RayHit> cast_ray_all(const Position& origin, const Vec3& direction, double max_distance,
                                     const QueryFilter& filter = {}) const;
    /// The first shape that the given convex one meets when it moves by `translation` (meters) from `start` without
    /// turning, within a millionth of the size of the smaller one. Where they overlap from the start, the fraction is
    /// 0, and point and normal are those of the shortest way apart; of several such shapes that of the lowest slot
    /// counts. Planes, meshes and height fields are met from outside only, and cannot be cast themselves
    /// (invalid_value).
    std::optional<ShapeCastHit> cast_shape(const Shape& shape, const Transform& start, const Vec3& translation,
                                           const QueryFilter& filter = {}) const;
    /// The shape nearest to a point, up to `max_distance` (meters, >= 0) away. What is below a plane is inside it;
    /// meshes and height fields have no inside.
    std::optional<ClosestPoint> closest_point(const Position& point, double max_distance,
                                              const QueryFilter& filter = {}) const;
    /// Shapes that have a point in common with the given one posed in the world (touching counts), in order of slot
    /// index. A plane is solid below. Rectangles, strips, double-sided planes, meshes and height fields are surfaces
    /// without thickness: what touches or crosses them from any side overlaps them, what lies below does not. Two
    /// surfaces never overlap.
    std::vector<ShapeId> overlap(const Shape& shape, const Transform& pose, const QueryFilter& filter = {}) const;
    /// Shapes whose tight bounds overlap the box, in order of slot index.
    std::vector<ShapeId> overlap_bounds(const Bounds& bounds, const QueryFilter& filter = {}) const;

    /// The boxes of the broad phase as they stand, down to that depth, for pictures and for who wants to know why a
    /// scene is slow: those of least depth first, and no more than `max_count`. Both >= 0.
    std::vector<BroadPhaseNode> broad_phase_nodes(int max_depth, int max_count) const;

    /// How each touching pair of shapes is solved, in the order of `contacts()`.
    std::vector<SolverContact> solver_contacts() const;

    /// What it consists of as lines, for programs that draw it themselves: bodies in order of slot index, then
    /// contacts, then joints. As many as there are edges: of large meshes and height fields that takes its time.
    std::vector<DebugLine> debug_lines(const DebugLinesDef& what = {}) const;

    // --- bulk reads, for renderers and bindings
    /// Writes the transform of each body of `ids`; `out` must have the same size.
    void read_transforms(std::span<const BodyId> ids, std::span<Transform> out) const;

    // --- whole-world measures
    double kinetic_energy() const;       ///< J, of all dynamic bodies.
    double potential_energy() const;     ///< J in the world's gravity, relative to the origin.
    glm::dvec3 linear_momentum() const;  ///< kg m/s, of all dynamic bodies.
    glm::dvec3 angular_momentum() const; ///< kg m^2/s about the origin, of all dynamic bodies.
    std::uint64_t state_hash() const;    ///< Of positions, rotations and velocities, by bits.
    StateDigest state_digest() const;    ///< Likewise, as sums over the bodies.
    /// The bodies in which this world differs from one of that digest. Empty if it does not, and if it differs in more
    /// than two or in one that is not here: the digests tell whether it does.
    std::vector<BodyId> bodies_that_differ(const StateDigest& other) const;
    Statistics statistics() const;

    // --- snapshots
    Snapshot save() const;
    /// Makes this world the one that was saved. Handles from then are valid again; those of what was made since are
    /// stale, until the same ones name what is made next. Throws on a damaged snapshot, leaving the world as it was.
    void restore(const Snapshot& snapshot);

    // --- commands (commands.h)
    /// Who is told of every change from now on; null: nobody. It is told first how the world is: by the settings of an
    /// empty world to which nothing has happened, by a snapshot of any other. Numbers of threads are not told.
    /// Snapshots do not hold it; `restore` is told like any other change. What it throws then is thrown here, and
    /// nobody is told.
    void set_command_listener(std::shared_ptr<CommandListener> listener);
    /// Makes a change that a listener was told of, in this world or another one. Handles in it stand for what has the
    /// same slot and generation here. Throws `Error`: what the call throws, `invalid_file` if the bytes are no command,
    /// `unsupported` if it is of a later version; the world stays as it was.
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
