#include "collision/flat_side.h"

#include "collision/convex_contact.h"

namespace cairn {

using math::dot;
using math::DVec3;
using math::to_double;
using math::to_vec;

namespace {

// Whether all points that are within the bounding radius of `other` from a point where it touches `round` are within
// `depth` m of the tangent plane there. A ball as `other` touches any surface in a single point.
bool is_flat_to(const Geometry& round, const Geometry& other, double depth) {
    const bool is_straight = (round.type == ShapeType::capsule || round.type == ShapeType::cylinder) &&
                             round.size.x == round.size.z && round.rounding == 0;
    if (round.type != ShapeType::sphere && !is_straight) return false;
    if (other.type == ShapeType::sphere || is_surface(other.type)) return false;
    const double reach = double(other.bounding_radius);
    return reach * reach <= 2 * double(round.size.x) * depth;
}

// The component of a vector along which a round side is straight: zero for balls.
DVec3 straight_part(const Convex& round, DVec3 v) {
    return round.kind == Convex::Kind::ball ? DVec3{} : dot(round.axes.c1, v) * round.axes.c1;
}

// Whether all points within `reach`, m, of the middle of `other` are over the side, not over an end.
bool is_over_side(const Convex& round, const Convex& other, double reach) {
    return round.kind == Convex::Kind::ball ||
           std::fabs(dot(round.axes.c1, middle(other) - round.center)) + reach < round.size.y;
}

} // namespace

bool may_be_flat(const Geometry& round, const Geometry& other, float width) {
    return is_flat_to(round, other, core_depth_of(0.5 * double(width)));
}

std::optional<FlatSide> flat_side_under(const Convex& round, const Convex& other, double reach) {
    if (!is_over_side(round, other, reach)) return std::nullopt;
    const DVec3 from = middle(other) - round.center, away = from - straight_part(round, from);
    const double length = math::length(away);
    if (!(length > 0)) return std::nullopt;
    const DVec3 up = (1 / length) * away;
    return FlatSide{up, dot(up, other.center - round.center) - round.size.x};
}

bool is_nearly_flat(const Geometry& round, const Geometry& other, float margin) {
    return is_flat_to(round, other, double(margin));
}

void add_corners(const Convex& round, const Convex& other, double reach, double margin, Manifold& out) {
    if (out.count == 0 || out.count > 2 || !is_over_side(round, other, reach)) return;
    const DVec3 up = -to_double(to_vec(out.normal)), foot = to_double(to_vec(out.points[0]));
    Manifold plane;
    collide_plane(other, up, dot(up, other.center - round.center) - round.size.x, margin, plane);
    struct Corner {
        DVec3 place;
        double separation, beside;
        std::uint32_t feature;
    } corners[4];
    int count = 0;
    for (int i = 0; i < plane.count; ++i) {
        const DVec3 corner = to_double(to_vec(plane.points[i])) + 0.5 * double(plane.points[i][3]) * up;
        const DVec3 from = corner - round.center, away = from - straight_part(round, from), to_foot = foot - corner;
        const double distance = math::length(away), separation = distance - round.size.x;
        const double beside = math::length(to_foot - straight_part(round, to_foot));
        if (!(separation <= margin) || beside < 1e-3 * other.extent) continue;
        corners[count++] = {corner - (0.5 * separation / distance) * away, separation, beside, plane.features[i]};
    }
    std::stable_sort(corners, corners + count, [](const Corner& a, const Corner& b) { return a.beside > b.beside; });
    for (int i = 0; i < count && out.count < 4; ++i) {
        math::put(out.points[out.count], math::to_float(corners[i].place));
        out.points[out.count][3] = float(corners[i].separation);
        out.features[out.count++] = corners[i].feature;
        out.features[0] |= on_second_face | on_flat_side;
    }
}

} // namespace cairn
