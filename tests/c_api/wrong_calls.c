// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "wrong_calls.h"

#include <math.h>
#include <stddef.h>

static cairn_result world_add_shape(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    cairn_shape shape_value = cairn_default_shape(1);
    const cairn_shape* shape = &shape_value;
    if (wrong == 2) { shape = NULL; }
    if (wrong == 3) { shape_value.kind = -1; }
    if (wrong == 4) { shape_value.kind = 8; }
    if (wrong == 5) { shape_value = cairn_default_shape(CAIRN_SHAPE_SPHERE); shape_value.as.sphere.radius = NAN; }
    if (wrong == 6) { shape_value = cairn_default_shape(CAIRN_SHAPE_BOX); shape_value.as.box.half_extents.y = NAN; }
    if (wrong == 7) { shape_value = cairn_default_shape(CAIRN_SHAPE_BOX); shape_value.as.box.rounding = NAN; }
    if (wrong == 8) { shape_value = cairn_default_shape(CAIRN_SHAPE_PLANE); shape_value.as.plane.normal.y = NAN; }
    if (wrong == 9) { shape_value = cairn_default_shape(CAIRN_SHAPE_PLANE); shape_value.as.plane.has_half_extents = true; shape_value.as.plane.half_extents.x = NAN; }
    if (wrong == 10) { shape_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); shape_value.as.capsule.half_height = NAN; }
    if (wrong == 11) { shape_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); shape_value.as.capsule.radius = NAN; }
    if (wrong == 12) { shape_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); shape_value.as.capsule.has_radius_top = true; shape_value.as.capsule.radius_top = NAN; }
    if (wrong == 13) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.half_height = NAN; }
    if (wrong == 14) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.radius = NAN; }
    if (wrong == 15) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.has_radius_top = true; shape_value.as.cylinder.radius_top = NAN; }
    if (wrong == 16) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.rounding = NAN; }
    if (wrong == 17) { shape_value = cairn_default_shape(CAIRN_SHAPE_HULL); shape_value.as.hull.geometry = NULL; }
    if (wrong == 18) { shape_value = cairn_default_shape(CAIRN_SHAPE_HULL); shape_value.as.hull.rounding = NAN; }
    if (wrong == 19) { shape_value = cairn_default_shape(CAIRN_SHAPE_MESH); shape_value.as.mesh.geometry = NULL; }
    if (wrong == 20) { shape_value = cairn_default_shape(CAIRN_SHAPE_HEIGHT_FIELD); shape_value.as.height_field.geometry = NULL; }
    cairn_shape_def def_value = cairn_default_shape_def();
    const cairn_shape_def* def = &def_value;
    if (wrong == 21) { def_value.struct_size = 0; }
    if (wrong == 22) { def_value.struct_size = sizeof(cairn_shape_def) + 8; }
    if (wrong == 23) { def_value.position.y = NAN; }
    if (wrong == 24) { def_value.rotation.w = NAN; }
    if (wrong == 25) { def_value.density = NAN; }
    if (wrong == 26) { def_value.material.static_friction = NAN; }
    if (wrong == 27) { def_value.material.dynamic_friction = NAN; }
    if (wrong == 28) { def_value.material.restitution = NAN; }
    if (wrong == 29) { def_value.material.rolling_friction = NAN; }
    if (wrong == 30) { def_value.material.torsional_friction = NAN; }
    if (wrong == 31) { def_value.material.friction_combine = -1; }
    if (wrong == 32) { def_value.material.friction_combine = 4; }
    if (wrong == 33) { def_value.material.restitution_combine = -1; }
    if (wrong == 34) { def_value.material.restitution_combine = 4; }
    if (wrong == 35) { def_value.surface_velocity.y = NAN; }
    if (wrong == 36) { def_value.one_way.y = NAN; }
    cairn_shape_id result_room[4];
    cairn_shape_id* result = result_room;
    if (wrong == 37) { result = NULL; }
    return cairn_world_add_shape(world, body, shape, def, result);
}

static cairn_result world_remove_shape(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    return cairn_world_remove_shape(world, shape);
}

static cairn_result world_set_shape(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_shape geometry_value = cairn_default_shape(1);
    const cairn_shape* geometry = &geometry_value;
    if (wrong == 2) { geometry = NULL; }
    if (wrong == 3) { geometry_value.kind = -1; }
    if (wrong == 4) { geometry_value.kind = 8; }
    if (wrong == 5) { geometry_value = cairn_default_shape(CAIRN_SHAPE_SPHERE); geometry_value.as.sphere.radius = NAN; }
    if (wrong == 6) { geometry_value = cairn_default_shape(CAIRN_SHAPE_BOX); geometry_value.as.box.half_extents.y = NAN; }
    if (wrong == 7) { geometry_value = cairn_default_shape(CAIRN_SHAPE_BOX); geometry_value.as.box.rounding = NAN; }
    if (wrong == 8) { geometry_value = cairn_default_shape(CAIRN_SHAPE_PLANE); geometry_value.as.plane.normal.y = NAN; }
    if (wrong == 9) { geometry_value = cairn_default_shape(CAIRN_SHAPE_PLANE); geometry_value.as.plane.has_half_extents = true; geometry_value.as.plane.half_extents.x = NAN; }
    if (wrong == 10) { geometry_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); geometry_value.as.capsule.half_height = NAN; }
    if (wrong == 11) { geometry_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); geometry_value.as.capsule.radius = NAN; }
    if (wrong == 12) { geometry_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); geometry_value.as.capsule.has_radius_top = true; geometry_value.as.capsule.radius_top = NAN; }
    if (wrong == 13) { geometry_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); geometry_value.as.cylinder.half_height = NAN; }
    if (wrong == 14) { geometry_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); geometry_value.as.cylinder.radius = NAN; }
    if (wrong == 15) { geometry_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); geometry_value.as.cylinder.has_radius_top = true; geometry_value.as.cylinder.radius_top = NAN; }
    if (wrong == 16) { geometry_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); geometry_value.as.cylinder.rounding = NAN; }
    if (wrong == 17) { geometry_value = cairn_default_shape(CAIRN_SHAPE_HULL); geometry_value.as.hull.geometry = NULL; }
    if (wrong == 18) { geometry_value = cairn_default_shape(CAIRN_SHAPE_HULL); geometry_value.as.hull.rounding = NAN; }
    if (wrong == 19) { geometry_value = cairn_default_shape(CAIRN_SHAPE_MESH); geometry_value.as.mesh.geometry = NULL; }
    if (wrong == 20) { geometry_value = cairn_default_shape(CAIRN_SHAPE_HEIGHT_FIELD); geometry_value.as.height_field.geometry = NULL; }
    return cairn_world_set_shape(world, shape, geometry);
}

static cairn_result world_set_shape_def(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_shape_def def_value = cairn_default_shape_def();
    const cairn_shape_def* def = &def_value;
    if (wrong == 2) { def = NULL; }
    if (wrong == 3) { def_value.struct_size = 0; }
    if (wrong == 4) { def_value.struct_size = sizeof(cairn_shape_def) + 8; }
    if (wrong == 5) { def_value.position.y = NAN; }
    if (wrong == 6) { def_value.rotation.w = NAN; }
    if (wrong == 7) { def_value.density = NAN; }
    if (wrong == 8) { def_value.material.static_friction = NAN; }
    if (wrong == 9) { def_value.material.dynamic_friction = NAN; }
    if (wrong == 10) { def_value.material.restitution = NAN; }
    if (wrong == 11) { def_value.material.rolling_friction = NAN; }
    if (wrong == 12) { def_value.material.torsional_friction = NAN; }
    if (wrong == 13) { def_value.material.friction_combine = -1; }
    if (wrong == 14) { def_value.material.friction_combine = 4; }
    if (wrong == 15) { def_value.material.restitution_combine = -1; }
    if (wrong == 16) { def_value.material.restitution_combine = 4; }
    if (wrong == 17) { def_value.surface_velocity.y = NAN; }
    if (wrong == 18) { def_value.one_way.y = NAN; }
    return cairn_world_set_shape_def(world, shape, def);
}

static cairn_result shape_get_body(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_body_id result_room[4];
    cairn_body_id* result = result_room;
    if (wrong == 2) { result = NULL; }
    return cairn_shape_get_body(world, shape, result);
}

static cairn_result world_get_shape(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_shape result_room[4];
    cairn_shape* result = result_room;
    if (wrong == 2) { result = NULL; }
    return cairn_world_get_shape(world, shape, result);
}

static cairn_result world_get_shape_def(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_shape_def shape_def_room[4] = {cairn_default_shape_def()};
    cairn_shape_def* shape_def = shape_def_room;
    if (wrong == 2) { shape_def = NULL; }
    if (wrong == 3) { shape_def_room[0].struct_size = 1; }
    return cairn_world_get_shape_def(world, shape, shape_def);
}

static cairn_result world_get_shape_transform(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_transform shape_transform_room[4];
    cairn_transform* shape_transform = shape_transform_room;
    if (wrong == 2) { shape_transform = NULL; }
    return cairn_world_get_shape_transform(world, shape, shape_transform);
}

static cairn_result world_get_shape_bounds(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_bounds shape_bounds_room[4];
    cairn_bounds* shape_bounds = shape_bounds_room;
    if (wrong == 2) { shape_bounds = NULL; }
    return cairn_world_get_shape_bounds(world, shape, shape_bounds);
}

static cairn_result world_set_material(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_material material_value = cairn_default_material();
    const cairn_material* material = &material_value;
    if (wrong == 2) { material = NULL; }
    if (wrong == 3) { material_value.static_friction = NAN; }
    if (wrong == 4) { material_value.dynamic_friction = NAN; }
    if (wrong == 5) { material_value.restitution = NAN; }
    if (wrong == 6) { material_value.rolling_friction = NAN; }
    if (wrong == 7) { material_value.torsional_friction = NAN; }
    if (wrong == 8) { material_value.friction_combine = -1; }
    if (wrong == 9) { material_value.friction_combine = 4; }
    if (wrong == 10) { material_value.restitution_combine = -1; }
    if (wrong == 11) { material_value.restitution_combine = 4; }
    return cairn_world_set_material(world, shape, material);
}

static cairn_result world_set_filter(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_collision_filter filter_value = cairn_default_collision_filter();
    const cairn_collision_filter* filter = &filter_value;
    if (wrong == 2) { filter = NULL; }
    return cairn_world_set_filter(world, shape, filter);
}

static cairn_result world_set_surface_velocity(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape_id shape = c->shape;
    if (wrong == 1) { shape = c->stale_shape; }
    cairn_vec3 velocity = c->vec3;
    if (wrong == 2) { velocity.y = NAN; }
    return cairn_world_set_surface_velocity(world, shape, velocity);
}

static cairn_result world_create_body(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_def def_value = cairn_default_body_def();
    const cairn_body_def* def = &def_value;
    if (wrong == 1) { def_value.struct_size = 0; }
    if (wrong == 2) { def_value.struct_size = sizeof(cairn_body_def) + 8; }
    if (wrong == 3) { def_value.type = -1; }
    if (wrong == 4) { def_value.type = 3; }
    if (wrong == 5) { def_value.position.z = NAN; }
    if (wrong == 6) { def_value.rotation.w = NAN; }
    if (wrong == 7) { def_value.linear_velocity.y = NAN; }
    if (wrong == 8) { def_value.angular_velocity.y = NAN; }
    if (wrong == 9) { def_value.linear_damping = NAN; }
    if (wrong == 10) { def_value.angular_damping = NAN; }
    if (wrong == 11) { def_value.gravity_scale = NAN; }
    if (wrong == 12) { def_value.has_mass = true; def_value.mass = NAN; }
    if (wrong == 13) { def_value.has_mass_properties = true; def_value.mass_properties.mass = NAN; }
    if (wrong == 14) { def_value.has_mass_properties = true; def_value.mass_properties.center_of_mass.y = NAN; }
    if (wrong == 15) { def_value.has_mass_properties = true; def_value.mass_properties.inertia_diagonal.y = NAN; }
    if (wrong == 16) { def_value.has_mass_properties = true; def_value.mass_properties.inertia_orientation.w = NAN; }
    cairn_body_id result_room[4];
    cairn_body_id* result = result_room;
    if (wrong == 17) { result = NULL; }
    return cairn_world_create_body(world, def, result);
}

static cairn_result world_destroy_body(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    return cairn_world_destroy_body(world, body);
}

