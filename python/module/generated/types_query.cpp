// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/containers.h"

namespace cairn::python {

void read(py::handle o, BroadPhaseTree& x, const Where& where) {
    x = BroadPhaseTree(read_enum(o, "BroadPhaseTree", where));
}
py::object write(BroadPhaseTree x) { return write_enum("BroadPhaseTree", int(x)); }

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

py::object write(const BroadPhaseNode& x) {
    return make("BroadPhaseNode", py::make_tuple(write(x.bounds), write(x.tree), write(x.depth), write(x.parent),
        write(x.is_leaf), write(x.shape)));
}

py::object write(const SolverContact& x) {
    return make("SolverContact", py::make_tuple(write(x.shape_a), write(x.shape_b), write(x.body_a), write(x.body_b),
        write(x.color), write(x.substeps)));
}

} // namespace cairn::python
