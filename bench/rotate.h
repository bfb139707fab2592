// Rotations in double precision, for exact measurements.
#pragma once

#include <cairn/math.h>

namespace cairn::bench {

inline glm::dvec3 rotate(const Quat& q, const glm::dvec3& v) {
    const glm::dvec3 u(q.x, q.y, q.z);
    const glm::dvec3 t = 2.0 * glm::cross(u, v);
    return v + double(q.w) * t + glm::cross(u, t);
}

inline Quat conjugate(const Quat& q) { return Quat(q.w, -q.x, -q.y, -q.z); }

} // namespace cairn::bench
