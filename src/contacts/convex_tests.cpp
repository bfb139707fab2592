// Tests of pairs that have no wide kernel: one at a time, in double precision, relative to the center of A.
#include "contacts/convex_tests.h"

#include "collision/convex_contact.h"
#include "collision/flat_side.h"
#include "collision/one_place.h"
#include "collision/one_way.h"
#include "collision/surface_contact.h"
#include "contacts/contact_update.h"
#include "contacts/pairs.h"
#include "shapes/gjk.h"

#include <limits>

namespace cairn {

using math::DVec3;
using math::to_double;
using math::to_vec;

namespace {

// From the center of A to the center of B; exact, however far from the origin both are.
DVec3 offset_between(const ShapePose& a, const ShapePose& b) {
    return (to_double(to_vec(b.high)) - to_double(to_vec(a.high))) +
           (to_double(to_vec(b.low)) - to_double(to_vec(a.low)));
}
// The same for shapes that are to be pushed apart even if their centers coincide: never zero.
DVec3 nonzero_center_offset(const ShapePose& a, const ShapePose& b) {
    const DVec3 offset = offset_between(a, b);
    if (!(offset == DVec3{})) return offset;
    float apart[3];
    coincident_center_offset(a.low[3], b.low[3], a.size[3] + b.size[3], apart);
    return {double(apart[0]), double(apart[1]), double(apart[2])};
}
math::DQuat rotation_of(const ShapePose& pose) {
    return math::normalized(math::DQuat{pose.q[0], pose.q[1], pose.q[2], pose.q[3]});
}
Convex convex_of(const PosedShape& shape, const DVec3& center) {
    return make_convex(shape.geometry, shape.data, center, rotation_of(shape.pose));
}

// The side from which a double-sided surface is touched is where the shape is: for an infinite plane, the side of the
// body's center of mass, as nothing can reach around the plane; for a rectangle, the side of the shape's middle, as
// parts of the body may well be on the other side.
DVec3 facing_normal(const PosedShape& a, const PosedShape& plane, DVec3 offset) {
    const DVec3 up = math::to_matrix(rotation_of(plane.pose)).c1;
    const bool is_behind = plane.geometry.is_double_sided && math::dot(up, -to_double(a.arm) - offset) < 0;
    return is_behind ? -up : up;
}
Convex facing_polygon(const Convex& a, double reach, const PosedShape& rectangle, DVec3 offset) {
    const math::DQuat rotation = rotation_of(rectangle.pose);
    DVec3 center = offset;
    const Geometry part = near_part(rectangle.geometry, center, rotation, middle(a), reach);
    const Convex polygon = make_convex(part, rectangle.data, center, rotation);
    const bool is_behind = part.is_double_sided && math::dot(polygon.axes.c1, middle(a) - polygon.center) < 0;
    return is_behind ? reversed(polygon) : polygon;
}

// Tests `a` against a round side that counts as a plane; returns whether it does. If they are separated by more than
// the margin, the separation of the first point is the distance from the plane, a lower bound of that from the round
// side.
bool collide_flat_side(const PosedShape& a, const PosedShape& round, const Convex& first, const Convex& side,
                       double margin, Manifold& out) {
    if (!may_be_flat(round.geometry, a.geometry, smallest_extent(a.geometry, a.data))) return false;
    const std::optional<FlatSide> flat = flat_side_under(side, first, double(a.geometry.bounding_radius));
    if (!flat) return false;
    collide_plane(first, flat->up, flat->height, margin, out);
    if (out.count > 0)
        out.features[0] |= on_second_face | on_flat_side;
    else
        out.points[0][3] = float(flat->height + math::dot(flat->up, support(first, -flat->up) - first.center));
    return true;
}

} // namespace

bool goes_through(const Shapes& shapes, const ContactInfo& c) {
    const PosedShape a = posed_shape(shapes, c.shape_a), b = posed_shape(shapes, c.shape_b);
    const Convex first = convex_of(a, {});
    DVec3 center = offset_between(a.pose, b.pose);
    const math::DQuat rotation = rotation_of(b.pose);
    const Geometry part =
        near_part(b.geometry, center, rotation, middle(first), 2 * double(a.geometry.bounding_radius));
    return !is_beyond(first, make_convex(part, b.data, center, rotation),
                      math::rotate(rotation, to_double(shapes.traits[c.shape_b].one_way)));
}

Manifold test_convex_pair(PairKind kind, const PosedShape& a, const PosedShape& b, math::Vec3 guess, float margin,
                          ContactMemory& memory) {
    const Convex first = convex_of(a, {});
    Manifold out;
    if (kind == PairKind::convex_convex) {
        const Convex second = convex_of(b, nonzero_center_offset(a.pose, b.pose));
        if (collide_flat_side(a, b, first, second, double(margin), out)) {
            memory = nothing_met;
            return out;
        }
        collide_convex(first, second, double(margin), to_double(guess), memory, out);
        if (out.count > 0 && is_nearly_flat(b.geometry, a.geometry, margin_of(smallest_extent(a.geometry, a.data))))
            add_corners(second, first, double(a.geometry.bounding_radius), double(margin), out);
        return out;
    }
    const DVec3 offset = offset_between(a.pose, b.pose);
    if (kind == PairKind::convex_plane) {
        const DVec3 up = facing_normal(a, b, offset);
        collide_plane(first, up, -math::dot(up, offset), double(margin), out);
    } else {
        const double reach = 2 * double(a.geometry.bounding_radius) + double(margin);
        collide_surface(first, facing_polygon(first, reach, b, offset), double(margin), to_double(guess), out);
    }
    return out;
}

void part_points(const PosedShape& a, const PosedShape& b, Manifold& m) {
    if (m.count == 0) return;
    const float least = least_separation(m);
    if (least > 0) return;
    const Convex first = convex_of(a, {}), second = convex_of(b, nonzero_center_offset(a.pose, b.pose));
    const CorePair pair{exact_core(first), exact_core(second)};
    const double radii = pair.a.radius + pair.b.radius;
    const GjkResult r = gjk_distance(pair, to_double(to_vec(m.normal)), std::numeric_limits<double>::infinity());
    if (!(r.distance > radii)) return; // 0 where the cores overlap
    for (int i = 0; i < m.count; ++i) m.points[i][3] += float(r.distance - radii) - least;
}

Manifold test_posed_pair(PairKind kind, const PosedShape& a, const PosedShape& b, math::Vec3 guess, float margin) {
    if (int(kind) < wide_kinds) {
        const ShapePose poses[2] = {a.pose, b.pose};
        std::uint32_t first[8], second[8], features[8];
        float margins[8];
        for (int i = 0; i < 8; ++i) first[i] = 0, second[i] = 1, margins[i] = margin, features[i] = no_features;
        Manifold manifolds[8];
        wide_kernel(kind)(poses, first, second, margins, features, 8, manifolds);
        return manifolds[0];
    }
    ContactMemory memory = nothing_met;
    return test_convex_pair(kind, a, b, guess, margin, memory);
}

float find_patches(const PosedShape& a, const PosedShape& surface, float margin, float reach, SurfaceScratch& scratch,
                   std::vector<Manifold>& hits) {
    const DVec3 offset = offset_between(a.pose, surface.pose);
    const Surface posed{surface.data, offset, math::to_matrix(rotation_of(surface.pose))};
    return float(
        collide_triangles(kernels().triangles, convex_of(a, {}), posed, double(margin), double(reach), scratch, hits));
}

} // namespace cairn
