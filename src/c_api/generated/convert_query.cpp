// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"

#include <string>

namespace cairn::c_api {

cairn_ray_hit to_c(const RayHit& x) {
    cairn_ray_hit c{};
    c.shape = to_c(x.shape);
    c.body = to_c(x.body);
    c.point = to_c(x.point);
    c.normal = to_c(x.normal);
    c.distance = x.distance;
    return c;
}

cairn_shape_cast_hit to_c(const ShapeCastHit& x) {
    cairn_shape_cast_hit c{};
    c.shape = to_c(x.shape);
    c.body = to_c(x.body);
    c.fraction = x.fraction;
    c.point = to_c(x.point);
    c.normal = to_c(x.normal);
    return c;
}

cairn_closest_point to_c(const ClosestPoint& x) {
    cairn_closest_point c{};
    c.shape = to_c(x.shape);
    c.body = to_c(x.body);
    c.point = to_c(x.point);
    c.distance = x.distance;
    return c;
}

} // namespace cairn::c_api
