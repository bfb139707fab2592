// Ray casts at the triangles of meshes and height fields, for use inside src/shapes; other code calls cast_ray
// (geometry.h).
#pragma once

#include "shapes/geometry.h"

namespace cairn {

// A ray in the shape's frame, with a unit direction.
struct LocalRay {
    math::DVec3 origin, direction;
    double max_distance;
};

std::optional<ShapeRayHit> cast_at_mesh(const MeshData& mesh, const LocalRay& ray);
std::optional<ShapeRayHit> cast_at_height_field(const HeightFieldData& field, const LocalRay& ray);

} // namespace cairn
