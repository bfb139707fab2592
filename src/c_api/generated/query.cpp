// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"
#include "c_api/support.h"

#include <cairn/c/cairn.h>

using namespace cairn::c_api;
using namespace cairn;

cairn_result cairn_world_cast_ray(const cairn_world* world, cairn_position origin, cairn_vec3 direction,
                                  double max_distance, const cairn_query_filter* filter, cairn_ray_hit* result,
                                  bool* found) {
    return guarded([&] {
        required(result, "result");
        required(found, "found");
        const auto answer = world_of(world).cast_ray(to_cpp(origin), to_cpp(direction), max_distance, filter
            ? to_cpp(versioned(*filter, "filter", cairn_default_query_filter())) : QueryFilter{});
        *found = answer.has_value();
        if (answer) *result = to_c(*answer);
    });
}

cairn_result cairn_world_cast_ray_all(const cairn_world* world, cairn_position origin, cairn_vec3 direction,
                                      double max_distance, const cairn_query_filter* filter, cairn_ray_hit* result,
                                      size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(result, capacity, count, "result");
        write_list(world_of(world).cast_ray_all(to_cpp(origin), to_cpp(direction), max_distance, filter
            ? to_cpp(versioned(*filter, "filter", cairn_default_query_filter())) : QueryFilter{}), result, capacity,
            count, [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_cast_shape(const cairn_world* world, const cairn_shape* shape, cairn_transform start,
                                    cairn_vec3 translation, const cairn_query_filter* filter,
                                    cairn_shape_cast_hit* result, bool* found) {
    return guarded([&] {
        required(result, "result");
        required(found, "found");
        const auto answer = world_of(world).cast_shape(to_cpp(required(shape, "shape")), to_cpp(start),
            to_cpp(translation), filter ? to_cpp(versioned(*filter, "filter", cairn_default_query_filter()))
            : QueryFilter{});
        *found = answer.has_value();
        if (answer) *result = to_c(*answer);
    });
}

cairn_result cairn_world_closest_point(const cairn_world* world, cairn_position point, double max_distance,
                                       const cairn_query_filter* filter, cairn_closest_point* result, bool* found) {
    return guarded([&] {
        required(result, "result");
        required(found, "found");
        const auto answer = world_of(world).closest_point(to_cpp(point), max_distance, filter
            ? to_cpp(versioned(*filter, "filter", cairn_default_query_filter())) : QueryFilter{});
        *found = answer.has_value();
        if (answer) *result = to_c(*answer);
    });
}

cairn_result cairn_world_overlap(const cairn_world* world, const cairn_shape* shape, cairn_transform pose,
                                 const cairn_query_filter* filter, cairn_shape_id* result, size_t capacity,
                                 size_t* count) {
    return guarded([&] {
        require_room(result, capacity, count, "result");
        write_list(world_of(world).overlap(to_cpp(required(shape, "shape")), to_cpp(pose), filter
            ? to_cpp(versioned(*filter, "filter", cairn_default_query_filter())) : QueryFilter{}), result, capacity,
            count, [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_overlap_bounds(const cairn_world* world, cairn_bounds bounds, const cairn_query_filter* filter,
                                        cairn_shape_id* result, size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(result, capacity, count, "result");
        write_list(world_of(world).overlap_bounds(to_cpp(bounds), filter ? to_cpp(versioned(*filter, "filter",
            cairn_default_query_filter())) : QueryFilter{}), result, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_broad_phase_nodes(const cairn_world* world, int max_depth, int max_count,
                                           cairn_broad_phase_node* result, size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(result, capacity, count, "result");
        write_list(world_of(world).broad_phase_nodes(max_depth, max_count), result, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_solver_contacts(const cairn_world* world, cairn_solver_contact* result, size_t capacity,
                                         size_t* count) {
    return guarded([&] {
        require_room(result, capacity, count, "result");
        write_list(world_of(world).solver_contacts(), result, capacity, count, [](const auto& x) { return to_c(x); });
    });
}

cairn_result cairn_world_debug_lines(const cairn_world* world, const cairn_debug_lines_def* what,
                                     cairn_debug_line* result, size_t capacity, size_t* count) {
    return guarded([&] {
        require_room(result, capacity, count, "result");
        write_list(world_of(world).debug_lines(what ? to_cpp(versioned(*what, "what",
            cairn_default_debug_lines_def())) : DebugLinesDef{}), result, capacity, count,
            [](const auto& x) { return to_c(x); });
    });
}
