/// \file minkowski.h
/// The Minkowski difference of two convex shapes, and the algorithm of Gilbert, Johnson and Keerthi (1988) on it, for
/// teaching: in double precision and plain form. The engine has its own implementation.
#pragma once

#include <cairn/world.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cairn::viewer {

/// A convex shape with its world pose.
struct ConvexShape {
    Shape shape;
    Transform pose;
};
/// Empty for planes, meshes and height fields.
std::optional<ConvexShape> convex_shape(const World& world, ShapeId shape);

/// The support point of a shape in a direction (of any length but zero), in world coordinates.
glm::dvec3 support(const ConvexShape& shape, const glm::dvec3& direction);

/// The result of GJK. Points are of the Minkowski difference: a point of the first shape minus one of the second.
struct GjkResult {
    std::vector<glm::dvec3> simplex;   ///< 1 to 4 points whose convex hull contains the point nearest to the origin.
    glm::dvec3 nearest{0.0, 0.0, 0.0}; ///< The nearest point; the origin itself if the shapes overlap.
    double distance = 0.0;             ///< m
    int iterations = 0;
};
GjkResult gjk(const ConvexShape& a, const ConvexShape& b);

/// The Minkowski difference of a pair, and where it is drawn: at the middle of the second shape, which serves as the
/// origin.
struct PairDifference {
    BodyId other;
    Position origin{0.0, 0.0, 0.0};
    std::vector<Vec3> points;                          ///< Surface points, relative to `origin`.
    std::vector<std::array<std::size_t, 3>> triangles; ///< Point indices; degenerate triangles are left out.
    GjkResult gjk;
};
/// The Minkowski difference of a body and the nearest convex shape. Empty if there are no two such shapes.
std::optional<PairDifference> nearest_difference(const World& world, BodyId body);

} // namespace cairn::viewer
