// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "c_api/generated/convert.h"

#include <string>

namespace cairn::c_api {

Integrator to_integrator(cairn_integrator value, const char* field) {
    if (value < 0 || value > 2)
        throw Error(ErrorCode::invalid_value, field, std::to_string(value),
            "must be 0 to 2 (semi_implicit_euler, explicit_euler, rk4)");
    return Integrator(value);
}

ForceField::Kind to_force_field_kind(cairn_force_field_kind value, const char* field) {
    if (value < 0 || value > 2)
        throw Error(ErrorCode::invalid_value, field, std::to_string(value), "must be 0 to 2 (uniform, radial, fluid)");
    return ForceField::Kind(value);
}

WorldDef to_cpp(const cairn_world_def& c) {
    WorldDef x;
    x.gravity = to_cpp(c.gravity);
    x.substeps = c.substeps;
    x.adaptive_substeps = c.adaptive_substeps;
    x.integrator = to_integrator(c.integrator, "WorldDef.integrator");
    x.enable_sleep = c.enable_sleep;
    x.sleep_speed = c.sleep_speed;
    x.sleep_time = c.sleep_time;
    x.restitution_speed = c.restitution_speed;
    x.hit_speed = c.hit_speed;
    x.recovery_speed = c.recovery_speed;
    x.max_linear_speed = c.max_linear_speed;
    x.max_angular_speed = c.max_angular_speed;
    return x;
}
cairn_world_def to_c(const WorldDef& x) {
    cairn_world_def c{};
    c.struct_size = sizeof c;
    c.gravity = to_c(x.gravity);
    c.substeps = x.substeps;
    c.adaptive_substeps = x.adaptive_substeps;
    c.integrator = cairn_integrator(x.integrator);
    c.enable_sleep = x.enable_sleep;
    c.sleep_speed = x.sleep_speed;
    c.sleep_time = x.sleep_time;
    c.restitution_speed = x.restitution_speed;
    c.hit_speed = x.hit_speed;
    c.recovery_speed = x.recovery_speed;
    c.max_linear_speed = x.max_linear_speed;
    c.max_angular_speed = x.max_angular_speed;
    return c;
}

ForceField to_cpp(const cairn_force_field& c) {
    ForceField x;
    x.kind = to_force_field_kind(c.kind, "ForceField.kind");
    x.direction = to_cpp(c.direction);
    x.center = to_cpp(c.center);
    x.strength = c.strength;
    x.exponent = c.exponent;
    x.is_force = c.is_force;
    x.half_extents = to_cpp(c.half_extents);
    x.density = c.density;
    x.drag = c.drag;
    x.skin_friction = c.skin_friction;
    x.added_mass = c.added_mass;
    x.wave_damping = c.wave_damping;
    return x;
}
cairn_force_field to_c(const ForceField& x) {
    cairn_force_field c{};
    c.struct_size = sizeof c;
    c.kind = cairn_force_field_kind(x.kind);
    c.direction = to_c(x.direction);
    c.center = to_c(x.center);
    c.strength = x.strength;
    c.exponent = x.exponent;
    c.is_force = x.is_force;
    c.half_extents = to_c(x.half_extents);
    c.density = x.density;
    c.drag = x.drag;
    c.skin_friction = x.skin_friction;
    c.added_mass = x.added_mass;
    c.wave_damping = x.wave_damping;
    return c;
}

cairn_stage_times to_c(const StageTimes& x) {
    cairn_stage_times c{};
    c.broad_phase = x.broad_phase;
    c.narrow_phase = x.narrow_phase;
    c.islands = x.islands;
    c.prepare = x.prepare;
    c.solve = x.solve;
    c.finalize = x.finalize;
    c.total = x.total;
    return c;
}

cairn_statistics to_c(const Statistics& x) {
    cairn_statistics c{};
    c.struct_size = sizeof c;
    c.steps = x.steps;
    c.time = x.time;
    c.bodies = x.bodies;
    c.dynamic_bodies = x.dynamic_bodies;
    c.awake_bodies = x.awake_bodies;
    c.shapes = x.shapes;
    c.candidate_pairs = x.candidate_pairs;
    c.tested_pairs = x.tested_pairs;
    c.contacts = x.contacts;
    c.contact_points = x.contact_points;
    c.islands = x.islands;
    c.sleeping_islands = x.sleeping_islands;
    c.colors = x.colors;
    c.overflow_contacts = x.overflow_contacts;
    c.clamped_speeds = x.clamped_speeds;
    c.max_substeps = x.max_substeps;
    c.max_penetration = x.max_penetration;
    c.swept_pairs = x.swept_pairs;
    c.impacts = x.impacts;
    c.stopped_bodies = x.stopped_bodies;
    c.times = to_c(x.times);
    return c;
}

cairn_snapshot_sizes to_c(const SnapshotSizes& x) {
    cairn_snapshot_sizes c{};
    c.bodies = x.bodies;
    c.contacts = x.contacts;
    c.joints = x.joints;
    c.broad_phase = x.broad_phase;
    c.other = x.other;
    c.definitions = x.definitions;
    return c;
}

} // namespace cairn::c_api
