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
    return c;
}

cairn_shape_cast_hit to_c(const ShapeCastHit& x) {
    cairn_shape_cast_hit c{};
    c.shape = to_c(x.shape);
    c.body = to_c(x.body);
    c.fraction = x.fraction;
    c.point = to_c(x.point);
    c.normal = to_c(x.normal);
    return c;
}

cairn_closest_point to_c(const ClosestPoint& x) {
    cairn_closest_point c{};
    c.shape = to_c(x.shape);
    c.body = to_c(x.body);
    c.point = to_c(x.point);
    c.distance = x.distance;
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

} // namespace cairn::c_api
