// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/containers.h"

namespace cairn::python {

void read(py::handle o, BodyType& x, const Where& where) {
    x = BodyType(read_enum(o, "BodyType", where));
}
py::object write(BodyType x) { return write_enum("BodyType", int(x)); }

void read(py::handle o, MassProperties& x, const Where& where) {
    if (!is_a(o, "MassProperties")) refuse_type(where, "a MassProperties", o);
    read(o.attr("mass"), x.mass, {"MassProperties", "mass"});
    read(o.attr("center_of_mass"), x.center_of_mass, {"MassProperties", "center_of_mass"});
    read(o.attr("inertia_diagonal"), x.inertia_diagonal, {"MassProperties", "inertia_diagonal"});
    read(o.attr("inertia_orientation"), x.inertia_orientation, {"MassProperties", "inertia_orientation"});
}
py::object write(const MassProperties& x) {
    return make("MassProperties", py::make_tuple(write(x.mass), write(x.center_of_mass), write(x.inertia_diagonal),
        write(x.inertia_orientation)));
}

void read(py::handle o, BodyDef& x, const Where& where) {
    if (!is_a(o, "BodyDef")) refuse_type(where, "a BodyDef", o);
    read(o.attr("type"), x.type, {"BodyDef", "type"});
    read(o.attr("position"), x.position, {"BodyDef", "position"});
    read(o.attr("rotation"), x.rotation, {"BodyDef", "rotation"});
    read(o.attr("linear_velocity"), x.linear_velocity, {"BodyDef", "linear_velocity"});
    read(o.attr("angular_velocity"), x.angular_velocity, {"BodyDef", "angular_velocity"});
    read(o.attr("linear_damping"), x.linear_damping, {"BodyDef", "linear_damping"});
    read(o.attr("angular_damping"), x.angular_damping, {"BodyDef", "angular_damping"});
    read(o.attr("gravity_scale"), x.gravity_scale, {"BodyDef", "gravity_scale"});
    read(o.attr("allow_sleep"), x.allow_sleep, {"BodyDef", "allow_sleep"});
    read(o.attr("mass"), x.mass, {"BodyDef", "mass"});
    read(o.attr("mass_properties"), x.mass_properties, {"BodyDef", "mass_properties"});
    read(o.attr("name"), x.name, {"BodyDef", "name"});
    read(o.attr("user_data"), x.user_data, {"BodyDef", "user_data"});
}
py::object write(const BodyDef& x) {
    return make("BodyDef", py::make_tuple(write(x.type), write(x.position), write(x.rotation), write(x.linear_velocity),
        write(x.angular_velocity), write(x.linear_damping), write(x.angular_damping), write(x.gravity_scale),
        write(x.allow_sleep), write(x.mass), write(x.mass_properties), write(x.name), write(x.user_data)));
}

} // namespace cairn::python
