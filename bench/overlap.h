// How deep two parts of a scene overlap, found without anything of the engines that are measured.
#pragma once

#include "bench/engine.h"
#include "bench/scenes.h"

#include <optional>
#include <vector>

namespace cairn::bench {

// The corners of a convex polyhedron from its center, the outward unit normals of its faces with their distances from
// it, and the directions of its edges.
struct Polyhedron {
    std::vector<glm::dvec3> corners, normals, edges;
    std::vector<double> offsets;
};

// A part where its body has put it.
struct PlacedPart {
    PartShape shape = PartShape::box;
    Position center{0.0, 0.0, 0.0};
    glm::dvec3 axes[3];                     // its unit axes in the world
    glm::dvec3 half_extents{0.0, 0.0, 0.0}; // box, m
    double radius = 0, half_height = 0;     // sphere, capsule, cylinder, m
    double bounding_radius = 0;             // m
    Polyhedron polyhedron;                  // hull
    const SurfaceMesh* mesh = nullptr;      // of the scene, which must live as long
};

PlacedPart place(const Scene& scene, const Part& part, const BodyState& body);

// The least distance, in m, by which one of two parts would have to be moved so that they only touch. Where they do not
// overlap it is negative, and at most as far from zero as they are apart. Of what overlaps it is
// - exact among spheres and boxes, hulls and boxes, and of two capsules whose axes do not meet;
// - with other capsules and cylinders, and of spheres in hulls, a search, never too small, and in the tests too great
// by
//   less than half a percent;
// - against a mesh the depth of the part's corner deepest below the plane of the triangle above it (of a cylinder: of
// 32
//   points of each rim; spheres and capsules add their radius to their centers), or of the mesh's corner deepest inside
//   the part: edges that cross are not seen.
double penetration(const PlacedPart& a, const PlacedPart& b);

} // namespace cairn::bench
