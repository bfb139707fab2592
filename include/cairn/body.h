/// \file body.h
/// Rigid bodies: their definition (BodyDef), and a lightweight accessor to one body of a world (Body).
#pragma once

#include <cairn/character.h>
#include <cairn/handle.h>
#include <cairn/math.h>
#include <cairn/shape.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn {

class World;

enum class BodyType : std::uint8_t {
    static_, ///< Never moves by itself.
    /// Moves with the velocities that it is given, rotating about its origin. Forces and contacts do not change them.
    kinematic,
    dynamic, ///< Moves by forces and contacts.
};

/// Mass, center of mass and inertia of a body. With a `mass` of +infinity forces do not translate the body; a zero
/// entry of `inertia_diagonal` keeps torques from rotating it about that principal axis.
struct MassProperties {
    float mass = 1.0f;                                ///< kg, > 0; may be infinite.
    Vec3 center_of_mass{0.0f, 0.0f, 0.0f};            ///< In the body's frame, meters.
    Vec3 inertia_diagonal{1.0f, 1.0f, 1.0f};          ///< Principal moments about the center of mass, kg m^2.
    Quat inertia_orientation{1.0f, 0.0f, 0.0f, 0.0f}; ///< Rotation from principal axes to the body's frame.
};

/// Everything that is needed to create a body (`World::create_body`).
struct BodyDef {
    BodyType type = BodyType::dynamic;
    Position position{0.0, 0.0, 0.0};        ///< Origin of the body's frame (not its center of mass), meters.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};   ///< Normalized on entry; must not be zero.
    Vec3 linear_velocity{0.0f, 0.0f, 0.0f};  ///< Of the center of mass, m/s.
    Vec3 angular_velocity{0.0f, 0.0f, 0.0f}; ///< In world axes, rad/s.
    float linear_damping = 0.0f;             ///< 1/s, >= 0: velocity decays as v' = -damping v.
    float angular_damping = 0.0f;            ///< 1/s, >= 0: the same for the angular velocity.
    float gravity_scale = 1.0f;              ///< Multiplies the world's gravity for this body; any finite value.
    bool allow_sleep = true;                 ///< false: the body and its island never fall asleep.
    /// Total mass in kg, > 0 (+infinity: immovable), to which the mass properties of the shapes are scaled. Absent: the
    /// mass follows from the densities of the shapes.
    std::optional<float> mass{};
    std::optional<MassProperties> mass_properties{}; ///< Used in place of `mass` and of the shapes' densities.
    std::string name{};                              ///< For display and `World::find_body`; need not be unique.
    std::uint64_t user_data = 0;                     ///< Stored for the application; the engine does not use it.
    bool enabled = true; ///< false: the body does not take part in the simulation until `Body::set_enabled`.
};

/// A lightweight accessor to one body of a world, cheap to create (`world.body(id)`) and to copy. It can be used as
/// long as the body exists; after that, every call throws `Error` (invalid_handle). Setters wake the body. Vectors are
/// in world axes and points in world space. Invalid values throw `Error` (invalid_value); calls that do not fit the
/// type or the state of the body throw wrong_state.
class Body {
  public:
    BodyId id() const noexcept { return id_; }
    BodyType type() const;
    const std::string& name() const;
    std::uint64_t user_data() const;

    Position position() const; ///< Origin of the body's frame, meters.
    Quat rotation() const;
    Transform transform() const;
    /// In world space, meters. For a kinematic body: its origin, unless BodyDef::mass_properties gave a center of mass.
    Position center_of_mass() const;
    Vec3 linear_velocity() const;                  ///< Of the center of mass, m/s.
    Vec3 angular_velocity() const;                 ///< rad/s.
    Vec3 velocity_at(const Position& point) const; ///< Velocity of the body's material at a point in world space, m/s.

    float mass() const; ///< kg; +infinity for static and kinematic bodies.
    MassProperties mass_properties() const;
    Mat3 world_inertia() const;    ///< About the center of mass, world axes, kg m^2.
    Vec3 angular_momentum() const; ///< About the center of mass, kg m^2/s.
    double kinetic_energy() const; ///< Linear and rotational, J; 0 for static and kinematic bodies.
    float gravity_scale() const;
    float linear_damping() const;
    float angular_damping() const;
    /// A static or disabled body never is; a kinematic body is while one of its velocities is not zero.
    bool is_awake() const;
    bool allow_sleep() const;
    bool enabled() const;
    std::vector<ShapeId> shapes() const;

