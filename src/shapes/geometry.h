// Shapes as the engine stores them: a type, three sizes, and the pose in the body's frame.
#pragma once

#include "math/bounds.h"
#include "math/vec.h"

#include <cairn/shape.h>

#include <cstdint>
#include <optional>

namespace cairn {

// Planes and rectangles face along their own +y.
struct Geometry {
    ShapeType type = ShapeType::sphere;
    math::Vec3 size;           // sphere: radius in x; box: half extents; rectangle: half extents in x and z
    float bounding_radius = 0; // about the shape's origin; 0 for the infinite plane
    math::Vec3 position;       // of the shape's origin in the body's frame
    math::Quat rotation;
    std::uint32_t is_turned = 0; // the rotation is not the identity
};

// Shapes must be valid (see world/validate.h).
Geometry make_geometry(const Shape& shape, const Transform& pose);

// Tight bounds of a shape posed in the world; infinite for an infinite plane.
DBounds geometry_bounds(const Geometry& shape, math::DVec3 position, const math::Mat3& rotation);

// Mass, center of mass and inertia tensor about it, in double for the sums over shapes.
struct MassSum {
    double mass = 0;
    math::DVec3 center;
    math::DSym3 inertia; // about `center`, in the axes that positions are given in
};

// Mass of a solid shape of that density, in the body's frame. Planes have none.
MassSum geometry_mass(const Geometry& shape, float density);

// Both together (parallel-axis theorem).
MassSum combine(const MassSum& a, const MassSum& b);

// Principal moments (eigenvalues) and axes of an inertia tensor, by Jacobi rotations.
struct PrincipalInertia {
    math::DVec3 moments;
    math::DQuat axes; // rotation from principal axes
};
PrincipalInertia diagonalize(const math::DSym3& inertia);

// Where a ray first meets a shape posed in the world. Volumes are not met from within; planes are solid below.
struct ShapeRayHit {
    double distance;
    math::DVec3 normal;
};
std::optional<ShapeRayHit> cast_ray(const Geometry& shape, math::DVec3 position, math::Quat rotation,
                                    math::DVec3 origin, math::DVec3 direction, double max_distance);

} // namespace cairn
