// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"
#include "c_api/support.h"

#include <cairn/c/cairn.h>

using namespace cairn::c_api;
using namespace cairn;

cairn_result cairn_world_create_body(cairn_world* world, const cairn_body_def* def, cairn_body_id* result) {
    return guarded([&] {
        required(result, "result");
        *result = to_c(world_of(world).create_body(def ? to_cpp(versioned(*def, "def", cairn_default_body_def()))
            : BodyDef{}));
    });
}

cairn_result cairn_world_destroy_body(cairn_world* world, cairn_body_id body) {
    return guarded([&] {
        world_of(world).destroy_body(to_cpp(body));
    });
}

bool cairn_body_is_valid(const cairn_world* world, cairn_body_id body) {
    return world && world_of(world).is_valid(to_cpp(body));
}

cairn_result cairn_world_get_bodies(const cairn_world* world, cairn_body_id* bodies, size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(bodies, capacity, count, "bodies");
        write_list(world_of(world).bodies(), bodies, capacity, count, [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_find_body(const cairn_world* world, const char* name, cairn_body_id* result, bool* found) {
    return guarded([&] {
        required(result, "result");
        required(found, "found");
        const auto answer = world_of(world).find_body(required_text(name, "name"));
        *found = answer.has_value();
        if (answer) *result = to_c(*answer);
    });
}

cairn_result cairn_body_get_type(const cairn_world* world, cairn_body_id body, cairn_body_type* type) {
    return guarded([&] {
        required(type, "type");
        *type = cairn_body_type(world_of(world).body(to_cpp(body)).type());
    });
}

cairn_result cairn_body_get_name(const cairn_world* world, cairn_body_id body, char* text, size_t capacity,
                                 size_t* length) {
    return guarded([&] {
        require_room(text, capacity, length, "text");
        write_text(world_of(world).body(to_cpp(body)).name(), text, capacity, length);
    });
}

cairn_result cairn_body_get_user_data(const cairn_world* world, cairn_body_id body, uint64_t* user_data) {
    return guarded([&] {
        required(user_data, "user_data");
        *user_data = world_of(world).body(to_cpp(body)).user_data();
    });
}

cairn_result cairn_body_get_position(const cairn_world* world, cairn_body_id body, cairn_position* position) {
    return guarded([&] {
        required(position, "position");
        *position = to_c(world_of(world).body(to_cpp(body)).position());
    });
}

cairn_result cairn_body_get_rotation(const cairn_world* world, cairn_body_id body, cairn_quat* rotation) {
    return guarded([&] {
        required(rotation, "rotation");
        *rotation = to_c(world_of(world).body(to_cpp(body)).rotation());
    });
}

cairn_result cairn_body_get_transform(const cairn_world* world, cairn_body_id body, cairn_transform* transform) {
    return guarded([&] {
        required(transform, "transform");
        *transform = to_c(world_of(world).body(to_cpp(body)).transform());
    });
}

cairn_result cairn_body_get_center_of_mass(const cairn_world* world, cairn_body_id body,
                                           cairn_position* center_of_mass) {
    return guarded([&] {
        required(center_of_mass, "center_of_mass");
        *center_of_mass = to_c(world_of(world).body(to_cpp(body)).center_of_mass());
    });
}

cairn_result cairn_body_get_linear_velocity(const cairn_world* world, cairn_body_id body, cairn_vec3* linear_velocity) {
    return guarded([&] {
        required(linear_velocity, "linear_velocity");
        *linear_velocity = to_c(world_of(world).body(to_cpp(body)).linear_velocity());
    });
}

cairn_result cairn_body_get_angular_velocity(const cairn_world* world, cairn_body_id body,
                                             cairn_vec3* angular_velocity) {
    return guarded([&] {
        required(angular_velocity, "angular_velocity");
        *angular_velocity = to_c(world_of(world).body(to_cpp(body)).angular_velocity());
    });
}

cairn_result cairn_body_get_velocity_at(const cairn_world* world, cairn_body_id body, cairn_position point,
                                        cairn_vec3* velocity_at) {
    return guarded([&] {
        required(velocity_at, "velocity_at");
        *velocity_at = to_c(world_of(world).body(to_cpp(body)).velocity_at(to_cpp(point)));
    });
}

cairn_result cairn_body_get_mass(const cairn_world* world, cairn_body_id body, float* mass) {
    return guarded([&] {
        required(mass, "mass");
        *mass = world_of(world).body(to_cpp(body)).mass();
    });
}

cairn_result cairn_body_get_mass_properties(const cairn_world* world, cairn_body_id body,
                                            cairn_mass_properties* mass_properties) {
    return guarded([&] {
        required(mass_properties, "mass_properties");
        *mass_properties = to_c(world_of(world).body(to_cpp(body)).mass_properties());
    });
}

cairn_result cairn_body_get_world_inertia(const cairn_world* world, cairn_body_id body, cairn_mat3* world_inertia) {
    return guarded([&] {
        required(world_inertia, "world_inertia");
        *world_inertia = to_c(world_of(world).body(to_cpp(body)).world_inertia());
    });
}

cairn_result cairn_body_get_angular_momentum(const cairn_world* world, cairn_body_id body,
                                             cairn_vec3* angular_momentum) {
    return guarded([&] {
        required(angular_momentum, "angular_momentum");
        *angular_momentum = to_c(world_of(world).body(to_cpp(body)).angular_momentum());
    });
}

cairn_result cairn_body_get_kinetic_energy(const cairn_world* world, cairn_body_id body, double* kinetic_energy) {
    return guarded([&] {
        required(kinetic_energy, "kinetic_energy");
        *kinetic_energy = world_of(world).body(to_cpp(body)).kinetic_energy();
    });
}

cairn_result cairn_body_get_gravity_scale(const cairn_world* world, cairn_body_id body, float* gravity_scale) {
    return guarded([&] {
        required(gravity_scale, "gravity_scale");
        *gravity_scale = world_of(world).body(to_cpp(body)).gravity_scale();
    });
}

cairn_result cairn_body_get_linear_damping(const cairn_world* world, cairn_body_id body, float* linear_damping) {
    return guarded([&] {
        required(linear_damping, "linear_damping");
        *linear_damping = world_of(world).body(to_cpp(body)).linear_damping();
    });
}

cairn_result cairn_body_get_angular_damping(const cairn_world* world, cairn_body_id body, float* angular_damping) {
    return guarded([&] {
        required(angular_damping, "angular_damping");
        *angular_damping = world_of(world).body(to_cpp(body)).angular_damping();
    });
}

cairn_result cairn_body_is_awake(const cairn_world* world, cairn_body_id body, bool* result) {
    return guarded([&] {
        required(result, "result");
        *result = world_of(world).body(to_cpp(body)).is_awake();
    });
}

cairn_result cairn_body_get_allow_sleep(const cairn_world* world, cairn_body_id body, bool* allow_sleep) {
    return guarded([&] {
        required(allow_sleep, "allow_sleep");
        *allow_sleep = world_of(world).body(to_cpp(body)).allow_sleep();
    });
}

cairn_result cairn_body_get_enabled(const cairn_world* world, cairn_body_id body, bool* enabled) {
    return guarded([&] {
        required(enabled, "enabled");
        *enabled = world_of(world).body(to_cpp(body)).enabled();
    });
}

cairn_result cairn_body_get_shapes(const cairn_world* world, cairn_body_id body, cairn_shape_id* shapes,
                                   size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(shapes, capacity, count, "shapes");
        write_list(world_of(world).body(to_cpp(body)).shapes(), shapes, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_body_set_transform(cairn_world* world, cairn_body_id body, cairn_position position,
                                      cairn_quat rotation) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_transform(to_cpp(position), to_cpp(rotation));
    });
}

cairn_result cairn_body_set_position(cairn_world* world, cairn_body_id body, cairn_position position) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_position(to_cpp(position));
    });
}

