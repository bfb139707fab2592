/// \file events.h
/// Events of the last step, and contacts. Events are buffered during a step and read after it; their order depends on
/// the scene alone.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

namespace cairn {

/// Two shapes began to touch.
struct ContactBegin {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
};

/// Two shapes ceased to touch, or one of them was removed (its handle is then stale).
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
    /// Time of the hit: seconds after the beginning of the last step, 0 to its length (except for rounding). Hits are
    /// not sorted by it. For bodies that bounce, or that move far within the step, it is the time of impact on a
    /// straight path through the step; at 60 Hz under gravity this path is within 0.4 mm of the true one. For bodies
    /// that come to rest, that already touch others, or that have joints, it is the time at which the gap would close
    /// at the approach speed at the beginning of the step (of the current pass through the step where a body spins),
    /// ignoring forces and other contacts until then. It is then limited to the end of the step, because the solver may
    /// stop the approach a substep early, and is 0 if the shapes overlapped at the beginning.
    float time;
    /// Number of the material (SurfaceMaterials) of the mesh or height field where it was hit; 0 for other shapes.
    int surface_material = 0;
};

/// A shape began or ceased to overlap a trigger (ShapeDef::is_trigger). Every trigger detects shapes of dynamic and
/// kinematic bodies, including characters; triggers on dynamic and kinematic bodies detect shapes of static bodies as
/// well. Triggers do not detect each other. Overlaps are tested at the beginning of each step, so that a shape that
/// enters in one step is reported by the next. A shape that enters and leaves within one step has both events in that
/// step; these are listed after those found at its beginning, sorted by time. Handles of removed shapes are stale.
struct TriggerEvent {
    ShapeId trigger, other;
    BodyId trigger_body, other_body;
    bool inside; ///< true: the shape entered; false: it left, or one of the two shapes was removed.
    /// Seconds after the beginning of the last step, 0 to its length. It is 0 for overlaps found at the beginning; for
    /// a shape that passes through within the step, it is the time at which the shape, on its path, entered or left.
    float time;
};

/// A joint was removed by the engine: it broke under its load, or one of its bodies was destroyed. Its handle is stale.
struct JointEvent {
    JointId joint;
    BodyId body_a, body_b; ///< Null stands for the world.
    bool broke;            ///< true: it exceeded its break force or torque; false: one of its bodies was destroyed.
    float force = 0.0f;    ///< N: force at which it broke.
    float torque = 0.0f;   ///< N m: torque at which it broke.
    std::uint64_t user_data = 0; ///< JointDef::user_data.
};

/// A body fell asleep or woke up.
struct SleepEvent {
    BodyId body;
    bool asleep;
};

/// One point of a contact.
struct ContactPoint {
    Position point;   ///< Midway between the two surfaces, meters, world space.
    float separation; ///< Meters; negative when the shapes overlap.
    /// N s: normal impulse during the last step, >= 0. Divided by the length of the step it is the mean force.
    float normal_impulse;
};

/// A contact manifold of a touching pair of shapes, after the last step. A shape that touches a mesh or height field
/// may have several manifolds with it, one for each normal and material.
struct Contact {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 normal;           ///< Unit, from A to B.
    Vec3 friction_impulse; ///< N s: friction impulse on B during the last step, world axes.
    int point_count;       ///< 1 to 4.
    ContactPoint points[4];
    /// Number of the material (SurfaceMaterials) of the mesh or height field there; 0 for other shapes.
    int surface_material = 0;
};

} // namespace cairn
