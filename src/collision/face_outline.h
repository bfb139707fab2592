// The outline of a flat polygonal face of a convex shape, in its own plane.
#pragma once

#include "collision/contact_features.h"
#include "shapes/hull.h"

#include <span>

namespace cairn {

struct FaceOutline {
    ContactFrame frame; // its origin is the first corner
    std::uint32_t index = 0;
    std::size_t corner_count = 0;
    double size = 0; // the largest absolute coordinate of a corner
    std::span<const SideBlock> sides;

    // `normal`, `on_face`: the results of face_normal and face_point.
    void find(const Convex& c, int face, const math::DVec3& normal, const math::DVec3& on_face);

    // Whether a point, projected along the normal, is inside of every side by more than `distance`.
    bool holds(const math::DVec3& p, double distance) const;

  private:
    SideBlock made_[made_blocks]; // used if the shape has no precomputed sides
};

} // namespace cairn
