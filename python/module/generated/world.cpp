// Made by tools/api.py from api/: change those, and run it.
// clang-format off
#include "module/body.h"
#include "module/containers.h"
#include "module/definitions.h"

namespace cairn::python {

void add_world_calls(py::class_<PyWorld, std::shared_ptr<PyWorld>>& c) {
    c.def("add_shape", [](PyWorld& w, py::object o_body, py::object o_shape, py::object o_definition, py::kwargs
        members) {
        const auto body = take<BodyId>(o_body, "body");
        const auto shape = take<Shape>(o_shape, "shape");
        const auto def = take_definition<ShapeDef>(o_definition, members, "ShapeDef");
        const auto answer = w.use("World.add_shape").add_shape(body, shape, def);
        w.update();
        return write(answer);
    }, py::arg("body"), py::arg("shape"), py::arg("definition") = py::none(), "add_shape(body: BodyId | Body, shape: "
        "Shape, definition: ShapeDef | None = None, **members: Any) -> ShapeId\n\nAdds a shape to a body and, unless "
            "its mass properties were given, updates them. A dynamic body whose shapes have no mass at all is a point "
                "of its given mass, or of 1 kg, that does not turn. Planes are refused on dynamic bodies.");
    c.def("remove_shape", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        w.use("World.remove_shape").remove_shape(shape);
        w.update();
    }, py::arg("shape"), "remove_shape(shape: ShapeId) -> None\n\nTakes a shape off its body, whose mass properties "
        "follow unless they were given.");
    c.def("set_shape", [](PyWorld& w, py::object o_shape, py::object o_geometry) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto geometry = take<Shape>(o_geometry, "geometry");
        w.use("World.set_shape").set_shape(shape, geometry);
        w.update();
    }, py::arg("shape"), py::arg("geometry"), "set_shape(shape: ShapeId, geometry: Shape) -> None\n\nGives a shape "
        "another geometry, in place: its handle and all that its definition says stay. The mass of the body follows "
            "as when a shape is added. What it touches then goes on touching it, without events, as long as it is of "
                "the same type; else its contacts end and begin anew. What overlaps it then is pushed out, no faster "
                    "than `WorldDef.recovery_speed`: ground that rises carries what is on it if it rises more slowly "
                        "than that, and by less than the height of that in one call. Wakes its body and what is "
                            "around the shape, before and after.");
    c.def("set_shape_def", [](PyWorld& w, py::object o_shape, py::object o_definition, py::kwargs members) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto def = take_definition<ShapeDef>(o_definition, members, "ShapeDef");
        w.use("World.set_shape_def").set_shape_def(shape, def);
        w.update();
    }, py::arg("shape"), py::arg("definition") = py::none(), "set_shape_def(shape: ShapeId, definition: ShapeDef | "
        "None = None, **members: Any) -> None\n\nGives a shape another definition, in place: place on its "
            "body, density, material, filter, and what else that says; to change a part of it, begin with the one "
                "that it has. Its contacts end and begin anew where `is_trigger` or `filter` is not what it was; else "
                    "as when its geometry is set.");
    c.def("body_of", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.body_of").body_of(shape);
        return write(answer);
    }, py::arg("shape"), "body_of(shape: ShapeId) -> BodyId\n\nThe body that a shape is on.");
    c.def("shape", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.shape").shape(shape);
        return write(answer);
    }, py::arg("shape"), "shape(shape: ShapeId) -> Shape\n\nWhat was added.");
    c.def("shape_def", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.shape_def").shape_def(shape);
        return write(answer);
    }, py::arg("shape"), "shape_def(shape: ShapeId) -> ShapeDef\n\nHow it is attached to its body, as it is now.");
    c.def("shape_transform", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.shape_transform").shape_transform(shape);
        return write(answer);
    }, py::arg("shape"), "shape_transform(shape: ShapeId) -> Transform\n\nIn world space.");
    c.def("shape_bounds", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.shape_bounds").shape_bounds(shape);
        return write(answer);
    }, py::arg("shape"), "shape_bounds(shape: ShapeId) -> Bounds\n\nTight; infinite for infinite planes.");
    c.def("set_material", [](PyWorld& w, py::object o_shape, py::object o_material) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto material = take<Material>(o_material, "material");
        w.use("World.set_material").set_material(shape, material);
        w.update();
    }, py::arg("shape"), py::arg("material"), "set_material(shape: ShapeId, material: Material) -> None\n\nReplaces "
        "the material.");
    c.def("set_filter", [](PyWorld& w, py::object o_shape, py::object o_filter) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto filter = take<CollisionFilter>(o_filter, "filter");
        w.use("World.set_filter").set_filter(shape, filter);
        w.update();
    }, py::arg("shape"), py::arg("filter"), "set_filter(shape: ShapeId, filter: CollisionFilter) -> None\n\nReplaces "
        "the collision filter.");
    c.def("set_surface_velocity", [](PyWorld& w, py::object o_shape, py::object o_velocity) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto velocity = take<Vec3>(o_velocity, "velocity");
        w.use("World.set_surface_velocity").set_surface_velocity(shape, velocity);
        w.update();
    }, py::arg("shape"), py::arg("velocity"), "set_surface_velocity(shape: ShapeId, velocity: Vector) -> None\n\nSee "
        "`ShapeDef.surface_velocity`. Refused (wrong_state) for a shape of a dynamic body.");
    c.def_property_readonly("bodies", [](PyWorld& w) {
        const auto answer = w.use("World.bodies").bodies();
        return write(answer);
    },
        "All, in order of slot index.");
    c.def("find_body", [](PyWorld& w, py::object o_name) {
        const auto name = take<std::string>(o_name, "name");
        const auto answer = w.use("World.find_body").find_body(name);
        return write(answer);
    }, py::arg("name"), "find_body(name: str) -> BodyId | None\n\nThe first of that name.");
    c.def("create_joint", [](PyWorld& w, py::object o_definition, py::kwargs members) {
        const auto def = take_definition<JointDef>(o_definition, members, "JointDef");
        const auto answer = w.use("World.create_joint").create_joint(def);
        w.update();
        return write(answer);
    }, py::arg("definition") = py::none(), "create_joint(definition: JointDef | None = None, **members: Any) -> "
        "JointId\n\nJoins two bodies, or a body and the world. Wakes them.");
    c.def("joint_at", [](PyWorld& w, py::object o_body_a, py::object o_body_b, py::object o_anchor, py::object
        o_axis, py::object o_joint) {
        const auto body_a = take<BodyId>(o_body_a, "body_a");
        const auto body_b = take<BodyId>(o_body_b, "body_b");
        const auto anchor = take<Position>(o_anchor, "anchor");
        const auto axis = take<Vec3>(o_axis, "axis");
        const auto joint = take<Joint>(o_joint, "joint");
        const auto answer = w.use("World.joint_at").joint_at(body_a, body_b, anchor, axis, joint);
        return write(answer);
    }, py::arg("body_a"), py::arg("body_b"), py::arg("anchor"), py::arg("axis"), py::arg("joint"), "joint_at(body_a: "
        "BodyId | Body, body_b: BodyId | Body, anchor: Vector, axis: Vector, joint: Joint) -> JointDef\n\nThe "
            "definition of a joint whose frames both lie at `anchor`, with x along `axis` (any non-zero vector; world "
                "space), and y and z as the shortest turn from those of the world has them: -x and z if `axis` points "
                    "up. As the bodies stand now.");
    c.def("destroy_joint", [](PyWorld& w, py::object o_joint) {
        const auto joint = take<JointId>(o_joint, "joint");
        w.use("World.destroy_joint").destroy_joint(joint);
        w.update();
    }, py::arg("joint"), "destroy_joint(joint: JointId) -> None\n\nTakes a joint out of the world and wakes its "
        "bodies.");
    c.def("joint_def", [](PyWorld& w, py::object o_joint) {
        const auto joint = take<JointId>(o_joint, "joint");
        const auto answer = w.use("World.joint_def").joint_def(joint);
        return write(answer);
    }, py::arg("joint"), "joint_def(joint: JointId) -> JointDef\n\nThe definition of a joint, as it is now.");
    c.def("set_joint", [](PyWorld& w, py::object o_id, py::object o_joint) {
        const auto id = take<JointId>(o_id, "id");
        const auto joint = take<Joint>(o_joint, "joint");
        w.use("World.set_joint").set_joint(id, joint);
        w.update();
    }, py::arg("id"), py::arg("joint"), "set_joint(id: JointId, joint: Joint) -> None\n\nChanges "
        "limits, motors, springs, or the kind of the joint. Wakes its bodies.");
    c.def("set_joint_strength", [](PyWorld& w, py::object o_joint, py::object o_break_force, py::object
        o_break_torque) {
        const auto joint = take<JointId>(o_joint, "joint");
        const auto break_force = take<float>(o_break_force, "break_force");
        const auto break_torque = take<float>(o_break_torque, "break_torque");
        w.use("World.set_joint_strength").set_joint_strength(joint, break_force, break_torque);
        w.update();
    }, py::arg("joint"), py::arg("break_force"), py::arg("break_torque"), "set_joint_strength(joint: "
        "JointId, break_force: float, break_torque: float) -> None\n\nN and N m, > 0; may be infinite.");
    c.def("set_joint_enabled", [](PyWorld& w, py::object o_joint, py::object o_enabled) {
        const auto joint = take<JointId>(o_joint, "joint");
        const auto enabled = take<bool>(o_enabled, "enabled");
        w.use("World.set_joint_enabled").set_joint_enabled(joint, enabled);
        w.update();
    }, py::arg("joint"), py::arg("enabled"), "set_joint_enabled(joint: JointId, enabled: bool) -> None\n\nA joint "
        "that is disabled keeps its definition and its handle, and acts on nothing: its bodies move, and collide, as "
            "if it had been destroyed. Enabled again it begins without impulses, and brings its bodies together where "
                "they have parted. Both wake them.");
    c.def("joint_state", [](PyWorld& w, py::object o_joint) {
        const auto joint = take<JointId>(o_joint, "joint");
        const auto answer = w.use("World.joint_state").joint_state(joint);
        return write(answer);
    }, py::arg("joint"), "joint_state(joint: JointId) -> JointState\n\nWhat a joint did in the last step.");
    c.def_property_readonly("joints", [](PyWorld& w) {
        const auto answer = w.use("World.joints").joints();
        return write(answer);
    },
        "All, in order of slot index.");
    c.def("find_joint", [](PyWorld& w, py::object o_name) {
        const auto name = take<std::string>(o_name, "name");
        const auto answer = w.use("World.find_joint").find_joint(name);
        return write(answer);
    }, py::arg("name"), "find_joint(name: str) -> JointId | None\n\nThe first of that name.");
    c.def("cast_ray", [](PyWorld& w, py::object o_origin, py::object o_direction, py::object o_max_distance,
        py::object o_filter, py::kwargs members) {
        const auto origin = take<Position>(o_origin, "origin");
        const auto direction = take<Vec3>(o_direction, "direction");
        const auto max_distance = take<double>(o_max_distance, "max_distance");
        const auto filter = take_definition<QueryFilter>(o_filter, members, "QueryFilter");
        const auto answer = w.use("World.cast_ray").cast_ray(origin, direction, max_distance, filter);
        return write(answer);
    }, py::arg("origin"), py::arg("direction"), py::arg("max_distance"), py::arg("filter") = py::none(),
        "cast_ray(origin: Vector, direction: Vector, max_distance: float, filter: QueryFilter | None = "
            "None, **members: Any) -> RayHit | None\n\nThe nearest shape that the ray meets within `max_distance`. "
                "`direction` need not be unit length. A ray that starts inside a shape does not meet that shape's "
                    "surface from within, except planes' solid side.");
    c.def("cast_ray_all", [](PyWorld& w, py::object o_origin, py::object o_direction, py::object o_max_distance,
        py::object o_filter, py::kwargs members) {
        const auto origin = take<Position>(o_origin, "origin");
        const auto direction = take<Vec3>(o_direction, "direction");
        const auto max_distance = take<double>(o_max_distance, "max_distance");
        const auto filter = take_definition<QueryFilter>(o_filter, members, "QueryFilter");
        const auto answer = w.use("World.cast_ray_all").cast_ray_all(origin, direction, max_distance, filter);
        return write(answer);
    }, py::arg("origin"), py::arg("direction"), py::arg("max_distance"), py::arg("filter") = py::none(),
        "cast_ray_all(origin: Vector, direction: Vector, max_distance: float, filter: QueryFilter | None = "
            "None, **members: Any) -> list[RayHit]\n\nEvery shape that the ray meets, nearest first.");
    c.def("cast_shape", [](PyWorld& w, py::object o_shape, py::object o_start, py::object o_translation, py::object
        o_filter, py::kwargs members) {
        const auto shape = take<Shape>(o_shape, "shape");
        const auto start = take<Transform>(o_start, "start");
        const auto translation = take<Vec3>(o_translation, "translation");
        const auto filter = take_definition<QueryFilter>(o_filter, members, "QueryFilter");
        const auto answer = w.use("World.cast_shape").cast_shape(shape, start, translation, filter);
        return write(answer);
    }, py::arg("shape"), py::arg("start"), py::arg("translation"), py::arg("filter") = py::none(), "cast_shape(shape: "
        "Shape, start: Transform, translation: Vector, filter: QueryFilter | None = None, **members: Any) -> "
            "ShapeCastHit | None\n\nThe first shape that the given convex one meets when it moves by `translation` "
                "(meters) from `start` without turning. Planes, meshes and height fields are met from outside "
                    "only, and cannot be cast themselves (invalid_value).");
    c.def("closest_point", [](PyWorld& w, py::object o_point, py::object o_max_distance, py::object o_filter,
        py::kwargs members) {
        const auto point = take<Position>(o_point, "point");
        const auto max_distance = take<double>(o_max_distance, "max_distance");
        const auto filter = take_definition<QueryFilter>(o_filter, members, "QueryFilter");
        const auto answer = w.use("World.closest_point").closest_point(point, max_distance, filter);
        return write(answer);
    }, py::arg("point"), py::arg("max_distance"), py::arg("filter") = py::none(), "closest_point(point: "
        "Vector, max_distance: float, filter: QueryFilter | None = None, **members: Any) -> ClosestPoint | "
            "None\n\nThe shape nearest to a point, up to `max_distance` (meters, >= 0) away. What is below a plane is "
                "inside it; meshes and height fields have no inside.");
    c.def("overlap", [](PyWorld& w, py::object o_shape, py::object o_pose, py::object o_filter, py::kwargs members) {
        const auto shape = take<Shape>(o_shape, "shape");
        const auto pose = take<Transform>(o_pose, "pose");
        const auto filter = take_definition<QueryFilter>(o_filter, members, "QueryFilter");
        const auto answer = w.use("World.overlap").overlap(shape, pose, filter);
        return write(answer);
    }, py::arg("shape"), py::arg("pose"), py::arg("filter") = py::none(), "overlap(shape: Shape, pose: "
        "Transform, filter: QueryFilter | None = None, **members: Any) -> list[ShapeId]\n\nShapes that overlap the "
            "given shape posed in the world, in order of slot index.");
    c.def("overlap_bounds", [](PyWorld& w, py::object o_bounds, py::object o_filter, py::kwargs members) {
        const auto bounds = take<Bounds>(o_bounds, "bounds");
        const auto filter = take_definition<QueryFilter>(o_filter, members, "QueryFilter");
        const auto answer = w.use("World.overlap_bounds").overlap_bounds(bounds, filter);
        return write(answer);
    }, py::arg("bounds"), py::arg("filter") = py::none(), "overlap_bounds(bounds: Bounds, filter: QueryFilter | None "
        "= None, **members: Any) -> list[ShapeId]\n\nShapes whose tight bounds overlap the box, in order of slot "
            "index.");
    c.def("broad_phase_nodes", [](PyWorld& w, py::object o_max_depth, py::object o_max_count) {
        const auto max_depth = take<int>(o_max_depth, "max_depth");
        const auto max_count = take<int>(o_max_count, "max_count");
        const auto answer = w.use("World.broad_phase_nodes").broad_phase_nodes(max_depth, max_count);
        return write(answer);
    }, py::arg("max_depth"), py::arg("max_count"), "broad_phase_nodes(max_depth: int, max_count: int) -> "
        "list[BroadPhaseNode]\n\nThe boxes of the broad phase as they stand, down to that depth, for pictures and for "
            "who wants to know why a scene is slow: those of least depth first, and no more than `max_count`. Both >= "
                "0.");
    c.def_property_readonly("solver_contacts", [](PyWorld& w) {
        const auto answer = w.use("World.solver_contacts").solver_contacts();
        return write(answer);
    },
        "How each touching pair of shapes is solved, in the order of `world_get_contacts`.");
    c.def("debug_lines", [](PyWorld& w, py::object o_what, py::kwargs members) {
        const auto what = take_definition<DebugLinesDef>(o_what, members, "DebugLinesDef");
        const auto answer = w.use("World.debug_lines").debug_lines(what);
        return write(answer);
    }, py::arg("what") = py::none(), "debug_lines(what: DebugLinesDef | None = None, **members: Any) -> "
        "list[DebugLine]\n\nWhat the world consists of as lines, for programs that draw it themselves: bodies in "
            "order of slot index, then contacts, then joints. As many as there are edges: of large meshes and height "
                "fields that takes its time.");
    c.def_property_readonly("contact_begins", [](PyWorld& w) {
        const auto answer = w.use("World.contact_begins").contact_begins();
        return write(answer);
    },
        "Shapes that began to touch in the last step.");
    c.def_property_readonly("contact_ends", [](PyWorld& w) {
        const auto answer = w.use("World.contact_ends").contact_ends();
        return write(answer);
    },
        "Shapes that ceased to touch in the last step.");
    c.def_property_readonly("contact_hits", [](PyWorld& w) {
        const auto answer = w.use("World.contact_hits").contact_hits();
        return write(answer);
    },
        "Shapes that hit each other in the last step, at `WorldDef.hit_speed` or more.");
    c.def_property_readonly("trigger_events", [](PyWorld& w) {
        const auto answer = w.use("World.trigger_events").trigger_events();
        return write(answer);
    },
        "What came into triggers and left them in the last step.");
    c.def_property_readonly("joint_events", [](PyWorld& w) {
        const auto answer = w.use("World.joint_events").joint_events();
        return write(answer);
    },
        "Joints that broke or lost a body in the last step, or since.");
    c.def_property_readonly("sleep_events", [](PyWorld& w) {
        const auto answer = w.use("World.sleep_events").sleep_events();
        return write(answer);
    },
        "Bodies that fell asleep or woke up in the last step.");
    c.def_property_readonly("contacts", [](PyWorld& w) {
        const auto answer = w.use("World.contacts").contacts();
        return write(answer);
    },
        "All touching pairs.");
    c.def_property("settings", [](PyWorld& w) {
        const auto answer = w.use("World.settings").settings();
        return write(answer);
    }, [](PyWorld& w, py::object o) {
        const auto value = take<WorldDef>(o, "World.settings");
        w.use("World.settings").set_settings(value);
        w.update();
    }, "What the world was made with, or was last set to. Setting: Replaces the settings. Wakes everything if gravity "
        "changes.");
    c.def("usual_substeps", [](PyWorld& w, py::object o_dt) {
        const auto dt = take<float>(o_dt, "dt");
        const auto answer = w.use("World.usual_substeps").usual_substeps(dt);
        return write(answer);
    }, py::arg("dt"), "usual_substeps(dt: float) -> int\n\nThe substeps of a step of `dt` seconds, finite and > "
        "0, where no island asks for more: `WorldDef.substeps`, or what its 0 stands for.");
    c.def_property("threads", [](PyWorld& w) {
        const auto answer = w.use("World.threads").threads();
        return write(answer);
    }, [](PyWorld& w, py::object o) {
        const auto value = take<int>(o, "World.threads");
        w.use("World.threads").set_threads(value);
        w.update();
    }, "The number of threads that a step may use. Setting: The number of threads that a step may use: that of the "
        "caller, and `count` - 1 more that the world keeps. 1 to 256; default 1. Results do not depend on it. "
            "Snapshots do not hold it. Raises outside that range, or when the system has no more threads.");
    c.def("add_force_field", [](PyWorld& w, py::object o_field, py::kwargs members) {
        const auto field = take_definition<ForceField>(o_field, members, "ForceField");
        const auto answer = w.use("World.add_force_field").add_force_field(field);
        w.update();
        return write(answer);
    }, py::arg("field") = py::none(), "add_force_field(field: ForceField | None = None, **members: Any) -> "
        "ForceFieldId\n\nAdds a field that acts on every dynamic body from the next step on.");
    c.def("set_force_field", [](PyWorld& w, py::object o_id, py::object o_field, py::kwargs members) {
        const auto id = take<ForceFieldId>(o_id, "id");
        const auto field = take_definition<ForceField>(o_field, members, "ForceField");
        w.use("World.set_force_field").set_force_field(id, field);
        w.update();
    }, py::arg("id"), py::arg("field") = py::none(), "set_force_field(id: ForceFieldId, field: ForceField | None = "
        "None, **members: Any) -> None\n\nReplaces a field by another one.");
    c.def("remove_force_field", [](PyWorld& w, py::object o_id) {
        const auto id = take<ForceFieldId>(o_id, "id");
        w.use("World.remove_force_field").remove_force_field(id);
        w.update();
    }, py::arg("id"), "remove_force_field(id: ForceFieldId) -> None\n\nTakes a field out of the world.");
    c.def("force_field", [](PyWorld& w, py::object o_id) {
        const auto id = take<ForceFieldId>(o_id, "id");
        const auto answer = w.use("World.force_field").force_field(id);
        return write(answer);
    }, py::arg("id"), "force_field(id: ForceFieldId) -> ForceField\n\nA field, as it is now.");
    c.def_property_readonly("force_fields", [](PyWorld& w) {
        const auto answer = w.use("World.force_fields").force_fields();
        return write(answer);
    },
        "All, in order of slot index.");
    c.def_property_readonly("step_count", [](PyWorld& w) {
        const auto answer = w.use("World.step_count").step_count();
        return write(answer);
    },
        "Steps since the world was made.");
    c.def_property_readonly("time", [](PyWorld& w) {
        const auto answer = w.use("World.time").time();
        return write(answer);
    },
        "Simulated seconds.");
    c.def_property_readonly("kinetic_energy", [](PyWorld& w) {
        const auto answer = w.use("World.kinetic_energy").kinetic_energy();
        return write(answer);
    },
        "J, of all dynamic bodies.");
    c.def_property_readonly("potential_energy", [](PyWorld& w) {
        const auto answer = w.use("World.potential_energy").potential_energy();
        return write(answer);
    },
        "J in the world's gravity, relative to the origin.");
    c.def_property_readonly("linear_momentum", [](PyWorld& w) {
        const auto answer = w.use("World.linear_momentum").linear_momentum();
        return write(answer);
    },
        "kg m/s, of all dynamic bodies.");
    c.def_property_readonly("angular_momentum", [](PyWorld& w) {
        const auto answer = w.use("World.angular_momentum").angular_momentum();
        return write(answer);
    },
        "kg m^2/s about the origin, of all dynamic bodies.");
    c.def_property_readonly("state_hash", [](PyWorld& w) {
        const auto answer = w.use("World.state_hash").state_hash();
        return write(answer);
    },
        "Of positions, rotations and velocities, by bits.");
    c.def_property_readonly("statistics", [](PyWorld& w) {
        const auto answer = w.use("World.statistics").statistics();
        return write(answer);
    },
        "Counts and times of the last step.");
}

} // namespace cairn::python
