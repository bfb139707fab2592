// Convex shapes in a common frame, for the narrow phase and for queries: the farthest point in a direction, and the
// face, edge or corner there.
//
// A shape is a core and a `radius` around it (Minkowski sum). Two shapes that touch are told apart by their cores,
// which do not overlap as long as the shapes overlap less than their radii. A ball is a point with a radius, a capsule
// a segment. Shapes with sharp edges have a core that is inset by the radius, and are themselves sharp: their cores
// only give the direction of the contact, the shapes themselves the points.
#pragma once

#include "math/vec.h"
#include "shapes/geometry.h"

#include <array>

namespace cairn {

struct Convex {
    enum class Kind : std::uint8_t { ball, box, capsule, cylinder, hull, triangle };
    Kind kind = Kind::ball;
    math::DVec3 center;     // of the shape's frame, in the common frame
    math::DMat3 axes;       // of the shape's frame, in the common frame
    math::DVec3 size;       // as in Geometry
    math::DVec3 corners[3]; // of a triangle, in the common frame
    const HullData* hull = nullptr;
    double radius = 0;     // around the core
    bool is_sharp = false; // the shape itself has no radius: the core is inset
};

// For every type but planes, rectangles, meshes and height fields.
Convex make_convex(const Geometry& geometry, const ShapeData& data, math::DVec3 center, math::DQuat rotation);
// Flat, solid on the side that sees the corners clockwise.
Convex make_triangle(math::DVec3 a, math::DVec3 b, math::DVec3 c);

} // namespace cairn
