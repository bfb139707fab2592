// Ray casts and overlap tests.
#include "bodies/bodies.h"
#include "contacts/convex_tests.h"
#include "contacts/pairs.h"
#include "shapes/convex_query.h"
#include "state/state.h"
#include "world/impl.h"
#include "world/query_frame.h"
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
    return {shapes.slots.id(shape), bodies.id(shapes.links[shape].body),
            to_public(ray.origin + hit.distance * ray.direction), to_public(math::to_float(hit.normal)), hit.distance};
}

bool bounds_overlap(const DBounds& a, const DBounds& b) {
    for (int i = 0; i < 3; ++i)
        if (a.lo[i] > b.hi[i] || b.lo[i] > a.hi[i]) return false;
    return true;
}

ShapePose make_pose(const Geometry& g, math::DVec3 position, math::Quat q) {
    ShapePose pose{};
    for (int i = 0; i < 3; ++i) {
        pose.high[i] = float(position[i]);
        pose.low[i] = float(position[i] - double(pose.high[i]));
        pose.size[i] = g.size[i];
    }
    pose.q[0] = q.x, pose.q[1] = q.y, pose.q[2] = q.z, pose.q[3] = q.w;
    pose.size[3] = g.bounding_radius;
    return pose;
}

// Whether a convex shape meets a triangle of a surface, in the frame of the surface's own place. Contacts do not tell:
// they are one-sided, and have no normal for a center beside the border and below it.
bool meets_triangles(const PosedShape& surface, const PosedShape& convex) {
    const math::DVec3 origin = shape_position(surface.pose);
    const Convex solid = make_convex(convex.geometry, convex.data, shape_position(convex.pose) - origin,
                                     math::normalized(math::to_double(shape_rotation(convex.pose))));
    math::DVec3 lo, hi;
    for (int i = 0; i < 3; ++i) {
        math::DVec3 axis;
        axis[i] = 1;
        lo[i] = support(solid, -axis)[i], hi[i] = support(solid, axis)[i];
    }
    bool found = false;
    const PosedInQuery posed(surface.geometry, surface.data, {}, shape_rotation(surface.pose));
    for_each_triangle_near(posed, lo, hi,
                           [&](const Convex& triangle) { found = found || cairn::overlap(solid, triangle); });
    return found;
}

// By the narrow phase itself, but for triangles.
bool shapes_overlap(const PosedShape& a, const PosedShape& b) {
    bool swapped = false;
    const std::optional<PairKind> kind = pair_kind(a.geometry, b.geometry, swapped);
    if (!kind) return false;
    const PosedShape &first = swapped ? b : a, &second = swapped ? a : b;
    if (*kind == PairKind::group) return meets_triangles(second, first);
    Manifold out[8];
    if (int(*kind) < wide_kinds) {
        const ShapePose poses[2] = {first.pose, second.pose};
        const std::uint32_t firsts[8] = {}, seconds[8] = {1, 1, 1, 1, 1, 1, 1, 1};
        const float margin[8] = {};
        wide_kernel (*kind)(poses, firsts, seconds, margin, nullptr, 8, out);
    } else {
        ContactMemory memory = nothing_met;
        out[0] = test_convex_pair(*kind, first, second, {}, 0, memory);
    }
    for (int i = 0; i < out[0].count; ++i)
        if (out[0].points[i][3] <= 0) return true;
    return false;
}

} // namespace

std::optional<RayHit> World::cast_ray(const Position& origin, const Vec3& direction, double max_distance,
                                      std::uint64_t layers) const {
    const Ray ray = checked_ray(origin, direction, max_distance);
    const State& s = impl_->whole("World::cast_ray");
    std::optional<ShapeRayHit> best;
    std::uint32_t best_shape = 0;
    s.broad_phase.query_ray(ray.origin, ray.direction, ray.max_distance, [&](std::uint32_t shape, double max) {
        if (!is_seen(s.shapes, shape, layers)) return max;
        const auto hit = cast_at_shape(s.shapes, shape, ray, max);
        // Of two at the same distance the one with the lower index counts, in whatever order they come.
        if (!hit || (best && hit->distance == best->distance && shape > best_shape)) return max;
        best = hit;
        best_shape = shape;
        return hit->distance;
    });
    if (!best) return std::nullopt;
    return to_hit(s.bodies, s.shapes, best_shape, ray, *best);
}

