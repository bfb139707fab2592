#include "collision/face_outline.h"

namespace cairn {

using math::dot;
using math::DVec3;

void FaceOutline::find(const Convex& c, int face, const DVec3& normal, const DVec3& on_face) {
    index = static_cast<std::uint32_t>(face);
    if (c.kind == Convex::Kind::hull) {
        const HullData& hull = *c.hull;
        const auto f = static_cast<std::size_t>(face);
        const HullOutline& outline = hull.outlines[f];
        corner_count = hull.faces[f].count, size = outline.size;
        sides = {&hull.sides[outline.first_side], (corner_count + SideBlock::width - 1) / SideBlock::width};
        frame.normal = normal, frame.e1 = c.axes * outline.e1;
        frame.e2 = math::cross(frame.normal, frame.e1);
        frame.origin = on_face;
        return;
    }
    Feature polygon;
    face_feature(c, face, polygon);
    const DVec3* const p = polygon.points.data();
    corner_count = polygon.points.size(), size = 0;
    frame.normal = polygon.normal, frame.e1 = direction_in_plane(p[1] - p[0], frame.normal);
    frame.e2 = math::cross(frame.normal, frame.e1);
    frame.origin = p[0];
    Buffer<FlatCorner, 16> corners;
    for (std::size_t i = 0; i < corner_count; ++i) {
        const DVec3 q = frame.to_frame(p[i]);
        corners.add({q.x, q.y});
        size = std::max(size, std::max(std::fabs(q.x), std::fabs(q.y)));
    }
    own_.clear();
    make_sides(corners, [&](const SideBlock& block) { own_.add(block); });
    sides = {own_.data(), own_.size()};
}

bool FaceOutline::holds(const DVec3& p, double distance) const {
    const DVec3 d = p - frame.origin;
    const double x = dot(d, frame.e1), y = dot(d, frame.e2);
    double inside[SideBlock::width];
    for (const SideBlock& block : sides)
        if (block.inside(x, y, -distance, inside) != 0) return false;
    return true;
}

} // namespace cairn
