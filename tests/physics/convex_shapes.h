// One convex shape of each of `convex_kinds` kinds, about as large as a ball of radius `size`, m.
#pragma once

#include "support.h"

#include <vector>

namespace cairn_test {

inline constexpr int convex_kinds = 6;
inline Shape convex(int kind, float size) {
    switch (kind) {
    case 0:
        return Sphere{size};
    case 1:
        return Box{{size, 0.8f * size, 0.6f * size}};
    case 2:
        return Capsule{0.6f * size, 0.5f * size};
    case 3:
        return Cylinder{0.6f * size, 0.7f * size};
    case 4:
        return Box{{0.7f * size, 0.6f * size, 0.5f * size}, 0.2f * size};
    default: {
        std::vector<Vec3> corners = box_corners({size, 0.7f * size, 0.6f * size});
        for (Vec3& p : corners)
            if (p.y > 0) p *= 0.7f;
        return Hull(corners);
    }
    }
}

} // namespace cairn_test
