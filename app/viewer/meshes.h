/// \file meshes.h
/// The triangle meshes of bodies. Spheres, boxes, rectangles, capsules and cylinders have one mesh for each kind, which
/// the vertex shader scales: all shapes of a kind are drawn by one call, whatever their proportions.
#pragma once

#include <cairn/math.h>

#include <cstdint>
#include <vector>

namespace cairn::viewer {

/// Boxes and rectangles: the vertex is at `corner * half_size` in the shape's frame. Spheres, capsules and cylinders:
/// `corner` and `inset` say which part of the shape a vertex belongs to (see below). Meshes of a single shape: `corner`
/// in meters, and texture coordinates in `inset`, if there is a texture.
struct MeshVertex {
    Vec3 corner;
    Vec3 inset{0.0f, 0.0f, 0.0f};
    Vec3 normal; ///< Unit.
};

struct TriangleMesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices; ///< Three per triangle, counterclockwise seen from outside.
    std::vector<Vec3> colors{}; ///< Linear, one for each vertex, or none: multiplied with the color of the mesh.
};

/// The visible part of a sphere: the cap that faces the viewer, of (2 x rings - 1) x segments triangles. `corner`:
/// direction around the cap's center in x and y, as a unit vector, and in z the distance from there to the rim, 0 to 1.
/// `segments` >= 3, `rings` >= 1.
TriangleMesh cap_mesh(int segments, int rings);
/// The box from -1 to 1 with flat faces: 12 triangles. The fragment shader rounds its edges.
TriangleMesh box_mesh();
/// The square from -1 to 1 in x and z, facing +y.
TriangleMesh rectangle_mesh();
/// Two caps and the surface between them, of any two radii: 4 x rings x segments triangles. `corner`: the direction
/// from the axis in x and z (zero at a pole), -1 or 1 in y for the lower or upper sphere. `inset.x`: 0 where the sphere
/// meets the surface between them, 1 at its pole. `segments` >= 3, `rings` >= 1.
TriangleMesh capsule_mesh(int segments, int rings);
/// A cylinder of any two radii with beveled rims, shaded as if rounded: 8 x segments triangles. `corner` as in a
/// capsule. `inset.x`: 0 at the center of the end disk, 1 at its rim, 2 at the end of the side. `segments` >= 3.
TriangleMesh cylinder_mesh(int segments);

} // namespace cairn::viewer
