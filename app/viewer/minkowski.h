/// \file minkowski.h
/// The Minkowski difference of two convex shapes, and the algorithm of Gilbert, Johnson and Keerthi (1988) on it, for
/// teaching: in double precision and plain form. The engine has its own.
#pragma once

#include <cairn/world.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace cairn::viewer {

/// A convex shape where it is.
struct ConvexShape {
    Shape shape;
    Transform pose;
};
/// Nothing for planes, meshes and height fields.
std::optional<ConvexShape> convex_shape(const World& world, ShapeId shape);

/// The point of a shape that is farthest along a direction (of any length but zero), in the world.
glm::dvec3 support(const ConvexShape& shape, const glm::dvec3& direction);

/// How GJK ended. Points are differences: of a point of the first shape and one of the second.
struct GjkResult {
    std::vector<glm::dvec3> simplex;   ///< 1 to 4 points, whose hull has the point nearest to the origin.
    glm::dvec3 nearest{0.0, 0.0, 0.0}; ///< That point; the origin itself, if they overlap.
    double distance = 0.0;             ///< m
    int iterations = 0;
};
GjkResult gjk(const ConvexShape& a, const ConvexShape& b);

/// The difference of a pair, and where it is drawn: about the middle of the second shape, which stands for the origin.
struct PairDifference {
    BodyId other;
    Position origin{0.0, 0.0, 0.0};
    std::vector<Vec3> points;                          ///< Of its surface, from `origin`.
    std::vector<std::array<std::size_t, 3>> triangles; ///< Indices; without those that have no area.
    GjkResult gjk;
};
/// Of a body and the convex shape nearest to it. Nothing if there are no two such shapes.
std::optional<PairDifference> nearest_difference(const World& world, BodyId body);

} // namespace cairn::viewer
