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
        write(x.distance), write(x.triangle)));
}

py::object write(const ShapeCastHit& x) {
    return make("ShapeCastHit", py::make_tuple(write(x.shape), write(x.body), write(x.fraction), write(x.point),
        write(x.normal), write(x.triangle)));
}

py::object write(const ClosestPoint& x) {
    return make("ClosestPoint", py::make_tuple(write(x.shape), write(x.body), write(x.point), write(x.distance),
        write(x.triangle)));
}

py::object write(const BroadPhaseNode& x) {
    return make("BroadPhaseNode", py::make_tuple(write(x.bounds), write(x.tree), write(x.depth), write(x.parent),
        write(x.is_leaf), write(x.shape)));
}

py::object write(const SolverContact& x) {
    return make("SolverContact", py::make_tuple(write(x.shape_a), write(x.shape_b), write(x.body_a), write(x.body_b),
        write(x.color), write(x.substeps)));
}

void read(py::handle o, DebugLinesDef& x, const Where& where) {
    if (!is_a(o, "DebugLinesDef")) refuse_type(where, "a DebugLinesDef", o);
    read(o.attr("shapes"), x.shapes, {"DebugLinesDef", "shapes"});
    read(o.attr("bounds"), x.bounds, {"DebugLinesDef", "bounds"});
    read(o.attr("centers"), x.centers, {"DebugLinesDef", "centers"});
    read(o.attr("velocities"), x.velocities, {"DebugLinesDef", "velocities"});
    read(o.attr("contacts"), x.contacts, {"DebugLinesDef", "contacts"});
    read(o.attr("joints"), x.joints, {"DebugLinesDef", "joints"});
    read(o.attr("size"), x.size, {"DebugLinesDef", "size"});
    read(o.attr("impulse_scale"), x.impulse_scale, {"DebugLinesDef", "impulse_scale"});
}
py::object write(const DebugLinesDef& x) {
    return make("DebugLinesDef", py::make_tuple(write(x.shapes), write(x.bounds), write(x.centers), write(x.velocities),
        write(x.contacts), write(x.joints), write(x.size), write(x.impulse_scale)));
}

py::object write(const DebugLine& x) {
    return make("DebugLine", py::make_tuple(write(x.begin), write(x.end), write(x.color)));
}

void read(py::handle o, QueryFilter& x, const Where& where) {
    if (!is_a(o, "QueryFilter")) refuse_type(where, "a QueryFilter", o);
    read(o.attr("layers"), x.layers, {"QueryFilter", "layers"});
    read(o.attr("own_layers"), x.own_layers, {"QueryFilter", "own_layers"});
    read(o.attr("static_bodies"), x.static_bodies, {"QueryFilter", "static_bodies"});
    read(o.attr("kinematic_bodies"), x.kinematic_bodies, {"QueryFilter", "kinematic_bodies"});
    read(o.attr("dynamic_bodies"), x.dynamic_bodies, {"QueryFilter", "dynamic_bodies"});
    read(o.attr("triggers"), x.triggers, {"QueryFilter", "triggers"});
    read(o.attr("any"), x.any, {"QueryFilter", "any"});
    read(o.attr("ignored_bodies"), x.ignored_bodies, {"QueryFilter", "ignored_bodies"});
}
py::object write(const QueryFilter& x) {
    return make("QueryFilter", py::make_tuple(write(x.layers), write(x.own_layers), write(x.static_bodies),
        write(x.kinematic_bodies), write(x.dynamic_bodies), write(x.triggers), write(x.any), write(x.ignored_bodies)));
}

} // namespace cairn::python
