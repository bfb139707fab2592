/// \file drag.h
/// Moving a body by the mouse: a servo joint between the world and the grabbed point.
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

inline constexpr double farthest_drag = 1000.0; ///< Meters, from the eye.

/// Where the cursor's ray wants a point grabbed at `grabbed` to be. `forward` is where the camera looks (unit).
/// A ray that never meets the constraint's plane keeps `grabbed`, and the point is never taken farther than
/// `max_distance` meters from the ray's origin, so that a ray along the horizon does not send it to infinity.
Position drag_target(const Ray& cursor, const Position& grabbed, const Vec3& forward, DragConstraint constraint,
                     double max_distance = farthest_drag);

/// The joint's tunables.
struct DragSpring {
    float frequency = 5.0f;           ///< Hz, > 0, of the undamped spring; it is critically damped.
    float max_stretch = 1.0f;         ///< m, > 0: a longer distance pulls no harder than this one.
    float max_acceleration = 1000.0f; ///< m/s^2, > 0: times the body's mass, the greatest force along each axis ...
    float max_lift = 50.0f;           ///< m/s^2, >= 0: ... and times the mass of what hangs on it by joints.
    float spin_damping = 3.0f;        ///< 1/s, >= 0: how fast the turning of a dragged body dies down.
};

/// The joint that drags a dynamic body by `local_point` (in the body's frame); its target is where that point is now.
/// Its springs are those of accelerations, so heavy and light bodies follow alike, and a hand carries its puppet: what
/// is joined to the body counts too, up to a hundred times its mass. The engine steps the springs implicitly, so no
/// time step makes them unstable.
JointDef drag_joint(const World& world, BodyId body, const Vec3& local_point, const DragSpring& spring = {});

/// Where the grabbed point is now.
Position dragged_point(const World& world, JointId drag);

/// To be called before every step: pulls the grabbed point towards `target`.
void pull_to(World& world, JointId drag, const Position& target, const DragSpring& spring = {});

} // namespace cairn::viewer