static cairn_result world_get_bodies(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id bodies_room[4];
    cairn_body_id* bodies = bodies_room;
    if (wrong == 1) { bodies = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_bodies(world, bodies, capacity, count);
}

static cairn_result world_find_body(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    const char* name = "name";
    if (wrong == 1) { name = NULL; }
    cairn_body_id result_room[4];
    cairn_body_id* result = result_room;
    if (wrong == 2) { result = NULL; }
    bool found_room[4];
    bool* found = found_room;
    if (wrong == 3) { found = NULL; }
    return cairn_world_find_body(world, name, result, found);
}

static cairn_result body_get_type(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_body_type type_room[4];
    cairn_body_type* type = type_room;
    if (wrong == 3) { type = NULL; }
    return cairn_body_get_type(world, body, type);
}

static cairn_result body_get_name(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    char text_room[4];
    char* text = text_room;
    if (wrong == 3) { text = NULL; }
    size_t capacity = 4;
    size_t length_room[4];
    size_t* length = length_room;
    if (wrong == 4) { length = NULL; }
    return cairn_body_get_name(world, body, text, capacity, length);
}

static cairn_result body_get_user_data(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    uint64_t user_data_room[4];
    uint64_t* user_data = user_data_room;
    if (wrong == 3) { user_data = NULL; }
    return cairn_body_get_user_data(world, body, user_data);
}

static cairn_result body_get_position(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_position position_room[4];
    cairn_position* position = position_room;
    if (wrong == 3) { position = NULL; }
    return cairn_body_get_position(world, body, position);
}

static cairn_result body_get_rotation(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_quat rotation_room[4];
    cairn_quat* rotation = rotation_room;
    if (wrong == 3) { rotation = NULL; }
    return cairn_body_get_rotation(world, body, rotation);
}

static cairn_result body_get_transform(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_transform transform_room[4];
    cairn_transform* transform = transform_room;
    if (wrong == 3) { transform = NULL; }
    return cairn_body_get_transform(world, body, transform);
}

static cairn_result body_get_center_of_mass(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_position center_of_mass_room[4];
    cairn_position* center_of_mass = center_of_mass_room;
    if (wrong == 3) { center_of_mass = NULL; }
    return cairn_body_get_center_of_mass(world, body, center_of_mass);
}

static cairn_result body_get_linear_velocity(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 linear_velocity_room[4];
    cairn_vec3* linear_velocity = linear_velocity_room;
    if (wrong == 3) { linear_velocity = NULL; }
    return cairn_body_get_linear_velocity(world, body, linear_velocity);
}

static cairn_result body_get_angular_velocity(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 angular_velocity_room[4];
    cairn_vec3* angular_velocity = angular_velocity_room;
    if (wrong == 3) { angular_velocity = NULL; }
    return cairn_body_get_angular_velocity(world, body, angular_velocity);
}

static cairn_result body_get_velocity_at(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_position point = c->position;
    if (wrong == 3) { point.z = NAN; }
    cairn_vec3 velocity_at_room[4];
    cairn_vec3* velocity_at = velocity_at_room;
    if (wrong == 4) { velocity_at = NULL; }
    return cairn_body_get_velocity_at(world, body, point, velocity_at);
}

static cairn_result body_get_mass(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    float mass_room[4];
    float* mass = mass_room;
    if (wrong == 3) { mass = NULL; }
    return cairn_body_get_mass(world, body, mass);
}

static cairn_result body_get_mass_properties(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_mass_properties mass_properties_room[4];
    cairn_mass_properties* mass_properties = mass_properties_room;
    if (wrong == 3) { mass_properties = NULL; }
    return cairn_body_get_mass_properties(world, body, mass_properties);
}

static cairn_result body_get_world_inertia(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_mat3 world_inertia_room[4];
    cairn_mat3* world_inertia = world_inertia_room;
    if (wrong == 3) { world_inertia = NULL; }
    return cairn_body_get_world_inertia(world, body, world_inertia);
}

static cairn_result body_get_angular_momentum(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 angular_momentum_room[4];
    cairn_vec3* angular_momentum = angular_momentum_room;
    if (wrong == 3) { angular_momentum = NULL; }
    return cairn_body_get_angular_momentum(world, body, angular_momentum);
}

static cairn_result body_get_kinetic_energy(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    double kinetic_energy_room[4];
    double* kinetic_energy = kinetic_energy_room;
    if (wrong == 3) { kinetic_energy = NULL; }
    return cairn_body_get_kinetic_energy(world, body, kinetic_energy);
}

static cairn_result body_get_gravity_scale(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    float gravity_scale_room[4];
    float* gravity_scale = gravity_scale_room;
    if (wrong == 3) { gravity_scale = NULL; }
    return cairn_body_get_gravity_scale(world, body, gravity_scale);
}

static cairn_result body_get_linear_damping(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    float linear_damping_room[4];
    float* linear_damping = linear_damping_room;
    if (wrong == 3) { linear_damping = NULL; }
    return cairn_body_get_linear_damping(world, body, linear_damping);
}

static cairn_result body_get_angular_damping(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    float angular_damping_room[4];
    float* angular_damping = angular_damping_room;
    if (wrong == 3) { angular_damping = NULL; }
    return cairn_body_get_angular_damping(world, body, angular_damping);
}

static cairn_result body_is_awake(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    bool result_room[4];
    bool* result = result_room;
    if (wrong == 3) { result = NULL; }
    return cairn_body_is_awake(world, body, result);
}

static cairn_result body_get_allow_sleep(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    bool allow_sleep_room[4];
    bool* allow_sleep = allow_sleep_room;
    if (wrong == 3) { allow_sleep = NULL; }
    return cairn_body_get_allow_sleep(world, body, allow_sleep);
}

static cairn_result body_get_enabled(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    bool enabled_room[4];
    bool* enabled = enabled_room;
    if (wrong == 3) { enabled = NULL; }
    return cairn_body_get_enabled(world, body, enabled);
}

static cairn_result body_get_shapes(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_shape_id shapes_room[4];
    cairn_shape_id* shapes = shapes_room;
    if (wrong == 3) { shapes = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 4) { count = NULL; }
    return cairn_body_get_shapes(world, body, shapes, capacity, count);
}

static cairn_result body_set_transform(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_position position = c->position;
    if (wrong == 3) { position.z = NAN; }
    cairn_quat rotation = c->quat;
    if (wrong == 4) { rotation.w = NAN; }
    return cairn_body_set_transform(world, body, position, rotation);
}

static cairn_result body_set_position(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_position position = c->position;
    if (wrong == 3) { position.z = NAN; }
    return cairn_body_set_position(world, body, position);
}

static cairn_result body_set_rotation(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_quat rotation = c->quat;
    if (wrong == 3) { rotation.w = NAN; }
    return cairn_body_set_rotation(world, body, rotation);
}

static cairn_result body_set_linear_velocity(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 velocity = c->vec3;
    if (wrong == 3) { velocity.y = NAN; }
    return cairn_body_set_linear_velocity(world, body, velocity);
}

static cairn_result body_set_angular_velocity(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 velocity = c->vec3;
    if (wrong == 3) { velocity.y = NAN; }
    return cairn_body_set_angular_velocity(world, body, velocity);
}

static cairn_result body_move_to(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_transform target = c->transform;
    if (wrong == 3) { target.position.z = NAN; }
    if (wrong == 4) { target.rotation.w = NAN; }
    float seconds = 1.0f;
    if (wrong == 5) { seconds = NAN; }
    return cairn_body_move_to(world, body, target, seconds);
}

static cairn_result body_set_gravity_scale(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    float scale = 1.0f;
    if (wrong == 3) { scale = NAN; }
    return cairn_body_set_gravity_scale(world, body, scale);
}

static cairn_result body_set_damping(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    float linear = 1.0f;
    if (wrong == 3) { linear = NAN; }
    float angular = 1.0f;
    if (wrong == 4) { angular = NAN; }
    return cairn_body_set_damping(world, body, linear, angular);
}

static cairn_result body_set_allow_sleep(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    bool allow = true;
    return cairn_body_set_allow_sleep(world, body, allow);
}

static cairn_result body_set_type(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_body_type type = 1;
    if (wrong == 3) { type = -1; }
    if (wrong == 4) { type = 3; }
    return cairn_body_set_type(world, body, type);
}

static cairn_result body_set_enabled(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    bool enabled = true;
    return cairn_body_set_enabled(world, body, enabled);
}

static cairn_result body_set_name(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    const char* name = "name";
    if (wrong == 3) { name = NULL; }
    return cairn_body_set_name(world, body, name);
}

static cairn_result body_set_mass_properties(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_mass_properties properties_value = cairn_default_mass_properties();
    const cairn_mass_properties* properties = &properties_value;
    if (wrong == 3) { properties = NULL; }
    if (wrong == 4) { properties_value.mass = NAN; }
    if (wrong == 5) { properties_value.center_of_mass.y = NAN; }
    if (wrong == 6) { properties_value.inertia_diagonal.y = NAN; }
    if (wrong == 7) { properties_value.inertia_orientation.w = NAN; }
    return cairn_body_set_mass_properties(world, body, properties);
}

static cairn_result body_set_mass_from_shapes(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    float mass_value = 1.0f;
    const float* mass = &mass_value;
    if (wrong == 3) { mass_value = NAN; }
    return cairn_body_set_mass_from_shapes(world, body, mass);
}

static cairn_result body_wake(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    return cairn_body_wake(world, body);
}

static cairn_result body_sleep(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    return cairn_body_sleep(world, body);
}

static cairn_result body_add_force(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 force = c->vec3;
    if (wrong == 3) { force.y = NAN; }
    return cairn_body_add_force(world, body, force);
}

static cairn_result body_add_force_at(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 force = c->vec3;
    if (wrong == 3) { force.y = NAN; }
    cairn_position point = c->position;
    if (wrong == 4) { point.z = NAN; }
    return cairn_body_add_force_at(world, body, force, point);
}

static cairn_result body_add_torque(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 torque = c->vec3;
    if (wrong == 3) { torque.y = NAN; }
    return cairn_body_add_torque(world, body, torque);
}

static cairn_result body_apply_impulse(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 impulse = c->vec3;
    if (wrong == 3) { impulse.y = NAN; }
    return cairn_body_apply_impulse(world, body, impulse);
}

static cairn_result body_apply_impulse_at(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 impulse = c->vec3;
    if (wrong == 3) { impulse.y = NAN; }
    cairn_position point = c->position;
    if (wrong == 4) { point.z = NAN; }
    return cairn_body_apply_impulse_at(world, body, impulse, point);
}

static cairn_result body_apply_angular_impulse(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 impulse = c->vec3;
    if (wrong == 3) { impulse.y = NAN; }
    return cairn_body_apply_angular_impulse(world, body, impulse);
}

static cairn_result body_is_character(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    bool result_room[4];
    bool* result = result_room;
    if (wrong == 3) { result = NULL; }
    return cairn_body_is_character(world, body, result);
}

static cairn_result body_get_character(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_character_def character_room[4] = {cairn_default_character_def()};
    cairn_character_def* character = character_room;
    if (wrong == 3) { character = NULL; }
    if (wrong == 4) { character_room[0].struct_size = 1; }
    return cairn_body_get_character(world, body, character);
}

static cairn_result body_set_character(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_character_def def_value = cairn_default_character_def();
    const cairn_character_def* def = &def_value;
    if (wrong == 3) { def = NULL; }
    if (wrong == 4) { def_value.struct_size = 0; }
    if (wrong == 5) { def_value.struct_size = sizeof(cairn_character_def) + 8; }
    if (wrong == 6) { def_value.up.y = NAN; }
    if (wrong == 7) { def_value.max_slope = NAN; }
    if (wrong == 8) { def_value.step_height = NAN; }
    if (wrong == 9) { def_value.stick_distance = NAN; }
    if (wrong == 10) { def_value.skin = NAN; }
    if (wrong == 11) { def_value.mass = NAN; }
    if (wrong == 12) { def_value.max_push_force = NAN; }
    if (wrong == 13) { def_value.air_acceleration = NAN; }
    return cairn_body_set_character(world, body, def);
}

static cairn_result body_remove_character(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    return cairn_body_remove_character(world, body);
}

static cairn_result body_get_walk_velocity(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 walk_velocity_room[4];
    cairn_vec3* walk_velocity = walk_velocity_room;
    if (wrong == 3) { walk_velocity = NULL; }
    return cairn_body_get_walk_velocity(world, body, walk_velocity);
}

static cairn_result body_set_walk_velocity(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_vec3 velocity = c->vec3;
    if (wrong == 3) { velocity.y = NAN; }
    return cairn_body_set_walk_velocity(world, body, velocity);
}

static cairn_result body_jump(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    float speed = 1.0f;
    if (wrong == 3) { speed = NAN; }
    return cairn_body_jump(world, body, speed);
}

static cairn_result body_character_state(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    if (wrong == 2) { body.bits = 0; }
    cairn_character_state result_room[4];
    cairn_character_state* result = result_room;
    if (wrong == 3) { result = NULL; }
    return cairn_body_character_state(world, body, result);
}

static cairn_result world_create_joint(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_def def_value = c->joint_def;
    const cairn_joint_def* def = &def_value;
    if (wrong == 1) { def = NULL; }
    if (wrong == 2) { def_value.struct_size = 0; }
    if (wrong == 3) { def_value.struct_size = sizeof(cairn_joint_def) + 8; }
    if (wrong == 4) { def_value.body_a = c->stale_body; }
    if (wrong == 5) { def_value.body_b = c->stale_body; }
    if (wrong == 6) { def_value.frame_a.position.z = NAN; }
    if (wrong == 7) { def_value.frame_a.rotation.w = NAN; }
    if (wrong == 8) { def_value.frame_b.position.z = NAN; }
    if (wrong == 9) { def_value.frame_b.rotation.w = NAN; }
    if (wrong == 10) { def_value.joint.kind = -1; }
    if (wrong == 11) { def_value.joint.kind = 13; }
    if (wrong == 12) { def_value.joint = cairn_default_joint(CAIRN_JOINT_BALL); def_value.joint.as.ball.has_cone_angle = true; def_value.joint.as.ball.cone_angle = NAN; }
    if (wrong == 13) { def_value.joint = cairn_default_joint(CAIRN_JOINT_BALL); def_value.joint.as.ball.has_twist = true; def_value.joint.as.ball.twist.lower = NAN; }
    if (wrong == 14) { def_value.joint = cairn_default_joint(CAIRN_JOINT_BALL); def_value.joint.as.ball.has_twist = true; def_value.joint.as.ball.twist.upper = NAN; }
    if (wrong == 15) { def_value.joint = cairn_default_joint(CAIRN_JOINT_BALL); def_value.joint.as.ball.has_twist = true; def_value.joint.as.ball.twist.has_spring = true; def_value.joint.as.ball.twist.spring.stiffness = NAN; }
    if (wrong == 16) { def_value.joint = cairn_default_joint(CAIRN_JOINT_BALL); def_value.joint.as.ball.has_twist = true; def_value.joint.as.ball.twist.has_spring = true; def_value.joint.as.ball.twist.spring.damping = NAN; }
    if (wrong == 17) { def_value.joint = cairn_default_joint(CAIRN_JOINT_BALL); def_value.joint.as.ball.friction = NAN; }
    if (wrong == 18) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.has_limits = true; def_value.joint.as.hinge.angle.limits.lower = NAN; }
    if (wrong == 19) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.has_limits = true; def_value.joint.as.hinge.angle.limits.upper = NAN; }
    if (wrong == 20) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.has_limits = true; def_value.joint.as.hinge.angle.limits.has_spring = true; def_value.joint.as.hinge.angle.limits.spring.stiffness = NAN; }
    if (wrong == 21) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.has_limits = true; def_value.joint.as.hinge.angle.limits.has_spring = true; def_value.joint.as.hinge.angle.limits.spring.damping = NAN; }
    if (wrong == 22) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.has_motor = true; def_value.joint.as.hinge.angle.motor.velocity = NAN; }
    if (wrong == 23) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.has_motor = true; def_value.joint.as.hinge.angle.motor.position = NAN; }
    if (wrong == 24) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.has_motor = true; def_value.joint.as.hinge.angle.motor.has_spring = true; def_value.joint.as.hinge.angle.motor.spring.stiffness = NAN; }
    if (wrong == 25) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.has_motor = true; def_value.joint.as.hinge.angle.motor.has_spring = true; def_value.joint.as.hinge.angle.motor.spring.damping = NAN; }
    if (wrong == 26) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.has_motor = true; def_value.joint.as.hinge.angle.motor.max_force = NAN; }
    if (wrong == 27) { def_value.joint = cairn_default_joint(CAIRN_JOINT_HINGE); def_value.joint.as.hinge.angle.friction = NAN; }
    if (wrong == 28) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.has_limits = true; def_value.joint.as.slider.translation.limits.lower = NAN; }
    if (wrong == 29) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.has_limits = true; def_value.joint.as.slider.translation.limits.upper = NAN; }
    if (wrong == 30) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.has_limits = true; def_value.joint.as.slider.translation.limits.has_spring = true; def_value.joint.as.slider.translation.limits.spring.stiffness = NAN; }
    if (wrong == 31) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.has_limits = true; def_value.joint.as.slider.translation.limits.has_spring = true; def_value.joint.as.slider.translation.limits.spring.damping = NAN; }
    if (wrong == 32) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.has_motor = true; def_value.joint.as.slider.translation.motor.velocity = NAN; }
    if (wrong == 33) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.has_motor = true; def_value.joint.as.slider.translation.motor.position = NAN; }
    if (wrong == 34) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.has_motor = true; def_value.joint.as.slider.translation.motor.has_spring = true; def_value.joint.as.slider.translation.motor.spring.stiffness = NAN; }
    if (wrong == 35) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.has_motor = true; def_value.joint.as.slider.translation.motor.has_spring = true; def_value.joint.as.slider.translation.motor.spring.damping = NAN; }
    if (wrong == 36) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.has_motor = true; def_value.joint.as.slider.translation.motor.max_force = NAN; }
    if (wrong == 37) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SLIDER); def_value.joint.as.slider.translation.friction = NAN; }
    if (wrong == 38) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.has_limits = true; def_value.joint.as.cylindrical.translation.limits.lower = NAN; }
    if (wrong == 39) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.has_limits = true; def_value.joint.as.cylindrical.translation.limits.upper = NAN; }
    if (wrong == 40) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.has_limits = true; def_value.joint.as.cylindrical.translation.limits.has_spring = true; def_value.joint.as.cylindrical.translation.limits.spring.stiffness = NAN; }
    if (wrong == 41) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.has_limits = true; def_value.joint.as.cylindrical.translation.limits.has_spring = true; def_value.joint.as.cylindrical.translation.limits.spring.damping = NAN; }
    if (wrong == 42) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.has_motor = true; def_value.joint.as.cylindrical.translation.motor.velocity = NAN; }
    if (wrong == 43) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.has_motor = true; def_value.joint.as.cylindrical.translation.motor.position = NAN; }
    if (wrong == 44) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.has_motor = true; def_value.joint.as.cylindrical.translation.motor.has_spring = true; def_value.joint.as.cylindrical.translation.motor.spring.stiffness = NAN; }
    if (wrong == 45) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.has_motor = true; def_value.joint.as.cylindrical.translation.motor.has_spring = true; def_value.joint.as.cylindrical.translation.motor.spring.damping = NAN; }
    if (wrong == 46) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.has_motor = true; def_value.joint.as.cylindrical.translation.motor.max_force = NAN; }
    if (wrong == 47) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.translation.friction = NAN; }
    if (wrong == 48) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.has_limits = true; def_value.joint.as.cylindrical.angle.limits.lower = NAN; }
    if (wrong == 49) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.has_limits = true; def_value.joint.as.cylindrical.angle.limits.upper = NAN; }
    if (wrong == 50) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.has_limits = true; def_value.joint.as.cylindrical.angle.limits.has_spring = true; def_value.joint.as.cylindrical.angle.limits.spring.stiffness = NAN; }
    if (wrong == 51) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.has_limits = true; def_value.joint.as.cylindrical.angle.limits.has_spring = true; def_value.joint.as.cylindrical.angle.limits.spring.damping = NAN; }
    if (wrong == 52) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.has_motor = true; def_value.joint.as.cylindrical.angle.motor.velocity = NAN; }
    if (wrong == 53) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.has_motor = true; def_value.joint.as.cylindrical.angle.motor.position = NAN; }
    if (wrong == 54) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.has_motor = true; def_value.joint.as.cylindrical.angle.motor.has_spring = true; def_value.joint.as.cylindrical.angle.motor.spring.stiffness = NAN; }
    if (wrong == 55) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.has_motor = true; def_value.joint.as.cylindrical.angle.motor.has_spring = true; def_value.joint.as.cylindrical.angle.motor.spring.damping = NAN; }
    if (wrong == 56) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.has_motor = true; def_value.joint.as.cylindrical.angle.motor.max_force = NAN; }
    if (wrong == 57) { def_value.joint = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); def_value.joint.as.cylindrical.angle.friction = NAN; }
    if (wrong == 58) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.has_limits = true; def_value.joint.as.universal.first.limits.lower = NAN; }
    if (wrong == 59) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.has_limits = true; def_value.joint.as.universal.first.limits.upper = NAN; }
    if (wrong == 60) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.has_limits = true; def_value.joint.as.universal.first.limits.has_spring = true; def_value.joint.as.universal.first.limits.spring.stiffness = NAN; }
    if (wrong == 61) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.has_limits = true; def_value.joint.as.universal.first.limits.has_spring = true; def_value.joint.as.universal.first.limits.spring.damping = NAN; }
    if (wrong == 62) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.has_motor = true; def_value.joint.as.universal.first.motor.velocity = NAN; }
    if (wrong == 63) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.has_motor = true; def_value.joint.as.universal.first.motor.position = NAN; }
    if (wrong == 64) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.has_motor = true; def_value.joint.as.universal.first.motor.has_spring = true; def_value.joint.as.universal.first.motor.spring.stiffness = NAN; }
    if (wrong == 65) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.has_motor = true; def_value.joint.as.universal.first.motor.has_spring = true; def_value.joint.as.universal.first.motor.spring.damping = NAN; }
    if (wrong == 66) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.has_motor = true; def_value.joint.as.universal.first.motor.max_force = NAN; }
    if (wrong == 67) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.first.friction = NAN; }
    if (wrong == 68) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.has_limits = true; def_value.joint.as.universal.second.limits.lower = NAN; }
    if (wrong == 69) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.has_limits = true; def_value.joint.as.universal.second.limits.upper = NAN; }
    if (wrong == 70) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.has_limits = true; def_value.joint.as.universal.second.limits.has_spring = true; def_value.joint.as.universal.second.limits.spring.stiffness = NAN; }
    if (wrong == 71) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.has_limits = true; def_value.joint.as.universal.second.limits.has_spring = true; def_value.joint.as.universal.second.limits.spring.damping = NAN; }
    if (wrong == 72) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.has_motor = true; def_value.joint.as.universal.second.motor.velocity = NAN; }
    if (wrong == 73) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.has_motor = true; def_value.joint.as.universal.second.motor.position = NAN; }
    if (wrong == 74) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.has_motor = true; def_value.joint.as.universal.second.motor.has_spring = true; def_value.joint.as.universal.second.motor.spring.stiffness = NAN; }
    if (wrong == 75) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.has_motor = true; def_value.joint.as.universal.second.motor.has_spring = true; def_value.joint.as.universal.second.motor.spring.damping = NAN; }
    if (wrong == 76) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.has_motor = true; def_value.joint.as.universal.second.motor.max_force = NAN; }
    if (wrong == 77) { def_value.joint = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); def_value.joint.as.universal.second.friction = NAN; }
    if (wrong == 78) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.has_limits = true; def_value.joint.as.distance.distance.limits.lower = NAN; }
    if (wrong == 79) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.has_limits = true; def_value.joint.as.distance.distance.limits.upper = NAN; }
    if (wrong == 80) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.has_limits = true; def_value.joint.as.distance.distance.limits.has_spring = true; def_value.joint.as.distance.distance.limits.spring.stiffness = NAN; }
    if (wrong == 81) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.has_limits = true; def_value.joint.as.distance.distance.limits.has_spring = true; def_value.joint.as.distance.distance.limits.spring.damping = NAN; }
    if (wrong == 82) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.has_motor = true; def_value.joint.as.distance.distance.motor.velocity = NAN; }
    if (wrong == 83) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.has_motor = true; def_value.joint.as.distance.distance.motor.position = NAN; }
    if (wrong == 84) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.has_motor = true; def_value.joint.as.distance.distance.motor.has_spring = true; def_value.joint.as.distance.distance.motor.spring.stiffness = NAN; }
    if (wrong == 85) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.has_motor = true; def_value.joint.as.distance.distance.motor.has_spring = true; def_value.joint.as.distance.distance.motor.spring.damping = NAN; }
    if (wrong == 86) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.has_motor = true; def_value.joint.as.distance.distance.motor.max_force = NAN; }
    if (wrong == 87) { def_value.joint = cairn_default_joint(CAIRN_JOINT_DISTANCE); def_value.joint.as.distance.distance.friction = NAN; }
    if (wrong == 88) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.has_limits = true; def_value.joint.as.wheel.suspension.limits.lower = NAN; }
    if (wrong == 89) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.has_limits = true; def_value.joint.as.wheel.suspension.limits.upper = NAN; }
    if (wrong == 90) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.has_limits = true; def_value.joint.as.wheel.suspension.limits.has_spring = true; def_value.joint.as.wheel.suspension.limits.spring.stiffness = NAN; }
    if (wrong == 91) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.has_limits = true; def_value.joint.as.wheel.suspension.limits.has_spring = true; def_value.joint.as.wheel.suspension.limits.spring.damping = NAN; }
    if (wrong == 92) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.has_motor = true; def_value.joint.as.wheel.suspension.motor.velocity = NAN; }
    if (wrong == 93) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.has_motor = true; def_value.joint.as.wheel.suspension.motor.position = NAN; }
    if (wrong == 94) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.has_motor = true; def_value.joint.as.wheel.suspension.motor.has_spring = true; def_value.joint.as.wheel.suspension.motor.spring.stiffness = NAN; }
    if (wrong == 95) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.has_motor = true; def_value.joint.as.wheel.suspension.motor.has_spring = true; def_value.joint.as.wheel.suspension.motor.spring.damping = NAN; }
    if (wrong == 96) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.has_motor = true; def_value.joint.as.wheel.suspension.motor.max_force = NAN; }
    if (wrong == 97) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.suspension.friction = NAN; }
    if (wrong == 98) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.has_limits = true; def_value.joint.as.wheel.steering.limits.lower = NAN; }
    if (wrong == 99) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.has_limits = true; def_value.joint.as.wheel.steering.limits.upper = NAN; }
    if (wrong == 100) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.has_limits = true; def_value.joint.as.wheel.steering.limits.has_spring = true; def_value.joint.as.wheel.steering.limits.spring.stiffness = NAN; }
    if (wrong == 101) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.has_limits = true; def_value.joint.as.wheel.steering.limits.has_spring = true; def_value.joint.as.wheel.steering.limits.spring.damping = NAN; }
    if (wrong == 102) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.has_motor = true; def_value.joint.as.wheel.steering.motor.velocity = NAN; }
    if (wrong == 103) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.has_motor = true; def_value.joint.as.wheel.steering.motor.position = NAN; }
    if (wrong == 104) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.has_motor = true; def_value.joint.as.wheel.steering.motor.has_spring = true; def_value.joint.as.wheel.steering.motor.spring.stiffness = NAN; }
    if (wrong == 105) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.has_motor = true; def_value.joint.as.wheel.steering.motor.has_spring = true; def_value.joint.as.wheel.steering.motor.spring.damping = NAN; }
    if (wrong == 106) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.has_motor = true; def_value.joint.as.wheel.steering.motor.max_force = NAN; }
    if (wrong == 107) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.has_steering = true; def_value.joint.as.wheel.steering.friction = NAN; }
    if (wrong == 108) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.has_limits = true; def_value.joint.as.wheel.spin.limits.lower = NAN; }
    if (wrong == 109) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.has_limits = true; def_value.joint.as.wheel.spin.limits.upper = NAN; }
    if (wrong == 110) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.has_limits = true; def_value.joint.as.wheel.spin.limits.has_spring = true; def_value.joint.as.wheel.spin.limits.spring.stiffness = NAN; }
    if (wrong == 111) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.has_limits = true; def_value.joint.as.wheel.spin.limits.has_spring = true; def_value.joint.as.wheel.spin.limits.spring.damping = NAN; }
    if (wrong == 112) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.has_motor = true; def_value.joint.as.wheel.spin.motor.velocity = NAN; }
    if (wrong == 113) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.has_motor = true; def_value.joint.as.wheel.spin.motor.position = NAN; }
    if (wrong == 114) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.has_motor = true; def_value.joint.as.wheel.spin.motor.has_spring = true; def_value.joint.as.wheel.spin.motor.spring.stiffness = NAN; }
    if (wrong == 115) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.has_motor = true; def_value.joint.as.wheel.spin.motor.has_spring = true; def_value.joint.as.wheel.spin.motor.spring.damping = NAN; }
    if (wrong == 116) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.has_motor = true; def_value.joint.as.wheel.spin.motor.max_force = NAN; }
    if (wrong == 117) { def_value.joint = cairn_default_joint(CAIRN_JOINT_WHEEL); def_value.joint.as.wheel.spin.friction = NAN; }
    if (wrong == 118) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SERVO); def_value.joint.as.servo.position.y = NAN; }
    if (wrong == 119) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SERVO); def_value.joint.as.servo.rotation.w = NAN; }
    if (wrong == 120) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SERVO); def_value.joint.as.servo.linear.stiffness = NAN; }
    if (wrong == 121) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SERVO); def_value.joint.as.servo.linear.damping = NAN; }
    if (wrong == 122) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SERVO); def_value.joint.as.servo.angular.stiffness = NAN; }
    if (wrong == 123) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SERVO); def_value.joint.as.servo.angular.damping = NAN; }
    if (wrong == 124) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SERVO); def_value.joint.as.servo.max_force = NAN; }
    if (wrong == 125) { def_value.joint = cairn_default_joint(CAIRN_JOINT_SERVO); def_value.joint.as.servo.max_torque = NAN; }
    if (wrong == 126) { def_value.joint = cairn_default_joint(CAIRN_JOINT_GEAR); def_value.joint.as.gear.ratio = NAN; }
    if (wrong == 127) { def_value.joint = cairn_default_joint(CAIRN_JOINT_RACK); def_value.joint.as.rack.radius = NAN; }
    if (wrong == 128) { def_value.joint = cairn_default_joint(CAIRN_JOINT_PULLEY); def_value.joint.as.pulley.ground_a.z = NAN; }
    if (wrong == 129) { def_value.joint = cairn_default_joint(CAIRN_JOINT_PULLEY); def_value.joint.as.pulley.ground_b.z = NAN; }
    if (wrong == 130) { def_value.joint = cairn_default_joint(CAIRN_JOINT_PULLEY); def_value.joint.as.pulley.ratio = NAN; }
    if (wrong == 131) { def_value.joint = cairn_default_joint(CAIRN_JOINT_PULLEY); def_value.joint.as.pulley.has_length = true; def_value.joint.as.pulley.length = NAN; }
    if (wrong == 132) { def_value.joint = cairn_default_joint(CAIRN_JOINT_GENERAL); def_value.joint.as.general.limits = NULL; def_value.joint.as.general.limit_count = 2; }
    if (wrong == 133) { def_value.joint = cairn_default_joint(CAIRN_JOINT_GENERAL); def_value.joint.as.general.drives = NULL; def_value.joint.as.general.drive_count = 2; }
    if (wrong == 134) { def_value.break_force = NAN; }
    if (wrong == 135) { def_value.break_torque = NAN; }
    if (wrong == 136) { def_value.solver = -1; }
    if (wrong == 137) { def_value.solver = 3; }
    cairn_joint_id result_room[4];
    cairn_joint_id* result = result_room;
    if (wrong == 138) { result = NULL; }
    return cairn_world_create_joint(world, def, result);
}

