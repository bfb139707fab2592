/// \file meshes.h
/// The triangles that bodies are drawn with. Spheres, boxes, rectangles, capsules and cylinders each have a mesh of
/// their own, which the vertex shader gives its sizes: all of a kind are drawn by one call, whatever their proportions.
#pragma once

#include <cairn/math.h>

#include <cstdint>
#include <vector>

namespace cairn::viewer {

/// Spheres, boxes, rectangles: at `corner * half_size - inset * bevel` in the shape's frame, so that bevels are equally
/// wide whatever the proportions. For capsules and cylinders, `corner` and `inset` say which part of the shape a vertex
/// belongs to (see below). Meshes of a single shape have meters in `corner`.
struct MeshVertex {
    Vec3 corner;
    Vec3 inset{0.0f, 0.0f, 0.0f};
    Vec3 normal; ///< Unit.
};

struct TriangleMesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices; ///< Three per triangle, counterclockwise seen from outside.
};

/// A unit sphere made by splitting an icosahedron `subdivisions` times (0 to 5): 20 x 4^subdivisions triangles.
TriangleMesh sphere_mesh(int subdivisions);
/// A box with beveled edges, shaded as if they were rounded: 44 triangles.
TriangleMesh box_mesh();
/// The square from -1 to 1 in x and z, facing +y.
TriangleMesh rectangle_mesh();
/// Two caps and the surface between them, of any two radii: 4 x rings x segments triangles. `corner`: the direction
/// from the axis in x and z (zero at a pole), -1 or 1 in y for the lower or upper ball. `inset.x`: 0 where the ball
/// meets the surface between them, 1 at its pole. `segments` >= 3, `rings` >= 1.
TriangleMesh capsule_mesh(int segments, int rings);
/// A cylinder of any two radii with beveled rims, shaded as if those were rounded: 8 x segments triangles. `corner` as
/// in a capsule. `inset.x`: 0 in the middle of the end's disk, 1 at its rim, 2 at the end of the side. `segments` >= 3.
TriangleMesh cylinder_mesh(int segments);

} // namespace cairn::viewer
