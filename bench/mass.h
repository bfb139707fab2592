// Mass, center of mass and inertia of what scenes are made of, so that every engine is given the same.
#pragma once

#include "bench/scenes.h"

namespace cairn::bench {

struct MassProperties {
    double mass = 0;            // kg
    glm::dvec3 center{0, 0, 0}; // m
    glm::dmat3 inertia{0.0};    // about the center, kg m^2
};

// Of one part in its body's frame. A mesh has none.
MassProperties mass_of(const Scene& scene, const Part& part, double density);

// Of both together.
MassProperties operator+(const MassProperties& a, const MassProperties& b);

// The triangles of the convex hull of points of which no four lie in one plane, found by trying every three of them.
// Throws std::invalid_argument if some point is no corner or four lie in a plane.
std::vector<std::array<std::uint32_t, 3>> hull_triangles(std::span<const Vec3> points);

// Of the solid inside a closed surface, of density 1, in the frame of its points.
MassProperties mass_of(const ConvexHull& hull);

} // namespace cairn::bench
