// Ray casts, box overlaps, and bounding boxes.
#include "bodies/bodies.h"
#include "state/state.h"
#include "world/impl.h"
#include "world/sight.h"
#include "world/validate.h"

#include <algorithm>

namespace cairn {

namespace {

struct Ray {
    math::DVec3 origin, direction;
    double max_distance;
};

Ray checked_ray(const Position& origin, const Vec3& direction, double max_distance) {
    require_position("World::cast_ray origin", origin);
    require_finite("World::cast_ray direction", direction);
    const math::DVec3 d = math::to_double(to_math(direction));
    const double length = math::length(d);
    if (!(length > 1e-30)) refuse("World::cast_ray direction", to_text(direction), "must not be zero");
    if (!(max_distance >= 0)) refuse("World::cast_ray max_distance", to_text(max_distance), "must be >= 0");
    return {to_math(origin), (1 / length) * d, max_distance};
}

std::optional<ShapeRayHit> cast_at_shape(const Shapes& shapes, std::uint32_t shape, const Ray& ray,
                                         double max_distance) {
    const ShapePose& pose = shapes.poses[shape];
    return cast_ray(shapes.geometry[shape], shapes.data[shape], shape_position(pose), shape_rotation(pose), ray.origin,
                    ray.direction, max_distance);
}

RayHit to_hit(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape, const Ray& ray, const ShapeRayHit& hit) {
    return {shapes.slots.id(shape),
            bodies.id(shapes.links[shape].body),
            to_public(ray.origin + hit.distance * ray.direction),
            to_public(math::to_float(hit.normal)),
            hit.distance,
            int(hit.triangle)};
}

bool bounds_overlap(const DBounds& a, const DBounds& b) {
    for (int i = 0; i < 3; ++i)
        if (a.lo[i] > b.hi[i] || b.lo[i] > a.hi[i]) return false;
    return true;
}

} // namespace

QueryVisibility::QueryVisibility(const State& state, const QueryFilter& filter)
    : state_(state), filter_(filter),
      sees_all_others_(filter.layers == all_layers && filter.own_layers == all_layers && filter.static_bodies &&
                       filter.kinematic_bodies && filter.dynamic_bodies && filter.ignored_bodies.empty()) {}

bool QueryVisibility::passes(const CollisionFilter& layers, std::int32_t body) const {
    if (filter_.layers != all_layers && (layers.layers & filter_.layers) == 0) return false;
    if (filter_.own_layers != all_layers && (layers.collides_with & filter_.own_layers) == 0) return false;
    const BodyType type = state_.bodies.settings[body].type;
    const bool is_asked_for = type == BodyType::static_     ? filter_.static_bodies
                              : type == BodyType::kinematic ? filter_.kinematic_bodies
                                                            : filter_.dynamic_bodies;
    const auto& ignored = filter_.ignored_bodies;
    return is_asked_for && std::find(ignored.begin(), ignored.end(), state_.bodies.id(body)) == ignored.end();
}

std::optional<RayHit> World::cast_ray(const Position& origin, const Vec3& direction, double max_distance,
                                      const QueryFilter& filter) const {
    const Ray ray = checked_ray(origin, direction, max_distance);
    const State& s = impl_->for_queries(filter, "World::cast_ray");
    const QueryVisibility sight(s, filter);
    std::optional<ShapeRayHit> best;
    std::uint32_t best_shape = 0;
    s.broad_phase.query_ray(ray.origin, ray.direction, ray.max_distance, [&](std::uint32_t shape, double max) {
        if (!sight.sees(shape)) return max;
        const auto hit = cast_at_shape(s.shapes, shape, ray, max);
        // Of two hits at the same distance, the shape with the lower index wins, whatever the order of the tests.
        if (!hit || (best && hit->distance == best->distance && shape > best_shape)) return max;
        best = hit;
        best_shape = shape;
        return sight.any() ? -1 : hit->distance;
    });
    if (!best) return std::nullopt;
    return to_hit(s.bodies, s.shapes, best_shape, ray, *best);
}

std::vector<RayHit> World::cast_ray_all(const Position& origin, const Vec3& direction, double max_distance,
                                        const QueryFilter& filter) const {
    const Ray ray = checked_ray(origin, direction, max_distance);
    const State& s = impl_->for_queries(filter, "World::cast_ray_all");
    const QueryVisibility sight(s, filter);
    std::vector<RayHit> hits;
    s.broad_phase.query_ray(ray.origin, ray.direction, ray.max_distance, [&](std::uint32_t shape, double max) {
        if (!sight.sees(shape)) return max;
        const auto hit = cast_at_shape(s.shapes, shape, ray, ray.max_distance);
        if (!hit) return max;
        hits.push_back(to_hit(s.bodies, s.shapes, shape, ray, *hit));
        return sight.any() ? -1 : max;
    });
    std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.shape.index() < b.shape.index();
    });
    return hits;
}

std::vector<ShapeId> World::overlap_bounds(const Bounds& bounds, const QueryFilter& filter) const {
    for (int i = 0; i < 3; ++i)
        if (std::isnan(bounds.min[i]) || std::isnan(bounds.max[i]))
            refuse("World::overlap_bounds bounds", to_text(bounds.min), "must not be NaN");
    const DBounds box{to_math(bounds.min), to_math(bounds.max)};
    const State& s = impl_->for_queries(filter, "World::overlap_bounds");
    const QueryVisibility sight(s, filter);
    std::vector<ShapeId> found;
    if (box.lo.x > box.hi.x || box.lo.y > box.hi.y || box.lo.z > box.hi.z) return found;
    s.broad_phase.query_bounds(box, [&](std::uint32_t other) {
        if (sight.any() && !found.empty()) return;
        if (sight.sees(other) && bounds_overlap(box, cairn::shape_bounds(s.shapes, other)))
            found.push_back(s.shapes.slots.id(other));
    });
    std::sort(found.begin(), found.end(), [](ShapeId a, ShapeId b) { return a.index() < b.index(); });
    return found;
}

std::vector<BroadPhaseNode> World::broad_phase_nodes(int max_depth, int max_count) const {
    if (max_depth < 0) refuse("World::broad_phase_nodes max_depth", std::to_string(max_depth), "must be >= 0");
    if (max_count < 0) refuse("World::broad_phase_nodes max_count", std::to_string(max_count), "must be >= 0");
    const State& s = impl_->intact("World::broad_phase_nodes");
    std::vector<BroadPhaseNode> list;
    for (const BroadPhase::Node& node : s.broad_phase.nodes(std::uint32_t(max_depth), std::size_t(max_count))) {
        const bool is_leaf = node.shape != BroadPhase::none;
        list.push_back({{to_public(node.bounds.lo), to_public(node.bounds.hi)},
                        BroadPhaseTree(node.tree),
                        int(node.depth),
                        node.parent == BroadPhase::none ? -1 : int(node.parent),
                        is_leaf,
                        is_leaf ? s.shapes.slots.id(node.shape) : ShapeId()});
    }
    return list;
}

void World::read_transforms(std::span<const BodyId> ids, std::span<Transform> out) const {
    if (ids.size() != out.size())
        refuse("World::read_transforms out", std::to_string(out.size()),
               "must have as many elements as ids (" + std::to_string(ids.size()) + ")");
    const State& s = impl_->intact("World::read_transforms");
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const std::int32_t b = impl_->index_of(ids[i]);
        out[i] = {to_public(body_origin(s.bodies, b)), to_public(math::to_float(s.bodies.motion[b].q))};
    }
}

} // namespace cairn