    /// Teleports the body: its velocities stay, and its contacts are detected afresh in the next step.
    void set_transform(const Position& position, const Quat& rotation);
    void set_position(const Position& position);
    void set_rotation(const Quat& rotation);
    void set_linear_velocity(const Vec3& velocity);
    void set_angular_velocity(const Vec3& velocity);
    /// Sets the velocities of a kinematic body such that it reaches `target` after `seconds` (> 0). It keeps these
    /// velocities afterwards. Throws (wrong_state) for bodies of other types.
    void move_to(const Transform& target, float seconds);
    void set_gravity_scale(float scale);
    void set_damping(float linear, float angular);
    void set_allow_sleep(bool allow);
    void set_type(BodyType type);
    /// Takes the body out of the simulation (false) or puts it back (true), and keeps its shapes, joints and handles.
    /// This suits bodies that are reused often, or that are needed only later. A disabled body does not move but keeps
    /// its velocities; it has no contacts, queries do not find it, its joints do not act, and energies and momenta of
    /// the world exclude it. Its properties may be changed, but forces and impulses are refused (wrong_state). When it
    /// is disabled, its contacts end with a ContactEnd, and the bodies that it touched wake. If it overlaps others when
    /// it is enabled, it is pushed out of them like a newly created body.
    void set_enabled(bool enabled);
    void set_name(std::string_view name);
    /// Sets the mass properties, which then do not follow the shapes. Dynamic bodies only; throws (wrong_state) for
    /// others.
    void set_mass_properties(const MassProperties& properties);
    /// Makes the mass properties follow the densities of the shapes again, scaled to a total of `mass` (kg, > 0) if it
    /// is given. Dynamic bodies only; throws (wrong_state) for others.
    void set_mass_from_shapes(std::optional<float> mass = std::nullopt);
    void wake();
    /// Sets the velocities of a dynamic body to zero and puts it to sleep at the beginning of the next step, at its
    /// present place, even in the air. This requires that `sleep` was called for all bodies of its island, that is,
    /// also for those that it touches or is joined to, and that all of them may sleep. A level that is created asleep
    /// costs no time until something wakes it; then it settles like newly created bodies. Calls that move or push the
    /// body before that step wake it as usual. No effect on other types of bodies, and where WorldDef::enable_sleep is
    /// false.
    void sleep();

    void add_force(const Vec3& force); ///< N, at the center of mass; acts during the next step only.
    void add_force_at(const Vec3& force, const Position& point); ///< N, at a world point; next step only.
    void add_torque(const Vec3& torque);                         ///< N m; next step only.
    void apply_impulse(const Vec3& impulse); ///< N s, at the center of mass; changes the velocity at once.
    void apply_impulse_at(const Vec3& impulse, const Position& point); ///< N s, at a world point.
    void apply_angular_impulse(const Vec3& impulse);                   ///< N m s.

    // --- characters (character.h)
    bool is_character() const;
    CharacterDef character() const; ///< Throws (wrong_state) if the body is no character.
    /// Makes a kinematic body a character, or changes the definition of a character. From then on each step sets the
    /// velocities of the body to those with which it moves the character. `set_linear_velocity` then throws the
    /// character: with an upward velocity, it leaves the ground.
    void set_character(const CharacterDef& def);
    void remove_character(); ///< Makes it an ordinary kinematic body again, at rest.
    Vec3 walk_velocity() const;
    /// Sets the velocity with which a character tries to move, m/s, relative to the ground; it holds until the next
    /// call. The character moves along the ground with this speed, in this direction as seen from above. The component
    /// along CharacterDef::up is used only if the character flies (CharacterDef::flies).
    void set_walk_velocity(const Vec3& velocity);
    /// A character that stands on the ground leaves it in the next step with this upward speed, m/s, > 0. No effect on
    /// a character that does not stand then.
    void jump(float speed);
    CharacterState character_state() const;

  private:
    friend class World;
    Body(World& world, BodyId id) : world_(&world), id_(id) {}
    World* world_;
    BodyId id_;
};

} // namespace cairn
