/// \file triangles.h
/// The surface of rounded shapes as triangles, for looking at them.
#pragma once

#include <cairn/shape.h>

#include <cstdint>
#include <vector>

namespace cairn {

struct ShapeTriangles {
    std::vector<Vec3> vertices;         ///< Meters, in the shape's frame.
    std::vector<Vec3> normals;          ///< Unit, outward: one for each vertex.
    std::vector<std::uint32_t> indices; ///< Three a triangle, counterclockwise as seen from outside.
};

/// The `rounding` of a Box, Cylinder or Hull; 0 for all other shapes.
float rounding_of(const Shape& shape);

/// The closed surface of a shape whose `rounding_of` is not zero, smooth where it is round and flat where it is flat.
/// Every corner is on the true surface. Empty for other shapes.
ShapeTriangles rounded_triangles(const Shape& shape);

} // namespace cairn
