/// \file triangles.h
/// The surface of rounded shapes as triangles, for rendering.
#pragma once

#include <cairn/shape.h>

#include <cstdint>
#include <vector>

namespace cairn {

struct ShapeTriangles {
    std::vector<Vec3> vertices;         ///< Meters, in the shape's frame.
    std::vector<Vec3> normals;          ///< Unit, outward: one for each vertex.
    std::vector<std::uint32_t> indices; ///< Three for each triangle, counterclockwise as seen from outside.
};

/// The `rounding` of a Box, Cylinder or Hull, meters; 0 for all other shapes.
float rounding_of(const Shape& shape);

/// The closed surface of a shape whose `rounding_of` is not zero, with normals for smooth shading of its round parts
/// and flat shading of its flat ones. Every vertex is on the true surface. Empty for other shapes.
ShapeTriangles rounded_triangles(const Shape& shape);

} // namespace cairn