static cairn_result world_destroy_joint(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_id joint = c->joint;
    if (wrong == 1) { joint = c->stale_joint; }
    return cairn_world_destroy_joint(world, joint);
}

static cairn_result world_get_joint_def(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_id joint = c->joint;
    if (wrong == 1) { joint = c->stale_joint; }
    cairn_joint_def joint_def_room[4] = {cairn_default_joint_def()};
    cairn_joint_def* joint_def = joint_def_room;
    if (wrong == 2) { joint_def = NULL; }
    if (wrong == 3) { joint_def_room[0].struct_size = 1; }
    return cairn_world_get_joint_def(world, joint, joint_def);
}

static cairn_result world_set_joint(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_id id = c->joint;
    if (wrong == 1) { id = c->stale_joint; }
    cairn_joint joint_value = cairn_default_joint(1);
    const cairn_joint* joint = &joint_value;
    if (wrong == 2) { joint = NULL; }
    if (wrong == 3) { joint_value.kind = -1; }
    if (wrong == 4) { joint_value.kind = 13; }
    if (wrong == 5) { joint_value = cairn_default_joint(CAIRN_JOINT_BALL); joint_value.as.ball.has_cone_angle = true; joint_value.as.ball.cone_angle = NAN; }
    if (wrong == 6) { joint_value = cairn_default_joint(CAIRN_JOINT_BALL); joint_value.as.ball.has_twist = true; joint_value.as.ball.twist.lower = NAN; }
    if (wrong == 7) { joint_value = cairn_default_joint(CAIRN_JOINT_BALL); joint_value.as.ball.has_twist = true; joint_value.as.ball.twist.upper = NAN; }
    if (wrong == 8) { joint_value = cairn_default_joint(CAIRN_JOINT_BALL); joint_value.as.ball.has_twist = true; joint_value.as.ball.twist.has_spring = true; joint_value.as.ball.twist.spring.stiffness = NAN; }
    if (wrong == 9) { joint_value = cairn_default_joint(CAIRN_JOINT_BALL); joint_value.as.ball.has_twist = true; joint_value.as.ball.twist.has_spring = true; joint_value.as.ball.twist.spring.damping = NAN; }
    if (wrong == 10) { joint_value = cairn_default_joint(CAIRN_JOINT_BALL); joint_value.as.ball.friction = NAN; }
    if (wrong == 11) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.has_limits = true; joint_value.as.hinge.angle.limits.lower = NAN; }
    if (wrong == 12) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.has_limits = true; joint_value.as.hinge.angle.limits.upper = NAN; }
    if (wrong == 13) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.has_limits = true; joint_value.as.hinge.angle.limits.has_spring = true; joint_value.as.hinge.angle.limits.spring.stiffness = NAN; }
    if (wrong == 14) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.has_limits = true; joint_value.as.hinge.angle.limits.has_spring = true; joint_value.as.hinge.angle.limits.spring.damping = NAN; }
    if (wrong == 15) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.has_motor = true; joint_value.as.hinge.angle.motor.velocity = NAN; }
    if (wrong == 16) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.has_motor = true; joint_value.as.hinge.angle.motor.position = NAN; }
    if (wrong == 17) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.has_motor = true; joint_value.as.hinge.angle.motor.has_spring = true; joint_value.as.hinge.angle.motor.spring.stiffness = NAN; }
    if (wrong == 18) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.has_motor = true; joint_value.as.hinge.angle.motor.has_spring = true; joint_value.as.hinge.angle.motor.spring.damping = NAN; }
    if (wrong == 19) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.has_motor = true; joint_value.as.hinge.angle.motor.max_force = NAN; }
    if (wrong == 20) { joint_value = cairn_default_joint(CAIRN_JOINT_HINGE); joint_value.as.hinge.angle.friction = NAN; }
    if (wrong == 21) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.has_limits = true; joint_value.as.slider.translation.limits.lower = NAN; }
    if (wrong == 22) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.has_limits = true; joint_value.as.slider.translation.limits.upper = NAN; }
    if (wrong == 23) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.has_limits = true; joint_value.as.slider.translation.limits.has_spring = true; joint_value.as.slider.translation.limits.spring.stiffness = NAN; }
    if (wrong == 24) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.has_limits = true; joint_value.as.slider.translation.limits.has_spring = true; joint_value.as.slider.translation.limits.spring.damping = NAN; }
    if (wrong == 25) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.has_motor = true; joint_value.as.slider.translation.motor.velocity = NAN; }
    if (wrong == 26) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.has_motor = true; joint_value.as.slider.translation.motor.position = NAN; }
    if (wrong == 27) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.has_motor = true; joint_value.as.slider.translation.motor.has_spring = true; joint_value.as.slider.translation.motor.spring.stiffness = NAN; }
    if (wrong == 28) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.has_motor = true; joint_value.as.slider.translation.motor.has_spring = true; joint_value.as.slider.translation.motor.spring.damping = NAN; }
    if (wrong == 29) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.has_motor = true; joint_value.as.slider.translation.motor.max_force = NAN; }
    if (wrong == 30) { joint_value = cairn_default_joint(CAIRN_JOINT_SLIDER); joint_value.as.slider.translation.friction = NAN; }
    if (wrong == 31) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.has_limits = true; joint_value.as.cylindrical.translation.limits.lower = NAN; }
    if (wrong == 32) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.has_limits = true; joint_value.as.cylindrical.translation.limits.upper = NAN; }
    if (wrong == 33) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.has_limits = true; joint_value.as.cylindrical.translation.limits.has_spring = true; joint_value.as.cylindrical.translation.limits.spring.stiffness = NAN; }
    if (wrong == 34) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.has_limits = true; joint_value.as.cylindrical.translation.limits.has_spring = true; joint_value.as.cylindrical.translation.limits.spring.damping = NAN; }
    if (wrong == 35) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.has_motor = true; joint_value.as.cylindrical.translation.motor.velocity = NAN; }
    if (wrong == 36) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.has_motor = true; joint_value.as.cylindrical.translation.motor.position = NAN; }
    if (wrong == 37) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.has_motor = true; joint_value.as.cylindrical.translation.motor.has_spring = true; joint_value.as.cylindrical.translation.motor.spring.stiffness = NAN; }
    if (wrong == 38) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.has_motor = true; joint_value.as.cylindrical.translation.motor.has_spring = true; joint_value.as.cylindrical.translation.motor.spring.damping = NAN; }
    if (wrong == 39) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.has_motor = true; joint_value.as.cylindrical.translation.motor.max_force = NAN; }
    if (wrong == 40) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.translation.friction = NAN; }
    if (wrong == 41) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.has_limits = true; joint_value.as.cylindrical.angle.limits.lower = NAN; }
    if (wrong == 42) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.has_limits = true; joint_value.as.cylindrical.angle.limits.upper = NAN; }
    if (wrong == 43) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.has_limits = true; joint_value.as.cylindrical.angle.limits.has_spring = true; joint_value.as.cylindrical.angle.limits.spring.stiffness = NAN; }
    if (wrong == 44) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.has_limits = true; joint_value.as.cylindrical.angle.limits.has_spring = true; joint_value.as.cylindrical.angle.limits.spring.damping = NAN; }
    if (wrong == 45) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.has_motor = true; joint_value.as.cylindrical.angle.motor.velocity = NAN; }
    if (wrong == 46) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.has_motor = true; joint_value.as.cylindrical.angle.motor.position = NAN; }
    if (wrong == 47) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.has_motor = true; joint_value.as.cylindrical.angle.motor.has_spring = true; joint_value.as.cylindrical.angle.motor.spring.stiffness = NAN; }
    if (wrong == 48) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.has_motor = true; joint_value.as.cylindrical.angle.motor.has_spring = true; joint_value.as.cylindrical.angle.motor.spring.damping = NAN; }
    if (wrong == 49) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.has_motor = true; joint_value.as.cylindrical.angle.motor.max_force = NAN; }
    if (wrong == 50) { joint_value = cairn_default_joint(CAIRN_JOINT_CYLINDRICAL); joint_value.as.cylindrical.angle.friction = NAN; }
    if (wrong == 51) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.has_limits = true; joint_value.as.universal.first.limits.lower = NAN; }
    if (wrong == 52) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.has_limits = true; joint_value.as.universal.first.limits.upper = NAN; }
    if (wrong == 53) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.has_limits = true; joint_value.as.universal.first.limits.has_spring = true; joint_value.as.universal.first.limits.spring.stiffness = NAN; }
    if (wrong == 54) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.has_limits = true; joint_value.as.universal.first.limits.has_spring = true; joint_value.as.universal.first.limits.spring.damping = NAN; }
    if (wrong == 55) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.has_motor = true; joint_value.as.universal.first.motor.velocity = NAN; }
    if (wrong == 56) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.has_motor = true; joint_value.as.universal.first.motor.position = NAN; }
    if (wrong == 57) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.has_motor = true; joint_value.as.universal.first.motor.has_spring = true; joint_value.as.universal.first.motor.spring.stiffness = NAN; }
    if (wrong == 58) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.has_motor = true; joint_value.as.universal.first.motor.has_spring = true; joint_value.as.universal.first.motor.spring.damping = NAN; }
    if (wrong == 59) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.has_motor = true; joint_value.as.universal.first.motor.max_force = NAN; }
    if (wrong == 60) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.first.friction = NAN; }
    if (wrong == 61) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.has_limits = true; joint_value.as.universal.second.limits.lower = NAN; }
    if (wrong == 62) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.has_limits = true; joint_value.as.universal.second.limits.upper = NAN; }
    if (wrong == 63) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.has_limits = true; joint_value.as.universal.second.limits.has_spring = true; joint_value.as.universal.second.limits.spring.stiffness = NAN; }
    if (wrong == 64) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.has_limits = true; joint_value.as.universal.second.limits.has_spring = true; joint_value.as.universal.second.limits.spring.damping = NAN; }
    if (wrong == 65) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.has_motor = true; joint_value.as.universal.second.motor.velocity = NAN; }
    if (wrong == 66) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.has_motor = true; joint_value.as.universal.second.motor.position = NAN; }
    if (wrong == 67) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.has_motor = true; joint_value.as.universal.second.motor.has_spring = true; joint_value.as.universal.second.motor.spring.stiffness = NAN; }
    if (wrong == 68) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.has_motor = true; joint_value.as.universal.second.motor.has_spring = true; joint_value.as.universal.second.motor.spring.damping = NAN; }
    if (wrong == 69) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.has_motor = true; joint_value.as.universal.second.motor.max_force = NAN; }
    if (wrong == 70) { joint_value = cairn_default_joint(CAIRN_JOINT_UNIVERSAL); joint_value.as.universal.second.friction = NAN; }
    if (wrong == 71) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.has_limits = true; joint_value.as.distance.distance.limits.lower = NAN; }
    if (wrong == 72) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.has_limits = true; joint_value.as.distance.distance.limits.upper = NAN; }
    if (wrong == 73) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.has_limits = true; joint_value.as.distance.distance.limits.has_spring = true; joint_value.as.distance.distance.limits.spring.stiffness = NAN; }
    if (wrong == 74) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.has_limits = true; joint_value.as.distance.distance.limits.has_spring = true; joint_value.as.distance.distance.limits.spring.damping = NAN; }
    if (wrong == 75) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.has_motor = true; joint_value.as.distance.distance.motor.velocity = NAN; }
    if (wrong == 76) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.has_motor = true; joint_value.as.distance.distance.motor.position = NAN; }
    if (wrong == 77) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.has_motor = true; joint_value.as.distance.distance.motor.has_spring = true; joint_value.as.distance.distance.motor.spring.stiffness = NAN; }
    if (wrong == 78) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.has_motor = true; joint_value.as.distance.distance.motor.has_spring = true; joint_value.as.distance.distance.motor.spring.damping = NAN; }
    if (wrong == 79) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.has_motor = true; joint_value.as.distance.distance.motor.max_force = NAN; }
    if (wrong == 80) { joint_value = cairn_default_joint(CAIRN_JOINT_DISTANCE); joint_value.as.distance.distance.friction = NAN; }
    if (wrong == 81) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.has_limits = true; joint_value.as.wheel.suspension.limits.lower = NAN; }
    if (wrong == 82) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.has_limits = true; joint_value.as.wheel.suspension.limits.upper = NAN; }
    if (wrong == 83) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.has_limits = true; joint_value.as.wheel.suspension.limits.has_spring = true; joint_value.as.wheel.suspension.limits.spring.stiffness = NAN; }
    if (wrong == 84) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.has_limits = true; joint_value.as.wheel.suspension.limits.has_spring = true; joint_value.as.wheel.suspension.limits.spring.damping = NAN; }
    if (wrong == 85) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.has_motor = true; joint_value.as.wheel.suspension.motor.velocity = NAN; }
    if (wrong == 86) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.has_motor = true; joint_value.as.wheel.suspension.motor.position = NAN; }
    if (wrong == 87) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.has_motor = true; joint_value.as.wheel.suspension.motor.has_spring = true; joint_value.as.wheel.suspension.motor.spring.stiffness = NAN; }
    if (wrong == 88) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.has_motor = true; joint_value.as.wheel.suspension.motor.has_spring = true; joint_value.as.wheel.suspension.motor.spring.damping = NAN; }
    if (wrong == 89) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.has_motor = true; joint_value.as.wheel.suspension.motor.max_force = NAN; }
    if (wrong == 90) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.suspension.friction = NAN; }
    if (wrong == 91) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.has_limits = true; joint_value.as.wheel.steering.limits.lower = NAN; }
    if (wrong == 92) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.has_limits = true; joint_value.as.wheel.steering.limits.upper = NAN; }
    if (wrong == 93) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.has_limits = true; joint_value.as.wheel.steering.limits.has_spring = true; joint_value.as.wheel.steering.limits.spring.stiffness = NAN; }
    if (wrong == 94) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.has_limits = true; joint_value.as.wheel.steering.limits.has_spring = true; joint_value.as.wheel.steering.limits.spring.damping = NAN; }
    if (wrong == 95) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.has_motor = true; joint_value.as.wheel.steering.motor.velocity = NAN; }
    if (wrong == 96) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.has_motor = true; joint_value.as.wheel.steering.motor.position = NAN; }
    if (wrong == 97) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.has_motor = true; joint_value.as.wheel.steering.motor.has_spring = true; joint_value.as.wheel.steering.motor.spring.stiffness = NAN; }
    if (wrong == 98) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.has_motor = true; joint_value.as.wheel.steering.motor.has_spring = true; joint_value.as.wheel.steering.motor.spring.damping = NAN; }
    if (wrong == 99) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.has_motor = true; joint_value.as.wheel.steering.motor.max_force = NAN; }
    if (wrong == 100) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.has_steering = true; joint_value.as.wheel.steering.friction = NAN; }
    if (wrong == 101) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.has_limits = true; joint_value.as.wheel.spin.limits.lower = NAN; }
    if (wrong == 102) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.has_limits = true; joint_value.as.wheel.spin.limits.upper = NAN; }
    if (wrong == 103) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.has_limits = true; joint_value.as.wheel.spin.limits.has_spring = true; joint_value.as.wheel.spin.limits.spring.stiffness = NAN; }
    if (wrong == 104) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.has_limits = true; joint_value.as.wheel.spin.limits.has_spring = true; joint_value.as.wheel.spin.limits.spring.damping = NAN; }
    if (wrong == 105) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.has_motor = true; joint_value.as.wheel.spin.motor.velocity = NAN; }
    if (wrong == 106) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.has_motor = true; joint_value.as.wheel.spin.motor.position = NAN; }
    if (wrong == 107) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.has_motor = true; joint_value.as.wheel.spin.motor.has_spring = true; joint_value.as.wheel.spin.motor.spring.stiffness = NAN; }
    if (wrong == 108) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.has_motor = true; joint_value.as.wheel.spin.motor.has_spring = true; joint_value.as.wheel.spin.motor.spring.damping = NAN; }
    if (wrong == 109) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.has_motor = true; joint_value.as.wheel.spin.motor.max_force = NAN; }
    if (wrong == 110) { joint_value = cairn_default_joint(CAIRN_JOINT_WHEEL); joint_value.as.wheel.spin.friction = NAN; }
    if (wrong == 111) { joint_value = cairn_default_joint(CAIRN_JOINT_SERVO); joint_value.as.servo.position.y = NAN; }
    if (wrong == 112) { joint_value = cairn_default_joint(CAIRN_JOINT_SERVO); joint_value.as.servo.rotation.w = NAN; }
    if (wrong == 113) { joint_value = cairn_default_joint(CAIRN_JOINT_SERVO); joint_value.as.servo.linear.stiffness = NAN; }
    if (wrong == 114) { joint_value = cairn_default_joint(CAIRN_JOINT_SERVO); joint_value.as.servo.linear.damping = NAN; }
    if (wrong == 115) { joint_value = cairn_default_joint(CAIRN_JOINT_SERVO); joint_value.as.servo.angular.stiffness = NAN; }
    if (wrong == 116) { joint_value = cairn_default_joint(CAIRN_JOINT_SERVO); joint_value.as.servo.angular.damping = NAN; }
    if (wrong == 117) { joint_value = cairn_default_joint(CAIRN_JOINT_SERVO); joint_value.as.servo.max_force = NAN; }
    if (wrong == 118) { joint_value = cairn_default_joint(CAIRN_JOINT_SERVO); joint_value.as.servo.max_torque = NAN; }
    if (wrong == 119) { joint_value = cairn_default_joint(CAIRN_JOINT_GEAR); joint_value.as.gear.ratio = NAN; }
    if (wrong == 120) { joint_value = cairn_default_joint(CAIRN_JOINT_RACK); joint_value.as.rack.radius = NAN; }
    if (wrong == 121) { joint_value = cairn_default_joint(CAIRN_JOINT_PULLEY); joint_value.as.pulley.ground_a.z = NAN; }
    if (wrong == 122) { joint_value = cairn_default_joint(CAIRN_JOINT_PULLEY); joint_value.as.pulley.ground_b.z = NAN; }
    if (wrong == 123) { joint_value = cairn_default_joint(CAIRN_JOINT_PULLEY); joint_value.as.pulley.ratio = NAN; }
    if (wrong == 124) { joint_value = cairn_default_joint(CAIRN_JOINT_PULLEY); joint_value.as.pulley.has_length = true; joint_value.as.pulley.length = NAN; }
    if (wrong == 125) { joint_value = cairn_default_joint(CAIRN_JOINT_GENERAL); joint_value.as.general.limits = NULL; joint_value.as.general.limit_count = 2; }
    if (wrong == 126) { joint_value = cairn_default_joint(CAIRN_JOINT_GENERAL); joint_value.as.general.drives = NULL; joint_value.as.general.drive_count = 2; }
    return cairn_world_set_joint(world, id, joint);
}

