// Rays at the triangles of meshes and height fields. Inside src/shapes; others call cast_ray (geometry.h).
#pragma once

#include "shapes/geometry.h"

namespace cairn {

// In the shape's frame; of unit direction.
struct LocalRay {
    math::DVec3 origin, direction;
    double max_distance;
};

std::optional<ShapeRayHit> cast_at_mesh(const MeshData& mesh, const LocalRay& ray);
std::optional<ShapeRayHit> cast_at_height_field(const HeightFieldData& field, const LocalRay& ray);

} // namespace cairn
