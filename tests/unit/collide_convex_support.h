// Shared by the tests of the capsule kernels: the double-precision test for all convex shapes, and relative placements.
#pragma once

#include "collide_test_support.h"
#include "collision/convex_contact.h"

#include <algorithm>

namespace collide_test {

inline cairn::Convex convex_of(const ShapePose& pose, cairn::ShapeType type, cairn::math::DVec3 center) {
    cairn::Geometry g;
    g.type = type;
    g.size = {pose.size[0], pose.size[1], pose.size[2]};
    g.bounding_radius = pose.size[3];
    const cairn::math::DQuat q{double(pose.q[0]), double(pose.q[1]), double(pose.q[2]), double(pose.q[3])};
    return make_convex(g, {}, center, normalized(q));
}
inline cairn::math::DVec3 offset_between(const ShapePose& a, const ShapePose& b) {
    const Vec d = frame_of(b).center - frame_of(a).center;
    return {d[0], d[1], d[2]};
}

// The manifold by the double-precision test; the second shape is a capsule.
inline Manifold scalar_result(const Pairs& pairs, int i, cairn::ShapeType first) {
    const ShapePose &a = pairs.first(i), &b = pairs.second(i);
    const cairn::math::DVec3 offset = offset_between(a, b);
    cairn::ContactMemory memory = cairn::nothing_met;
    Manifold m;
    collide_convex(convex_of(a, first, {}), convex_of(b, cairn::ShapeType::capsule, offset), pairs.margin(i), {},
                   memory, m);
    return m;
}

inline Quat times(const Quat& p, const Quat& q) {
    const Vec a = {p[0], p[1], p[2]}, b = {q[0], q[1], q[2]}, v = p[3] * b + q[3] * a + cross(a, b);
    return {v[0], v[1], v[2], p[3] * q[3] - dot(a, b)};
}
inline Vec axis_of(const Quat& q) { return frame_of(capsule({}, q, 1, 1)).axis[1]; }

// The point of a capsule's axis segment that is closest to a given point.
inline Vec nearest_on(const Frame& c, const Vec& p) {
    return c.center + std::clamp(dot(c.axis[1], p - c.center), -c.half[1], c.half[1]) * c.axis[1];
}

} // namespace collide_test