static cairn_result world_set_joint_strength(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_id joint = c->joint;
    if (wrong == 1) { joint = c->stale_joint; }
    float break_force = 1.0f;
    if (wrong == 2) { break_force = NAN; }
    float break_torque = 1.0f;
    if (wrong == 3) { break_torque = NAN; }
    return cairn_world_set_joint_strength(world, joint, break_force, break_torque);
}

static cairn_result world_set_joint_enabled(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_id joint = c->joint;
    if (wrong == 1) { joint = c->stale_joint; }
    bool enabled = true;
    return cairn_world_set_joint_enabled(world, joint, enabled);
}

static cairn_result world_get_joint_state(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_id joint = c->joint;
    if (wrong == 1) { joint = c->stale_joint; }
    cairn_joint_state joint_state_room[4];
    cairn_joint_state* joint_state = joint_state_room;
    if (wrong == 2) { joint_state = NULL; }
    return cairn_world_get_joint_state(world, joint, joint_state);
}

static cairn_result world_get_joints(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_id joints_room[4];
    cairn_joint_id* joints = joints_room;
    if (wrong == 1) { joints = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_joints(world, joints, capacity, count);
}

static cairn_result body_get_joints(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    cairn_joint_id joints_room[4];
    cairn_joint_id* joints = joints_room;
    if (wrong == 2) { joints = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 3) { count = NULL; }
    return cairn_body_get_joints(world, body, joints, capacity, count);
}

static cairn_result world_find_joint(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    const char* name = "name";
    if (wrong == 1) { name = NULL; }
    cairn_joint_id result_room[4];
    cairn_joint_id* result = result_room;
    if (wrong == 2) { result = NULL; }
    bool found_room[4];
    bool* found = found_room;
    if (wrong == 3) { found = NULL; }
    return cairn_world_find_joint(world, name, result, found);
}

static cairn_result joint_get_name(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_id joint = c->joint;
    if (wrong == 1) { joint = c->stale_joint; }
    char text_room[4];
    char* text = text_room;
    if (wrong == 2) { text = NULL; }
    size_t capacity = 4;
    size_t length_room[4];
    size_t* length = length_room;
    if (wrong == 3) { length = NULL; }
    return cairn_joint_get_name(world, joint, text, capacity, length);
}

static cairn_result world_cast_ray(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_position origin = c->position;
    if (wrong == 1) { origin.z = NAN; }
    cairn_vec3 direction = c->vec3;
    if (wrong == 2) { direction.y = NAN; }
    double max_distance = 1.0;
    if (wrong == 3) { max_distance = NAN; }
    cairn_query_filter filter_value = cairn_default_query_filter();
    const cairn_query_filter* filter = &filter_value;
    if (wrong == 4) { filter_value.struct_size = 0; }
    if (wrong == 5) { filter_value.struct_size = sizeof(cairn_query_filter) + 8; }
    if (wrong == 6) { filter_value.ignored_bodies = NULL; filter_value.ignored_body_count = 2; }
    cairn_ray_hit result_room[4];
    cairn_ray_hit* result = result_room;
    if (wrong == 7) { result = NULL; }
    bool found_room[4];
    bool* found = found_room;
    if (wrong == 8) { found = NULL; }
    return cairn_world_cast_ray(world, origin, direction, max_distance, filter, result, found);
}

static cairn_result world_cast_ray_all(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_position origin = c->position;
    if (wrong == 1) { origin.z = NAN; }
    cairn_vec3 direction = c->vec3;
    if (wrong == 2) { direction.y = NAN; }
    double max_distance = 1.0;
    if (wrong == 3) { max_distance = NAN; }
    cairn_query_filter filter_value = cairn_default_query_filter();
    const cairn_query_filter* filter = &filter_value;
    if (wrong == 4) { filter_value.struct_size = 0; }
    if (wrong == 5) { filter_value.struct_size = sizeof(cairn_query_filter) + 8; }
    if (wrong == 6) { filter_value.ignored_bodies = NULL; filter_value.ignored_body_count = 2; }
    cairn_ray_hit result_room[4];
    cairn_ray_hit* result = result_room;
    if (wrong == 7) { result = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 8) { count = NULL; }
    return cairn_world_cast_ray_all(world, origin, direction, max_distance, filter, result, capacity, count);
}

static cairn_result world_cast_shape(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape shape_value = cairn_default_shape(1);
    const cairn_shape* shape = &shape_value;
    if (wrong == 1) { shape = NULL; }
    if (wrong == 2) { shape_value.kind = -1; }
    if (wrong == 3) { shape_value.kind = 8; }
    if (wrong == 4) { shape_value = cairn_default_shape(CAIRN_SHAPE_SPHERE); shape_value.as.sphere.radius = NAN; }
    if (wrong == 5) { shape_value = cairn_default_shape(CAIRN_SHAPE_BOX); shape_value.as.box.half_extents.y = NAN; }
    if (wrong == 6) { shape_value = cairn_default_shape(CAIRN_SHAPE_BOX); shape_value.as.box.rounding = NAN; }
    if (wrong == 7) { shape_value = cairn_default_shape(CAIRN_SHAPE_PLANE); shape_value.as.plane.normal.y = NAN; }
    if (wrong == 8) { shape_value = cairn_default_shape(CAIRN_SHAPE_PLANE); shape_value.as.plane.has_half_extents = true; shape_value.as.plane.half_extents.x = NAN; }
    if (wrong == 9) { shape_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); shape_value.as.capsule.half_height = NAN; }
    if (wrong == 10) { shape_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); shape_value.as.capsule.radius = NAN; }
    if (wrong == 11) { shape_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); shape_value.as.capsule.has_radius_top = true; shape_value.as.capsule.radius_top = NAN; }
    if (wrong == 12) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.half_height = NAN; }
    if (wrong == 13) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.radius = NAN; }
    if (wrong == 14) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.has_radius_top = true; shape_value.as.cylinder.radius_top = NAN; }
    if (wrong == 15) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.rounding = NAN; }
    if (wrong == 16) { shape_value = cairn_default_shape(CAIRN_SHAPE_HULL); shape_value.as.hull.geometry = NULL; }
    if (wrong == 17) { shape_value = cairn_default_shape(CAIRN_SHAPE_HULL); shape_value.as.hull.rounding = NAN; }
    if (wrong == 18) { shape_value = cairn_default_shape(CAIRN_SHAPE_MESH); shape_value.as.mesh.geometry = NULL; }
    if (wrong == 19) { shape_value = cairn_default_shape(CAIRN_SHAPE_HEIGHT_FIELD); shape_value.as.height_field.geometry = NULL; }
    cairn_transform start = c->transform;
    if (wrong == 20) { start.position.z = NAN; }
    if (wrong == 21) { start.rotation.w = NAN; }
    cairn_vec3 translation = c->vec3;
    if (wrong == 22) { translation.y = NAN; }
    cairn_query_filter filter_value = cairn_default_query_filter();
    const cairn_query_filter* filter = &filter_value;
    if (wrong == 23) { filter_value.struct_size = 0; }
    if (wrong == 24) { filter_value.struct_size = sizeof(cairn_query_filter) + 8; }
    if (wrong == 25) { filter_value.ignored_bodies = NULL; filter_value.ignored_body_count = 2; }
    cairn_shape_cast_hit result_room[4];
    cairn_shape_cast_hit* result = result_room;
    if (wrong == 26) { result = NULL; }
    bool found_room[4];
    bool* found = found_room;
    if (wrong == 27) { found = NULL; }
    return cairn_world_cast_shape(world, shape, start, translation, filter, result, found);
}

