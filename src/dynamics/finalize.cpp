#include "dynamics/finalize.h"

#include "dynamics/bodies.h"
#include "dynamics/islands.h"

#include <algorithm>

namespace cairn {

namespace {

void move_shapes(State& s, std::int32_t b, float dt) {
    const BodyMotion& motion = s.motion[std::size_t(b)];
    const math::Quat q = math::to_float(motion.q);
    const math::Mat3 rotation = math::to_matrix(q);
    const math::Vec3 center = s.mass[std::size_t(b)].center;
    const math::Vec3 displacement = dt * motion.v;
    for (std::int32_t shape = s.bodies[std::size_t(b)].first_shape; shape != none;
         shape = s.shapes[std::size_t(shape)].next) {
        place_shape(s, std::uint32_t(shape), motion, rotation, q, center);
        if (s.geometry[std::size_t(shape)].type == ShapeType::plane) {
            const math::DVec3 p = shape_position(s.shape_poses[std::size_t(shape)]);
            s.broad_phase.move_plane(
                std::uint32_t(shape), p,
                math::rotate(shape_rotation(s.shape_poses[std::size_t(shape)]), math::Vec3{0, 1, 0}));
        } else {
            const Geometry& geometry = s.geometry[std::size_t(shape)];
            const ShapePose& pose = s.shape_poses[std::size_t(shape)];
            const DBounds bounds = geometry_bounds(
                geometry, shape_position(pose), geometry.is_turned ? math::to_matrix(shape_rotation(pose)) : rotation);
            s.broad_phase.set_bounds(std::uint32_t(shape), bounds, displacement);
        }
    }
}

} // namespace

void finalize_bodies(State& s, float dt, bool is_last_pass) {
    const float quiet_speed = s.settings.sleep_speed;
    const auto& g = s.settings.gravity;
    const float gravity = math::length(math::Vec3{g.x, g.y, g.z});
    for (const std::int32_t i : s.awake_islands) {
        Island& island = s.islands[std::size_t(i)];
        island.weight = 0;
        for (std::int32_t b = island.first_body; b != none; b = s.bodies[std::size_t(b)].next_in_island) {
            const BodyMass& mass = s.mass[std::size_t(b)];
            if (mass.inverse_mass > 0) island.weight += mass.mass * gravity;
            move_shapes(s, b, dt);
            BodyLinks& links = s.bodies[std::size_t(b)];
            const BodyMotion& motion = s.motion[std::size_t(b)];
            const float speed = math::length(motion.v) + math::length(motion.w) * links.radius;
            links.quiet_time = speed < quiet_speed ? links.quiet_time + dt : 0;
            if (is_last_pass) s.forces[std::size_t(b)] = {}; // they act for one step
        }
    }
    for (const std::int32_t b : s.kinematics) {
        const BodyMotion& motion = s.motion[std::size_t(b)];
        if (motion.v == math::Vec3{} && motion.w == math::Vec3{}) continue;
        move_shapes(s, b, dt);
        // Planes make no pairs with what sleeps.
        for (std::int32_t shape = s.bodies[std::size_t(b)].first_shape; shape != none;
             shape = s.shapes[std::size_t(shape)].next)
            if (s.geometry[std::size_t(shape)].type == ShapeType::plane) wake_around_shape(s, std::uint32_t(shape));
    }
}

void add_proxy(State& s, std::uint32_t shape) {
    const std::int32_t body = s.shapes[shape].body;
    const BodyType type = s.body_settings[std::size_t(body)].type;
    if (s.geometry[shape].type == ShapeType::plane) {
        const ShapePose& pose = s.shape_poses[shape];
        s.broad_phase.add_plane(shape, shape_position(pose), math::rotate(shape_rotation(pose), math::Vec3{0, 1, 0}));
        return;
    }
    const auto mobility = type == BodyType::static_ ? BroadPhase::Mobility::fixed : BroadPhase::Mobility::awake;
    s.broad_phase.add(shape, shape_bounds(s, shape), mobility, type == BodyType::kinematic);
}

void update_proxies(State& s, std::int32_t b) {
    s.left_at[std::size_t(b)] = s.passes + 1;
    place_shapes(s, b);
    move_shapes(s, b, 0);
}

} // namespace cairn
