// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"
#include "c_api/support.h"

#include <cairn/c/cairn.h>

using namespace cairn::c_api;
using namespace cairn;

cairn_result cairn_world_add_shape(cairn_world* world, cairn_body_id body, const cairn_shape* shape,
                                   const cairn_shape_def* def, cairn_shape_id* result) {
    return guarded([&] {
        required(result, "result");
        *result = to_c(world_of(world).add_shape(to_cpp(body), to_cpp(required(shape, "shape")), def
            ? to_cpp(versioned(*def, "def", cairn_default_shape_def())) : ShapeDef{}));
    });
}

cairn_result cairn_world_remove_shape(cairn_world* world, cairn_shape_id shape) {
    return guarded([&] {
        world_of(world).remove_shape(to_cpp(shape));
    });
}

cairn_result cairn_world_set_shape(cairn_world* world, cairn_shape_id shape, const cairn_shape* geometry) {
    return guarded([&] {
        world_of(world).set_shape(to_cpp(shape), to_cpp(required(geometry, "geometry")));
    });
}

cairn_result cairn_world_set_shape_def(cairn_world* world, cairn_shape_id shape, const cairn_shape_def* def) {
    return guarded([&] {
        world_of(world).set_shape_def(to_cpp(shape), to_cpp(versioned(required(def, "def"), "def",
            cairn_default_shape_def())));
    });
}

bool cairn_shape_is_valid(const cairn_world* world, cairn_shape_id shape) {
    return world && world_of(world).is_valid(to_cpp(shape));
}

cairn_result cairn_shape_get_body(const cairn_world* world, cairn_shape_id shape, cairn_body_id* result) {
    return guarded([&] {
        required(result, "result");
        *result = to_c(world_of(world).body_of(to_cpp(shape)));
    });
}

cairn_result cairn_world_get_shape(const cairn_world* world, cairn_shape_id shape, cairn_shape* result) {
    return guarded([&] {
        required(result, "result");
        *result = to_c(world_of(world).shape(to_cpp(shape)));
    });
}

cairn_result cairn_world_get_shape_def(const cairn_world* world, cairn_shape_id shape, cairn_shape_def* shape_def) {
    return guarded([&] {
        require_versioned(shape_def, "shape_def");
        write_versioned(to_c(world_of(world).shape_def(to_cpp(shape))), shape_def);
    });
}

cairn_result cairn_world_get_shape_transform(const cairn_world* world, cairn_shape_id shape,
                                             cairn_transform* shape_transform) {
    return guarded([&] {
        required(shape_transform, "shape_transform");
        *shape_transform = to_c(world_of(world).shape_transform(to_cpp(shape)));
    });
}

cairn_result cairn_world_get_shape_bounds(const cairn_world* world, cairn_shape_id shape, cairn_bounds* shape_bounds) {
    return guarded([&] {
        required(shape_bounds, "shape_bounds");
        *shape_bounds = to_c(world_of(world).shape_bounds(to_cpp(shape)));
    });
}

cairn_result cairn_world_set_material(cairn_world* world, cairn_shape_id shape, const cairn_material* material) {
    return guarded([&] {
        world_of(world).set_material(to_cpp(shape), to_cpp(required(material, "material")));
    });
}

cairn_result cairn_world_set_filter(cairn_world* world, cairn_shape_id shape, const cairn_collision_filter* filter) {
    return guarded([&] {
        world_of(world).set_filter(to_cpp(shape), to_cpp(required(filter, "filter")));
    });
}

cairn_result cairn_world_set_surface_velocity(cairn_world* world, cairn_shape_id shape, cairn_vec3 velocity) {
    return guarded([&] {
        world_of(world).set_surface_velocity(to_cpp(shape), to_cpp(velocity));
    });
}
