#include "dynamics/finalize.h"

#include "dynamics/bodies.h"
#include "dynamics/islands.h"

#include <algorithm>

namespace cairn {

namespace {

// f(shape) for all shapes of a body, after they were placed anew.
template <class F> void place_each(State& s, std::int32_t b, F&& f) {
    const BodyMotion& motion = s.motion[std::size_t(b)];
    const math::Quat q = math::to_float(motion.q);
    const math::Mat3 rotation = math::to_matrix(q);
    const math::Vec3 center = s.mass[std::size_t(b)].center;
    for (std::int32_t shape = s.bodies[std::size_t(b)].first_shape; shape != none;
         shape = s.shapes[std::size_t(shape)].next) {
        place_shape(s, std::uint32_t(shape), motion, rotation, q, center);
        f(std::uint32_t(shape), rotation);
    }
}

// The new bounds of a shape of a body that turned.
DBounds bounds_of(const State& s, std::uint32_t shape, const math::Mat3& rotation) {
    const Geometry& geometry = s.geometry[shape];
    const ShapePose& pose = s.shape_poses[shape];
    if (geometry.type == ShapeType::plane) return {};
    return geometry_bounds(geometry, shape_position(pose),
                           geometry.is_turned ? math::to_matrix(shape_rotation(pose)) : rotation);
}

void move_shapes(State& s, std::int32_t b, float dt) {
    const math::Vec3 displacement = dt * s.motion[std::size_t(b)].v;
    place_each(s, b, [&](std::uint32_t shape, const math::Mat3& rotation) {
        apply_bounds(s, {shape, bounds_of(s, shape, rotation), displacement});
    });
}

} // namespace

void apply_bounds(State& s, const EscapedShape& e) {
    if (s.geometry[e.shape].type != ShapeType::plane) {
        s.broad_phase.set_bounds(e.shape, e.bounds, e.displacement);
        return;
    }
    const ShapePose& pose = s.shape_poses[e.shape];
    s.broad_phase.move_plane(e.shape, shape_position(pose), math::rotate(shape_rotation(pose), math::Vec3{0, 1, 0}));
}

void finalize_body(State& s, std::int32_t b, float dt, bool is_last_pass, std::vector<EscapedShape>& escaped) {
    const BodyMotion& motion = s.motion[std::size_t(b)];
    const math::Vec3 displacement = dt * motion.v;
    place_each(s, b, [&](std::uint32_t shape, const math::Mat3& rotation) {
        const DBounds bounds = bounds_of(s, shape, rotation);
        if (s.geometry[shape].type == ShapeType::plane || !s.broad_phase.serves(shape, bounds, displacement))
            escaped.push_back({shape, bounds, displacement});
    });
    BodyLinks& links = s.bodies[std::size_t(b)];
    const float speed = math::length(motion.v) + math::length(motion.w) * links.radius;
    links.quiet_time = speed < s.settings.sleep_speed ? links.quiet_time + dt : 0;
    if (is_last_pass) s.forces[std::size_t(b)] = {}; // they act for one step
}

void finalize_kinematics(State& s, float dt) {
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
