// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/containers.h"

namespace cairn::python {

void read(py::handle o, Transform& x, const Where& where) {
    if (!is_a(o, "Transform")) refuse_type(where, "a Transform", o);
    read(o.attr("position"), x.position, {"Transform", "position"});
    read(o.attr("rotation"), x.rotation, {"Transform", "rotation"});
}
py::object write(const Transform& x) {
    return make("Transform", py::make_tuple(write(x.position), write(x.rotation)));
}

void read(py::handle o, Bounds& x, const Where& where) {
    if (!is_a(o, "Bounds")) refuse_type(where, "a Bounds", o);
    read(o.attr("min"), x.min, {"Bounds", "min"});
    read(o.attr("max"), x.max, {"Bounds", "max"});
}
py::object write(const Bounds& x) {
    return make("Bounds", py::make_tuple(write(x.min), write(x.max)));
}

} // namespace cairn::python
