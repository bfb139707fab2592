// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/containers.h"

namespace cairn::python {

void read(py::handle o, Integrator& x, const Where& where) {
    x = Integrator(read_enum(o, "Integrator", where));
}
py::object write(Integrator x) { return write_enum("Integrator", int(x)); }

void read(py::handle o, ForceField::Kind& x, const Where& where) {
    x = ForceField::Kind(read_enum(o, "ForceFieldKind", where));
}
py::object write(ForceField::Kind x) { return write_enum("ForceFieldKind", int(x)); }

void read(py::handle o, WorldDef& x, const Where& where) {
    if (!is_a(o, "WorldDef")) refuse_type(where, "a WorldDef", o);
    read(o.attr("gravity"), x.gravity, {"WorldDef", "gravity"});
    read(o.attr("substeps"), x.substeps, {"WorldDef", "substeps"});
    read(o.attr("adaptive_substeps"), x.adaptive_substeps, {"WorldDef", "adaptive_substeps"});
    read(o.attr("integrator"), x.integrator, {"WorldDef", "integrator"});
    read(o.attr("enable_sleep"), x.enable_sleep, {"WorldDef", "enable_sleep"});
    read(o.attr("sleep_speed"), x.sleep_speed, {"WorldDef", "sleep_speed"});
    read(o.attr("sleep_time"), x.sleep_time, {"WorldDef", "sleep_time"});
    read(o.attr("restitution_speed"), x.restitution_speed, {"WorldDef", "restitution_speed"});
    read(o.attr("hit_speed"), x.hit_speed, {"WorldDef", "hit_speed"});
    read(o.attr("recovery_speed"), x.recovery_speed, {"WorldDef", "recovery_speed"});
    read(o.attr("max_linear_speed"), x.max_linear_speed, {"WorldDef", "max_linear_speed"});
    read(o.attr("max_angular_speed"), x.max_angular_speed, {"WorldDef", "max_angular_speed"});
}
py::object write(const WorldDef& x) {
    return make("WorldDef", py::make_tuple(write(x.gravity), write(x.substeps), write(x.adaptive_substeps),
        write(x.integrator), write(x.enable_sleep), write(x.sleep_speed), write(x.sleep_time),
        write(x.restitution_speed), write(x.hit_speed), write(x.recovery_speed), write(x.max_linear_speed),
        write(x.max_angular_speed)));
}

void read(py::handle o, ForceField& x, const Where& where) {
    if (!is_a(o, "ForceField")) refuse_type(where, "a ForceField", o);
    read(o.attr("kind"), x.kind, {"ForceField", "kind"});
    read(o.attr("direction"), x.direction, {"ForceField", "direction"});
    read(o.attr("center"), x.center, {"ForceField", "center"});
    read(o.attr("strength"), x.strength, {"ForceField", "strength"});
    read(o.attr("exponent"), x.exponent, {"ForceField", "exponent"});
    read(o.attr("is_force"), x.is_force, {"ForceField", "is_force"});
    read(o.attr("half_extents"), x.half_extents, {"ForceField", "half_extents"});
    read(o.attr("density"), x.density, {"ForceField", "density"});
    read(o.attr("drag"), x.drag, {"ForceField", "drag"});
    read(o.attr("skin_friction"), x.skin_friction, {"ForceField", "skin_friction"});
    read(o.attr("added_mass"), x.added_mass, {"ForceField", "added_mass"});
    read(o.attr("wave_damping"), x.wave_damping, {"ForceField", "wave_damping"});
}
py::object write(const ForceField& x) {
    return make("ForceField", py::make_tuple(write(x.kind), write(x.direction), write(x.center), write(x.strength),
        write(x.exponent), write(x.is_force), write(x.half_extents), write(x.density), write(x.drag),
        write(x.skin_friction), write(x.added_mass), write(x.wave_damping)));
}

py::object write(const StageTimes& x) {
    return make("StageTimes", py::make_tuple(write(x.broad_phase), write(x.narrow_phase), write(x.islands),
        write(x.prepare), write(x.solve), write(x.finalize), write(x.total)));
}

py::object write(const Statistics& x) {
    return make("Statistics", py::make_tuple(write(x.steps), write(x.time), write(x.bodies), write(x.dynamic_bodies),
        write(x.awake_bodies), write(x.shapes), write(x.candidate_pairs), write(x.tested_pairs), write(x.contacts),
        write(x.contact_points), write(x.islands), write(x.sleeping_islands), write(x.colors),
        write(x.overflow_contacts), write(x.clamped_speeds), write(x.max_substeps), write(x.max_penetration),
        write(x.swept_pairs), write(x.impacts), write(x.stopped_bodies), write(x.times)));
}

py::object write(const SnapshotSizes& x) {
    return make("SnapshotSizes", py::make_tuple(write(x.bodies), write(x.contacts), write(x.joints),
        write(x.broad_phase), write(x.other), write(x.definitions)));
}

} // namespace cairn::python