cairn_result cairn_body_set_rotation(cairn_world* world, cairn_body_id body, cairn_quat rotation) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_rotation(to_cpp(rotation));
    });
}

cairn_result cairn_body_set_linear_velocity(cairn_world* world, cairn_body_id body, cairn_vec3 velocity) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_linear_velocity(to_cpp(velocity));
    });
}

cairn_result cairn_body_set_angular_velocity(cairn_world* world, cairn_body_id body, cairn_vec3 velocity) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_angular_velocity(to_cpp(velocity));
    });
}

cairn_result cairn_body_move_to(cairn_world* world, cairn_body_id body, cairn_transform target, float seconds) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).move_to(to_cpp(target), seconds);
    });
}

cairn_result cairn_body_set_gravity_scale(cairn_world* world, cairn_body_id body, float scale) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_gravity_scale(scale);
    });
}

cairn_result cairn_body_set_damping(cairn_world* world, cairn_body_id body, float linear, float angular) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_damping(linear, angular);
    });
}

cairn_result cairn_body_set_allow_sleep(cairn_world* world, cairn_body_id body, bool allow) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_allow_sleep(allow);
    });
}

cairn_result cairn_body_set_type(cairn_world* world, cairn_body_id body, cairn_body_type type) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_type(to_body_type(type, "type"));
    });
}

