// The points of a contact, and the selection of at most four that represent them.
#pragma once

#include "math/vec.h"

#include <cstddef>
#include <span>

namespace cairn {

// A contact point midway between the surfaces.
struct SurfacePoint {
    math::DVec3 position;
    double separation;
};

// A candidate point, projected along the normal. `nearness`, from 0 to 1: a weight for how near the surfaces are there,
// computed by choose_points.
struct FlatPoint {
    double x, y, separation, nearness;
};
struct FlatFrame {
    // `middle`: near the middle of the possible contact.
    FlatFrame(const math::DVec3& normal, const math::DVec3& middle);
    FlatPoint flat(math::DVec3 position, double separation) const {
        const math::DVec3 d = position - center;
        return {math::dot(d, e1), math::dot(d, e2), separation, 1};
    }
    math::DVec3 e1, e2, center;
};
struct Chosen {
    int count = 0;
    std::size_t index[4] = {};
};
// Chooses at most four points that represent all. `extent`: the size of the smaller shape, for the tolerances.
Chosen choose_points(std::span<FlatPoint> points, double extent);

} // namespace cairn