static cairn_result world_closest_point(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_position point = c->position;
    if (wrong == 1) { point.z = NAN; }
    double max_distance = 1.0;
    if (wrong == 2) { max_distance = NAN; }
    cairn_query_filter filter_value = cairn_default_query_filter();
    const cairn_query_filter* filter = &filter_value;
    if (wrong == 3) { filter_value.struct_size = 0; }
    if (wrong == 4) { filter_value.struct_size = sizeof(cairn_query_filter) + 8; }
    if (wrong == 5) { filter_value.ignored_bodies = NULL; filter_value.ignored_body_count = 2; }
    cairn_closest_point result_room[4];
    cairn_closest_point* result = result_room;
    if (wrong == 6) { result = NULL; }
    bool found_room[4];
    bool* found = found_room;
    if (wrong == 7) { found = NULL; }
    return cairn_world_closest_point(world, point, max_distance, filter, result, found);
}

static cairn_result world_overlap(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_shape shape_value = cairn_default_shape(1);
    const cairn_shape* shape = &shape_value;
    if (wrong == 1) { shape = NULL; }
    if (wrong == 2) { shape_value.kind = -1; }
    if (wrong == 3) { shape_value.kind = 8; }
    if (wrong == 4) { shape_value = cairn_default_shape(CAIRN_SHAPE_SPHERE); shape_value.as.sphere.radius = NAN; }
    if (wrong == 5) { shape_value = cairn_default_shape(CAIRN_SHAPE_BOX); shape_value.as.box.half_extents.y = NAN; }
    if (wrong == 6) { shape_value = cairn_default_shape(CAIRN_SHAPE_BOX); shape_value.as.box.rounding = NAN; }
    if (wrong == 7) { shape_value = cairn_default_shape(CAIRN_SHAPE_PLANE); shape_value.as.plane.normal.y = NAN; }
    if (wrong == 8) { shape_value = cairn_default_shape(CAIRN_SHAPE_PLANE); shape_value.as.plane.has_half_extents = true; shape_value.as.plane.half_extents.x = NAN; }
    if (wrong == 9) { shape_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); shape_value.as.capsule.half_height = NAN; }
    if (wrong == 10) { shape_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); shape_value.as.capsule.radius = NAN; }
    if (wrong == 11) { shape_value = cairn_default_shape(CAIRN_SHAPE_CAPSULE); shape_value.as.capsule.has_radius_top = true; shape_value.as.capsule.radius_top = NAN; }
    if (wrong == 12) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.half_height = NAN; }
    if (wrong == 13) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.radius = NAN; }
    if (wrong == 14) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.has_radius_top = true; shape_value.as.cylinder.radius_top = NAN; }
    if (wrong == 15) { shape_value = cairn_default_shape(CAIRN_SHAPE_CYLINDER); shape_value.as.cylinder.rounding = NAN; }
    if (wrong == 16) { shape_value = cairn_default_shape(CAIRN_SHAPE_HULL); shape_value.as.hull.geometry = NULL; }
    if (wrong == 17) { shape_value = cairn_default_shape(CAIRN_SHAPE_HULL); shape_value.as.hull.rounding = NAN; }
    if (wrong == 18) { shape_value = cairn_default_shape(CAIRN_SHAPE_MESH); shape_value.as.mesh.geometry = NULL; }
    if (wrong == 19) { shape_value = cairn_default_shape(CAIRN_SHAPE_HEIGHT_FIELD); shape_value.as.height_field.geometry = NULL; }
    cairn_transform pose = c->transform;
    if (wrong == 20) { pose.position.z = NAN; }
    if (wrong == 21) { pose.rotation.w = NAN; }
    cairn_query_filter filter_value = cairn_default_query_filter();
    const cairn_query_filter* filter = &filter_value;
    if (wrong == 22) { filter_value.struct_size = 0; }
    if (wrong == 23) { filter_value.struct_size = sizeof(cairn_query_filter) + 8; }
    if (wrong == 24) { filter_value.ignored_bodies = NULL; filter_value.ignored_body_count = 2; }
    cairn_shape_id result_room[4];
    cairn_shape_id* result = result_room;
    if (wrong == 25) { result = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 26) { count = NULL; }
    return cairn_world_overlap(world, shape, pose, filter, result, capacity, count);
}

static cairn_result world_overlap_bounds(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_bounds bounds = c->bounds;
    if (wrong == 1) { bounds.min.z = NAN; }
    if (wrong == 2) { bounds.max.z = NAN; }
    cairn_query_filter filter_value = cairn_default_query_filter();
    const cairn_query_filter* filter = &filter_value;
    if (wrong == 3) { filter_value.struct_size = 0; }
    if (wrong == 4) { filter_value.struct_size = sizeof(cairn_query_filter) + 8; }
    if (wrong == 5) { filter_value.ignored_bodies = NULL; filter_value.ignored_body_count = 2; }
    cairn_shape_id result_room[4];
    cairn_shape_id* result = result_room;
    if (wrong == 6) { result = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 7) { count = NULL; }
    return cairn_world_overlap_bounds(world, bounds, filter, result, capacity, count);
}

