#include "bodies/finalize.h"

#include "bodies/bodies.h"
#include "bodies/motion_budget.h"
#include "collision/core_sweep.h"

#include "core/cache.h"
#include "state/substeps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

namespace {

// How far the shape's surface moves by its body's rotation in the next step, m; 0 for a sphere at the center of mass.
double turn_of_shape(const Shapes& shapes, std::uint32_t shape, float turn) {
    return shapes.geometry[shape].type == ShapeType::sphere && shapes.links[shape].arm == math::Vec3{} ? 0.0
                                                                                                       : double(turn);
}

// Bounds of a shape that is not an infinite plane; the rotation of its body in the next step moves it by `turn` meters.
DBounds bounds_of(const Shapes& shapes, std::uint32_t shape, float turn) {
    const ShapePose& pose = shapes.poses[shape];
    return grown(geometry_bounds(shapes.geometry[shape], shapes.data[shape], shape_position(pose),
                                 math::to_matrix(shape_rotation(pose))),
                 turn_of_shape(shapes, shape, turn));
}

math::Vec3 normal_of_plane(const ShapePose& pose) { return math::rotate(shape_rotation(pose), math::Vec3{0, 1, 0}); }

void move_shapes(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t b, float dt) {
    const math::Vec3 displacement = dt * bodies.motion[b].v;
    const float turn = rotation_bound(bodies, b, dt);
    bodies.boxes_until[b] = bodies.travel[b];
    place_each_shape(bodies, shapes, b, [&](std::uint32_t shape) {
        if (!bodies.is_enabled(b)) return;
        const ShapePose& pose = shapes.poses[shape];
        if (shapes.geometry[shape].type == ShapeType::plane)
            broad_phase.move_plane(shape, shape_position(pose), normal_of_plane(pose));
        else
            broad_phase.set_bounds(shape, bounds_of(shapes, shape, turn), displacement);
    });
}

// The distance from the center of mass to the farthest surface point, m. A body without shapes counts as large as its
// radius of gyration.
float surface_radius(const Bodies& bodies, std::int32_t b) {
    const float radius = bodies.links[b].radius;
    const BodyMass& mass = bodies.mass[b];
    if (radius > 0 || !(mass.inverse_mass > 0)) return radius;
    return std::sqrt(std::max(mass.inertia.x, std::max(mass.inertia.y, mass.inertia.z)) * mass.inverse_mass);
}

// Updates the time that the body has been slower than the sleep speed, and half of its mean squared speed over the last
// quarter of a sleep time and over the quarter before: their difference shows whether an island gains energy
// (islands.cpp).
void note_rest(const WorldDef& settings, BodyLinks& links, float speed, float dt) {
    if (!settings.enable_sleep || !(speed < settings.sleep_speed)) {
        links.quiet_time = 0;
        return;
    }
    const float energy = 0.5f * speed * speed;
    if (links.quiet_time == 0) {
        links.late = links.later = energy;
    } else {
        const float share = dt / (dt + lag_of_rest * settings.sleep_time);
        links.late += share * (energy - links.late);
        links.later += share * (links.late - links.later);
    }
    links.quiet_time += dt;
}

} // namespace

void finalize_body(Bodies& bodies, Shapes& shapes, const BroadPhase& broad_phase, const WorldDef& settings,
                   std::int32_t b, float dt, FinalizeScratch& own) {
    const BodyMotion& motion = bodies.motion[b];
    const float turn = rotation_bound(bodies, b, dt);
    BodyLinks& links = bodies.links[b];
    const float velocity = math::length(motion.v);
    const double ahead = double(turn + dt * velocity);
    // The motion of the current step is added to the travel at the start of the next one.
    const double moved = uncounted(bodies.counted[b], motion, links.radius);
    const bool is_fast = moved > free_share * double(links.inner_radius);
    // Whether the body moved farther than predicted by more than half of the speculative margin (the bodies of a pair
    // share the margin).
    const auto went_farther = [&] {
        const double surface_moved = turns_on_the_spot(links) ? math::length(motion.x - bodies.counted[b].x) : moved;
        const double spare = 0.5 * std::min(max_margin, margin_per_extent * 2 * double(links.inner_radius));
        return is_before(bodies.ahead[b] + budget_of(spare), bodies.travel[b] + budget_of(surface_moved));
    };
    bool has_strayed = is_fast && went_farther();
    const Travel now = bodies.travel[b] + travelled(moved);
    if (is_before(now + travelled(ahead), bodies.boxes_until[b])) {
        place_each_shape(bodies, shapes, b, [](std::uint32_t) {});
    } else {
        const math::Vec3 displacement = dt * motion.v;
        double room = std::numeric_limits<double>::infinity();
        place_each_shape(bodies, shapes, b, [&](std::uint32_t shape) { // never a plane: the body is dynamic
            const DBounds bounds = bounds_of(shapes, shape, turn);
            has_strayed |= is_fast && !contains(broad_phase.fat_bounds(shape), bounds);
            const double left = broad_phase.room(shape, bounds, displacement);
            if (left < 0) own.escaped.push_back({shape, bounds, displacement});
            room = std::min(room, left);
        });
        bodies.boxes_until[b] = now + budget_of(room - rounding * double(links.radius));
    }
    if (is_fast) {
        own.fast.push_back(b);
        if (has_strayed) own.strayed.push_back(b);
    }
    const float speed = velocity + math::length(motion.w) * surface_radius(bodies, b);
    note_rest(settings, links, speed, dt);
}

