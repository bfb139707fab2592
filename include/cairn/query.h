/// \file query.h
/// Ray casts, shape casts, closest points and overlap tests. Exact against the shapes, read-only, and safe from several
/// threads at a time while no step runs.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

#include <cstdint>

namespace cairn {

/// The nearest thing that a ray met.
struct RayHit {
    ShapeId shape;
    BodyId body;
    Position point;  ///< On the surface, meters.
    Vec3 normal;     ///< Unit outward normal of the surface there.
    double distance; ///< From the ray's origin, meters.
};

/// The first thing that a moving shape met.
struct ShapeCastHit {
    ShapeId shape;
    BodyId body;
    double fraction; ///< Of the translation, 0 to 1; 0 if they overlapped from the start.
    Position point;  ///< Where they meet, meters.
    Vec3 normal;     ///< Unit, out of the shape that was met.
};

/// The surface point nearest to a given one.
struct ClosestPoint {
    ShapeId shape;
    BodyId body;
    Position point;  ///< On the surface, meters; the given point itself if that lies inside.
    double distance; ///< Meters; 0 inside.
};

/// Which shapes a query sees: those that are in any of these layers (CollisionFilter::layers). Triggers are never seen.
inline constexpr std::uint64_t all_layers = ~std::uint64_t{};

} // namespace cairn