std::vector<RayHit> World::cast_ray_all(const Position& origin, const Vec3& direction, double max_distance,
                                        std::uint64_t layers) const {
    const Ray ray = checked_ray(origin, direction, max_distance);
    const State& s = impl_->whole("World::cast_ray_all");
    std::vector<RayHit> hits;
    s.broad_phase.query_ray(ray.origin, ray.direction, ray.max_distance, [&](std::uint32_t shape, double max) {
        if (!is_seen(s.shapes, shape, layers)) return max;
        if (const auto hit = cast_at_shape(s.shapes, shape, ray, ray.max_distance))
            hits.push_back(to_hit(s.bodies, s.shapes, shape, ray, *hit));
        return max;
    });
    std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.shape.index() < b.shape.index();
    });
    return hits;
}

std::vector<ShapeId> World::overlap(const Shape& shape, const Transform& pose, std::uint64_t layers) const {
    validate(shape);
    require_position("World::overlap pose.position", pose.position);
    const Quat rotation = checked_rotation("World::overlap pose.rotation", pose.rotation);
    const Geometry g = make_geometry(shape, {Position(0.0), rotation});
    const math::DVec3 position = to_math(pose.position);
    const ShapeData data = make_shape_data(shape);
    const DBounds bounds = geometry_bounds(g, data, position, math::to_matrix(g.rotation));
    const ShapePose query = make_pose(g, position, g.rotation);
    const math::Vec3 arm = -math::rotate(g.rotation, g.middle); // of its middle, as it has no mass
    const State& s = impl_->whole("World::overlap");
    std::vector<ShapeId> found;
    s.broad_phase.query_bounds(bounds, [&](std::uint32_t other) {
        if (is_seen(s.shapes, other, layers) && bounds_overlap(bounds, cairn::shape_bounds(s.shapes, other)) &&
            shapes_overlap({g, data, query, arm}, posed_shape(s.shapes, other)))
            found.push_back(s.shapes.slots.id(other));
    });
    std::sort(found.begin(), found.end(), [](ShapeId a, ShapeId b) { return a.index() < b.index(); });
    return found;
}

std::vector<ShapeId> World::overlap_bounds(const Bounds& bounds, std::uint64_t layers) const {
    for (int i = 0; i < 3; ++i)
        if (std::isnan(bounds.min[i]) || std::isnan(bounds.max[i]))
            refuse("World::overlap_bounds bounds", to_text(bounds.min), "must not be NaN");
    const DBounds box{to_math(bounds.min), to_math(bounds.max)};
    const State& s = impl_->whole("World::overlap_bounds");
    std::vector<ShapeId> found;
    if (box.lo.x > box.hi.x || box.lo.y > box.hi.y || box.lo.z > box.hi.z) return found;
    s.broad_phase.query_bounds(box, [&](std::uint32_t other) {
        if (is_seen(s.shapes, other, layers) && bounds_overlap(box, cairn::shape_bounds(s.shapes, other)))
            found.push_back(s.shapes.slots.id(other));
    });
    std::sort(found.begin(), found.end(), [](ShapeId a, ShapeId b) { return a.index() < b.index(); });
    return found;
}

void World::read_transforms(std::span<const BodyId> ids, std::span<Transform> out) const {
    if (ids.size() != out.size())
        refuse("World::read_transforms out", std::to_string(out.size()),
               "must have as many elements as ids (" + std::to_string(ids.size()) + ")");
    const State& s = impl_->whole("World::read_transforms");
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const std::int32_t b = impl_->index_of(ids[i]);
        out[i] = {to_public(body_origin(s.bodies, b)), to_public(math::to_float(s.bodies.motion[b].q))};
    }
}

} // namespace cairn