cairn_result cairn_body_set_enabled(cairn_world* world, cairn_body_id body, bool enabled) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_enabled(enabled);
    });
}

cairn_result cairn_body_set_name(cairn_world* world, cairn_body_id body, const char* name) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_name(required_text(name, "name"));
    });
}

cairn_result cairn_body_set_mass_properties(cairn_world* world, cairn_body_id body,
                                            const cairn_mass_properties* properties) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_mass_properties(to_cpp(required(properties, "properties")));
    });
}

cairn_result cairn_body_set_mass_from_shapes(cairn_world* world, cairn_body_id body, const float* mass) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_mass_from_shapes(mass ? std::optional<float>(*mass) : std::nullopt);
    });
}

cairn_result cairn_body_wake(cairn_world* world, cairn_body_id body) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).wake();
    });
}

cairn_result cairn_body_sleep(cairn_world* world, cairn_body_id body) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).sleep();
    });
}

cairn_result cairn_body_add_force(cairn_world* world, cairn_body_id body, cairn_vec3 force) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).add_force(to_cpp(force));
    });
}

cairn_result cairn_body_add_force_at(cairn_world* world, cairn_body_id body, cairn_vec3 force, cairn_position point) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).add_force_at(to_cpp(force), to_cpp(point));
    });
}

cairn_result cairn_body_add_torque(cairn_world* world, cairn_body_id body, cairn_vec3 torque) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).add_torque(to_cpp(torque));
    });
}

cairn_result cairn_body_apply_impulse(cairn_world* world, cairn_body_id body, cairn_vec3 impulse) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).apply_impulse(to_cpp(impulse));
    });
}

cairn_result cairn_body_apply_impulse_at(cairn_world* world, cairn_body_id body, cairn_vec3 impulse,
                                         cairn_position point) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).apply_impulse_at(to_cpp(impulse), to_cpp(point));
    });
}

cairn_result cairn_body_apply_angular_impulse(cairn_world* world, cairn_body_id body, cairn_vec3 impulse) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).apply_angular_impulse(to_cpp(impulse));
    });
}

cairn_result cairn_body_is_character(const cairn_world* world, cairn_body_id body, bool* result) {
    return guarded([&] {
        required(result, "result");
        *result = world_of(world).body(to_cpp(body)).is_character();
    });
}

cairn_result cairn_body_get_character(const cairn_world* world, cairn_body_id body, cairn_character_def* character) {
    return guarded([&] {
        require_versioned(character, "character");
        write_versioned(to_c(world_of(world).body(to_cpp(body)).character()), character);
    });
}

cairn_result cairn_body_set_character(cairn_world* world, cairn_body_id body, const cairn_character_def* def) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_character(to_cpp(versioned(required(def, "def"), "def",
            cairn_default_character_def())));
    });
}

cairn_result cairn_body_remove_character(cairn_world* world, cairn_body_id body) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).remove_character();
    });
}

cairn_result cairn_body_get_walk_velocity(const cairn_world* world, cairn_body_id body, cairn_vec3* walk_velocity) {
    return guarded([&] {
        required(walk_velocity, "walk_velocity");
        *walk_velocity = to_c(world_of(world).body(to_cpp(body)).walk_velocity());
    });
}

cairn_result cairn_body_set_walk_velocity(cairn_world* world, cairn_body_id body, cairn_vec3 velocity) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).set_walk_velocity(to_cpp(velocity));
    });
}

cairn_result cairn_body_jump(cairn_world* world, cairn_body_id body, float speed) {
    return guarded([&] {
        world_of(world).body(to_cpp(body)).jump(speed);
    });
}

cairn_result cairn_body_character_state(const cairn_world* world, cairn_body_id body, cairn_character_state* result) {
    return guarded([&] {
        required(result, "result");
        *result = to_c(world_of(world).body(to_cpp(body)).character_state());
    });
}