static cairn_result world_broad_phase_nodes(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    int max_depth = 2;
    int max_count = 2;
    cairn_broad_phase_node result_room[4];
    cairn_broad_phase_node* result = result_room;
    if (wrong == 1) { result = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_broad_phase_nodes(world, max_depth, max_count, result, capacity, count);
}

static cairn_result world_solver_contacts(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_solver_contact result_room[4];
    cairn_solver_contact* result = result_room;
    if (wrong == 1) { result = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_solver_contacts(world, result, capacity, count);
}

static cairn_result world_debug_lines(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_debug_lines_def what_value = cairn_default_debug_lines_def();
    const cairn_debug_lines_def* what = &what_value;
    if (wrong == 1) { what_value.struct_size = 0; }
    if (wrong == 2) { what_value.struct_size = sizeof(cairn_debug_lines_def) + 8; }
    if (wrong == 3) { what_value.size = NAN; }
    if (wrong == 4) { what_value.impulse_scale = NAN; }
    cairn_debug_line result_room[4];
    cairn_debug_line* result = result_room;
    if (wrong == 5) { result = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 6) { count = NULL; }
    return cairn_world_debug_lines(world, what, result, capacity, count);
}

static cairn_result world_get_contact_begins(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_contact_begin contact_begins_room[4];
    cairn_contact_begin* contact_begins = contact_begins_room;
    if (wrong == 1) { contact_begins = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_contact_begins(world, contact_begins, capacity, count);
}

static cairn_result world_get_contact_ends(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_contact_end contact_ends_room[4];
    cairn_contact_end* contact_ends = contact_ends_room;
    if (wrong == 1) { contact_ends = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_contact_ends(world, contact_ends, capacity, count);
}

static cairn_result world_get_contact_hits(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_contact_hit contact_hits_room[4];
    cairn_contact_hit* contact_hits = contact_hits_room;
    if (wrong == 1) { contact_hits = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_contact_hits(world, contact_hits, capacity, count);
}

static cairn_result world_get_trigger_events(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_trigger_event trigger_events_room[4];
    cairn_trigger_event* trigger_events = trigger_events_room;
    if (wrong == 1) { trigger_events = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_trigger_events(world, trigger_events, capacity, count);
}

static cairn_result world_get_joint_events(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_joint_event joint_events_room[4];
    cairn_joint_event* joint_events = joint_events_room;
    if (wrong == 1) { joint_events = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_joint_events(world, joint_events, capacity, count);
}

static cairn_result world_get_sleep_events(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_sleep_event sleep_events_room[4];
    cairn_sleep_event* sleep_events = sleep_events_room;
    if (wrong == 1) { sleep_events = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_sleep_events(world, sleep_events, capacity, count);
}

static cairn_result world_get_contacts(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_contact contacts_room[4];
    cairn_contact* contacts = contacts_room;
    if (wrong == 1) { contacts = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_contacts(world, contacts, capacity, count);
}

static cairn_result body_get_contacts(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_body_id body = c->body;
    if (wrong == 1) { body = c->stale_body; }
    cairn_contact contacts_room[4];
    cairn_contact* contacts = contacts_room;
    if (wrong == 2) { contacts = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 3) { count = NULL; }
    return cairn_body_get_contacts(world, body, contacts, capacity, count);
}

static cairn_result world_get_settings(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_world_def settings_room[4] = {cairn_default_world_def()};
    cairn_world_def* settings = settings_room;
    if (wrong == 1) { settings = NULL; }
    if (wrong == 2) { settings_room[0].struct_size = 1; }
    return cairn_world_get_settings(world, settings);
}

static cairn_result world_set_settings(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_world_def def_value = cairn_default_world_def();
    const cairn_world_def* def = &def_value;
    if (wrong == 1) { def = NULL; }
    if (wrong == 2) { def_value.struct_size = 0; }
    if (wrong == 3) { def_value.struct_size = sizeof(cairn_world_def) + 8; }
    if (wrong == 4) { def_value.gravity.y = NAN; }
    if (wrong == 5) { def_value.integrator = -1; }
    if (wrong == 6) { def_value.integrator = 3; }
    if (wrong == 7) { def_value.sleep_speed = NAN; }
    if (wrong == 8) { def_value.sleep_time = NAN; }
    if (wrong == 9) { def_value.restitution_speed = NAN; }
    if (wrong == 10) { def_value.hit_speed = NAN; }
    if (wrong == 11) { def_value.recovery_speed = NAN; }
    if (wrong == 12) { def_value.max_linear_speed = NAN; }
    if (wrong == 13) { def_value.max_angular_speed = NAN; }
    return cairn_world_set_settings(world, def);
}

static cairn_result world_usual_substeps(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    float dt = 1.0f;
    if (wrong == 1) { dt = NAN; }
    int result_room[4];
    int* result = result_room;
    if (wrong == 2) { result = NULL; }
    return cairn_world_usual_substeps(world, dt, result);
}

static cairn_result world_set_threads(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    int count = 2;
    return cairn_world_set_threads(world, count);
}

static cairn_result world_get_threads(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    int threads_room[4];
    int* threads = threads_room;
    if (wrong == 1) { threads = NULL; }
    return cairn_world_get_threads(world, threads);
}

static cairn_result world_add_force_field(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_force_field field_value = cairn_default_force_field();
    const cairn_force_field* field = &field_value;
    if (wrong == 1) { field = NULL; }
    if (wrong == 2) { field_value.struct_size = 0; }
    if (wrong == 3) { field_value.struct_size = sizeof(cairn_force_field) + 8; }
    if (wrong == 4) { field_value.kind = -1; }
    if (wrong == 5) { field_value.kind = 3; }
    if (wrong == 6) { field_value.direction.y = NAN; }
    if (wrong == 7) { field_value.center.z = NAN; }
    if (wrong == 8) { field_value.strength = NAN; }
    if (wrong == 9) { field_value.exponent = NAN; }
    if (wrong == 10) { field_value.half_extents.y = NAN; }
    if (wrong == 11) { field_value.density = NAN; }
    if (wrong == 12) { field_value.drag = NAN; }
    if (wrong == 13) { field_value.skin_friction = NAN; }
    if (wrong == 14) { field_value.added_mass = NAN; }
    if (wrong == 15) { field_value.wave_damping = NAN; }
    cairn_force_field_id result_room[4];
    cairn_force_field_id* result = result_room;
    if (wrong == 16) { result = NULL; }
    return cairn_world_add_force_field(world, field, result);
}

static cairn_result world_set_force_field(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_force_field_id id = c->force_field;
    if (wrong == 1) { id = c->stale_force_field; }
    cairn_force_field field_value = cairn_default_force_field();
    const cairn_force_field* field = &field_value;
    if (wrong == 2) { field = NULL; }
    if (wrong == 3) { field_value.struct_size = 0; }
    if (wrong == 4) { field_value.struct_size = sizeof(cairn_force_field) + 8; }
    if (wrong == 5) { field_value.kind = -1; }
    if (wrong == 6) { field_value.kind = 3; }
    if (wrong == 7) { field_value.direction.y = NAN; }
    if (wrong == 8) { field_value.center.z = NAN; }
    if (wrong == 9) { field_value.strength = NAN; }
    if (wrong == 10) { field_value.exponent = NAN; }
    if (wrong == 11) { field_value.half_extents.y = NAN; }
    if (wrong == 12) { field_value.density = NAN; }
    if (wrong == 13) { field_value.drag = NAN; }
    if (wrong == 14) { field_value.skin_friction = NAN; }
    if (wrong == 15) { field_value.added_mass = NAN; }
    if (wrong == 16) { field_value.wave_damping = NAN; }
    return cairn_world_set_force_field(world, id, field);
}

static cairn_result world_remove_force_field(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_force_field_id id = c->force_field;
    if (wrong == 1) { id = c->stale_force_field; }
    return cairn_world_remove_force_field(world, id);
}

static cairn_result world_get_force_field(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_force_field_id id = c->force_field;
    if (wrong == 1) { id = c->stale_force_field; }
    cairn_force_field force_field_room[4] = {cairn_default_force_field()};
    cairn_force_field* force_field = force_field_room;
    if (wrong == 2) { force_field = NULL; }
    if (wrong == 3) { force_field_room[0].struct_size = 1; }
    return cairn_world_get_force_field(world, id, force_field);
}

static cairn_result world_get_force_fields(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_force_field_id force_fields_room[4];
    cairn_force_field_id* force_fields = force_fields_room;
    if (wrong == 1) { force_fields = NULL; }
    size_t capacity = 4;
    size_t count_room[4];
    size_t* count = count_room;
    if (wrong == 2) { count = NULL; }
    return cairn_world_get_force_fields(world, force_fields, capacity, count);
}

static cairn_result world_step(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    float dt = 1.0f;
    if (wrong == 1) { dt = NAN; }
    return cairn_world_step(world, dt);
}

static cairn_result world_get_step_count(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    uint64_t step_count_room[4];
    uint64_t* step_count = step_count_room;
    if (wrong == 1) { step_count = NULL; }
    return cairn_world_get_step_count(world, step_count);
}

static cairn_result world_get_time(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    double time_room[4];
    double* time = time_room;
    if (wrong == 1) { time = NULL; }
    return cairn_world_get_time(world, time);
}

static cairn_result world_get_kinetic_energy(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    double kinetic_energy_room[4];
    double* kinetic_energy = kinetic_energy_room;
    if (wrong == 1) { kinetic_energy = NULL; }
    return cairn_world_get_kinetic_energy(world, kinetic_energy);
}

static cairn_result world_get_potential_energy(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    double potential_energy_room[4];
    double* potential_energy = potential_energy_room;
    if (wrong == 1) { potential_energy = NULL; }
    return cairn_world_get_potential_energy(world, potential_energy);
}

static cairn_result world_get_linear_momentum(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_dvec3 linear_momentum_room[4];
    cairn_dvec3* linear_momentum = linear_momentum_room;
    if (wrong == 1) { linear_momentum = NULL; }
    return cairn_world_get_linear_momentum(world, linear_momentum);
}

static cairn_result world_get_angular_momentum(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_dvec3 angular_momentum_room[4];
    cairn_dvec3* angular_momentum = angular_momentum_room;
    if (wrong == 1) { angular_momentum = NULL; }
    return cairn_world_get_angular_momentum(world, angular_momentum);
}

static cairn_result world_get_state_hash(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    uint64_t state_hash_room[4];
    uint64_t* state_hash = state_hash_room;
    if (wrong == 1) { state_hash = NULL; }
    return cairn_world_get_state_hash(world, state_hash);
}

static cairn_result world_get_statistics(const struct wrong_context* c, int wrong) {
    cairn_world* world = c->world;
    if (wrong == 0) { world = NULL; }
    cairn_statistics statistics_room[4] = {cairn_default_statistics()};
    cairn_statistics* statistics = statistics_room;
    if (wrong == 1) { statistics = NULL; }
    if (wrong == 2) { statistics_room[0].struct_size = 1; }
    return cairn_world_get_statistics(world, statistics);
}

const struct wrong_call wrong_calls[] = {
    {"world_add_shape", "world is null", world_add_shape, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_add_shape", "body is stale", world_add_shape, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_add_shape", "shape is null", world_add_shape, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.kind is -1", world_add_shape, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.kind is 8", world_add_shape, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.sphere.radius is NaN", world_add_shape, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.box.half_extents.y is NaN", world_add_shape, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.box.rounding is NaN", world_add_shape, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.plane.normal.y is NaN", world_add_shape, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.plane.half_extents.x is NaN", world_add_shape, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.capsule.half_height is NaN", world_add_shape, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.capsule.radius is NaN", world_add_shape, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.capsule.radius_top is NaN", world_add_shape, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.cylinder.half_height is NaN", world_add_shape, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.cylinder.radius is NaN", world_add_shape, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.cylinder.radius_top is NaN", world_add_shape, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.cylinder.rounding is NaN", world_add_shape, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.hull.geometry is null", world_add_shape, 17, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.hull.rounding is NaN", world_add_shape, 18, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.mesh.geometry is null", world_add_shape, 19, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "shape_value.as.height_field.geometry is null", world_add_shape, 20, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.struct_size is 0", world_add_shape, 21, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.struct_size is sizeof(cairn_shape_def) + 8", world_add_shape, 22, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.position.y is NaN", world_add_shape, 23, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.rotation.w is NaN", world_add_shape, 24, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.density is NaN", world_add_shape, 25, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.material.static_friction is NaN", world_add_shape, 26, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.material.dynamic_friction is NaN", world_add_shape, 27, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.material.restitution is NaN", world_add_shape, 28, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.material.rolling_friction is NaN", world_add_shape, 29, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.material.torsional_friction is NaN", world_add_shape, 30, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.material.friction_combine is -1", world_add_shape, 31, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.material.friction_combine is 4", world_add_shape, 32, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.material.restitution_combine is -1", world_add_shape, 33, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.material.restitution_combine is 4", world_add_shape, 34, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.surface_velocity.y is NaN", world_add_shape, 35, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "def_value.one_way.y is NaN", world_add_shape, 36, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_shape", "result is null", world_add_shape, 37, CAIRN_ERROR_INVALID_VALUE},
    {"world_remove_shape", "world is null", world_remove_shape, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_remove_shape", "shape is stale", world_remove_shape, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_shape", "world is null", world_set_shape, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_shape", "shape is stale", world_set_shape, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_shape", "geometry is null", world_set_shape, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.kind is -1", world_set_shape, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.kind is 8", world_set_shape, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.sphere.radius is NaN", world_set_shape, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.box.half_extents.y is NaN", world_set_shape, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.box.rounding is NaN", world_set_shape, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.plane.normal.y is NaN", world_set_shape, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.plane.half_extents.x is NaN", world_set_shape, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.capsule.half_height is NaN", world_set_shape, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.capsule.radius is NaN", world_set_shape, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.capsule.radius_top is NaN", world_set_shape, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.cylinder.half_height is NaN", world_set_shape, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.cylinder.radius is NaN", world_set_shape, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.cylinder.radius_top is NaN", world_set_shape, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.cylinder.rounding is NaN", world_set_shape, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.hull.geometry is null", world_set_shape, 17, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.hull.rounding is NaN", world_set_shape, 18, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.mesh.geometry is null", world_set_shape, 19, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape", "geometry_value.as.height_field.geometry is null", world_set_shape, 20, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "world is null", world_set_shape_def, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_shape_def", "shape is stale", world_set_shape_def, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_shape_def", "def is null", world_set_shape_def, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.struct_size is 0", world_set_shape_def, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.struct_size is sizeof(cairn_shape_def) + 8", world_set_shape_def, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.position.y is NaN", world_set_shape_def, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.rotation.w is NaN", world_set_shape_def, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.density is NaN", world_set_shape_def, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.material.static_friction is NaN", world_set_shape_def, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.material.dynamic_friction is NaN", world_set_shape_def, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.material.restitution is NaN", world_set_shape_def, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.material.rolling_friction is NaN", world_set_shape_def, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.material.torsional_friction is NaN", world_set_shape_def, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.material.friction_combine is -1", world_set_shape_def, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.material.friction_combine is 4", world_set_shape_def, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.material.restitution_combine is -1", world_set_shape_def, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.material.restitution_combine is 4", world_set_shape_def, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.surface_velocity.y is NaN", world_set_shape_def, 17, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_shape_def", "def_value.one_way.y is NaN", world_set_shape_def, 18, CAIRN_ERROR_INVALID_VALUE},
    {"shape_get_body", "world is null", shape_get_body, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"shape_get_body", "shape is stale", shape_get_body, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"shape_get_body", "result is null", shape_get_body, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_shape", "world is null", world_get_shape, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_shape", "shape is stale", world_get_shape, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_shape", "result is null", world_get_shape, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_shape_def", "world is null", world_get_shape_def, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_shape_def", "shape is stale", world_get_shape_def, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_shape_def", "shape_def is null", world_get_shape_def, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_shape_def", "shape_def.struct_size is 1", world_get_shape_def, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_shape_transform", "world is null", world_get_shape_transform, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_shape_transform", "shape is stale", world_get_shape_transform, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_shape_transform", "shape_transform is null", world_get_shape_transform, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_shape_bounds", "world is null", world_get_shape_bounds, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_shape_bounds", "shape is stale", world_get_shape_bounds, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_shape_bounds", "shape_bounds is null", world_get_shape_bounds, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "world is null", world_set_material, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_material", "shape is stale", world_set_material, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_material", "material is null", world_set_material, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "material_value.static_friction is NaN", world_set_material, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "material_value.dynamic_friction is NaN", world_set_material, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "material_value.restitution is NaN", world_set_material, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "material_value.rolling_friction is NaN", world_set_material, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "material_value.torsional_friction is NaN", world_set_material, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "material_value.friction_combine is -1", world_set_material, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "material_value.friction_combine is 4", world_set_material, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "material_value.restitution_combine is -1", world_set_material, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_material", "material_value.restitution_combine is 4", world_set_material, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_filter", "world is null", world_set_filter, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_filter", "shape is stale", world_set_filter, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_filter", "filter is null", world_set_filter, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_surface_velocity", "world is null", world_set_surface_velocity, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_surface_velocity", "shape is stale", world_set_surface_velocity, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_surface_velocity", "velocity.y is NaN", world_set_surface_velocity, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "world is null", world_create_body, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_create_body", "def_value.struct_size is 0", world_create_body, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.struct_size is sizeof(cairn_body_def) + 8", world_create_body, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.type is -1", world_create_body, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.type is 3", world_create_body, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.position.z is NaN", world_create_body, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.rotation.w is NaN", world_create_body, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.linear_velocity.y is NaN", world_create_body, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.angular_velocity.y is NaN", world_create_body, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.linear_damping is NaN", world_create_body, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.angular_damping is NaN", world_create_body, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.gravity_scale is NaN", world_create_body, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.mass is NaN", world_create_body, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.mass_properties.mass is NaN", world_create_body, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.mass_properties.center_of_mass.y is NaN", world_create_body, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.mass_properties.inertia_diagonal.y is NaN", world_create_body, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "def_value.mass_properties.inertia_orientation.w is NaN", world_create_body, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_body", "result is null", world_create_body, 17, CAIRN_ERROR_INVALID_VALUE},
    {"world_destroy_body", "world is null", world_destroy_body, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_destroy_body", "body is stale", world_destroy_body, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_bodies", "world is null", world_get_bodies, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_bodies", "bodies is null", world_get_bodies, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_bodies", "count is null", world_get_bodies, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_find_body", "world is null", world_find_body, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_find_body", "name is null", world_find_body, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_find_body", "result is null", world_find_body, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_find_body", "found is null", world_find_body, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_type", "world is null", body_get_type, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_type", "body is stale", body_get_type, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_type", "body is null", body_get_type, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_type", "type is null", body_get_type, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_name", "world is null", body_get_name, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_name", "body is stale", body_get_name, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_name", "body is null", body_get_name, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_name", "text is null", body_get_name, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_name", "length is null", body_get_name, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_user_data", "world is null", body_get_user_data, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_user_data", "body is stale", body_get_user_data, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_user_data", "body is null", body_get_user_data, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_user_data", "user_data is null", body_get_user_data, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_position", "world is null", body_get_position, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_position", "body is stale", body_get_position, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_position", "body is null", body_get_position, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_position", "position is null", body_get_position, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_rotation", "world is null", body_get_rotation, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_rotation", "body is stale", body_get_rotation, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_rotation", "body is null", body_get_rotation, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_rotation", "rotation is null", body_get_rotation, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_transform", "world is null", body_get_transform, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_transform", "body is stale", body_get_transform, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_transform", "body is null", body_get_transform, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_transform", "transform is null", body_get_transform, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_center_of_mass", "world is null", body_get_center_of_mass, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_center_of_mass", "body is stale", body_get_center_of_mass, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_center_of_mass", "body is null", body_get_center_of_mass, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_center_of_mass", "center_of_mass is null", body_get_center_of_mass, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_linear_velocity", "world is null", body_get_linear_velocity, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_linear_velocity", "body is stale", body_get_linear_velocity, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_linear_velocity", "body is null", body_get_linear_velocity, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_linear_velocity", "linear_velocity is null", body_get_linear_velocity, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_angular_velocity", "world is null", body_get_angular_velocity, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_angular_velocity", "body is stale", body_get_angular_velocity, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_angular_velocity", "body is null", body_get_angular_velocity, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_angular_velocity", "angular_velocity is null", body_get_angular_velocity, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_velocity_at", "world is null", body_get_velocity_at, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_velocity_at", "body is stale", body_get_velocity_at, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_velocity_at", "body is null", body_get_velocity_at, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_velocity_at", "point.z is NaN", body_get_velocity_at, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_velocity_at", "velocity_at is null", body_get_velocity_at, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_mass", "world is null", body_get_mass, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_mass", "body is stale", body_get_mass, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_mass", "body is null", body_get_mass, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_mass", "mass is null", body_get_mass, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_mass_properties", "world is null", body_get_mass_properties, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_mass_properties", "body is stale", body_get_mass_properties, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_mass_properties", "body is null", body_get_mass_properties, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_mass_properties", "mass_properties is null", body_get_mass_properties, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_world_inertia", "world is null", body_get_world_inertia, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_world_inertia", "body is stale", body_get_world_inertia, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_world_inertia", "body is null", body_get_world_inertia, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_world_inertia", "world_inertia is null", body_get_world_inertia, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_angular_momentum", "world is null", body_get_angular_momentum, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_angular_momentum", "body is stale", body_get_angular_momentum, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_angular_momentum", "body is null", body_get_angular_momentum, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_angular_momentum", "angular_momentum is null", body_get_angular_momentum, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_kinetic_energy", "world is null", body_get_kinetic_energy, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_kinetic_energy", "body is stale", body_get_kinetic_energy, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_kinetic_energy", "body is null", body_get_kinetic_energy, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_kinetic_energy", "kinetic_energy is null", body_get_kinetic_energy, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_gravity_scale", "world is null", body_get_gravity_scale, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_gravity_scale", "body is stale", body_get_gravity_scale, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_gravity_scale", "body is null", body_get_gravity_scale, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_gravity_scale", "gravity_scale is null", body_get_gravity_scale, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_linear_damping", "world is null", body_get_linear_damping, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_linear_damping", "body is stale", body_get_linear_damping, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_linear_damping", "body is null", body_get_linear_damping, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_linear_damping", "linear_damping is null", body_get_linear_damping, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_angular_damping", "world is null", body_get_angular_damping, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_angular_damping", "body is stale", body_get_angular_damping, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_angular_damping", "body is null", body_get_angular_damping, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_angular_damping", "angular_damping is null", body_get_angular_damping, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_is_awake", "world is null", body_is_awake, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_is_awake", "body is stale", body_is_awake, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_is_awake", "body is null", body_is_awake, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_is_awake", "result is null", body_is_awake, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_allow_sleep", "world is null", body_get_allow_sleep, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_allow_sleep", "body is stale", body_get_allow_sleep, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_allow_sleep", "body is null", body_get_allow_sleep, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_allow_sleep", "allow_sleep is null", body_get_allow_sleep, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_enabled", "world is null", body_get_enabled, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_enabled", "body is stale", body_get_enabled, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_enabled", "body is null", body_get_enabled, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_enabled", "enabled is null", body_get_enabled, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_shapes", "world is null", body_get_shapes, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_shapes", "body is stale", body_get_shapes, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_shapes", "body is null", body_get_shapes, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_shapes", "shapes is null", body_get_shapes, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_shapes", "count is null", body_get_shapes, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_transform", "world is null", body_set_transform, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_transform", "body is stale", body_set_transform, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_transform", "body is null", body_set_transform, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_transform", "position.z is NaN", body_set_transform, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_transform", "rotation.w is NaN", body_set_transform, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_position", "world is null", body_set_position, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_position", "body is stale", body_set_position, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_position", "body is null", body_set_position, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_position", "position.z is NaN", body_set_position, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_rotation", "world is null", body_set_rotation, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_rotation", "body is stale", body_set_rotation, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_rotation", "body is null", body_set_rotation, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_rotation", "rotation.w is NaN", body_set_rotation, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_linear_velocity", "world is null", body_set_linear_velocity, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_linear_velocity", "body is stale", body_set_linear_velocity, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_linear_velocity", "body is null", body_set_linear_velocity, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_linear_velocity", "velocity.y is NaN", body_set_linear_velocity, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_angular_velocity", "world is null", body_set_angular_velocity, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_angular_velocity", "body is stale", body_set_angular_velocity, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_angular_velocity", "body is null", body_set_angular_velocity, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_angular_velocity", "velocity.y is NaN", body_set_angular_velocity, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_move_to", "world is null", body_move_to, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_move_to", "body is stale", body_move_to, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_move_to", "body is null", body_move_to, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_move_to", "target.position.z is NaN", body_move_to, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_move_to", "target.rotation.w is NaN", body_move_to, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_move_to", "seconds is NaN", body_move_to, 5, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_gravity_scale", "world is null", body_set_gravity_scale, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_gravity_scale", "body is stale", body_set_gravity_scale, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_gravity_scale", "body is null", body_set_gravity_scale, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_gravity_scale", "scale is NaN", body_set_gravity_scale, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_damping", "world is null", body_set_damping, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_damping", "body is stale", body_set_damping, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_damping", "body is null", body_set_damping, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_damping", "linear is NaN", body_set_damping, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_damping", "angular is NaN", body_set_damping, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_allow_sleep", "world is null", body_set_allow_sleep, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_allow_sleep", "body is stale", body_set_allow_sleep, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_allow_sleep", "body is null", body_set_allow_sleep, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_type", "world is null", body_set_type, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_type", "body is stale", body_set_type, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_type", "body is null", body_set_type, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_type", "type is -1", body_set_type, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_type", "type is 3", body_set_type, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_enabled", "world is null", body_set_enabled, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_enabled", "body is stale", body_set_enabled, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_enabled", "body is null", body_set_enabled, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_name", "world is null", body_set_name, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_name", "body is stale", body_set_name, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_name", "body is null", body_set_name, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_name", "name is null", body_set_name, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_mass_properties", "world is null", body_set_mass_properties, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_mass_properties", "body is stale", body_set_mass_properties, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_mass_properties", "body is null", body_set_mass_properties, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_mass_properties", "properties is null", body_set_mass_properties, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_mass_properties", "properties_value.mass is NaN", body_set_mass_properties, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_mass_properties", "properties_value.center_of_mass.y is NaN", body_set_mass_properties, 5, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_mass_properties", "properties_value.inertia_diagonal.y is NaN", body_set_mass_properties, 6, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_mass_properties", "properties_value.inertia_orientation.w is NaN", body_set_mass_properties, 7, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_mass_from_shapes", "world is null", body_set_mass_from_shapes, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_mass_from_shapes", "body is stale", body_set_mass_from_shapes, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_mass_from_shapes", "body is null", body_set_mass_from_shapes, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_mass_from_shapes", "mass_value is NaN", body_set_mass_from_shapes, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_wake", "world is null", body_wake, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_wake", "body is stale", body_wake, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_wake", "body is null", body_wake, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_sleep", "world is null", body_sleep, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_sleep", "body is stale", body_sleep, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_sleep", "body is null", body_sleep, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_force", "world is null", body_add_force, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_force", "body is stale", body_add_force, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_force", "body is null", body_add_force, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_force", "force.y is NaN", body_add_force, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_add_force_at", "world is null", body_add_force_at, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_force_at", "body is stale", body_add_force_at, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_force_at", "body is null", body_add_force_at, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_force_at", "force.y is NaN", body_add_force_at, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_add_force_at", "point.z is NaN", body_add_force_at, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_add_torque", "world is null", body_add_torque, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_torque", "body is stale", body_add_torque, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_torque", "body is null", body_add_torque, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_add_torque", "torque.y is NaN", body_add_torque, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_apply_impulse", "world is null", body_apply_impulse, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_apply_impulse", "body is stale", body_apply_impulse, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_apply_impulse", "body is null", body_apply_impulse, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_apply_impulse", "impulse.y is NaN", body_apply_impulse, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_apply_impulse_at", "world is null", body_apply_impulse_at, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_apply_impulse_at", "body is stale", body_apply_impulse_at, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_apply_impulse_at", "body is null", body_apply_impulse_at, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_apply_impulse_at", "impulse.y is NaN", body_apply_impulse_at, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_apply_impulse_at", "point.z is NaN", body_apply_impulse_at, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_apply_angular_impulse", "world is null", body_apply_angular_impulse, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_apply_angular_impulse", "body is stale", body_apply_angular_impulse, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_apply_angular_impulse", "body is null", body_apply_angular_impulse, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_apply_angular_impulse", "impulse.y is NaN", body_apply_angular_impulse, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_is_character", "world is null", body_is_character, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_is_character", "body is stale", body_is_character, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_is_character", "body is null", body_is_character, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_is_character", "result is null", body_is_character, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_character", "world is null", body_get_character, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_character", "body is stale", body_get_character, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_character", "body is null", body_get_character, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_character", "character is null", body_get_character, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_character", "character.struct_size is 1", body_get_character, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "world is null", body_set_character, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_character", "body is stale", body_set_character, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_character", "body is null", body_set_character, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_character", "def is null", body_set_character, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.struct_size is 0", body_set_character, 4, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.struct_size is sizeof(cairn_character_def) + 8", body_set_character, 5, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.up.y is NaN", body_set_character, 6, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.max_slope is NaN", body_set_character, 7, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.step_height is NaN", body_set_character, 8, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.stick_distance is NaN", body_set_character, 9, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.skin is NaN", body_set_character, 10, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.mass is NaN", body_set_character, 11, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.max_push_force is NaN", body_set_character, 12, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_character", "def_value.air_acceleration is NaN", body_set_character, 13, CAIRN_ERROR_INVALID_VALUE},
    {"body_remove_character", "world is null", body_remove_character, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_remove_character", "body is stale", body_remove_character, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_remove_character", "body is null", body_remove_character, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_walk_velocity", "world is null", body_get_walk_velocity, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_walk_velocity", "body is stale", body_get_walk_velocity, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_walk_velocity", "body is null", body_get_walk_velocity, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_walk_velocity", "walk_velocity is null", body_get_walk_velocity, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_set_walk_velocity", "world is null", body_set_walk_velocity, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_walk_velocity", "body is stale", body_set_walk_velocity, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_walk_velocity", "body is null", body_set_walk_velocity, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_set_walk_velocity", "velocity.y is NaN", body_set_walk_velocity, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_jump", "world is null", body_jump, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_jump", "body is stale", body_jump, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_jump", "body is null", body_jump, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_jump", "speed is NaN", body_jump, 3, CAIRN_ERROR_INVALID_VALUE},
    {"body_character_state", "world is null", body_character_state, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_character_state", "body is stale", body_character_state, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_character_state", "body is null", body_character_state, 2, CAIRN_ERROR_INVALID_HANDLE},
    {"body_character_state", "result is null", body_character_state, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "world is null", world_create_joint, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_create_joint", "def is null", world_create_joint, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.struct_size is 0", world_create_joint, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.struct_size is sizeof(cairn_joint_def) + 8", world_create_joint, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.body_a is stale", world_create_joint, 4, CAIRN_ERROR_INVALID_HANDLE},
    {"world_create_joint", "def_value.body_b is stale", world_create_joint, 5, CAIRN_ERROR_INVALID_HANDLE},
    {"world_create_joint", "def_value.frame_a.position.z is NaN", world_create_joint, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.frame_a.rotation.w is NaN", world_create_joint, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.frame_b.position.z is NaN", world_create_joint, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.frame_b.rotation.w is NaN", world_create_joint, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.kind is -1", world_create_joint, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.kind is 13", world_create_joint, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.ball.cone_angle is NaN", world_create_joint, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.ball.twist.lower is NaN", world_create_joint, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.ball.twist.upper is NaN", world_create_joint, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.ball.twist.spring.stiffness is NaN", world_create_joint, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.ball.twist.spring.damping is NaN", world_create_joint, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.ball.friction is NaN", world_create_joint, 17, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.limits.lower is NaN", world_create_joint, 18, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.limits.upper is NaN", world_create_joint, 19, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.limits.spring.stiffness is NaN", world_create_joint, 20, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.limits.spring.damping is NaN", world_create_joint, 21, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.motor.velocity is NaN", world_create_joint, 22, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.motor.position is NaN", world_create_joint, 23, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.motor.spring.stiffness is NaN", world_create_joint, 24, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.motor.spring.damping is NaN", world_create_joint, 25, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.motor.max_force is NaN", world_create_joint, 26, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.hinge.angle.friction is NaN", world_create_joint, 27, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.limits.lower is NaN", world_create_joint, 28, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.limits.upper is NaN", world_create_joint, 29, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.limits.spring.stiffness is NaN", world_create_joint, 30, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.limits.spring.damping is NaN", world_create_joint, 31, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.motor.velocity is NaN", world_create_joint, 32, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.motor.position is NaN", world_create_joint, 33, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.motor.spring.stiffness is NaN", world_create_joint, 34, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.motor.spring.damping is NaN", world_create_joint, 35, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.motor.max_force is NaN", world_create_joint, 36, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.slider.translation.friction is NaN", world_create_joint, 37, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.limits.lower is NaN", world_create_joint, 38, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.limits.upper is NaN", world_create_joint, 39, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.limits.spring.stiffness is NaN", world_create_joint, 40, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.limits.spring.damping is NaN", world_create_joint, 41, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.motor.velocity is NaN", world_create_joint, 42, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.motor.position is NaN", world_create_joint, 43, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.motor.spring.stiffness is NaN", world_create_joint, 44, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.motor.spring.damping is NaN", world_create_joint, 45, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.motor.max_force is NaN", world_create_joint, 46, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.translation.friction is NaN", world_create_joint, 47, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.limits.lower is NaN", world_create_joint, 48, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.limits.upper is NaN", world_create_joint, 49, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.limits.spring.stiffness is NaN", world_create_joint, 50, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.limits.spring.damping is NaN", world_create_joint, 51, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.motor.velocity is NaN", world_create_joint, 52, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.motor.position is NaN", world_create_joint, 53, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.motor.spring.stiffness is NaN", world_create_joint, 54, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.motor.spring.damping is NaN", world_create_joint, 55, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.motor.max_force is NaN", world_create_joint, 56, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.cylindrical.angle.friction is NaN", world_create_joint, 57, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.limits.lower is NaN", world_create_joint, 58, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.limits.upper is NaN", world_create_joint, 59, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.limits.spring.stiffness is NaN", world_create_joint, 60, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.limits.spring.damping is NaN", world_create_joint, 61, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.motor.velocity is NaN", world_create_joint, 62, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.motor.position is NaN", world_create_joint, 63, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.motor.spring.stiffness is NaN", world_create_joint, 64, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.motor.spring.damping is NaN", world_create_joint, 65, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.motor.max_force is NaN", world_create_joint, 66, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.first.friction is NaN", world_create_joint, 67, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.limits.lower is NaN", world_create_joint, 68, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.limits.upper is NaN", world_create_joint, 69, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.limits.spring.stiffness is NaN", world_create_joint, 70, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.limits.spring.damping is NaN", world_create_joint, 71, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.motor.velocity is NaN", world_create_joint, 72, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.motor.position is NaN", world_create_joint, 73, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.motor.spring.stiffness is NaN", world_create_joint, 74, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.motor.spring.damping is NaN", world_create_joint, 75, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.motor.max_force is NaN", world_create_joint, 76, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.universal.second.friction is NaN", world_create_joint, 77, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.limits.lower is NaN", world_create_joint, 78, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.limits.upper is NaN", world_create_joint, 79, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.limits.spring.stiffness is NaN", world_create_joint, 80, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.limits.spring.damping is NaN", world_create_joint, 81, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.motor.velocity is NaN", world_create_joint, 82, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.motor.position is NaN", world_create_joint, 83, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.motor.spring.stiffness is NaN", world_create_joint, 84, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.motor.spring.damping is NaN", world_create_joint, 85, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.motor.max_force is NaN", world_create_joint, 86, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.distance.distance.friction is NaN", world_create_joint, 87, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.limits.lower is NaN", world_create_joint, 88, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.limits.upper is NaN", world_create_joint, 89, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.limits.spring.stiffness is NaN", world_create_joint, 90, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.limits.spring.damping is NaN", world_create_joint, 91, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.motor.velocity is NaN", world_create_joint, 92, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.motor.position is NaN", world_create_joint, 93, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.motor.spring.stiffness is NaN", world_create_joint, 94, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.motor.spring.damping is NaN", world_create_joint, 95, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.motor.max_force is NaN", world_create_joint, 96, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.suspension.friction is NaN", world_create_joint, 97, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.limits.lower is NaN", world_create_joint, 98, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.limits.upper is NaN", world_create_joint, 99, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.limits.spring.stiffness is NaN", world_create_joint, 100, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.limits.spring.damping is NaN", world_create_joint, 101, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.motor.velocity is NaN", world_create_joint, 102, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.motor.position is NaN", world_create_joint, 103, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.motor.spring.stiffness is NaN", world_create_joint, 104, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.motor.spring.damping is NaN", world_create_joint, 105, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.motor.max_force is NaN", world_create_joint, 106, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.steering.friction is NaN", world_create_joint, 107, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.limits.lower is NaN", world_create_joint, 108, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.limits.upper is NaN", world_create_joint, 109, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.limits.spring.stiffness is NaN", world_create_joint, 110, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.limits.spring.damping is NaN", world_create_joint, 111, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.motor.velocity is NaN", world_create_joint, 112, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.motor.position is NaN", world_create_joint, 113, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.motor.spring.stiffness is NaN", world_create_joint, 114, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.motor.spring.damping is NaN", world_create_joint, 115, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.motor.max_force is NaN", world_create_joint, 116, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.wheel.spin.friction is NaN", world_create_joint, 117, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.servo.position.y is NaN", world_create_joint, 118, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.servo.rotation.w is NaN", world_create_joint, 119, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.servo.linear.stiffness is NaN", world_create_joint, 120, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.servo.linear.damping is NaN", world_create_joint, 121, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.servo.angular.stiffness is NaN", world_create_joint, 122, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.servo.angular.damping is NaN", world_create_joint, 123, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.servo.max_force is NaN", world_create_joint, 124, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.servo.max_torque is NaN", world_create_joint, 125, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.gear.ratio is NaN", world_create_joint, 126, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.rack.radius is NaN", world_create_joint, 127, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.pulley.ground_a.z is NaN", world_create_joint, 128, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.pulley.ground_b.z is NaN", world_create_joint, 129, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.pulley.ratio is NaN", world_create_joint, 130, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.pulley.length is NaN", world_create_joint, 131, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.general.limits is null", world_create_joint, 132, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.joint.as.general.drives is null", world_create_joint, 133, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.break_force is NaN", world_create_joint, 134, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.break_torque is NaN", world_create_joint, 135, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.solver is -1", world_create_joint, 136, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "def_value.solver is 3", world_create_joint, 137, CAIRN_ERROR_INVALID_VALUE},
    {"world_create_joint", "result is null", world_create_joint, 138, CAIRN_ERROR_INVALID_VALUE},
    {"world_destroy_joint", "world is null", world_destroy_joint, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_destroy_joint", "joint is stale", world_destroy_joint, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_joint_def", "world is null", world_get_joint_def, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_joint_def", "joint is stale", world_get_joint_def, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_joint_def", "joint_def is null", world_get_joint_def, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_joint_def", "joint_def.struct_size is 1", world_get_joint_def, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "world is null", world_set_joint, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_joint", "id is stale", world_set_joint, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_joint", "joint is null", world_set_joint, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.kind is -1", world_set_joint, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.kind is 13", world_set_joint, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.ball.cone_angle is NaN", world_set_joint, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.ball.twist.lower is NaN", world_set_joint, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.ball.twist.upper is NaN", world_set_joint, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.ball.twist.spring.stiffness is NaN", world_set_joint, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.ball.twist.spring.damping is NaN", world_set_joint, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.ball.friction is NaN", world_set_joint, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.limits.lower is NaN", world_set_joint, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.limits.upper is NaN", world_set_joint, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.limits.spring.stiffness is NaN", world_set_joint, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.limits.spring.damping is NaN", world_set_joint, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.motor.velocity is NaN", world_set_joint, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.motor.position is NaN", world_set_joint, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.motor.spring.stiffness is NaN", world_set_joint, 17, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.motor.spring.damping is NaN", world_set_joint, 18, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.motor.max_force is NaN", world_set_joint, 19, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.hinge.angle.friction is NaN", world_set_joint, 20, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.limits.lower is NaN", world_set_joint, 21, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.limits.upper is NaN", world_set_joint, 22, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.limits.spring.stiffness is NaN", world_set_joint, 23, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.limits.spring.damping is NaN", world_set_joint, 24, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.motor.velocity is NaN", world_set_joint, 25, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.motor.position is NaN", world_set_joint, 26, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.motor.spring.stiffness is NaN", world_set_joint, 27, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.motor.spring.damping is NaN", world_set_joint, 28, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.motor.max_force is NaN", world_set_joint, 29, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.slider.translation.friction is NaN", world_set_joint, 30, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.limits.lower is NaN", world_set_joint, 31, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.limits.upper is NaN", world_set_joint, 32, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.limits.spring.stiffness is NaN", world_set_joint, 33, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.limits.spring.damping is NaN", world_set_joint, 34, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.motor.velocity is NaN", world_set_joint, 35, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.motor.position is NaN", world_set_joint, 36, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.motor.spring.stiffness is NaN", world_set_joint, 37, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.motor.spring.damping is NaN", world_set_joint, 38, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.motor.max_force is NaN", world_set_joint, 39, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.translation.friction is NaN", world_set_joint, 40, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.limits.lower is NaN", world_set_joint, 41, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.limits.upper is NaN", world_set_joint, 42, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.limits.spring.stiffness is NaN", world_set_joint, 43, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.limits.spring.damping is NaN", world_set_joint, 44, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.motor.velocity is NaN", world_set_joint, 45, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.motor.position is NaN", world_set_joint, 46, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.motor.spring.stiffness is NaN", world_set_joint, 47, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.motor.spring.damping is NaN", world_set_joint, 48, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.motor.max_force is NaN", world_set_joint, 49, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.cylindrical.angle.friction is NaN", world_set_joint, 50, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.limits.lower is NaN", world_set_joint, 51, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.limits.upper is NaN", world_set_joint, 52, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.limits.spring.stiffness is NaN", world_set_joint, 53, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.limits.spring.damping is NaN", world_set_joint, 54, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.motor.velocity is NaN", world_set_joint, 55, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.motor.position is NaN", world_set_joint, 56, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.motor.spring.stiffness is NaN", world_set_joint, 57, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.motor.spring.damping is NaN", world_set_joint, 58, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.motor.max_force is NaN", world_set_joint, 59, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.first.friction is NaN", world_set_joint, 60, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.limits.lower is NaN", world_set_joint, 61, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.limits.upper is NaN", world_set_joint, 62, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.limits.spring.stiffness is NaN", world_set_joint, 63, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.limits.spring.damping is NaN", world_set_joint, 64, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.motor.velocity is NaN", world_set_joint, 65, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.motor.position is NaN", world_set_joint, 66, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.motor.spring.stiffness is NaN", world_set_joint, 67, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.motor.spring.damping is NaN", world_set_joint, 68, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.motor.max_force is NaN", world_set_joint, 69, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.universal.second.friction is NaN", world_set_joint, 70, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.limits.lower is NaN", world_set_joint, 71, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.limits.upper is NaN", world_set_joint, 72, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.limits.spring.stiffness is NaN", world_set_joint, 73, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.limits.spring.damping is NaN", world_set_joint, 74, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.motor.velocity is NaN", world_set_joint, 75, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.motor.position is NaN", world_set_joint, 76, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.motor.spring.stiffness is NaN", world_set_joint, 77, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.motor.spring.damping is NaN", world_set_joint, 78, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.motor.max_force is NaN", world_set_joint, 79, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.distance.distance.friction is NaN", world_set_joint, 80, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.limits.lower is NaN", world_set_joint, 81, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.limits.upper is NaN", world_set_joint, 82, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.limits.spring.stiffness is NaN", world_set_joint, 83, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.limits.spring.damping is NaN", world_set_joint, 84, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.motor.velocity is NaN", world_set_joint, 85, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.motor.position is NaN", world_set_joint, 86, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.motor.spring.stiffness is NaN", world_set_joint, 87, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.motor.spring.damping is NaN", world_set_joint, 88, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.motor.max_force is NaN", world_set_joint, 89, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.suspension.friction is NaN", world_set_joint, 90, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.limits.lower is NaN", world_set_joint, 91, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.limits.upper is NaN", world_set_joint, 92, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.limits.spring.stiffness is NaN", world_set_joint, 93, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.limits.spring.damping is NaN", world_set_joint, 94, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.motor.velocity is NaN", world_set_joint, 95, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.motor.position is NaN", world_set_joint, 96, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.motor.spring.stiffness is NaN", world_set_joint, 97, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.motor.spring.damping is NaN", world_set_joint, 98, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.motor.max_force is NaN", world_set_joint, 99, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.steering.friction is NaN", world_set_joint, 100, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.limits.lower is NaN", world_set_joint, 101, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.limits.upper is NaN", world_set_joint, 102, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.limits.spring.stiffness is NaN", world_set_joint, 103, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.limits.spring.damping is NaN", world_set_joint, 104, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.motor.velocity is NaN", world_set_joint, 105, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.motor.position is NaN", world_set_joint, 106, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.motor.spring.stiffness is NaN", world_set_joint, 107, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.motor.spring.damping is NaN", world_set_joint, 108, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.motor.max_force is NaN", world_set_joint, 109, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.wheel.spin.friction is NaN", world_set_joint, 110, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.servo.position.y is NaN", world_set_joint, 111, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.servo.rotation.w is NaN", world_set_joint, 112, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.servo.linear.stiffness is NaN", world_set_joint, 113, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.servo.linear.damping is NaN", world_set_joint, 114, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.servo.angular.stiffness is NaN", world_set_joint, 115, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.servo.angular.damping is NaN", world_set_joint, 116, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.servo.max_force is NaN", world_set_joint, 117, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.servo.max_torque is NaN", world_set_joint, 118, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.gear.ratio is NaN", world_set_joint, 119, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.rack.radius is NaN", world_set_joint, 120, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.pulley.ground_a.z is NaN", world_set_joint, 121, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.pulley.ground_b.z is NaN", world_set_joint, 122, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.pulley.ratio is NaN", world_set_joint, 123, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.pulley.length is NaN", world_set_joint, 124, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.general.limits is null", world_set_joint, 125, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint", "joint_value.as.general.drives is null", world_set_joint, 126, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint_strength", "world is null", world_set_joint_strength, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_joint_strength", "joint is stale", world_set_joint_strength, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_joint_strength", "break_force is NaN", world_set_joint_strength, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint_strength", "break_torque is NaN", world_set_joint_strength, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_joint_enabled", "world is null", world_set_joint_enabled, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_joint_enabled", "joint is stale", world_set_joint_enabled, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_joint_state", "world is null", world_get_joint_state, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_joint_state", "joint is stale", world_get_joint_state, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_joint_state", "joint_state is null", world_get_joint_state, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_joints", "world is null", world_get_joints, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_joints", "joints is null", world_get_joints, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_joints", "count is null", world_get_joints, 2, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_joints", "world is null", body_get_joints, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_joints", "body is stale", body_get_joints, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_joints", "joints is null", body_get_joints, 2, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_joints", "count is null", body_get_joints, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_find_joint", "world is null", world_find_joint, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_find_joint", "name is null", world_find_joint, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_find_joint", "result is null", world_find_joint, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_find_joint", "found is null", world_find_joint, 3, CAIRN_ERROR_INVALID_VALUE},
    {"joint_get_name", "world is null", joint_get_name, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"joint_get_name", "joint is stale", joint_get_name, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"joint_get_name", "text is null", joint_get_name, 2, CAIRN_ERROR_INVALID_VALUE},
    {"joint_get_name", "length is null", joint_get_name, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray", "world is null", world_cast_ray, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_cast_ray", "origin.z is NaN", world_cast_ray, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray", "direction.y is NaN", world_cast_ray, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray", "max_distance is NaN", world_cast_ray, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray", "filter_value.struct_size is 0", world_cast_ray, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray", "filter_value.struct_size is sizeof(cairn_query_filter) + 8", world_cast_ray, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray", "filter_value.ignored_bodies is null", world_cast_ray, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray", "result is null", world_cast_ray, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray", "found is null", world_cast_ray, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray_all", "world is null", world_cast_ray_all, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_cast_ray_all", "origin.z is NaN", world_cast_ray_all, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray_all", "direction.y is NaN", world_cast_ray_all, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray_all", "max_distance is NaN", world_cast_ray_all, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray_all", "filter_value.struct_size is 0", world_cast_ray_all, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray_all", "filter_value.struct_size is sizeof(cairn_query_filter) + 8", world_cast_ray_all, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray_all", "filter_value.ignored_bodies is null", world_cast_ray_all, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray_all", "result is null", world_cast_ray_all, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_ray_all", "count is null", world_cast_ray_all, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "world is null", world_cast_shape, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_cast_shape", "shape is null", world_cast_shape, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.kind is -1", world_cast_shape, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.kind is 8", world_cast_shape, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.sphere.radius is NaN", world_cast_shape, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.box.half_extents.y is NaN", world_cast_shape, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.box.rounding is NaN", world_cast_shape, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.plane.normal.y is NaN", world_cast_shape, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.plane.half_extents.x is NaN", world_cast_shape, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.capsule.half_height is NaN", world_cast_shape, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.capsule.radius is NaN", world_cast_shape, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.capsule.radius_top is NaN", world_cast_shape, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.cylinder.half_height is NaN", world_cast_shape, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.cylinder.radius is NaN", world_cast_shape, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.cylinder.radius_top is NaN", world_cast_shape, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.cylinder.rounding is NaN", world_cast_shape, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.hull.geometry is null", world_cast_shape, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.hull.rounding is NaN", world_cast_shape, 17, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.mesh.geometry is null", world_cast_shape, 18, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "shape_value.as.height_field.geometry is null", world_cast_shape, 19, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "start.position.z is NaN", world_cast_shape, 20, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "start.rotation.w is NaN", world_cast_shape, 21, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "translation.y is NaN", world_cast_shape, 22, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "filter_value.struct_size is 0", world_cast_shape, 23, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "filter_value.struct_size is sizeof(cairn_query_filter) + 8", world_cast_shape, 24, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "filter_value.ignored_bodies is null", world_cast_shape, 25, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "result is null", world_cast_shape, 26, CAIRN_ERROR_INVALID_VALUE},
    {"world_cast_shape", "found is null", world_cast_shape, 27, CAIRN_ERROR_INVALID_VALUE},
    {"world_closest_point", "world is null", world_closest_point, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_closest_point", "point.z is NaN", world_closest_point, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_closest_point", "max_distance is NaN", world_closest_point, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_closest_point", "filter_value.struct_size is 0", world_closest_point, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_closest_point", "filter_value.struct_size is sizeof(cairn_query_filter) + 8", world_closest_point, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_closest_point", "filter_value.ignored_bodies is null", world_closest_point, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_closest_point", "result is null", world_closest_point, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_closest_point", "found is null", world_closest_point, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "world is null", world_overlap, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_overlap", "shape is null", world_overlap, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.kind is -1", world_overlap, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.kind is 8", world_overlap, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.sphere.radius is NaN", world_overlap, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.box.half_extents.y is NaN", world_overlap, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.box.rounding is NaN", world_overlap, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.plane.normal.y is NaN", world_overlap, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.plane.half_extents.x is NaN", world_overlap, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.capsule.half_height is NaN", world_overlap, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.capsule.radius is NaN", world_overlap, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.capsule.radius_top is NaN", world_overlap, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.cylinder.half_height is NaN", world_overlap, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.cylinder.radius is NaN", world_overlap, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.cylinder.radius_top is NaN", world_overlap, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.cylinder.rounding is NaN", world_overlap, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.hull.geometry is null", world_overlap, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.hull.rounding is NaN", world_overlap, 17, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.mesh.geometry is null", world_overlap, 18, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "shape_value.as.height_field.geometry is null", world_overlap, 19, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "pose.position.z is NaN", world_overlap, 20, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "pose.rotation.w is NaN", world_overlap, 21, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "filter_value.struct_size is 0", world_overlap, 22, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "filter_value.struct_size is sizeof(cairn_query_filter) + 8", world_overlap, 23, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "filter_value.ignored_bodies is null", world_overlap, 24, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "result is null", world_overlap, 25, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap", "count is null", world_overlap, 26, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap_bounds", "world is null", world_overlap_bounds, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_overlap_bounds", "bounds.min.z is NaN", world_overlap_bounds, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap_bounds", "bounds.max.z is NaN", world_overlap_bounds, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap_bounds", "filter_value.struct_size is 0", world_overlap_bounds, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap_bounds", "filter_value.struct_size is sizeof(cairn_query_filter) + 8", world_overlap_bounds, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap_bounds", "filter_value.ignored_bodies is null", world_overlap_bounds, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap_bounds", "result is null", world_overlap_bounds, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_overlap_bounds", "count is null", world_overlap_bounds, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_broad_phase_nodes", "world is null", world_broad_phase_nodes, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_broad_phase_nodes", "result is null", world_broad_phase_nodes, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_broad_phase_nodes", "count is null", world_broad_phase_nodes, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_solver_contacts", "world is null", world_solver_contacts, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_solver_contacts", "result is null", world_solver_contacts, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_solver_contacts", "count is null", world_solver_contacts, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_debug_lines", "world is null", world_debug_lines, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_debug_lines", "what_value.struct_size is 0", world_debug_lines, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_debug_lines", "what_value.struct_size is sizeof(cairn_debug_lines_def) + 8", world_debug_lines, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_debug_lines", "what_value.size is NaN", world_debug_lines, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_debug_lines", "what_value.impulse_scale is NaN", world_debug_lines, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_debug_lines", "result is null", world_debug_lines, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_debug_lines", "count is null", world_debug_lines, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_contact_begins", "world is null", world_get_contact_begins, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_contact_begins", "contact_begins is null", world_get_contact_begins, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_contact_begins", "count is null", world_get_contact_begins, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_contact_ends", "world is null", world_get_contact_ends, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_contact_ends", "contact_ends is null", world_get_contact_ends, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_contact_ends", "count is null", world_get_contact_ends, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_contact_hits", "world is null", world_get_contact_hits, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_contact_hits", "contact_hits is null", world_get_contact_hits, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_contact_hits", "count is null", world_get_contact_hits, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_trigger_events", "world is null", world_get_trigger_events, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_trigger_events", "trigger_events is null", world_get_trigger_events, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_trigger_events", "count is null", world_get_trigger_events, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_joint_events", "world is null", world_get_joint_events, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_joint_events", "joint_events is null", world_get_joint_events, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_joint_events", "count is null", world_get_joint_events, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_sleep_events", "world is null", world_get_sleep_events, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_sleep_events", "sleep_events is null", world_get_sleep_events, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_sleep_events", "count is null", world_get_sleep_events, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_contacts", "world is null", world_get_contacts, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_contacts", "contacts is null", world_get_contacts, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_contacts", "count is null", world_get_contacts, 2, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_contacts", "world is null", body_get_contacts, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_contacts", "body is stale", body_get_contacts, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"body_get_contacts", "contacts is null", body_get_contacts, 2, CAIRN_ERROR_INVALID_VALUE},
    {"body_get_contacts", "count is null", body_get_contacts, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_settings", "world is null", world_get_settings, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_settings", "settings is null", world_get_settings, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_settings", "settings.struct_size is 1", world_get_settings, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "world is null", world_set_settings, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_settings", "def is null", world_set_settings, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.struct_size is 0", world_set_settings, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.struct_size is sizeof(cairn_world_def) + 8", world_set_settings, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.gravity.y is NaN", world_set_settings, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.integrator is -1", world_set_settings, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.integrator is 3", world_set_settings, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.sleep_speed is NaN", world_set_settings, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.sleep_time is NaN", world_set_settings, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.restitution_speed is NaN", world_set_settings, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.hit_speed is NaN", world_set_settings, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.recovery_speed is NaN", world_set_settings, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.max_linear_speed is NaN", world_set_settings, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_settings", "def_value.max_angular_speed is NaN", world_set_settings, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_usual_substeps", "world is null", world_usual_substeps, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_usual_substeps", "dt is NaN", world_usual_substeps, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_usual_substeps", "result is null", world_usual_substeps, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_threads", "world is null", world_set_threads, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_threads", "world is null", world_get_threads, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_threads", "threads is null", world_get_threads, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "world is null", world_add_force_field, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_add_force_field", "field is null", world_add_force_field, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.struct_size is 0", world_add_force_field, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.struct_size is sizeof(cairn_force_field) + 8", world_add_force_field, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.kind is -1", world_add_force_field, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.kind is 3", world_add_force_field, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.direction.y is NaN", world_add_force_field, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.center.z is NaN", world_add_force_field, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.strength is NaN", world_add_force_field, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.exponent is NaN", world_add_force_field, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.half_extents.y is NaN", world_add_force_field, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.density is NaN", world_add_force_field, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.drag is NaN", world_add_force_field, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.skin_friction is NaN", world_add_force_field, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.added_mass is NaN", world_add_force_field, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "field_value.wave_damping is NaN", world_add_force_field, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_add_force_field", "result is null", world_add_force_field, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "world is null", world_set_force_field, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_force_field", "id is stale", world_set_force_field, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_set_force_field", "field is null", world_set_force_field, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.struct_size is 0", world_set_force_field, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.struct_size is sizeof(cairn_force_field) + 8", world_set_force_field, 4, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.kind is -1", world_set_force_field, 5, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.kind is 3", world_set_force_field, 6, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.direction.y is NaN", world_set_force_field, 7, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.center.z is NaN", world_set_force_field, 8, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.strength is NaN", world_set_force_field, 9, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.exponent is NaN", world_set_force_field, 10, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.half_extents.y is NaN", world_set_force_field, 11, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.density is NaN", world_set_force_field, 12, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.drag is NaN", world_set_force_field, 13, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.skin_friction is NaN", world_set_force_field, 14, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.added_mass is NaN", world_set_force_field, 15, CAIRN_ERROR_INVALID_VALUE},
    {"world_set_force_field", "field_value.wave_damping is NaN", world_set_force_field, 16, CAIRN_ERROR_INVALID_VALUE},
    {"world_remove_force_field", "world is null", world_remove_force_field, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_remove_force_field", "id is stale", world_remove_force_field, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_force_field", "world is null", world_get_force_field, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_force_field", "id is stale", world_get_force_field, 1, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_force_field", "force_field is null", world_get_force_field, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_force_field", "force_field.struct_size is 1", world_get_force_field, 3, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_force_fields", "world is null", world_get_force_fields, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_force_fields", "force_fields is null", world_get_force_fields, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_force_fields", "count is null", world_get_force_fields, 2, CAIRN_ERROR_INVALID_VALUE},
    {"world_step", "world is null", world_step, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_step", "dt is NaN", world_step, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_step_count", "world is null", world_get_step_count, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_step_count", "step_count is null", world_get_step_count, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_time", "world is null", world_get_time, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_time", "time is null", world_get_time, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_kinetic_energy", "world is null", world_get_kinetic_energy, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_kinetic_energy", "kinetic_energy is null", world_get_kinetic_energy, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_potential_energy", "world is null", world_get_potential_energy, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_potential_energy", "potential_energy is null", world_get_potential_energy, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_linear_momentum", "world is null", world_get_linear_momentum, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_linear_momentum", "linear_momentum is null", world_get_linear_momentum, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_angular_momentum", "world is null", world_get_angular_momentum, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_angular_momentum", "angular_momentum is null", world_get_angular_momentum, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_state_hash", "world is null", world_get_state_hash, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_state_hash", "state_hash is null", world_get_state_hash, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_statistics", "world is null", world_get_statistics, 0, CAIRN_ERROR_INVALID_HANDLE},
    {"world_get_statistics", "statistics is null", world_get_statistics, 1, CAIRN_ERROR_INVALID_VALUE},
    {"world_get_statistics", "statistics.struct_size is 1", world_get_statistics, 2, CAIRN_ERROR_INVALID_VALUE},
};
const int wrong_call_count = (int)(sizeof wrong_calls / sizeof wrong_calls[0]);
