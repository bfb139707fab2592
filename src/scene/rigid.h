// A pose in double precision: a rotation, then a translation.
#pragma once

#include <cairn/math.h>

#include <cmath>

namespace cairn::scene {

struct Rigid {
    glm::dvec3 position{0.0, 0.0, 0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};

    // Composes poses: `inner`, which is given in this frame, in the frame in which this pose is given.
    Rigid operator*(const Rigid& inner) const {
        return {position + rotation * inner.position, glm::normalize(rotation * inner.rotation)};
    }
    Transform transform() const { return {position, Quat(rotation)}; }
};

inline glm::dquat turn_about(const glm::dvec3& unit_axis, double angle) {
    const double sine = std::sin(0.5 * angle);
    return {std::cos(0.5 * angle), sine * unit_axis.x, sine * unit_axis.y, sine * unit_axis.z};
}

// The rotation from the x axis, which is the axis of joints in the engine, to `axis`, of unit length.
inline glm::dquat turn_from_x(const glm::dvec3& axis) {
    if (axis.x < -0.999999) return {0.0, 0.0, 0.0, 1.0};
    return glm::normalize(glm::dquat(1.0 + axis.x, 0.0, -axis.z, axis.y));
}

inline Rigid inverse(const Rigid& frame) {
    const glm::dquat back = glm::conjugate(frame.rotation);
    return {back * -frame.position, back};
}

inline constexpr double degree = 3.14159265358979323846 / 180.0; // rad
inline constexpr double root_of_half = 0.70710678118654752440;   // sine and cosine of 45 degrees

// From a file with z up to the world with y up: x stays x, z becomes y, y becomes -z.
inline const Rigid upright{{0.0, 0.0, 0.0}, {root_of_half, -root_of_half, 0.0, 0.0}};
// From shapes along y, as in the engine, to shapes along z, as in files.
inline const Rigid y_to_z{{0.0, 0.0, 0.0}, {root_of_half, root_of_half, 0.0, 0.0}};

} // namespace cairn::scene
