/// \file meshes.h
/// The triangles that bodies are drawn with. Spheres, boxes, rectangles, capsules and cylinders each have a mesh of
/// their own, which the vertex shader gives its sizes: all of a kind are drawn by one call, whatever their proportions.
#pragma once

#include <cairn/math.h>

#include <cstdint>
#include <vector>

namespace cairn::viewer {

/// Boxes, rectangles: at `corner * half_size` in the shape's frame. For spheres, capsules and cylinders, `corner` and
/// `inset` say which part of the shape a vertex belongs to (see below). Meshes of a single shape have meters in
/// `corner`, and in `inset` where in its texture a vertex lies, if it has one.
struct MeshVertex {
    Vec3 corner;
    Vec3 inset{0.0f, 0.0f, 0.0f};
    Vec3 normal; ///< Unit.
};

struct TriangleMesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices; ///< Three per triangle, counterclockwise seen from outside.
    std::vector<Vec3> colors{};         ///< Linear, one for each vertex, or none: multiply that of the mesh.
};

/// What is seen of a ball, wherever from: the cap that faces the viewer, of (2 x rings - 1) x segments triangles.
/// `corner`: the way around the middle in x and y, as a unit vector, and in z how far from there to the rim, 0 to 1.
/// `segments`
/// >= 3, `rings` >= 1.
TriangleMesh cap_mesh(int segments, int rings);
/// The box from -1 to 1 with flat faces: 12 triangles. The fragment shader rounds its edges.
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
