// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/containers.h"

namespace cairn::python {

void read(py::handle o, BodyType& x, const Where& where) {
    x = BodyType(read_enum(o, "BodyType", where));
}
py::object write(BodyType x) { return write_enum("BodyType", int(x)); }

void read(py::handle o, CharacterSupport& x, const Where& where) {
    x = CharacterSupport(read_enum(o, "CharacterSupport", where));
}
py::object write(CharacterSupport x) { return write_enum("CharacterSupport", int(x)); }

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
    read(o.attr("enabled"), x.enabled, {"BodyDef", "enabled"});
}
py::object write(const BodyDef& x) {
    return make("BodyDef", py::make_tuple(write(x.type), write(x.position), write(x.rotation), write(x.linear_velocity),
        write(x.angular_velocity), write(x.linear_damping), write(x.angular_damping), write(x.gravity_scale),
        write(x.allow_sleep), write(x.mass), write(x.mass_properties), write(x.name), write(x.user_data),
        write(x.enabled)));
}

void read(py::handle o, CharacterDef& x, const Where& where) {
    if (!is_a(o, "CharacterDef")) refuse_type(where, "a CharacterDef", o);
    read(o.attr("up"), x.up, {"CharacterDef", "up"});
    read(o.attr("max_slope"), x.max_slope, {"CharacterDef", "max_slope"});
    read(o.attr("step_height"), x.step_height, {"CharacterDef", "step_height"});
    read(o.attr("stick_distance"), x.stick_distance, {"CharacterDef", "stick_distance"});
    read(o.attr("skin"), x.skin, {"CharacterDef", "skin"});
    read(o.attr("mass"), x.mass, {"CharacterDef", "mass"});
    read(o.attr("max_push_force"), x.max_push_force, {"CharacterDef", "max_push_force"});
    read(o.attr("air_acceleration"), x.air_acceleration, {"CharacterDef", "air_acceleration"});
    read(o.attr("flies"), x.flies, {"CharacterDef", "flies"});
}
py::object write(const CharacterDef& x) {
    return make("CharacterDef", py::make_tuple(write(x.up), write(x.max_slope), write(x.step_height),
        write(x.stick_distance), write(x.skin), write(x.mass), write(x.max_push_force), write(x.air_acceleration),
        write(x.flies)));
}

py::object write(const CharacterState& x) {
    return make("CharacterState", py::make_tuple(write(x.support), write(x.velocity), write(x.ground_shape),
        write(x.ground_body), write(x.ground_point), write(x.ground_normal), write(x.ground_velocity)));
}

} // namespace cairn::python
