/// \file drag.h
/// Moving a body by the mouse: a critically damped spring between the grabbed point and the cursor.
#pragma once

#include "viewer/camera.h"

#include <cairn/cairn.h>

namespace cairn::viewer {

/// Along what the cursor may move the grabbed point.
enum class DragConstraint {
    view_plane, ///< The plane through the grabbed point that faces the camera.
    vertical,   ///< Straight up and down.
    ground,     ///< The horizontal plane through the grabbed point.
};

/// Where the cursor's ray wants a point grabbed at `grabbed` to be. `forward` is where the camera looks (unit).
/// A ray that never meets the constraint's plane keeps `grabbed`, and the point is never taken farther than
/// `max_distance` meters from the ray's origin, so that a ray along the horizon does not send it to infinity.
Position drag_target(const Ray& cursor, const Position& grabbed, const Vec3& forward, DragConstraint constraint,
                     double max_distance = 1000.0);

/// The spring's tunables.
struct DragSpring {
    float frequency = 5.0f;    ///< Hz, > 0, of the undamped spring.
    float max_stretch = 1.0f;  ///< m, > 0: a longer distance pulls no harder than this one.
    float spin_damping = 3.0f; ///< 1/s, >= 0: how fast the turning of a dragged body dies down.
};

/// The force for the next step at the body's point `local_point` (in the body's frame), and the torque that damps its
/// spin. It is what one implicit Euler step of length `dt` of a critically damped spring exerts, scaled by the body's
/// effective mass at the point, so heavy and light bodies follow alike and no time step makes it unstable.
struct DragForce {
    Vec3 force{0.0f, 0.0f, 0.0f};  ///< N.
    Vec3 torque{0.0f, 0.0f, 0.0f}; ///< N m.
    Position point{0.0, 0.0, 0.0}; ///< Where the force acts, world space.
};
DragForce drag_force(const Body& body, const Vec3& local_point, const Position& target, float dt,
                     const DragSpring& spring = {});

} // namespace cairn::viewer
