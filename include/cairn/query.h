/// \file query.h
/// Ray casts and overlap tests. Exact against the shapes, read-only, and safe from several threads at a time
/// while no step runs.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

namespace cairn {

/// The nearest thing that a ray met.
struct RayHit {
    ShapeId shape;
    BodyId body;
    Position point;  ///< On the surface, meters.
    Vec3 normal;     ///< Unit outward normal of the surface there.
    double distance; ///< From the ray's origin, meters.
};

} // namespace cairn
