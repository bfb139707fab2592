/// \file shape.h
/// Shapes and surface materials.
#pragma once

#include <cairn/handle.h>
#include <cairn/math.h>

#include <cstdint>
#include <optional>
#include <variant>

namespace cairn {

/// A ball around the shape's origin. `radius` in meters, > 0.
struct Sphere {
    float radius = 0.5f;
};

/// A box around the shape's origin. `half_extents` in meters, each > 0.
struct Box {
    Vec3 half_extents{0.5f, 0.5f, 0.5f};
};

/// A plane through the shape's origin; solid is the side away from `normal`.
/// Without `half_extents` it is an infinite half-space. With them it is a finite rectangle, `half_extents[0]`
/// along the shape's `tangent` and `half_extents[1]` along normal x tangent; the rectangle is one-sided, and
/// pushes along its normal whatever is above it or has sunk less than its own size below it.
/// Planes have no mass: they may only be added to static and kinematic bodies.
struct Plane {
    Vec3 normal{0.0f, 1.0f, 0.0f};           ///< Any non-zero finite vector; it is normalized.
    Vec3 tangent{1.0f, 0.0f, 0.0f};          ///< Only for the rectangle; made orthogonal to `normal`.
    std::optional<glm::vec2> half_extents{}; ///< Meters, each > 0; absent for an infinite plane.
};

/// Any shape.
using Shape = std::variant<Sphere, Box, Plane>;

enum class ShapeType : std::uint8_t { sphere, box, plane, rectangle };

/// How the coefficients of two touching materials become one. Where the two materials disagree on the rule,
/// the stronger one counts, in the order average > minimum > maximum > multiply (KHR_physics_rigid_bodies).
enum class CombineRule : std::uint8_t { average, minimum, maximum, multiply };

/// Surface properties of a shape.
struct Material {
    float static_friction = 0.6f;      ///< Coulomb coefficient while the contact sticks, >= 0.
    float dynamic_friction = 0.6f;     ///< Coulomb coefficient while it slides, >= 0.
    float restitution = 0.0f;          ///< Ratio of rebound to approach speed, 0 (no bounce) to 1 (elastic).
    float rolling_friction = 0.0f;     ///< Lever arm of the rolling resistance torque in meters, >= 0.
    float torsional_friction = 0.001f; ///< Radius of the contact patch in meters, >= 0: a spinning one-point contact
                                       ///< feels a torque of at most friction x normal force x this radius. Without
                                       ///< any, a ball that spins upright never comes to rest.
    CombineRule friction_combine = CombineRule::average;
    CombineRule restitution_combine = CombineRule::average;
};

/// How a shape is attached to its body.
struct ShapeDef {
    Vec3 position{0.0f, 0.0f, 0.0f};       ///< Origin of the shape in the body's frame, meters.
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< Orientation in the body's frame; normalized, must not be zero.
    float density = 1000.0f;               ///< kg/m^3, >= 0; 0 adds no mass. Ignored by planes.
    Material material{};
    std::uint64_t user_data = 0; ///< Not touched by the engine.
};

} // namespace cairn
