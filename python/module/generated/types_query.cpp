// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/containers.h"

namespace cairn::python {

py::object write(const RayHit& x) {
    return make("RayHit", py::make_tuple(write(x.shape), write(x.body), write(x.point), write(x.normal),
        write(x.distance)));
}

py::object write(const ShapeCastHit& x) {
    return make("ShapeCastHit", py::make_tuple(write(x.shape), write(x.body), write(x.fraction), write(x.point),
        write(x.normal)));
}

py::object write(const ClosestPoint& x) {
    return make("ClosestPoint", py::make_tuple(write(x.shape), write(x.body), write(x.point), write(x.distance)));
}

} // namespace cairn::python
