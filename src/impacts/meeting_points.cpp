#include "impacts/meeting_points.h"

#include "bodies/bodies.h"
#include "contacts/convex_tests.h"
#include "contacts/pairs.h"

#include <algorithm>

namespace cairn {

using math::DVec3;
using math::to_double;

namespace {

struct Placed {
    std::uint32_t shape;
    math::Vec3 arm; // from the body's center of mass to the shape's origin
    ShapePose pose;
};

// Pose relative to `origin`, for precision far from the origin of the world.
Placed placed_at(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape, const MovingState& body,
                 DVec3 origin) {
    const Geometry& g = shapes.geometry[shape];
    const math::Quat q = math::to_float(body.q);
    Placed p{shape, math::rotate(q, g.position - bodies.mass[shapes.links[shape].body].center), shapes.poses[shape]};
    pose_shape(p.pose, g, (body.x - origin) + to_double(p.arm), q);
    return p;
}

} // namespace

void find_meeting_points(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape_a, const MovingState& a,
                         std::uint32_t shape_b, const MovingState& b, DVec3 axis, NarrowBatch& scratch,
                         std::vector<ImpactPoint>& points) {
    bool swapped = false;
    std::optional<PairKind> kind = pair_kind(shapes.geometry[shape_a], shapes.geometry[shape_b], swapped);
    if (!kind) return;
    const auto rests_on = [&](std::uint32_t one, std::uint32_t other) {
        return !bodies.is_dynamic(shapes.links[other].body) &&
               rests_on_round_side(shapes.geometry[one], shapes.geometry[other]);
    };
    if (rests_on(shape_a, shape_b))
        kind = PairKind::convex_convex, swapped = false;
    else if (rests_on(shape_b, shape_a))
        kind = PairKind::convex_convex, swapped = true;
    const double half_width =
        half_width_of(shapes.geometry[shape_a], shapes.data[shape_a], shapes.geometry[shape_b], shapes.data[shape_b]);
    const auto margin = float(touch_tolerance(half_width));
    const DVec3 origin = a.x;
    Placed first = placed_at(bodies, shapes, shape_a, a, origin),
           second = placed_at(bodies, shapes, shape_b, b, origin);
    if (swapped) std::swap(first, second), axis = -axis;
    scratch.hits.clear();
    const auto posed = [&](const Placed& p) {
        return PosedShape{shapes.geometry[p.shape], shapes.data[p.shape], p.pose, p.arm};
    };
    if (*kind == PairKind::group)
        find_patches(posed(first), posed(second), margin, margin, scratch.surface, scratch.hits);
    else
        scratch.hits.push_back(test_posed_pair(*kind, posed(first), posed(second), math::to_float(axis), margin));
    const DVec3 center = origin + shape_position(first.pose);
    for (const Manifold& hit : scratch.hits)
        for (int i = 0; i < hit.count; ++i) {
            if (!(hit.points[i][3] <= margin)) continue;
            const DVec3 n = to_double(math::to_vec(hit.normal)), normal = math::normalized(swapped ? -n : n);
            points.push_back({center + to_double(math::to_vec(hit.points[i])), normal, double(-hit.points[i][3]),
                              *kind == PairKind::group ? surface_material_of(hit) : std::uint16_t{}});
        }
}

ImpactMaterial material_at(const Shapes& shapes, std::uint32_t shape_a, std::uint32_t shape_b, std::uint16_t number,
                           float restitution_speed) {
    const auto of = [&](std::uint32_t shape) {
        return material_of(shapes, shape, surface_materials(shapes.data[shape]).empty() ? 0u : number);
    };
    const PairMaterial m = combined_material(of(shape_a), of(shape_b));
    return {double(m.restitution), double(m.friction), double(m.torsion_radius), double(m.rolling_radius),
            double(restitution_speed)};
}

DVec3 surface_velocity(const Bodies& bodies, const Shapes& shapes, std::uint32_t shape,
                       std::span<const ImpactPoint> points) {
    const ShapeTraits& traits = shapes.traits[shape];
    if (!traits.has_surface_velocity || bodies.is_dynamic(shapes.links[shape].body) || points.empty()) return {};
    const DVec3 n = points.front().normal;
    const DVec3 u = to_double(math::rotate(shape_rotation(shapes.poses[shape]), traits.surface_velocity));
    return u - math::dot(u, n) * n;
}

} // namespace cairn
