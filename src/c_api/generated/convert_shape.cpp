// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"

#include <string>

namespace cairn::c_api {

CombineRule to_combine_rule(cairn_combine_rule value, const char* field) {
    if (value < 0 || value > 3)
        throw Error(ErrorCode::invalid_value, field, std::to_string(value),
            "must be 0 to 3 (average, minimum, maximum, multiply)");
    return CombineRule(value);
}

Sphere to_cpp(const cairn_sphere& c) {
    Sphere x;
    x.radius = c.radius;
    return x;
}
cairn_sphere to_c(const Sphere& x) {
    cairn_sphere c{};
    c.radius = x.radius;
    return c;
}

Box to_cpp(const cairn_box& c) {
    Box x;
    x.half_extents = to_cpp(c.half_extents);
    x.rounding = c.rounding;
    return x;
}
cairn_box to_c(const Box& x) {
    cairn_box c{};
    c.half_extents = to_c(x.half_extents);
    c.rounding = x.rounding;
    return c;
}

Plane to_cpp(const cairn_plane& c) {
    Plane x;
    x.normal = to_cpp(c.normal);
    x.tangent = to_cpp(c.tangent);
    if (c.has_half_extents) x.half_extents = to_cpp(c.half_extents);
    x.double_sided = c.double_sided;
    return x;
}
cairn_plane to_c(const Plane& x) {
    cairn_plane c{};
    c.normal = to_c(x.normal);
    c.tangent = to_c(x.tangent);
    c.has_half_extents = x.half_extents.has_value();
    if (x.half_extents) c.half_extents = to_c(*x.half_extents);
    c.double_sided = x.double_sided;
    return c;
}

Capsule to_cpp(const cairn_capsule& c) {
    Capsule x;
    x.half_height = c.half_height;
    x.radius = c.radius;
    if (c.has_radius_top) x.radius_top = c.radius_top;
    return x;
}
cairn_capsule to_c(const Capsule& x) {
    cairn_capsule c{};
    c.half_height = x.half_height;
    c.radius = x.radius;
    c.has_radius_top = x.radius_top.has_value();
    if (x.radius_top) c.radius_top = *x.radius_top;
    return c;
}

Cylinder to_cpp(const cairn_cylinder& c) {
    Cylinder x;
    x.half_height = c.half_height;
    x.radius = c.radius;
    if (c.has_radius_top) x.radius_top = c.radius_top;
    x.rounding = c.rounding;
    return x;
}
cairn_cylinder to_c(const Cylinder& x) {
    cairn_cylinder c{};
    c.half_height = x.half_height;
    c.radius = x.radius;
    c.has_radius_top = x.radius_top.has_value();
    if (x.radius_top) c.radius_top = *x.radius_top;
    c.rounding = x.rounding;
    return c;
}

Material to_cpp(const cairn_material& c) {
    Material x;
    x.static_friction = c.static_friction;
    x.dynamic_friction = c.dynamic_friction;
    x.restitution = c.restitution;
    x.rolling_friction = c.rolling_friction;
    x.torsional_friction = c.torsional_friction;
    x.friction_combine = to_combine_rule(c.friction_combine, "Material.friction_combine");
    x.restitution_combine = to_combine_rule(c.restitution_combine, "Material.restitution_combine");
    return x;
}
cairn_material to_c(const Material& x) {
    cairn_material c{};
    c.static_friction = x.static_friction;
    c.dynamic_friction = x.dynamic_friction;
    c.restitution = x.restitution;
    c.rolling_friction = x.rolling_friction;
    c.torsional_friction = x.torsional_friction;
    c.friction_combine = cairn_combine_rule(x.friction_combine);
    c.restitution_combine = cairn_combine_rule(x.restitution_combine);
    return c;
}

CollisionFilter to_cpp(const cairn_collision_filter& c) {
    CollisionFilter x;
    x.layers = c.layers;
    x.collides_with = c.collides_with;
    return x;
}
cairn_collision_filter to_c(const CollisionFilter& x) {
    cairn_collision_filter c{};
    c.layers = x.layers;
    c.collides_with = x.collides_with;
    return c;
}

ShapeDef to_cpp(const cairn_shape_def& c) {
    ShapeDef x;
    x.position = to_cpp(c.position);
    x.rotation = to_cpp(c.rotation);
    x.density = c.density;
    x.material = to_cpp(c.material);
    x.filter = to_cpp(c.filter);
    x.is_trigger = c.is_trigger;
    x.surface_velocity = to_cpp(c.surface_velocity);
    x.user_data = c.user_data;
    x.one_way = to_cpp(c.one_way);
    return x;
}
cairn_shape_def to_c(const ShapeDef& x) {
    cairn_shape_def c{};
    c.struct_size = sizeof c;
    c.position = to_c(x.position);
    c.rotation = to_c(x.rotation);
    c.density = x.density;
    c.material = to_c(x.material);
    c.filter = to_c(x.filter);
    c.is_trigger = x.is_trigger;
    c.surface_velocity = to_c(x.surface_velocity);
    c.user_data = x.user_data;
    c.one_way = to_c(x.one_way);
    return c;
}

Shape to_cpp(const cairn_shape& c) {
    switch (c.kind) {
    case CAIRN_SHAPE_SPHERE: return to_cpp(c.as.sphere);
    case CAIRN_SHAPE_BOX: return to_cpp(c.as.box);
    case CAIRN_SHAPE_PLANE: return to_cpp(c.as.plane);
    case CAIRN_SHAPE_CAPSULE: return to_cpp(c.as.capsule);
    case CAIRN_SHAPE_CYLINDER: return to_cpp(c.as.cylinder);
    case CAIRN_SHAPE_HULL: return to_cpp(c.as.hull);
    case CAIRN_SHAPE_MESH: return to_cpp(c.as.mesh);
    case CAIRN_SHAPE_HEIGHT_FIELD: return to_cpp(c.as.height_field);
    default:
        throw Error(ErrorCode::invalid_value, "Shape.kind", std::to_string(c.kind), "must be 0 to 7");
    }
}
cairn_shape to_c(const Shape& x) {
    cairn_shape c{};
    c.kind = cairn_shape_kind(x.index());
    switch (c.kind) {
    case CAIRN_SHAPE_SPHERE: c.as.sphere = to_c(std::get<0>(x)); break;
    case CAIRN_SHAPE_BOX: c.as.box = to_c(std::get<1>(x)); break;
    case CAIRN_SHAPE_PLANE: c.as.plane = to_c(std::get<2>(x)); break;
    case CAIRN_SHAPE_CAPSULE: c.as.capsule = to_c(std::get<3>(x)); break;
    case CAIRN_SHAPE_CYLINDER: c.as.cylinder = to_c(std::get<4>(x)); break;
    case CAIRN_SHAPE_HULL: c.as.hull = to_c(std::get<5>(x)); break;
    case CAIRN_SHAPE_MESH: c.as.mesh = to_c(std::get<6>(x)); break;
    case CAIRN_SHAPE_HEIGHT_FIELD: c.as.height_field = to_c(std::get<7>(x)); break;
    }
    return c;
}

} // namespace cairn::c_api
