// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"

#include <string>

namespace cairn::c_api {

BroadPhaseTree to_broad_phase_tree(cairn_broad_phase_tree value, const char* field) {
    if (value < 0 || value > 3)
        throw Error(ErrorCode::invalid_value, field, std::to_string(value),
            "must be 0 to 3 (fixed, awake, large, sleeping)");
    return BroadPhaseTree(value);
}

cairn_ray_hit to_c(const RayHit& x) {
    cairn_ray_hit c{};
    c.shape = to_c(x.shape);
    c.body = to_c(x.body);
    c.point = to_c(x.point);
    c.normal = to_c(x.normal);
    c.distance = x.distance;
    c.triangle = x.triangle;
    return c;
}

cairn_shape_cast_hit to_c(const ShapeCastHit& x) {
    cairn_shape_cast_hit c{};
    c.shape = to_c(x.shape);
    c.body = to_c(x.body);
    c.fraction = x.fraction;
    c.point = to_c(x.point);
    c.normal = to_c(x.normal);
    c.triangle = x.triangle;
    return c;
}

cairn_closest_point to_c(const ClosestPoint& x) {
    cairn_closest_point c{};
    c.shape = to_c(x.shape);
    c.body = to_c(x.body);
    c.point = to_c(x.point);
    c.distance = x.distance;
    c.triangle = x.triangle;
    return c;
}

cairn_broad_phase_node to_c(const BroadPhaseNode& x) {
    cairn_broad_phase_node c{};
    c.bounds = to_c(x.bounds);
    c.tree = cairn_broad_phase_tree(x.tree);
    c.depth = x.depth;
    c.parent = x.parent;
    c.is_leaf = x.is_leaf;
    c.shape = to_c(x.shape);
    return c;
}

cairn_solver_contact to_c(const SolverContact& x) {
    cairn_solver_contact c{};
    c.shape_a = to_c(x.shape_a);
    c.shape_b = to_c(x.shape_b);
    c.body_a = to_c(x.body_a);
    c.body_b = to_c(x.body_b);
    c.color = x.color;
    c.substeps = x.substeps;
    return c;
}

DebugLinesDef to_cpp(const cairn_debug_lines_def& c) {
    DebugLinesDef x;
    x.shapes = c.shapes;
    x.bounds = c.bounds;
    x.centers = c.centers;
    x.velocities = c.velocities;
    x.contacts = c.contacts;
    x.joints = c.joints;
    x.size = c.size;
    x.impulse_scale = c.impulse_scale;
    return x;
}
cairn_debug_lines_def to_c(const DebugLinesDef& x) {
    cairn_debug_lines_def c{};
    c.struct_size = sizeof c;
    c.shapes = x.shapes;
    c.bounds = x.bounds;
    c.centers = x.centers;
    c.velocities = x.velocities;
    c.contacts = x.contacts;
    c.joints = x.joints;
    c.size = x.size;
    c.impulse_scale = x.impulse_scale;
    return c;
}

cairn_debug_line to_c(const DebugLine& x) {
    cairn_debug_line c{};
    c.begin = to_c(x.begin);
    c.end = to_c(x.end);
    c.color = to_c(x.color);
    return c;
}

QueryFilter to_cpp(const cairn_query_filter& c) {
    QueryFilter x;
    x.layers = c.layers;
    x.own_layers = c.own_layers;
    x.static_bodies = c.static_bodies;
    x.kinematic_bodies = c.kinematic_bodies;
    x.dynamic_bodies = c.dynamic_bodies;
    x.triggers = c.triggers;
    x.any = c.any;
    require_list(c.ignored_bodies, c.ignored_body_count, "QueryFilter.ignored_bodies");
    for (std::size_t i = 0; i < c.ignored_body_count; ++i) x.ignored_bodies.push_back(to_cpp(c.ignored_bodies[i]));
    return x;
}
cairn_query_filter to_c(const QueryFilter& x) {
    cairn_query_filter c{};
    c.struct_size = sizeof c;
    c.layers = x.layers;
    c.own_layers = x.own_layers;
    c.static_bodies = x.static_bodies;
    c.kinematic_bodies = x.kinematic_bodies;
    c.dynamic_bodies = x.dynamic_bodies;
    c.triggers = x.triggers;
    c.any = x.any;
    c.ignored_body_count = x.ignored_bodies.size();
    return c;
}

} // namespace cairn::c_api
