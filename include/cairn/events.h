/// \file events.h
/// What happened in the last step. Events are buffered during the step and read after it, in an order that
/// depends on the scene alone.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

namespace cairn {

/// Two shapes began to touch.
struct ContactBegin {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
};

/// Two shapes no longer touch, or one of them was removed (its handles are stale then).
struct ContactEnd {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
};

/// Two shapes began to touch with an approach speed of at least WorldDef::hit_speed.
struct ContactHit {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Position point;       ///< Meters, world space.
    Vec3 normal;          ///< Unit, from A to B.
    float approach_speed; ///< m/s, > 0.
    /// When they met: seconds after the beginning of the last step, 0 to its length (but for rounding). Of what bounces
    /// or passes far in a step, the moment of the impact, on a straight way through the step: with gravity at 60 Hz
    /// that is within 0.4 mm of the true way. Of what comes to rest on something, and of bodies that touch others
    /// already or hang on joints: when the gap would close at the approach speed with which the step (or the pass of
    /// it, where something spins) began, without what forces and other contacts do until then; at the end of it at the
    /// latest, as the solver may stop it a substep early, and at its beginning if they overlapped by then. Hits are not
    /// listed in its order.
    float time;
    /// Of a mesh or height field, where it was hit: the number of its material (SurfaceMaterials). Else 0.
    int surface_material = 0;
};

/// A shape began or ceased to overlap a trigger (ShapeDef::is_trigger). Triggers see what is on dynamic and kinematic
/// bodies, characters too; those on dynamic and kinematic bodies see static ones as well. They do not see each other.
/// It is seen at the beginning of each step: what comes in is told after the next one. What passes through within a
/// step has both events in that one, behind those of the beginning, in the order of their times. Handles of what was
/// removed are stale.
struct TriggerEvent {
    ShapeId trigger, other;
    BodyId trigger_body, other_body;
    bool inside; ///< true: it came in; false: it left, or one of the two was removed.
    /// Seconds after the beginning of the last step, 0 to its length: 0 for what is seen there; of what passes within
    /// it, when it came in and when it left, on the way that it took.
    float time;
};

/// A joint is gone: it broke under its load, or one of its bodies was destroyed. Its handle is stale.
struct JointEvent {
    JointId joint;
    BodyId body_a, body_b;       ///< Null: the world.
    bool broke;                  ///< false: a body was destroyed.
    float force = 0.0f;          ///< N: at which it broke.
    float torque = 0.0f;         ///< N m: likewise.
    std::uint64_t user_data = 0; ///< Of its definition.
};

/// A body fell asleep or woke up.
struct SleepEvent {
    BodyId body;
    bool asleep;
};

/// One point of a contact.
struct ContactPoint {
    Position point;       ///< Midway between the two surfaces, meters.
    float separation;     ///< Meters; negative when the shapes overlap.
    float normal_impulse; ///< N s during the last step, >= 0. Divide by the step for the mean force.
};

/// A touching pair of shapes as it stood after the last step. A shape may touch a mesh or height field, and the
/// surfaces of several of its faces, in several of these, one for each normal and material.
struct Contact {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 normal;           ///< Unit, from A to B.
    Vec3 friction_impulse; ///< N s on B during the last step, world axes.
    int point_count;       ///< 1 to 4.
    ContactPoint points[4];
    int surface_material = 0; ///< Of a mesh or height field there: the number of its material (SurfaceMaterials).
};

} // namespace cairn
