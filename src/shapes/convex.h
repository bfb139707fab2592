// Convex shapes in a common frame, for the narrow phase and for queries: support points and faces.
// A shape is a core plus a `radius` around it (the Minkowski sum of the core and a ball). Contact normals are computed
// from the cores, which stay separated as long as the penetration of the shapes is less than the sum of their radii.
// The core of a ball is a point, that of a capsule a segment. A shape with sharp edges has a core that is inset by the
// radius: the core provides only the direction of a contact, and the sharp shape itself the contact points. The core of
// a rounded shape is the shape without its rounding, and the radius is the rounding.
#pragma once

#include "math/vec.h"
#include "shapes/geometry.h"
#include "shapes/hull.h"

#include <array>

namespace cairn {

// A solid of revolution about y: the convex hull of two discs.
struct Frustum {
    double low, low_radius, high, high_radius;
};

struct Convex {
    Convex() {}
    enum class Kind : std::uint8_t { ball, box, capsule, cylinder, hull, polygon };
    Kind kind = Kind::ball;
    bool is_sharp = false; // the shape itself has no radius, and its core is inset
    int corner_count = 0;  // number of corners of a polygon: 3 or 4
    math::DVec3 center;    // origin of the shape's frame, in the common frame
    math::DMat3 axes;      // axes of the shape's frame, in the common frame
    math::DVec3 size;      // as in Geometry
    union {                // uninitialized for other kinds: clearing it takes as long as the rest of the construction
        math::DVec3 corners[4]; // corners of a polygon, in the common frame
        Frustum core;           // core of a cylinder
    };
    const HullData* hull = nullptr;
    double radius = 0;  // added around the core
    double shallow = 0; // penetrations up to this depth are shallow: the radius, or somewhat more for rounded shapes
    double extent = 0;  // the smallest half width; infinite for polygons
};

// For every shape type but infinite planes, meshes and height fields. A rectangle becomes a flat polygon.
Convex make_convex(const Geometry& geometry, const ShapeData& data, const math::DVec3& center,
                   const math::DQuat& rotation);
// A flat triangle that faces the side from which its corners appear counterclockwise, and is solid on the other side.
Convex make_triangle(math::DVec3 a, math::DVec3 b, math::DVec3 c);
// The polygon that faces the other way.
Convex reversed(const Convex& polygon);
Convex moved(const Convex& shape, math::DVec3 by);

// Reduces the core of a shape by a depth, m: removes everything closer to its surface, but keeps at least a point or
// segment in its middle. A hull is scaled along its axes about the middle of its bounds, so that these shrink by the
// depth on every side; or, if that middle is not well inside of it, uniformly about its center of mass, such that the
// nearest face moves by the depth. Polygons stay unchanged.
void shrink(Convex& shape, double depth);

// Transforms a direction from the common frame to the shape's frame.
inline math::DVec3 to_local(const Convex& c, math::DVec3 v) {
    return {math::dot(c.axes.c0, v), math::dot(c.axes.c1, v), math::dot(c.axes.c2, v)};
}
inline math::DVec3 hull_point(const Convex& c, math::Vec3 p) { return c.center + c.axes * math::to_double(p); }

// The view that distance algorithms have of a shape: a core, and a radius to be added to the result.
struct Core {
    const Convex* shape;
    bool is_inset; // false: a sharp shape is its own core
    double radius;
    // for hulls: support points within 3e-6 of the hull's size from the exact support are good enough
    bool is_quick = false;
};
// The inset core of a sharp shape.
inline Core inset_core(const Convex& c) { return {&c, true, c.radius}; }
// The core that gives exact distances.
inline Core exact_core(const Convex& c) { return {&c, false, c.is_sharp ? 0 : c.radius}; }

// The radius around the exact core.
inline double outer_radius(const Convex& c) { return c.is_sharp ? 0 : c.radius; }

// Support points of the most frequent shapes along d, which may have any length.
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
math::DVec3 round_support(const Core& core, math::DVec3 d); // for balls, capsules and cylinders

// The support point of the core along d.
inline math::DVec3 core_support(const Core& core, math::DVec3 d) {
    const Convex& c = *core.shape;
    if (c.kind == Convex::Kind::hull) return hull_support(core, d);
    if (c.kind == Convex::Kind::polygon) return polygon_support(c, d);
    if (c.kind != Convex::Kind::box) return round_support(core, d);
    const double m = core.is_inset ? c.radius : 0;
    return box_support(c, c.size - math::DVec3{m, m, m}, d);
}
// The support point of the shape itself along d.
inline math::DVec3 support(const Convex& c, math::DVec3 d) {
    const math::DVec3 p = core_support(exact_core(c), d);
    if (c.is_sharp) return p;
    const double length = math::length(d);
    return length > 0 ? p + (c.radius / length) * d : p;
}
// The support point of the shape along a unit vector, approximate for hulls: some vertex within 3e-6 of the hull's size
// from the support.
inline constexpr int unknown_vertex = -1;
struct NearSupport {
    math::DVec3 point;
    int vertex = unknown_vertex; // index, for hulls
};
inline NearSupport near_support(const Convex& c, math::DVec3 unit) {
    if (c.kind != Convex::Kind::hull) return {support(c, unit)};
    const std::size_t vertex = c.hull->vertex_columns.nearly_farthest(to_local(c, unit));
    const math::DVec3 p = hull_point(c, c.hull->vertices[vertex]);
    return {c.is_sharp ? p : p + c.radius * unit, static_cast<int>(vertex)};
}
// The middle of the shape's bounds; it may lie outside of a hull.
math::DVec3 middle(const Convex& c);
// A point deep inside the shape.
math::DVec3 inside_of(const Convex& c);

// Flat faces exist on boxes (+x -x +y -y +z -z), hulls and polygons, and as the ends of cylinders (top, base). Face 0
// of a polygon is its front; face 1 is its back, which can touch but provides no contact normal.
int face_count(const Convex& c);
bool has_face(const Convex& c, int face); // false for the tip of a cone
inline math::DVec3 face_normal(const Convex& c, int face) {
    if (c.kind == Convex::Kind::hull) return c.axes * c.hull->unit_normal(static_cast<std::size_t>(face));
    if (c.kind == Convex::Kind::box) return face % 2 == 0 ? c.axes.column(face / 2) : -c.axes.column(face / 2);
    return face == 0 ? c.axes.c1 : -c.axes.c1;
}
math::DVec3 face_point(const Convex& c, int face); // some point of the face
// The face of a box whose normal is most aligned with a direction in its frame.
inline int box_face_along(math::DVec3 local) {
    const math::DVec3 size = math::abs(local);
    const int i = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * i + (local[i] < 0 ? 1 : 0);
}

} // namespace cairn
