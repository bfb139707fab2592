// Mass, center of mass and inertia of scene parts, so that every engine gets the same values.
#pragma once

#include "bench/scenes.h"

namespace cairn::bench {

struct MassProperties {
    double mass = 0;            // kg
    glm::dvec3 center{0, 0, 0}; // m
    glm::dmat3 inertia{0.0};    // about the center, kg m^2
};

// Mass properties of one part in its body's frame; 0 for a mesh.
MassProperties mass_of(const Scene& scene, const Part& part, double density);

// Mass properties of both bodies together.
MassProperties operator+(const MassProperties& a, const MassProperties& b);

// The triangles of the convex hull of points, no four of which are coplanar, by testing every triple of points. Throws
// std::invalid_argument if a point is not a vertex of the hull or four points are coplanar.
std::vector<std::array<std::uint32_t, 3>> hull_triangles(std::span<const Vec3> points);

// Mass properties of the solid inside a closed surface with density 1, in the frame of its points.
MassProperties mass_of(const ConvexHull& hull);

} // namespace cairn::bench
