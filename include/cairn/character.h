/// \file character.h
/// Characters: bodies that walk, jump and climb stairs as the application asks, rather than by forces.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

#include <cstdint>

namespace cairn {

/// How a character moves. A character is a kinematic body that is moved at the beginning of each step: it slides along
/// walls, climbs steps, stands on slopes, falls, is carried by the body on which it stands, and never passes through
/// anything that its shapes collide with. Only its convex shapes count; a capsule along `up` is usual. It rotates with
/// the body on which it stands (about `up`), and otherwise only if the application rotates it.
struct CharacterDef {
    Vec3 up{0.0f, 1.0f, 0.0f}; ///< Direction away from the ground: any non-zero vector; it is normalized.
    /// rad, 0 to 1.57: greatest slope on which the character stands. It slides down steeper slopes and does not walk up
    /// them.
    float max_slope = 0.87f;
    float step_height = 0.3f; ///< m, >= 0: greatest height of a step that it climbs; 0: it climbs none.
    /// m, >= 0: it stays on the ground where this drops by up to this distance within a time step, as on stairs
    /// downwards.
    float stick_distance = 0.3f;
    float skin = 0.02f; ///< m, 1e-4 to 1: the distance that it keeps from all other shapes.
    /// kg, >= 0: the mass with which it acts on dynamic bodies on which it stands or lands, or from which it jumps.
    float mass = 70.0f;
    float max_push_force = 500.0f; ///< N, >= 0: greatest force with which it pushes dynamic bodies that are in its way.
    /// m/s^2, >= 0: greatest acceleration towards the walk velocity while it is in the air.
    float air_acceleration = 10.0f;
    /// true: it moves with the walk velocity in all three directions, and gravity, ground and steps do not act on it:
    /// for swimming, ladders, flying.
    bool flies = false;
};

/// What supports a character.
enum class CharacterSupport : std::uint8_t {
    none,   ///< The character is in the air, or flies.
    steep,  ///< It slides down a slope steeper than `CharacterDef::max_slope`.
    ground, ///< It stands on the ground.
};

/// The motion and support of a character after the last step.
struct CharacterState {
    CharacterSupport support = CharacterSupport::none;
    /// m/s, in world axes, including the velocity of the ground. It differs from the velocity of the body, which is the
    /// displacement in the last step divided by its duration: it excludes the height of stairs that were climbed, and
    /// in the air it is the velocity at the end of the step.
    Vec3 velocity{0.0f, 0.0f, 0.0f};
    ShapeId ground_shape; ///< The shape on which it stands or slides; null in the air, and if that shape was removed.
    BodyId ground_body;   ///< The body of that shape.
    /// Where the character touches it, m, world space; valid unless `support` is none.
    Position ground_point{0.0, 0.0, 0.0};
    Vec3 ground_normal{0.0f, 1.0f, 0.0f}; ///< Unit normal there, out of the ground; valid unless `support` is none.
    /// m/s: velocity of the ground's material there; valid unless `support` is none.
    Vec3 ground_velocity{0.0f, 0.0f, 0.0f};
};

} // namespace cairn
