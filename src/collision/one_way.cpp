#include "collision/one_way.h"

#include "collision/sweep_search.h"

#include <algorithm>

namespace cairn {

using math::DVec3;

namespace {

Convex convex_at_begin(const SweptShape& shape, DVec3 near, double reach) {
    const RigidPath::Pose pose = shape.path.first();
    DVec3 center = pose.x + math::rotate(pose.q, shape.offset);
    const math::DQuat rotation = math::normalized(pose.q * math::to_double(shape.geometry.rotation));
    const Geometry part = near_part(shape.geometry, center, rotation, near, reach);
    return make_convex(part, shape.data, center, rotation);
}

DVec3 farthest_of_core(Convex shape, double half_width, DVec3 direction) {
    shrink(shape, sweep::depth_of(shape, sweep::Layer::deep, half_width));
    return support(shape, direction);
}

} // namespace

bool is_beyond(const Convex& shape, const Convex& other, DVec3 direction) {
    const DVec3 d = math::normalized(direction);
    const double half_width = std::min(shape.extent, other.extent);
    return math::dot(d, farthest_of_core(shape, half_width, -d) - farthest_of_core(other, half_width, d)) >= 0;
}

bool begins_beyond(const SweptShape& shape, const SweptShape& other, math::Vec3 direction) {
    const Convex first = convex_at_begin(shape, {}, 0);
    const double reach = 2 * double(shape.geometry.bounding_radius);
    const Convex second = convex_at_begin(other, middle(first), reach);
    return is_beyond(first, second, second.axes * math::to_double(direction));
}

} // namespace cairn