void place_again(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t b, float dt) {
    move_shapes(bodies, shapes, broad_phase, b, dt);
}

void prefetch_motion(const Bodies& bodies, std::int32_t b) {
    prefetch(&bodies.motion[b].x);
    prefetch(&bodies.motion[b].q);
    prefetch(&bodies.mass[b]);
    prefetch(&bodies.settings[b]);
}

void prefetch_body(const Bodies& bodies, std::int32_t b) {
    prefetch_motion(bodies, b);
    prefetch(&bodies.links[b].first_shape);
    prefetch(&bodies.links[b].inner_radius);
    prefetch(&bodies.counted[b]);
    prefetch(&bodies.boxes_until[b]);
}

void prefetch_shape_of(const Bodies& bodies, const Shapes& shapes, const BroadPhase& broad_phase, std::int32_t b) {
    const std::int32_t first = bodies.links[b].first_shape;
    if (first == none) return;
    const auto shape = std::size_t(first);
    prefetch(&shapes.links[shape]);
    prefetch(&shapes.poses[shape]);
    prefetch(&shapes.geometry[shape]);
    prefetch(&shapes.geometry[shape].is_double_sided);
    prefetch(&broad_phase.fat_bounds(std::uint32_t(shape)));
}

void finalize_kinematics(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, float dt) {
    for (const std::int32_t b : bodies.kinematics) {
        const BodyMotion& motion = bodies.motion[b];
        if (motion.v == math::Vec3{} && motion.w == math::Vec3{}) continue;
        move_shapes(bodies, shapes, broad_phase, b, dt);
    }
}

void add_proxy(Bodies& bodies, const Shapes& shapes, BroadPhase& broad_phase, std::uint32_t shape) {
    const std::int32_t body = shapes.links[shape].body;
    if (!bodies.is_enabled(body)) return broad_phase.make_room(shape);
    bodies.boxes_until[body] = bodies.travel[body];
    const BodyType type = bodies.settings[body].type;
    const bool is_trigger = shapes.traits[shape].is_trigger != 0;
    if (shapes.geometry[shape].type == ShapeType::plane) {
        const ShapePose& pose = shapes.poses[shape];
        broad_phase.add_plane(shape, shape_position(pose), normal_of_plane(pose),
                              shapes.geometry[shape].is_double_sided != 0, is_trigger);
        return;
    }
    const auto mobility = type == BodyType::static_ ? BroadPhase::Mobility::fixed : BroadPhase::Mobility::awake;
    broad_phase.add(shape, shape_bounds(shapes, shape), mobility, type == BodyType::kinematic, is_trigger);
    broad_phase.set_bounds(shape, bounds_of(shapes, shape, rotation_bound(bodies, body, usual_step)),
                           usual_step * bodies.motion[body].v);
}

void renew_proxy(Bodies& bodies, const Shapes& shapes, BroadPhase& broad_phase, std::uint32_t shape) {
    const std::int32_t body = shapes.links[shape].body;
    if (!bodies.is_enabled(body)) return;
    bodies.boxes_until[body] = bodies.travel[body];
    if (shapes.geometry[shape].type == ShapeType::plane) {
        const ShapePose& pose = shapes.poses[shape];
        broad_phase.move_plane(shape, shape_position(pose), normal_of_plane(pose));
        return;
    }
    broad_phase.renew_bounds(shape, bounds_of(shapes, shape, rotation_bound(bodies, body, usual_step)),
                             usual_step * bodies.motion[body].v);
}

void update_proxies(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t b) {
    spend_budget(bodies, b);
    place_shapes(bodies, shapes, b);
    sweep_proxies(bodies, shapes, broad_phase, b);
}

void sweep_proxies(Bodies& bodies, Shapes& shapes, BroadPhase& broad_phase, std::int32_t b) {
    move_shapes(bodies, shapes, broad_phase, b, usual_step);
}

} // namespace cairn
