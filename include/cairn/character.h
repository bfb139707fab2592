/// \file character.h
/// Characters: bodies that walk, jump and climb stairs by what they are asked to do, rather than by forces.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

#include <cstdint>

namespace cairn {

/// How a character moves. A character is a kinematic body that is moved at the beginning of each step: it slides along
/// walls, climbs steps, stands on slopes, falls, is carried by what it stands on, and never passes through anything
/// that its shapes collide with. Its shapes must be convex to count; a capsule along `up` is usual. It does not turn by
/// itself, but for what it stands on.
struct CharacterDef {
    Vec3 up{0.0f, 1.0f, 0.0f};      ///< Away from the ground; any non-zero vector, it is normalized.
    float max_slope = 0.87f;        ///< rad, 0 to 1.57: it slides down what is steeper, and does not walk up there.
    float step_height = 0.3f;       ///< m, >= 0: it climbs steps up to this height; 0: none.
    float stick_distance = 0.3f;    ///< m, >= 0: it stays on ground that falls away by up to this in a step.
    float skin = 0.02f;             ///< m, 1e-4 to 1: the distance that it keeps from everything.
    float mass = 70.0f;             ///< kg, >= 0: what dynamic bodies feel that it stands on, lands on or jumps off.
    float max_push_force = 500.0f;  ///< N, >= 0: it pushes dynamic bodies out of its way with no more than this.
    float air_acceleration = 10.0f; ///< m/s^2, >= 0: how fast its velocity follows the wanted one in the air.
    /// It moves with the wanted velocity in all directions, without gravity, ground and steps: for swimming, ladders,
    /// flying.
    bool flies = false;
};

/// What a character is on.
enum class CharacterSupport : std::uint8_t {
    none,   ///< It is in the air, or flies.
    steep,  ///< It slides down something steeper than `CharacterDef::max_slope`.
    ground, ///< It stands.
};

/// How a character moves, as it stood after the last step.
struct CharacterState {
    CharacterSupport support = CharacterSupport::none;
    /// m/s, in world axes, that of the ground included. Unlike the velocity of its body, which is by how much the last
    /// step moved it, it is without steps that were climbed, and in the air it is that at the end of the step.
    Vec3 velocity{0.0f, 0.0f, 0.0f};
    ShapeId ground_shape;                   ///< What it is on; null in the air, and when that was removed.
    BodyId ground_body;                     ///< Its body.
    Position ground_point{0.0, 0.0, 0.0};   ///< Where it touches that, m; valid unless `support` is none.
    Vec3 ground_normal{0.0f, 1.0f, 0.0f};   ///< Unit, out of it; likewise.
    Vec3 ground_velocity{0.0f, 0.0f, 0.0f}; ///< m/s, of its material there; likewise.
};

} // namespace cairn
