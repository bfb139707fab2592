/// \file drag.h
/// Dragging a body with the mouse: a servo joint between the world and the grabbed point.
#pragma once

#include "viewer/camera.h"

#include <cairn/cairn.h>

namespace cairn::viewer {

/// The line or plane along which the cursor moves the grabbed point.
enum class DragConstraint {
    view_plane, ///< The plane through the grabbed point that faces the camera.
    vertical,   ///< Straight up and down.
    ground,     ///< The horizontal plane through the grabbed point.
};

inline constexpr double farthest_drag = 1000.0; ///< Greatest distance from the eye to which a point is dragged, meters.

/// The position to which the cursor's ray drags a point grabbed at `grabbed`. `forward`: view direction (unit). A ray
/// that does not meet the constraint's plane keeps `grabbed`. The result is never farther than `max_distance` meters
/// from the ray's origin, so that a ray along the horizon does not send the point to infinity.
Position drag_target(const Ray& cursor, const Position& grabbed, const Vec3& forward, DragConstraint constraint,
                     double max_distance = farthest_drag);

/// Parameters of the drag joint.
struct DragSpring {
    float frequency = 5.0f;           ///< Natural frequency of the spring, Hz, > 0; it is critically damped.
    float max_stretch = 1.0f;         ///< m, > 0: distances beyond this one exert no greater force.
    float max_acceleration = 1000.0f; ///< m/s^2, > 0: times the body's mass, the maximum force along each axis ...
    float max_lift = 50.0f;           ///< m/s^2, >= 0: ... plus this times the mass of the bodies attached by joints.
    float spin_damping = 3.0f;        ///< 1/s, >= 0: decay rate of the angular velocity of a dragged body.
};

/// The joint that drags a dynamic body by `local_point` (in the body's frame); its initial target is the point's
/// present position. Its springs are defined per unit of mass, so that heavy and light bodies follow equally. The mass
/// includes that of bodies attached by joints, up to a hundred times the body's mass, so that a puppet can be carried
/// by its hand. The engine integrates the springs implicitly, so that they are stable for any time step.
JointDef drag_joint(const World& world, BodyId body, const Vec3& local_point, const DragSpring& spring = {});

/// Present world position of the grabbed point.
Position dragged_point(const World& world, JointId drag);

/// To be called before every step: sets the joint's target to `target`, but at most `max_stretch` from the grabbed
/// point.
void pull_to(World& world, JointId drag, const Position& target, const DragSpring& spring = {});

} // namespace cairn::viewer
