// A flat face of a convex shape with corners, in its own plane.
#pragma once

#include "collision/contact_features.h"
#include "shapes/hull.h"

#include <span>

namespace cairn {

struct FaceOutline {
    ContactFrame frame; // about the first corner
    std::uint32_t index = 0;
    std::size_t corner_count = 0;
    double size = 0; // the largest coordinate of a corner
    std::span<const SideBlock> sides;

    // `normal`, `on_face`: as of face_normal and face_point.
    void find(const Convex& c, int face, const math::DVec3& normal, const math::DVec3& on_face);

    // Whether a point, seen along the normal, is farther inside of every side than so much.
    bool holds(const math::DVec3& p, double distance) const;

  private:
    SideBlock made_[made_blocks]; // of what has none at hand
};

} // namespace cairn
