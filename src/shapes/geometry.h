// Shapes as the engine stores them: a type, three sizes, and the pose in the body's frame.
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

// The part of a shape that it may share with others: of hulls, meshes and height fields.
using ShapeData = std::variant<std::monostate, std::shared_ptr<const HullData>, std::shared_ptr<const MeshData>,
                               std::shared_ptr<const HeightFieldData>>;

inline const HullData& hull_of(const ShapeData& data) { return **std::get_if<std::shared_ptr<const HullData>>(&data); }
inline const MeshData& mesh_of(const ShapeData& data) { return **std::get_if<std::shared_ptr<const MeshData>>(&data); }
inline const HeightFieldData& height_field_of(const ShapeData& data) {
    return **std::get_if<std::shared_ptr<const HeightFieldData>>(&data);
}

// Of meshes and height fields; of other shapes there are none.
std::span<const Material> surface_materials(const ShapeData& data);

// Surfaces have no mass, and are never dynamic.
inline bool is_surface(ShapeType type) {
    return type == ShapeType::plane || type == ShapeType::rectangle || type == ShapeType::mesh ||
           type == ShapeType::height_field;
}

inline bool is_plane(ShapeType type) { return type == ShapeType::plane || type == ShapeType::rectangle; }

// Half the length of a strip, a rectangle that is infinite along one axis, m: farther than positions reach.
inline constexpr float endless = 4e15f;

// Planes and rectangles face along their own +y; capsules and cylinders stand along it.
struct Geometry {
    ShapeType type = ShapeType::sphere;
    std::uint8_t padding[3] = {}; // snapshots are compared byte by byte
    // sphere: radius in x; box: half extents; rectangle: half extents in x and z; capsule, cylinder: lower radius in x,
    // half height in y, upper radius in z
    math::Vec3 size;
    math::Vec3 middle;         // of its bounds: of hulls, which may lie anywhere in their frame
    float bounding_radius = 0; // about `middle`, with the rounding; 0 for infinite planes and strips
    math::Vec3 position;       // of the shape's origin in the body's frame
    math::Quat rotation;
    float rounding = 0;          // of boxes, cylinders and hulls: radius of a ball that is added to all of the above
    std::uint16_t is_turned = 0; // the rotation is not the identity
    std::uint16_t is_double_sided = 0; // of planes and rectangles
};

// Whether a shape has surfaces that are round: places where they touch move over them as they roll.
inline bool is_round(const Geometry& g) {
    return g.type == ShapeType::sphere || g.type == ShapeType::capsule || g.type == ShapeType::cylinder ||
           g.rounding > 0;
}

// The least width of a shape, m; of surfaces one that is larger than any.
inline constexpr float unlimited_extent = 1e9f;
float smallest_extent(const Geometry& geometry, const ShapeData& data);
// Half of that of the narrower of two shapes, m.
inline double half_width_of(const Geometry& a, const ShapeData& data_a, const Geometry& b, const ShapeData& data_b) {
    return 0.5 * double(std::min(smallest_extent(a, data_a), smallest_extent(b, data_b)));
}

inline bool is_strip(const Geometry& g) {
    return g.type == ShapeType::rectangle && (g.size.x == endless || g.size.z == endless);
}

// Of a strip the part near a point, as a rectangle at `center`: it reaches at least as far from there as it is wide,
// and by `reach` farther. Other shapes stay as they are.
Geometry near_part(const Geometry& g, math::DVec3& center, math::DQuat rotation, math::DVec3 point, double reach);

// Shapes must be valid (see world/validate.h).
Geometry make_geometry(const Shape& shape, const Transform& pose);
ShapeData make_shape_data(const Shape& shape);

// Tight bounds of a shape posed in the world; infinite for an infinite plane.
DBounds geometry_bounds(const Geometry& shape, const ShapeData& data, math::DVec3 position, const math::Mat3& rotation);

// Mass of a solid shape of that density, in the body's frame. Surfaces have none.
MassSum geometry_mass(const Geometry& shape, const ShapeData& data, float density);

// Where a ray first meets a shape posed in the world. Volumes are not met from within; planes are solid below; the
// triangles of meshes and height fields are met from outside only.
struct ShapeRayHit {
    double distance;
    math::DVec3 normal;
    std::uint32_t triangle = no_triangle; // of a mesh or height field
};
std::optional<ShapeRayHit> cast_ray(const Geometry& shape, const ShapeData& data, math::DVec3 position,
                                    math::Quat rotation, math::DVec3 origin, math::DVec3 direction,
                                    double max_distance);

} // namespace cairn
