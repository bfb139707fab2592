// Shapes in the engine's representation: a type, three sizes, and a pose in the body's frame.
#pragma once

#include "math/bounds.h"
#include "math/vec.h"
#include "shapes/hull.h"
#include "shapes/mass.h"
#include "shapes/mesh.h"

#include <cairn/shape.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>

namespace cairn {

// The part of a hull, mesh or height field that shapes may share.
using ShapeData = std::variant<std::monostate, std::shared_ptr<const HullData>, std::shared_ptr<const MeshData>,
                               std::shared_ptr<const HeightFieldData>>;

inline const HullData& hull_of(const ShapeData& data) { return **std::get_if<std::shared_ptr<const HullData>>(&data); }
inline const MeshData& mesh_of(const ShapeData& data) { return **std::get_if<std::shared_ptr<const MeshData>>(&data); }
inline const HeightFieldData& height_field_of(const ShapeData& data) {
    return **std::get_if<std::shared_ptr<const HeightFieldData>>(&data);
}

// The materials of the parts of a mesh or height field; empty for other shapes.
std::span<const Material> surface_materials(const ShapeData& data);

// Surfaces have no mass, and cannot belong to dynamic bodies.
inline bool is_surface(ShapeType type) {
    return type == ShapeType::plane || type == ShapeType::rectangle || type == ShapeType::mesh ||
           type == ShapeType::height_field;
}

inline bool is_plane(ShapeType type) { return type == ShapeType::plane || type == ShapeType::rectangle; }

// Half the length of a strip, m: a rectangle that is infinite along one axis. It exceeds the range of positions.
inline constexpr float endless = 4e15f;

// Planes and rectangles face their own +y axis, which is also the axis of capsules and cylinders.
struct Geometry {
    ShapeType type = ShapeType::sphere;
    std::uint8_t padding[3] = {}; // zero, since snapshots are compared byte by byte
    // sphere: radius in x; box: half extents; rectangle: half extents in x and z; capsule, cylinder: lower radius in x,
    // half height in y, upper radius in z
    math::Vec3 size;
    math::Vec3 middle;         // of the bounds; nonzero only for hulls, which may lie anywhere in their frame
    float bounding_radius = 0; // about `middle`, including the rounding; 0 for infinite planes and strips
    math::Vec3 position;       // origin of the shape in the body's frame
    math::Quat rotation;
    float rounding = 0;                // radius of a ball that is added to a box, cylinder or hull of the above size
    std::uint16_t is_turned = 0;       // whether the rotation differs from the identity
    std::uint16_t is_double_sided = 0; // for planes and rectangles
};

// Whether a shape has curved surfaces, over which contact points move as it rolls.
inline bool is_round(const Geometry& g) {
    return g.type == ShapeType::sphere || g.type == ShapeType::capsule || g.type == ShapeType::cylinder ||
           g.rounding > 0;
}

// The extent of surfaces, m: larger than that of any solid.
inline constexpr float unlimited_extent = 1e9f;
float smallest_extent(const Geometry& geometry, const ShapeData& data);
// Half of the smallest extent of two shapes, m.
inline double half_width_of(const Geometry& a, const ShapeData& data_a, const Geometry& b, const ShapeData& data_b) {
    return 0.5 * double(std::min(smallest_extent(a, data_a), smallest_extent(b, data_b)));
}

inline bool is_strip(const Geometry& g) {
    return g.type == ShapeType::rectangle && (g.size.x == endless || g.size.z == endless);
}

// The part of a strip near a point, as a rectangle at `center`: it extends from there at least by the width of the
// strip plus `reach`. Other shapes are returned unchanged.
Geometry near_part(const Geometry& g, math::DVec3& center, math::DQuat rotation, math::DVec3 point, double reach);

// The shape must be valid (see world/validate.h).
Geometry make_geometry(const Shape& shape, const Transform& pose);
ShapeData make_shape_data(const Shape& shape);

// Tight bounds of a shape in the world; infinite for an infinite plane.
DBounds geometry_bounds(const Geometry& shape, const ShapeData& data, math::DVec3 position, const math::Mat3& rotation);

// The mass of a solid shape of the given density, in the body's frame; zero for surfaces.
MassSum geometry_mass(const Geometry& shape, const ShapeData& data, float density);

// The first hit of a ray on a shape in the world. A ray that starts inside a solid does not hit it; planes are solid
// below; triangles of meshes and height fields are hit from outside only.
struct ShapeRayHit {
    double distance;
    math::DVec3 normal;
    std::uint32_t triangle = no_triangle; // index, for meshes and height fields
};
std::optional<ShapeRayHit> cast_ray(const Geometry& shape, const ShapeData& data, math::DVec3 position,
                                    math::Quat rotation, math::DVec3 origin, math::DVec3 direction,
                                    double max_distance);

} // namespace cairn
