// Convex shapes in a common frame, for the narrow phase and for queries: the farthest point in a direction, and the
// faces.
//
// A shape is a core and a `radius` around it (Minkowski sum). Two shapes that touch are told apart by their cores,
// which do not overlap as long as the shapes overlap less than their radii. A ball is a point with a radius, a capsule
// a segment. Shapes with sharp edges have a core that is inset by the radius, and are themselves sharp: their cores
// only give the direction of the contact, the shapes themselves the points. Rounded shapes are their sharp self as the
// core, and their rounding as the radius.
#pragma once

#include "math/vec.h"
#include "shapes/geometry.h"
#include "shapes/hull.h"

#include <array>

namespace cairn {

// A solid of revolution about y: the hull of two discs.
struct Frustum {
    double low, low_radius, high, high_radius;
};

struct Convex {
    Convex() {}
    enum class Kind : std::uint8_t { ball, box, capsule, cylinder, hull, polygon };
    Kind kind = Kind::ball;
    bool is_sharp = false;      // the shape itself has no radius: the core is inset
    int corner_count = 0;       // of a polygon: 3 or 4
    math::DVec3 center;         // of the shape's frame, in the common frame
    math::DMat3 axes;           // of the shape's frame, in the common frame
    math::DVec3 size;           // as in Geometry
    union {                     // without values for other kinds: clearing them takes as long as all the rest
        math::DVec3 corners[4]; // of a polygon, in the common frame
        Frustum core;           // of a cylinder
    };
    const HullData* hull = nullptr;
    double radius = 0;  // around the core
    double shallow = 0; // an overlap up to this is a small one: the radius, or of rounded shapes somewhat more
    double extent = 0;  // the smallest half width; infinite for polygons
};

// For every type but planes, meshes and height fields. A rectangle is a flat polygon.
Convex make_convex(const Geometry& geometry, const ShapeData& data, const math::DVec3& center,
                   const math::DQuat& rotation);
// Flat, solid on the side that sees the corners clockwise.
Convex make_triangle(math::DVec3 a, math::DVec3 b, math::DVec3 c);
// A polygon that faces the other way.
Convex reversed(const Convex& polygon);
Convex moved(const Convex& shape, math::DVec3 by);

// Leaves the core of a shape at a depth, m: without what is nearer to its surface; at least a point or a segment in its
// middle. Of hulls, the hull scaled along its axes about the middle of its bounds, such that those shrink by the depth
// on every side; or, where that is not well inside of it, evenly about its center of mass, by the depth at the nearest
// face. Polygons stay as they are.
void shrink(Convex& shape, double depth);

// From the common frame to the shape's and back.
inline math::DVec3 to_local(const Convex& c, math::DVec3 v) {
    return {math::dot(c.axes.c0, v), math::dot(c.axes.c1, v), math::dot(c.axes.c2, v)};
}
inline math::DVec3 hull_point(const Convex& c, math::Vec3 p) { return c.center + c.axes * math::to_double(p); }

// A shape as the distance algorithms see it: a core, and a radius that is added afterwards.
struct Core {
    const Convex* shape;
    bool is_inset; // else a sharp shape is its own core
    double radius;
    bool is_quick = false; // of a hull: corners within 3e-6 of its size of the farthest will do
};
// Only of sharp shapes.
inline Core inset_core(const Convex& c) { return {&c, true, c.radius}; }
// The core that gives exact distances.
inline Core exact_core(const Convex& c) { return {&c, false, c.is_sharp ? 0 : c.radius}; }

// What lies around the exact core.
inline double outer_radius(const Convex& c) { return c.is_sharp ? 0 : c.radius; }

// The farthest points of the shapes that are asked for most, along d, which may have any length.
inline math::DVec3 box_support(const Convex& c, math::DVec3 half, math::DVec3 d) {
    const math::DVec3 along = to_local(c, d);
    const math::DVec3 local{along.x < 0 ? -half.x : half.x, along.y < 0 ? -half.y : half.y,
                            along.z < 0 ? -half.z : half.z};
    return c.center + c.axes * local;
}
inline math::DVec3 polygon_support(const Convex& c, math::DVec3 d) {
    int best = 0;
    double farthest = math::dot(c.corners[0], d);
    for (int i = 1; i < c.corner_count; ++i) {
        const double along = math::dot(c.corners[i], d);
        if (along > farthest) farthest = along, best = i;
    }
    return c.corners[best];
}
inline math::DVec3 hull_support(const Core& core, math::DVec3 d) {
    const HullData& hull = *core.shape->hull;
    const Columns& columns = core.is_inset ? hull.core : hull.vertex_columns;
    const math::DVec3 along = to_local(*core.shape, d);
    const std::size_t i = core.is_quick ? columns.nearly_farthest(along) : columns.farthest(along);
    return hull_point(*core.shape, columns[i]);
}
math::DVec3 round_support(const Core& core, math::DVec3 d); // of balls, capsules and cylinders

// The point of the core that is farthest along d.
inline math::DVec3 core_support(const Core& core, math::DVec3 d) {
    const Convex& c = *core.shape;
    if (c.kind == Convex::Kind::hull) return hull_support(core, d);
    if (c.kind == Convex::Kind::polygon) return polygon_support(c, d);
    if (c.kind != Convex::Kind::box) return round_support(core, d);
    const double m = core.is_inset ? c.radius : 0;
    return box_support(c, c.size - math::DVec3{m, m, m}, d);
}
// The point of the shape itself that is farthest along d.
inline math::DVec3 support(const Convex& c, math::DVec3 d) {
    const math::DVec3 p = core_support(exact_core(c), d);
    if (c.is_sharp) return p;
    const double length = math::length(d);
    return length > 0 ? p + (c.radius / length) * d : p;
}
// Likewise along a unit vector, quickly: of a hull some vertex within 3e-6 of its size of the farthest.
inline constexpr int unknown_vertex = -1;
struct NearSupport {
    math::DVec3 point;
    int vertex = unknown_vertex; // of a hull
};
inline NearSupport near_support(const Convex& c, math::DVec3 unit) {
    if (c.kind != Convex::Kind::hull) return {support(c, unit)};
    const std::size_t vertex = c.hull->vertex_columns.nearly_farthest(to_local(c, unit));
    const math::DVec3 p = hull_point(c, c.hull->vertices[vertex]);
    return {c.is_sharp ? p : p + c.radius * unit, static_cast<int>(vertex)};
}
// The middle of the bounds: of most shapes inside, but not of every hull.
math::DVec3 middle(const Convex& c);
// A point deep inside.
math::DVec3 inside_of(const Convex& c);

// Flat faces: of boxes, hulls and polygons, and the ends of cylinders. A polygon has its front; number 1 is its back,
// which touches but gives no direction.
// Those of a box: +x -x +y -y +z -z; of a cylinder: top, base.
int face_count(const Convex& c);
bool has_face(const Convex& c, int face); // the tip of a cone is none
inline math::DVec3 face_normal(const Convex& c, int face) {
    if (c.kind == Convex::Kind::hull) return c.axes * c.hull->unit_normal(static_cast<std::size_t>(face));
    if (c.kind == Convex::Kind::box) return face % 2 == 0 ? c.axes.column(face / 2) : -c.axes.column(face / 2);
    return face == 0 ? c.axes.c1 : -c.axes.c1;
}
math::DVec3 face_point(const Convex& c, int face); // some point of it
// The face of a box that looks most along a direction in its frame.
inline int box_face_along(math::DVec3 local) {
    const math::DVec3 size = math::abs(local);
    const int i = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * i + (local[i] < 0 ? 1 : 0);
}

} // namespace cairn
