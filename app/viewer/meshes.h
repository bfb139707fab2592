/// \file meshes.h
/// The triangles that bodies are drawn with. A vertex shader places a vertex at `corner * half_size - inset * bevel`
/// in the body's frame, so one box mesh has bevels of equal width whatever the proportions of the box.
#pragma once

#include <cairn/math.h>

#include <cstdint>
#include <vector>

namespace cairn::viewer {

struct MeshVertex {
    Vec3 corner;                  ///< Times the half size.
    Vec3 inset{0.0f, 0.0f, 0.0f}; ///< Times the width of the bevel, inwards.
    Vec3 normal;                  ///< Unit.
};

struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint16_t> indices; ///< Three per triangle, counterclockwise seen from outside.
};

/// A unit sphere made by splitting an icosahedron `subdivisions` times (0 to 5): 20 x 4^subdivisions triangles.
Mesh sphere_mesh(int subdivisions);
/// A box with beveled edges, shaded as if they were rounded: 44 triangles.
Mesh box_mesh();
/// The square from -1 to 1 in x and z, facing +y.
Mesh rectangle_mesh();

} // namespace cairn::viewer
