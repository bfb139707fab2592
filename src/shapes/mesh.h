// Triangle meshes and height fields. What a Mesh and a HeightField share: made once, never changed.
#pragma once

#include "math/bounds.h"
#include "math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cairn {

// Triangles in kd order, 8 to a leaf; above them an implicit tree: node i of a level holds the bounds of nodes 8 i to
// 8 i + 7 of the level below (level 0: of triangles).
struct MeshData {
    std::vector<math::Vec3> vertices;
    std::vector<std::uint32_t> indices;
    struct Box {
        math::Vec3 lo, hi;
    };
    std::vector<std::vector<Box>> levels; // the last has one box
    std::uint64_t dropped = 0;            // triangles without area
    math::Vec3 lo, hi;
    float bounding_radius = 0; // about the origin of the shape's frame
};

struct HeightFieldData {
    int columns = 0, rows = 0;
    float spacing_x = 0, spacing_z = 0;
    std::vector<float> heights;
    float least = 0, greatest = 0;
    float bounding_radius = 0;
};

// Throws Error(invalid_value) with fields "Mesh vertices" and "Mesh indices" (see Mesh in shape.h).
MeshData build_mesh(std::span<const math::Vec3> vertices, std::span<const std::uint32_t> indices);

struct Triangle {
    math::Vec3 a, b, c; // counterclockwise as seen from outside
};

} // namespace cairn
