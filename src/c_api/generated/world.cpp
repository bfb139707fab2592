// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"
#include "c_api/support.h"

#include <cairn/c/cairn.h>

using namespace cairn::c_api;
using namespace cairn;

cairn_result cairn_world_get_settings(const cairn_world* world, cairn_world_def* settings) {
    return guarded([&] {
        require_versioned(settings, "settings");
        write_versioned(to_c(world_of(world).settings()), settings);
    });
}

cairn_result cairn_world_set_settings(cairn_world* world, const cairn_world_def* def) {
    return guarded([&] {
        world_of(world).set_settings(to_cpp(versioned(required(def, "def"), "def", cairn_default_world_def())));
    });
}

cairn_result cairn_world_usual_substeps(const cairn_world* world, float dt, int* result) {
    return guarded([&] {
        required(result, "result");
        *result = world_of(world).usual_substeps(dt);
    });
}

cairn_result cairn_world_set_threads(cairn_world* world, int count) {
    return guarded([&] {
        world_of(world).set_threads(count);
    });
}

cairn_result cairn_world_get_threads(const cairn_world* world, int* threads) {
    return guarded([&] {
        required(threads, "threads");
        *threads = world_of(world).threads();
    });
}

cairn_result cairn_world_add_force_field(cairn_world* world, const cairn_force_field* field,
                                         cairn_force_field_id* result) {
    return guarded([&] {
        required(result, "result");
        *result = to_c(world_of(world).add_force_field(to_cpp(versioned(required(field, "field"), "field",
            cairn_default_force_field()))));
    });
}

cairn_result cairn_world_set_force_field(cairn_world* world, cairn_force_field_id id, const cairn_force_field* field) {
    return guarded([&] {
        world_of(world).set_force_field(to_cpp(id), to_cpp(versioned(required(field, "field"), "field",
            cairn_default_force_field())));
    });
}

cairn_result cairn_world_remove_force_field(cairn_world* world, cairn_force_field_id id) {
    return guarded([&] {
        world_of(world).remove_force_field(to_cpp(id));
    });
}

cairn_result cairn_world_get_force_field(const cairn_world* world, cairn_force_field_id id,
                                         cairn_force_field* force_field) {
    return guarded([&] {
        require_versioned(force_field, "force_field");
        write_versioned(to_c(world_of(world).force_field(to_cpp(id))), force_field);
    });
}

cairn_result cairn_world_get_force_fields(const cairn_world* world, cairn_force_field_id* force_fields, size_t capacity,
                                          size_t* count) {
    return guarded([&] {
        require_room(force_fields, capacity, count, "force_fields");
        write_list(world_of(world).force_fields(), force_fields, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

bool cairn_force_field_is_valid(const cairn_world* world, cairn_force_field_id id) {
    return world && world_of(world).is_valid(to_cpp(id));
}

cairn_result cairn_world_step(cairn_world* world, float dt) {
    return guarded([&] {
        world_of(world).step(dt);
    });
}

cairn_result cairn_world_get_step_count(const cairn_world* world, uint64_t* step_count) {
    return guarded([&] {
        required(step_count, "step_count");
        *step_count = world_of(world).step_count();
    });
}

cairn_result cairn_world_get_time(const cairn_world* world, double* time) {
    return guarded([&] {
        required(time, "time");
        *time = world_of(world).time();
    });
}

cairn_result cairn_world_get_kinetic_energy(const cairn_world* world, double* kinetic_energy) {
    return guarded([&] {
        required(kinetic_energy, "kinetic_energy");
        *kinetic_energy = world_of(world).kinetic_energy();
    });
}

cairn_result cairn_world_get_potential_energy(const cairn_world* world, double* potential_energy) {
    return guarded([&] {
        required(potential_energy, "potential_energy");
        *potential_energy = world_of(world).potential_energy();
    });
}

cairn_result cairn_world_get_linear_momentum(const cairn_world* world, cairn_dvec3* linear_momentum) {
    return guarded([&] {
        required(linear_momentum, "linear_momentum");
        *linear_momentum = to_c(world_of(world).linear_momentum());
    });
}

cairn_result cairn_world_get_angular_momentum(const cairn_world* world, cairn_dvec3* angular_momentum) {
    return guarded([&] {
        required(angular_momentum, "angular_momentum");
        *angular_momentum = to_c(world_of(world).angular_momentum());
    });
}

cairn_result cairn_world_get_state_hash(const cairn_world* world, uint64_t* state_hash) {
    return guarded([&] {
        required(state_hash, "state_hash");
        *state_hash = world_of(world).state_hash();
    });
}

cairn_result cairn_world_get_statistics(const cairn_world* world, cairn_statistics* statistics) {
    return guarded([&] {
        require_versioned(statistics, "statistics");
        write_versioned(to_c(world_of(world).statistics()), statistics);
    });
}
