// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/containers.h"

namespace cairn::python {

void read(py::handle o, CombineRule& x, const Where& where) {
    x = CombineRule(read_enum(o, "CombineRule", where));
}
py::object write(CombineRule x) { return write_enum("CombineRule", int(x)); }

void read(py::handle o, Sphere& x, const Where& where) {
    if (!is_a(o, "Sphere")) refuse_type(where, "a Sphere", o);
    read(o.attr("radius"), x.radius, {"Sphere", "radius"});
}
py::object write(const Sphere& x) {
    return make("Sphere", py::make_tuple(write(x.radius)));
}

void read(py::handle o, Box& x, const Where& where) {
    if (!is_a(o, "Box")) refuse_type(where, "a Box", o);
    read(o.attr("half_extents"), x.half_extents, {"Box", "half_extents"});
    read(o.attr("rounding"), x.rounding, {"Box", "rounding"});
}
py::object write(const Box& x) {
    return make("Box", py::make_tuple(write(x.half_extents), write(x.rounding)));
}

void read(py::handle o, Plane& x, const Where& where) {
    if (!is_a(o, "Plane")) refuse_type(where, "a Plane", o);
    read(o.attr("normal"), x.normal, {"Plane", "normal"});
    read(o.attr("tangent"), x.tangent, {"Plane", "tangent"});
    read(o.attr("half_extents"), x.half_extents, {"Plane", "half_extents"});
    read(o.attr("double_sided"), x.double_sided, {"Plane", "double_sided"});
}
py::object write(const Plane& x) {
    return make("Plane", py::make_tuple(write(x.normal), write(x.tangent), write(x.half_extents),
        write(x.double_sided)));
}

void read(py::handle o, Capsule& x, const Where& where) {
    if (!is_a(o, "Capsule")) refuse_type(where, "a Capsule", o);
    read(o.attr("half_height"), x.half_height, {"Capsule", "half_height"});
    read(o.attr("radius"), x.radius, {"Capsule", "radius"});
    read(o.attr("radius_top"), x.radius_top, {"Capsule", "radius_top"});
}
py::object write(const Capsule& x) {
    return make("Capsule", py::make_tuple(write(x.half_height), write(x.radius), write(x.radius_top)));
}

void read(py::handle o, Cylinder& x, const Where& where) {
    if (!is_a(o, "Cylinder")) refuse_type(where, "a Cylinder", o);
    read(o.attr("half_height"), x.half_height, {"Cylinder", "half_height"});
    read(o.attr("radius"), x.radius, {"Cylinder", "radius"});
    read(o.attr("radius_top"), x.radius_top, {"Cylinder", "radius_top"});
    read(o.attr("rounding"), x.rounding, {"Cylinder", "rounding"});
}
py::object write(const Cylinder& x) {
    return make("Cylinder", py::make_tuple(write(x.half_height), write(x.radius), write(x.radius_top),
        write(x.rounding)));
}

void read(py::handle o, Material& x, const Where& where) {
    if (!is_a(o, "Material")) refuse_type(where, "a Material", o);
    read(o.attr("static_friction"), x.static_friction, {"Material", "static_friction"});
    read(o.attr("dynamic_friction"), x.dynamic_friction, {"Material", "dynamic_friction"});
    read(o.attr("restitution"), x.restitution, {"Material", "restitution"});
    read(o.attr("rolling_friction"), x.rolling_friction, {"Material", "rolling_friction"});
    read(o.attr("torsional_friction"), x.torsional_friction, {"Material", "torsional_friction"});
    read(o.attr("friction_combine"), x.friction_combine, {"Material", "friction_combine"});
    read(o.attr("restitution_combine"), x.restitution_combine, {"Material", "restitution_combine"});
}
py::object write(const Material& x) {
    return make("Material", py::make_tuple(write(x.static_friction), write(x.dynamic_friction), write(x.restitution),
        write(x.rolling_friction), write(x.torsional_friction), write(x.friction_combine),
        write(x.restitution_combine)));
}

void read(py::handle o, CollisionFilter& x, const Where& where) {
    if (!is_a(o, "CollisionFilter")) refuse_type(where, "a CollisionFilter", o);
    read(o.attr("layers"), x.layers, {"CollisionFilter", "layers"});
    read(o.attr("collides_with"), x.collides_with, {"CollisionFilter", "collides_with"});
}
py::object write(const CollisionFilter& x) {
    return make("CollisionFilter", py::make_tuple(write(x.layers), write(x.collides_with)));
}

void read(py::handle o, ShapeDef& x, const Where& where) {
    if (!is_a(o, "ShapeDef")) refuse_type(where, "a ShapeDef", o);
    read(o.attr("position"), x.position, {"ShapeDef", "position"});
    read(o.attr("rotation"), x.rotation, {"ShapeDef", "rotation"});
    read(o.attr("density"), x.density, {"ShapeDef", "density"});
    read(o.attr("material"), x.material, {"ShapeDef", "material"});
    read(o.attr("filter"), x.filter, {"ShapeDef", "filter"});
    read(o.attr("is_trigger"), x.is_trigger, {"ShapeDef", "is_trigger"});
    read(o.attr("surface_velocity"), x.surface_velocity, {"ShapeDef", "surface_velocity"});
    read(o.attr("user_data"), x.user_data, {"ShapeDef", "user_data"});
    read(o.attr("one_way"), x.one_way, {"ShapeDef", "one_way"});
}
py::object write(const ShapeDef& x) {
    return make("ShapeDef", py::make_tuple(write(x.position), write(x.rotation), write(x.density), write(x.material),
        write(x.filter), write(x.is_trigger), write(x.surface_velocity), write(x.user_data), write(x.one_way)));
}

void read(py::handle o, Shape& x, const Where& where) {
    if (is_a(o, "Sphere")) {
        read(o, x.emplace<Sphere>(), where);
        return;
    }
    if (is_a(o, "Box")) {
        read(o, x.emplace<Box>(), where);
        return;
    }
    if (is_a(o, "Plane")) {
        read(o, x.emplace<Plane>(), where);
        return;
    }
    if (is_a(o, "Capsule")) {
        read(o, x.emplace<Capsule>(), where);
        return;
    }
    if (is_a(o, "Cylinder")) {
        read(o, x.emplace<Cylinder>(), where);
        return;
    }
    if (py::isinstance<Hull>(o)) {
        x = o.cast<Hull>();
        return;
    }
    if (py::isinstance<Mesh>(o)) {
        x = o.cast<Mesh>();
        return;
    }
    if (py::isinstance<HeightField>(o)) {
        x = o.cast<HeightField>();
        return;
    }
    refuse_type(where, "a Shape", o);
}
py::object write(const Shape& x) {
    return std::visit([](const auto& y) { return write(y); }, x);
}

} // namespace cairn::python
