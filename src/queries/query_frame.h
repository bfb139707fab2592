// Common parts of shape casts, closest points and overlap queries.
#pragma once

#include "bodies/bodies.h"
#include "shapes/convex.h"
#include "state/state.h"

#include <algorithm>

namespace cairn {

// A shape of the world in the frame of a query: the axes of the world, with the origin where the query starts.
struct PosedInQuery {
    const Geometry& geometry;
    const ShapeData& data;
    math::DVec3 center;
    math::DQuat rotation;

    PosedInQuery(const Geometry& g, const ShapeData& d, math::DVec3 at, math::Quat q)
        : geometry(g), data(d), center(at), rotation(math::normalized(math::to_double(q))) {}
    PosedInQuery(const Shapes& shapes, std::uint32_t shape, math::DVec3 origin)
        : PosedInQuery(shapes.geometry[shape], shapes.data[shape], shape_position(shapes.poses[shape]) - origin,
                       shape_rotation(shapes.poses[shape])) {}
    math::DVec3 up() const { return math::rotate(rotation, math::DVec3{0, 1, 0}); }
    // The center of the shape's bounding sphere.
    math::DVec3 middle() const {
        if (geometry.type != ShapeType::hull) return center;
        return center + math::rotate(rotation, math::to_double(geometry.middle));
    }
    // The convex shape; of an infinite strip, the part near a point (near_part).
    Convex convex(math::DVec3 near, double reach) const {
        if (!is_strip(geometry)) return make_convex(geometry, data, center, rotation);
        math::DVec3 place = center;
        const Geometry part = near_part(geometry, place, rotation, near, reach);
        return make_convex(part, data, place, rotation);
    }
};

// Bounds of a shape: of a box along the exact axes that casts use, of other shapes along axes rounded to float, as in
// the broad phase.
inline DBounds bounds_in_query(const PosedInQuery& shape, const Convex& convex) {
    if (convex.kind != Convex::Kind::box)
        return geometry_bounds(shape.geometry, shape.data, shape.center,
                               math::to_matrix(math::to_float(shape.rotation)));
    const math::DVec3 size = convex.size;
    const double radius = outer_radius(convex);
    const math::DVec3 half = size.x * math::abs(convex.axes.c0) + size.y * math::abs(convex.axes.c1) +
                             size.z * math::abs(convex.axes.c2) + math::DVec3{radius, radius, radius};
    return {convex.center - half, convex.center + half};
}

// A convex shape in the query's frame, its bounds, and the radius of its bounding sphere.
struct QuerySolid {
    Convex convex;
    DBounds bounds;
    double radius;

    explicit QuerySolid(const PosedInQuery& shape)
        : convex(shape.convex({}, 0)), bounds(bounds_in_query(shape, convex)),
          radius(double(shape.geometry.bounding_radius)) {}
};

// Calls f(triangle as a convex, index) for the triangles of a mesh or height field near the box, in the query's frame.
template <class F> void for_each_triangle_near(const PosedInQuery& surface, math::DVec3 lo, math::DVec3 hi, F&& f) {
    const math::DMat3 axes = math::to_matrix(surface.rotation);
    const math::DVec3 middle = 0.5 * (lo + hi) - surface.center, half = 0.5 * (hi - lo);
    math::Vec3 local_lo, local_hi;
    for (int i = 0; i < 3; ++i) {
        const math::DVec3 axis = axes.column(i), along = math::abs(axis);
        const double center = math::dot(axis, middle), reach = math::dot(along, half);
        const double slack = 1e-6 * (std::fabs(center) + reach);
        local_lo[i] = float(std::max(center - reach - slack, -1e30));
        local_hi[i] = float(std::min(center + reach + slack, 1e30));
    }
    const auto corner = [&](math::Vec3 v) { return surface.center + axes * math::to_double(v); };
    const auto visit = [&](const auto& data) {
        for_each_triangle(data, local_lo, local_hi, [&](std::uint32_t index) {
            const Triangle t = triangle_of(data, index);
            f(make_triangle(corner(t.a), corner(t.b), corner(t.c)), index);
        });
    };
    if (surface.geometry.type == ShapeType::mesh)
        visit(mesh_of(surface.data));
    else
        visit(height_field_of(surface.data));
}

} // namespace cairn
