// Tests of pairs that no wide kernel does: one at a time, in double, about the center of A.
#include "collision/convex_contact.h"
#include "collision/surface_contact.h"
#include "dynamics/contacts.h"

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
math::DQuat rotation_of(const ShapePose& pose) {
    return math::normalized(math::DQuat{pose.q[0], pose.q[1], pose.q[2], pose.q[3]});
}
Convex convex_of(const PosedShape& shape, DVec3 center) {
    return make_convex(shape.geometry, shape.data, center, rotation_of(shape.pose));
}

} // namespace

Manifold test_convex_pair(PairKind kind, const PosedShape& a, const PosedShape& b, math::Vec3 guess, float margin) {
    const DVec3 offset = offset_between(a.pose, b.pose);
    const Convex first = convex_of(a, {});
    Manifold out{};
    if (kind == PairKind::convex_convex) {
        collide_convex(first, convex_of(b, offset), double(margin), to_double(guess), out);
        return out;
    }
    if (kind == PairKind::convex_plane) {
        const DVec3 up = math::to_matrix(rotation_of(b.pose)).c1;
        collide_plane(first, up, -math::dot(up, offset), double(margin), out);
    } else {
        collide_surface(first, convex_of(b, offset), double(margin), to_double(guess), out);
    }
    return out;
}

void find_patches(const PosedShape& a, const PosedShape& surface, float margin, SurfaceScratch& scratch,
                  std::vector<Manifold>& hits) {
    const DVec3 offset = offset_between(a.pose, surface.pose);
    const Surface posed{surface.data, offset, math::to_matrix(rotation_of(surface.pose))};
    collide_triangles(convex_of(a, {}), posed, double(margin), scratch, hits);
}

} // namespace cairn
