// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"

#include <string>

namespace cairn::c_api {

Transform to_cpp(const cairn_transform& c) {
    Transform x;
    x.position = to_cpp(c.position);
    x.rotation = to_cpp(c.rotation);
    return x;
}
cairn_transform to_c(const Transform& x) {
    cairn_transform c{};
    c.position = to_c(x.position);
    c.rotation = to_c(x.rotation);
    return c;
}

Bounds to_cpp(const cairn_bounds& c) {
    Bounds x;
    x.min = to_cpp(c.min);
    x.max = to_cpp(c.max);
    return x;
}
cairn_bounds to_c(const Bounds& x) {
    cairn_bounds c{};
    c.min = to_c(x.min);
    c.max = to_c(x.max);
    return c;
}

} // namespace cairn::c_api
