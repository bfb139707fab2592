// The penetration depth of two parts of a scene, computed without any code of the measured engines.
#pragma once

#include "bench/engine.h"
#include "bench/scenes.h"

#include <optional>
#include <vector>

namespace cairn::bench {

// A convex polyhedron: its vertices relative to its center, the outward unit normals of its faces with their distances
// from the center, and the directions of its edges.
struct Polyhedron {
    std::vector<glm::dvec3> corners, normals, edges;
    std::vector<double> offsets;
};

// A part in the world, at the pose of its body.
struct PlacedPart {
    PartShape shape = PartShape::box;
    Position center{0.0, 0.0, 0.0};
    glm::dvec3 axes[3];                     // its unit axes in the world
    glm::dvec3 half_extents{0.0, 0.0, 0.0}; // box, m
    double radius = 0, half_height = 0;     // sphere, capsule, cylinder, m
    double bounding_radius = 0;             // m
    Polyhedron polyhedron;                  // hull
    const SurfaceMesh* mesh = nullptr;      // owned by the scene, which must outlive this
};

PlacedPart place(const Scene& scene, const Part& part, const BodyState& body);

// The penetration depth, m: the least distance by which one of two parts must be moved so that they only touch. It is
// negative for separated parts, with a magnitude of at most their distance. For overlapping parts
// - among spheres and boxes, among hulls and boxes, and for two capsules whose axes do not intersect it is exact;
// - for other pairs with capsules and cylinders, and for spheres against hulls, it is the result of a search: never too
// small, and in the tests too large by less than half a percent;
// - against a mesh it is the greatest depth of a vertex of the part below the plane of the triangle above it (for a
// cylinder: of 32 points on each rim; for spheres and capsules: of their centers, plus the radius), or of a mesh vertex
// inside the part. Crossing edges are not detected.
//   the part: edges that cross are not seen.
double penetration(const PlacedPart& a, const PlacedPart& b);

} // namespace cairn::bench
