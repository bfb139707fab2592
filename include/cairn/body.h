/// \file body.h
/// Rigid bodies: what they are made from, and the light accessor to one.
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
    static_,   ///< Never moves by itself.
    kinematic, ///< Moves with the velocity it is given, and turns about its origin; nothing pushes it.
    dynamic,   ///< Moves by forces and contacts.
};

/// Mass, center of mass and inertia of a body. A `mass` of +infinity, and zero entries of `inertia_diagonal`,
/// stand for what cannot be moved or turned.
struct MassProperties {
    float mass = 1.0f;                                ///< kg, > 0; may be infinite.
    Vec3 center_of_mass{0.0f, 0.0f, 0.0f};            ///< In the body's frame, meters.
    Vec3 inertia_diagonal{1.0f, 1.0f, 1.0f};          ///< Principal moments about the center of mass, kg m^2.
    Quat inertia_orientation{1.0f, 0.0f, 0.0f, 0.0f}; ///< Rotation from principal axes to the body's frame.
};

/// Everything needed to make a body.
struct BodyDef {
    BodyType type = BodyType::dynamic;
    Position position{0.0, 0.0, 0.0};        ///< Origin of the body's frame (not its center of mass), meters.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};   ///< Normalized on entry; must not be zero.
    Vec3 linear_velocity{0.0f, 0.0f, 0.0f};  ///< Of the center of mass, m/s.
    Vec3 angular_velocity{0.0f, 0.0f, 0.0f}; ///< In world axes, rad/s.
    float linear_damping = 0.0f;             ///< 1/s, >= 0: velocity decays as v' = -damping v.
    float angular_damping = 0.0f;            ///< 1/s, >= 0.
    float gravity_scale = 1.0f;              ///< Multiplies the world's gravity for this body; any finite value.
    bool allow_sleep = true;                 ///< false: the body and its island never fall asleep.
    std::optional<float> mass{};             ///< kg, > 0 (+infinity: immovable). Absent: from the shapes' densities.
    std::optional<MassProperties> mass_properties{}; ///< Overrides mass and shapes altogether.
    std::string name{};                              ///< For people; need not be unique.
    std::uint64_t user_data = 0;                     ///< Not touched by the engine.
    bool enabled = true;                             ///< false: it takes no part in the world until it is enabled.
};

/// A light accessor to one body of a world. Cheap to copy and to make (`world.body(id)`); it stays usable as
/// long as the body lives, and every call throws `Error` (invalid_handle) after that.
/// Setters wake the body. Vectors are in world axes, points in world space, unless a name says `local`.
class Body {
  public:
    BodyId id() const noexcept { return id_; }
    BodyType type() const;
    const std::string& name() const;
    std::uint64_t user_data() const;

    Position position() const; ///< Origin of the body's frame, meters.
    Quat rotation() const;
    Transform transform() const;
    Position center_of_mass() const; ///< In world space, meters; of kinematic bodies, their origin, if not given.
    Vec3 linear_velocity() const;    ///< Of the center of mass, m/s.
    Vec3 angular_velocity() const;   ///< rad/s.
    Vec3 velocity_at(const Position& point) const; ///< Of the body's material at a world point, m/s.

    float mass() const; ///< kg; +infinity for static and kinematic bodies.
    MassProperties mass_properties() const;
    Mat3 world_inertia() const;    ///< About the center of mass, world axes, kg m^2.
    Vec3 angular_momentum() const; ///< About the center of mass, kg m^2/s.
    double kinetic_energy() const; ///< Linear and rotational, J; 0 for static and kinematic bodies.
    float gravity_scale() const;
    float linear_damping() const;
    float angular_damping() const;
    bool is_awake() const; ///< Static bodies never are; kinematic ones are while they move.
    bool allow_sleep() const;
    bool enabled() const;
    std::vector<ShapeId> shapes() const;

    /// Teleports the body: velocities stay, contacts are found anew.
    void set_transform(const Position& position, const Quat& rotation);
    void set_position(const Position& position);
    void set_rotation(const Quat& rotation);
    void set_linear_velocity(const Vec3& velocity);
    void set_angular_velocity(const Vec3& velocity);
    /// Kinematic bodies: sets the velocities that bring the body to `target` in `seconds` (> 0).
    void move_to(const Transform& target, float seconds);
    void set_gravity_scale(float scale);
    void set_damping(float linear, float angular);
    void set_allow_sleep(bool allow);
    void set_type(BodyType type);
    /// Takes a body out of the world and puts it back, with its shapes, joints and handles as they are: for what is
    /// used again and again, or not yet. What is disabled does not move and keeps its velocities; nothing touches it,
    /// queries do not see it, its joints do not act, and energies and momenta are without it. All of it may be changed,
    /// but nothing can push it: forces and impulses are refused (wrong_state). What it touched ends with a ContactEnd,
    /// and wakes; where it is put back into something, it is pushed out as what is made there.
    void set_enabled(bool enabled);
    void set_name(std::string_view name);
    /// Replaces the mass properties; they no longer follow the shapes. Dynamic bodies only.
    void set_mass_properties(const MassProperties& properties);
    /// Mass properties follow the shapes' densities again, scaled to `mass` if given.
    void set_mass_from_shapes(std::optional<float> mass = std::nullopt);
    void wake();
    /// Brings a dynamic body to rest and lets it sleep from the next step on, as it is, even in the air: before
    /// anything moves, provided that all that touches it or is joined to it was told so, too, and all may sleep. A
    /// level that is made asleep costs nothing until something comes; then it settles like anything that is made. What
    /// moves or pushes the body in between wakes it, as ever.
    void sleep();

    void add_force(const Vec3& force); ///< N, at the center of mass; acts during the next step only.
    void add_force_at(const Vec3& force, const Position& point); ///< N, at a world point; next step only.
    void add_torque(const Vec3& torque);                         ///< N m; next step only.
    void apply_impulse(const Vec3& impulse); ///< N s, at the center of mass; changes the velocity at once.
    void apply_impulse_at(const Vec3& impulse, const Position& point); ///< N s, at a world point.
    void apply_angular_impulse(const Vec3& impulse);                   ///< N m s.

    // --- characters (character.h)
    bool is_character() const;
    CharacterDef character() const; ///< Throws (wrong_state) unless it is one.
    /// Makes a kinematic body a character, or changes how one moves. From then on its velocities are those with which
    /// each step moves it, and setting its linear velocity throws it: upwards, it leaves the ground.
    void set_character(const CharacterDef& def);
    void remove_character(); ///< It is an ordinary kinematic body again, at rest.
    Vec3 walk_velocity() const;
    /// Where a character wants to go, m/s, until it is set anew: over the ground, with this speed and, seen from above,
    /// in this direction, beside the motion of the ground itself. What of it leads up or down counts for those alone
    /// that fly.
    void set_walk_velocity(const Vec3& velocity);
    /// In the next step, a character that stands on the ground leaves it with this speed, m/s, > 0; others do not.
    void jump(float speed);
    CharacterState character_state() const;

  private:
    friend class World;
    Body(World& world, BodyId id) : world_(&world), id_(id) {}
    World* world_;
    BodyId id_;
};

} // namespace cairn
