#include "collision/face_outline.h"

namespace cairn {

using math::dot;
using math::DVec3;

void FaceOutline::find(const Convex& c, int face, const DVec3& normal, const DVec3& on_face) {
    index = static_cast<std::uint32_t>(face);
    if (c.kind == Convex::Kind::hull) {
        const HullData& hull = *c.hull;
        const auto f = static_cast<std::size_t>(face);
        const HullOutline outline = outline_of(hull, f, made_);
        corner_count = hull.faces[f].count, size = outline.size, sides = outline.sides;
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
    double x[max_made_sides + 1], y[max_made_sides + 1]; // a box's face or a polygon has at most four corners
    for (std::size_t i = 0; i < corner_count; ++i) {
        const DVec3 q = frame.to_frame(p[i]);
        x[i] = q.x, y[i] = q.y;
        size = std::max(size, std::max(std::fabs(q.x), std::fabs(q.y)));
    }
    make_sides(x, y, corner_count, made_);
    sides = {made_, blocks_of(corner_count)};
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
