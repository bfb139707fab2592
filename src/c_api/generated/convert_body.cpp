// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"

#include <string>

namespace cairn::c_api {

BodyType to_body_type(cairn_body_type value, const char* field) {
    if (value < 0 || value > 2)
        throw Error(ErrorCode::invalid_value, field, std::to_string(value),
            "must be 0 to 2 (static, kinematic, dynamic)");
    return BodyType(value);
}

CharacterSupport to_character_support(cairn_character_support value, const char* field) {
    if (value < 0 || value > 2)
        throw Error(ErrorCode::invalid_value, field, std::to_string(value), "must be 0 to 2 (none, steep, ground)");
    return CharacterSupport(value);
}

MassProperties to_cpp(const cairn_mass_properties& c) {
    MassProperties x;
    x.mass = c.mass;
    x.center_of_mass = to_cpp(c.center_of_mass);
    x.inertia_diagonal = to_cpp(c.inertia_diagonal);
    x.inertia_orientation = to_cpp(c.inertia_orientation);
    return x;
}
cairn_mass_properties to_c(const MassProperties& x) {
    cairn_mass_properties c{};
    c.mass = x.mass;
    c.center_of_mass = to_c(x.center_of_mass);
    c.inertia_diagonal = to_c(x.inertia_diagonal);
    c.inertia_orientation = to_c(x.inertia_orientation);
    return c;
}

BodyDef to_cpp(const cairn_body_def& c) {
    BodyDef x;
    x.type = to_body_type(c.type, "BodyDef.type");
    x.position = to_cpp(c.position);
    x.rotation = to_cpp(c.rotation);
    x.linear_velocity = to_cpp(c.linear_velocity);
    x.angular_velocity = to_cpp(c.angular_velocity);
    x.linear_damping = c.linear_damping;
    x.angular_damping = c.angular_damping;
    x.gravity_scale = c.gravity_scale;
    x.allow_sleep = c.allow_sleep;
    if (c.has_mass) x.mass = c.mass;
    if (c.has_mass_properties) x.mass_properties = to_cpp(c.mass_properties);
    x.name = text_of(c.name);
    x.user_data = c.user_data;
    x.enabled = c.enabled;
    return x;
}
cairn_body_def to_c(const BodyDef& x) {
    cairn_body_def c{};
    c.struct_size = sizeof c;
    c.type = cairn_body_type(x.type);
    c.position = to_c(x.position);
    c.rotation = to_c(x.rotation);
    c.linear_velocity = to_c(x.linear_velocity);
    c.angular_velocity = to_c(x.angular_velocity);
    c.linear_damping = x.linear_damping;
    c.angular_damping = x.angular_damping;
    c.gravity_scale = x.gravity_scale;
    c.allow_sleep = x.allow_sleep;
    c.has_mass = x.mass.has_value();
    if (x.mass) c.mass = *x.mass;
    c.has_mass_properties = x.mass_properties.has_value();
    if (x.mass_properties) c.mass_properties = to_c(*x.mass_properties);
    c.user_data = x.user_data;
    c.enabled = x.enabled;
    return c;
}

CharacterDef to_cpp(const cairn_character_def& c) {
    CharacterDef x;
    x.up = to_cpp(c.up);
    x.max_slope = c.max_slope;
    x.step_height = c.step_height;
    x.stick_distance = c.stick_distance;
    x.skin = c.skin;
    x.mass = c.mass;
    x.max_push_force = c.max_push_force;
    x.air_acceleration = c.air_acceleration;
    x.flies = c.flies;
    return x;
}
cairn_character_def to_c(const CharacterDef& x) {
    cairn_character_def c{};
    c.struct_size = sizeof c;
    c.up = to_c(x.up);
    c.max_slope = x.max_slope;
    c.step_height = x.step_height;
    c.stick_distance = x.stick_distance;
    c.skin = x.skin;
    c.mass = x.mass;
    c.max_push_force = x.max_push_force;
    c.air_acceleration = x.air_acceleration;
    c.flies = x.flies;
    return c;
}

cairn_character_state to_c(const CharacterState& x) {
    cairn_character_state c{};
    c.support = cairn_character_support(x.support);
    c.velocity = to_c(x.velocity);
    c.ground_shape = to_c(x.ground_shape);
    c.ground_body = to_c(x.ground_body);
    c.ground_point = to_c(x.ground_point);
    c.ground_normal = to_c(x.ground_normal);
    c.ground_velocity = to_c(x.ground_velocity);
    return c;
}

} // namespace cairn::c_api
