// Mass, poses and bounds of bodies and their shapes.
#pragma once

#include "state/state.h"

#include <algorithm>

namespace cairn {

// Recomputes the mass properties of a body from its shapes, if they follow them, and with them the center of mass. The
// body's origin and the velocity field of its material stay where they are.
void refresh_mass(Bodies& bodies, const Shapes& shapes, Joints& joints, std::int32_t body);

// Gives a body these mass properties; the center of mass moves, the body's origin does not.
void set_mass(Bodies& bodies, Joints& joints, std::int32_t body, const MassProperties& properties);

// Recomputes world poses and arms of a body's shapes, and the body's radius, after its pose or shapes changed.
void place_shapes(Bodies& bodies, Shapes& shapes, std::int32_t body);

// Sets the pose of a shape with its middle at `position`, on a body with the rotation `q`; the size stays.
inline void pose_shape(ShapePose& pose, const Geometry& geometry, math::DVec3 position, math::Quat q) {
    for (int i = 0; i < 3; ++i) {
        pose.high[i] = float(position[i]);
        pose.low[i] = float(position[i] - double(pose.high[i]));
    }
    const math::Quat r = geometry.is_turned ? q * geometry.rotation : q;
    pose.q[0] = r.x, pose.q[1] = r.y, pose.q[2] = r.z, pose.q[3] = r.w;
}
inline void size_shape(ShapePose& pose, const Geometry& geometry, std::size_t number) {
    pose.low[3] = float(number);
    pose.size[0] = geometry.size.x, pose.size[1] = geometry.size.y, pose.size[2] = geometry.size.z;
    pose.size[3] = geometry.bounding_radius;
}

// Updates the world pose and arm of one shape from its body's pose: part of the step's inner loop.
inline void place_shape(Shapes& shapes, std::uint32_t shape, const BodyMotion& motion, math::Quat q,
                        math::Vec3 center) {
    const Geometry& geometry = shapes.geometry[shape];
    math::Vec3 arm;
    if (!(geometry.position == center)) arm = math::rotate(q, geometry.position - center);
    shapes.links[shape].arm = arm;
    pose_shape(shapes.poses[shape], geometry, motion.x + math::to_double(arm), q);
}

// Updates the poses of all shapes of a body; calls f(shape) after each.
template <class F> void place_each_shape(const Bodies& bodies, Shapes& shapes, std::int32_t body, F&& f) {
    const BodyMotion& motion = bodies.motion[body];
    const math::Quat q = math::to_float(motion.q);
    const math::Vec3 center = bodies.mass[body].center;
    for (std::int32_t s = bodies.links[body].first_shape; s != none; s = shapes.links[s].next) {
        place_shape(shapes, std::uint32_t(s), motion, q, center);
        f(std::uint32_t(s));
    }
}

// The part of a body's rotation in a step, rad, that fat boxes and motion bounds allow for. A body that rotates faster
// meets the objects within its radius anyway.
inline float predicted_rotation(float turn) {
    constexpr float most = 0.25f;
    return std::min(turn, most);
}
// How far the rotation of that step moves any point of the body, m, at most.
inline float rotation_bound(const Bodies& bodies, std::int32_t body, float dt) {
    return predicted_rotation(dt * math::length(bodies.motion[body].w)) * bodies.links[body].radius;
}

inline math::DVec3 shape_position(const ShapePose& pose) {
    return {double(pose.high[0]) + pose.low[0], double(pose.high[1]) + pose.low[1], double(pose.high[2]) + pose.low[2]};
}
inline math::Quat shape_rotation(const ShapePose& pose) { return {pose.q[0], pose.q[1], pose.q[2], pose.q[3]}; }

inline DBounds shape_bounds(const Shapes& shapes, std::uint32_t shape) {
    const ShapePose& pose = shapes.poses[shape];
    return geometry_bounds(shapes.geometry[shape], shapes.data[shape], shape_position(pose),
                           math::to_matrix(shape_rotation(pose)));
}

// The origin of the body's frame, in world coordinates.
math::DVec3 body_origin(const Bodies& bodies, std::int32_t body);
// Moves the body so that its origin is at `origin`.
void set_pose(Bodies& bodies, std::int32_t body, math::DVec3 origin, math::DQuat rotation);

// World tensors about the center of mass.
math::Sym3 world_inverse_inertia(const BodyMotion& motion, const BodyMass& mass);
math::DSym3 world_inertia(const BodyMotion& motion, const BodyMass& mass);

// J; 0 for static and kinematic bodies. Degrees of freedom without finite mass or inertia count as 0.
double kinetic_energy(const Bodies& bodies, std::int32_t body);

// Clamps velocities to the maximum speeds; true if any was clamped.
bool cut_velocity(const WorldDef& settings, math::Vec3& v, math::Vec3& w);
inline bool clamp_velocity(const WorldDef& settings, math::Vec3& v, math::Vec3& w) {
    // The common case: both speeds are far below their limits.
    const float max_v = 0.5f * settings.max_linear_speed, max_w = 0.5f * settings.max_angular_speed;
    if (math::dot(v, v) < max_v * max_v && math::dot(w, w) < max_w * max_w) return false;
    return cut_velocity(settings, v, w);
}

} // namespace cairn
