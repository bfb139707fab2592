/// \file math.h
/// Vector types of the public API. They are GLM's, so that applications with GLM need no conversion. The engine
/// computes with its own operations (src/math), never with GLM's functions.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace cairn {

using Vec3 = glm::vec3;      ///< Directions, velocities, extents, forces: float, SI units.
using Position = glm::dvec3; ///< World position in meters: double, so that large worlds keep their precision.
using Quat = glm::quat;      ///< Rotation as a unit quaternion. Constructor order is (w, x, y, z).
using Mat3 = glm::mat3;      ///< Column-major 3x3 matrix (inertia tensors, in kg m^2).

static_assert(sizeof(Vec3) == 12 && sizeof(Position) == 24 && sizeof(Quat) == 16 && sizeof(Mat3) == 36,
              "cairn relies on GLM's packed layout");

/// A pose: rotate by `rotation`, then translate by `position` (meters).
struct Transform {
    Position position{0.0, 0.0, 0.0};
    Quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
};

/// An axis-aligned box in world space, in meters. Empty when any `min` exceeds its `max`.
struct Bounds {
    Position min{0.0, 0.0, 0.0};
    Position max{0.0, 0.0, 0.0};
};

} // namespace cairn
