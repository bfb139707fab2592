// Where something stands, in double: a rotation, then a translation.
#pragma once

#include <cairn/math.h>

namespace cairn::scene {

struct Rigid {
    glm::dvec3 position{0.0, 0.0, 0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};

    // `inner`, which stands here, as seen from where this is seen.
    Rigid operator*(const Rigid& inner) const {
        return {position + rotation * inner.position, glm::normalize(rotation * inner.rotation)};
    }
    Transform transform() const { return {position, Quat(rotation)}; }
};

} // namespace cairn::scene
