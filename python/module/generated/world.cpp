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
            "its mass properties were given, updates these. A dynamic body whose shapes have no mass has its given "
                "mass, or 1 kg, at a point, and does not rotate. Planes, meshes and height fields are refused on "
                    "dynamic bodies (wrong_state).");
    c.def("remove_shape", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        w.use("World.remove_shape").remove_shape(shape);
        w.update();
    }, py::arg("shape"), "remove_shape(shape: ShapeId) -> None\n\nRemoves a shape from its body and, unless the mass "
        "properties of the body were given, updates these.");
    c.def("set_shape", [](PyWorld& w, py::object o_shape, py::object o_geometry) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto geometry = take<Shape>(o_geometry, "geometry");
        w.use("World.set_shape").set_shape(shape, geometry);
        w.update();
    }, py::arg("shape"), py::arg("geometry"), "set_shape(shape: ShapeId, geometry: Shape) -> None\n\nReplaces the "
        "geometry of a shape; its handle and its definition stay. The mass of the body is updated as when a shape is "
            "added. If the new geometry is of the same type, contacts with shapes that it still touches continue "
                "without events; otherwise its contacts end and begin anew. Shapes that overlap the new geometry are "
                    "pushed out with at most `WorldDef.recovery_speed`. Rising ground therefore carries the bodies on "
                        "it if it rises more slowly than that, and in one call by less than the height of the body. "
                            "Wakes the body of the shape, and bodies around the old and the new geometry.");
    c.def("set_shape_def", [](PyWorld& w, py::object o_shape, py::object o_definition, py::kwargs members) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto def = take_definition<ShapeDef>(o_definition, members, "ShapeDef");
        w.use("World.set_shape_def").set_shape_def(shape, def);
        w.update();
    }, py::arg("shape"), py::arg("definition") = py::none(), "set_shape_def(shape: ShapeId, definition: ShapeDef | "
        "None = None, **members: Any) -> None\n\nReplaces the definition of a shape in the same way as its geometry: "
            "its pose on the body, density, material, filter, and so on. To change only a part of it, begin with the "
                "present definition. Its contacts end and begin anew if `is_trigger` or `filter` changes.");
    c.def("body_of", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.body_of").body_of(shape);
        return write(answer);
    }, py::arg("shape"), "body_of(shape: ShapeId) -> BodyId\n\nThe body to which a shape belongs.");
    c.def("shape", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.shape").shape(shape);
        return write(answer);
    }, py::arg("shape"), "shape(shape: ShapeId) -> Shape\n\nThe geometry of a shape.");
    c.def("shape_def", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.shape_def").shape_def(shape);
        return write(answer);
    }, py::arg("shape"), "shape_def(shape: ShapeId) -> ShapeDef\n\nThe present definition of a shape.");
    c.def("shape_transform", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.shape_transform").shape_transform(shape);
        return write(answer);
    }, py::arg("shape"), "shape_transform(shape: ShapeId) -> Transform\n\nThe pose of a shape in world space.");
    c.def("shape_bounds", [](PyWorld& w, py::object o_shape) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto answer = w.use("World.shape_bounds").shape_bounds(shape);
        return write(answer);
    }, py::arg("shape"), "shape_bounds(shape: ShapeId) -> Bounds\n\nTight axis-aligned bounds of a "
        "shape, meters; infinite for infinite planes.");
    c.def("set_material", [](PyWorld& w, py::object o_shape, py::object o_material) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto material = take<Material>(o_material, "material");
        w.use("World.set_material").set_material(shape, material);
        w.update();
    }, py::arg("shape"), py::arg("material"), "set_material(shape: ShapeId, material: Material) -> None\n\nReplaces "
        "the material of a shape.");
    c.def("set_filter", [](PyWorld& w, py::object o_shape, py::object o_filter) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto filter = take<CollisionFilter>(o_filter, "filter");
        w.use("World.set_filter").set_filter(shape, filter);
        w.update();
    }, py::arg("shape"), py::arg("filter"), "set_filter(shape: ShapeId, filter: CollisionFilter) -> None\n\nReplaces "
        "the collision filter of a shape.");
    c.def("set_surface_velocity", [](PyWorld& w, py::object o_shape, py::object o_velocity) {
        const auto shape = take<ShapeId>(o_shape, "shape");
        const auto velocity = take<Vec3>(o_velocity, "velocity");
        w.use("World.set_surface_velocity").set_surface_velocity(shape, velocity);
        w.update();
    }, py::arg("shape"), py::arg("velocity"), "set_surface_velocity(shape: ShapeId, velocity: Vector) -> None\n\nSets "
        "`ShapeDef.surface_velocity`, m/s. Refused (wrong_state) for a shape of a dynamic body.");
    c.def_property_readonly("bodies", [](PyWorld& w) {
        const auto answer = w.use("World.bodies").bodies();
        return write(answer);
    },
        "All bodies, in order of slot index.");
    c.def("find_body", [](PyWorld& w, py::object o_name) {
        const auto name = take<std::string>(o_name, "name");
        const auto answer = w.use("World.find_body").find_body(name);
        return write(answer);
    }, py::arg("name"), "find_body(name: str) -> BodyId | None\n\nThe first body with that name.");
    c.def("create_joint", [](PyWorld& w, py::object o_definition, py::kwargs members) {
        const auto def = take_definition<JointDef>(o_definition, members, "JointDef");
        const auto answer = w.use("World.create_joint").create_joint(def);
        w.update();
        return write(answer);
    }, py::arg("definition") = py::none(), "create_joint(definition: JointDef | None = None, **members: Any) -> "
        "JointId\n\nJoins two bodies, or a body and the world, and wakes them.");
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
        "BodyId | Body, body_b: BodyId | Body, anchor: Vector, axis: Vector, joint: Joint) -> JointDef\n\nReturns the "
            "definition of a joint whose two frames coincide, for the present poses of the bodies: with their origin "
                "at `anchor` (world space, meters) and x along `axis` (world space, any non-zero vector). The y and z "
                    "axes result from the shortest rotation that takes the world's x axis to `axis`: for an `axis` "
                        "along +y, they are -x and z.");
    c.def("destroy_joint", [](PyWorld& w, py::object o_joint) {
        const auto joint = take<JointId>(o_joint, "joint");
        w.use("World.destroy_joint").destroy_joint(joint);
        w.update();
    }, py::arg("joint"), "destroy_joint(joint: JointId) -> None\n\nDestroys a joint and wakes its bodies.");
    c.def("joint_def", [](PyWorld& w, py::object o_joint) {
        const auto joint = take<JointId>(o_joint, "joint");
        const auto answer = w.use("World.joint_def").joint_def(joint);
        return write(answer);
    }, py::arg("joint"), "joint_def(joint: JointId) -> JointDef\n\nThe present definition of a joint.");
    c.def("set_joint", [](PyWorld& w, py::object o_id, py::object o_joint) {
        const auto id = take<JointId>(o_id, "id");
        const auto joint = take<Joint>(o_joint, "joint");
        w.use("World.set_joint").set_joint(id, joint);
        w.update();
    }, py::arg("id"), py::arg("joint"), "set_joint(id: JointId, joint: Joint) -> None\n\nReplaces the type-specific "
        "part of a joint: limits, motors, springs, or its type. Wakes its bodies.");
    c.def("set_joint_strength", [](PyWorld& w, py::object o_joint, py::object o_break_force, py::object
        o_break_torque) {
        const auto joint = take<JointId>(o_joint, "joint");
        const auto break_force = take<float>(o_break_force, "break_force");
        const auto break_torque = take<float>(o_break_torque, "break_torque");
        w.use("World.set_joint_strength").set_joint_strength(joint, break_force, break_torque);
        w.update();
    }, py::arg("joint"), py::arg("break_force"), py::arg("break_torque"), "set_joint_strength(joint: "
        "JointId, break_force: float, break_torque: float) -> None\n\nSets the force (N) and torque (N m) at which a "
            "joint breaks, > 0; may be infinite.");
    c.def("set_joint_enabled", [](PyWorld& w, py::object o_joint, py::object o_enabled) {
        const auto joint = take<JointId>(o_joint, "joint");
        const auto enabled = take<bool>(o_enabled, "enabled");
        w.use("World.set_joint_enabled").set_joint_enabled(joint, enabled);
        w.update();
    }, py::arg("joint"), py::arg("enabled"), "set_joint_enabled(joint: JointId, enabled: bool) -> None\n\nDisables or "
        "enables a joint. A disabled joint keeps its definition and its handle but does not act: its bodies move and "
            "collide as if it had been destroyed. When it is enabled, it starts with zero impulses, and pulls its "
                "bodies together if they have moved apart. Both wake its bodies.");
    c.def("joint_state", [](PyWorld& w, py::object o_joint) {
        const auto joint = take<JointId>(o_joint, "joint");
        const auto answer = w.use("World.joint_state").joint_state(joint);
        return write(answer);
    }, py::arg("joint"), "joint_state(joint: JointId) -> JointState\n\nForces, positions and errors of a joint in the "
        "last step.");
    c.def_property_readonly("joints", [](PyWorld& w) {
        const auto answer = w.use("World.joints").joints();
        return write(answer);
    },
        "All joints, in order of slot index.");
    c.def("find_joint", [](PyWorld& w, py::object o_name) {
        const auto name = take<std::string>(o_name, "name");
        const auto answer = w.use("World.find_joint").find_joint(name);
        return write(answer);
    }, py::arg("name"), "find_joint(name: str) -> JointId | None\n\nThe first joint with that name.");
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
            "None, **members: Any) -> RayHit | None\n\nThe nearest intersection of a ray with a shape within "
                "`max_distance` (meters). `direction` need not have unit length. A ray that starts inside a shape "
                    "does not hit that shape; only one that starts below an infinite plane hits it, at distance 0.");
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
            "None, **members: Any) -> list[RayHit]\n\nThe intersections of the ray with all shapes within "
                "`max_distance` (meters), nearest first.");
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
            "ShapeCastHit | None\n\nThe first shape that the given convex shape hits when it moves by `translation` "
                "(meters) from `start` without rotation. The accuracy is a millionth of the size of the smaller "
                    "shape. If they overlap at the start, the fraction is 0, and point and normal are those of the "
                        "smallest separating translation; if several shapes overlap, the one with the lowest slot "
                            "index is returned. Planes, meshes and height fields are hit from outside only, and "
                                "cannot be cast (invalid_value).");
    c.def("closest_point", [](PyWorld& w, py::object o_point, py::object o_max_distance, py::object o_filter,
        py::kwargs members) {
        const auto point = take<Position>(o_point, "point");
        const auto max_distance = take<double>(o_max_distance, "max_distance");
        const auto filter = take_definition<QueryFilter>(o_filter, members, "QueryFilter");
        const auto answer = w.use("World.closest_point").closest_point(point, max_distance, filter);
        return write(answer);
    }, py::arg("point"), py::arg("max_distance"), py::arg("filter") = py::none(), "closest_point(point: "
        "Vector, max_distance: float, filter: QueryFilter | None = None, **members: Any) -> ClosestPoint | "
            "None\n\nThe shape nearest to a point, at most `max_distance` (meters, >= 0) away. Points below a plane "
                "are inside it; meshes and height fields have no inside.");
    c.def("overlap", [](PyWorld& w, py::object o_shape, py::object o_pose, py::object o_filter, py::kwargs members) {
        const auto shape = take<Shape>(o_shape, "shape");
        const auto pose = take<Transform>(o_pose, "pose");
        const auto filter = take_definition<QueryFilter>(o_filter, members, "QueryFilter");
        const auto answer = w.use("World.overlap").overlap(shape, pose, filter);
        return write(answer);
    }, py::arg("shape"), py::arg("pose"), py::arg("filter") = py::none(), "overlap(shape: Shape, pose: "
        "Transform, filter: QueryFilter | None = None, **members: Any) -> list[ShapeId]\n\nAll shapes that have a "
            "point in common with the given shape at `pose` (touching counts), in order of slot index. A plane is "
                "solid below. Rectangles, strips, double-sided planes, meshes and height fields are surfaces without "
                    "thickness: a shape that touches or crosses them from any side overlaps them; a shape entirely "
                        "below does not. Two surfaces never overlap.");
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
        "list[BroadPhaseNode]\n\nThe present nodes of the broad phase down to `max_depth` (>= 0), in order of "
            "depth, at most `max_count` (>= 0): for visualization, and to find out why a scene is slow.");
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
        "list[DebugLine]\n\nThe contents of the world as lines, for programs with their own renderer: bodies in order "
            "of slot index, then contacts, then joints. There is a line for each edge, which takes time for large "
                "meshes and height fields.");
    c.def_property_readonly("contact_begins", [](PyWorld& w) {
        const auto answer = w.use("World.contact_begins").contact_begins();
        return write(answer);
    },
        "Pairs of shapes that began to touch in the last step.");
    c.def_property_readonly("contact_ends", [](PyWorld& w) {
        const auto answer = w.use("World.contact_ends").contact_ends();
        return write(answer);
    },
        "Pairs of shapes that ceased to touch in the last step.");
    c.def_property_readonly("contact_hits", [](PyWorld& w) {
        const auto answer = w.use("World.contact_hits").contact_hits();
        return write(answer);
    },
        "Pairs of shapes that hit each other in the last step with an approach speed of at least "
            "`WorldDef.hit_speed`.");
    c.def_property_readonly("trigger_events", [](PyWorld& w) {
        const auto answer = w.use("World.trigger_events").trigger_events();
        return write(answer);
    },
        "Shapes that entered or left triggers in the last step.");
    c.def_property_readonly("joint_events", [](PyWorld& w) {
        const auto answer = w.use("World.joint_events").joint_events();
        return write(answer);
    },
        "Joints that broke, or of which a body was destroyed, in the last step or since then.");
    c.def_property_readonly("sleep_events", [](PyWorld& w) {
        const auto answer = w.use("World.sleep_events").sleep_events();
        return write(answer);
    },
        "Bodies that fell asleep or woke up in the last step.");
    c.def_property_readonly("contacts", [](PyWorld& w) {
        const auto answer = w.use("World.contacts").contacts();
        return write(answer);
    },
        "The contact manifolds of all touching pairs of shapes.");
    c.def_property("settings", [](PyWorld& w) {
        const auto answer = w.use("World.settings").settings();
        return write(answer);
    }, [](PyWorld& w, py::object o) {
        const auto value = take<WorldDef>(o, "World.settings");
        w.use("World.settings").set_settings(value);
        w.update();
    }, "The present settings of the world. Setting: Replaces the settings. Wakes all bodies if gravity changes.");
    c.def("usual_substeps", [](PyWorld& w, py::object o_dt) {
        const auto dt = take<float>(o_dt, "dt");
        const auto answer = w.use("World.usual_substeps").usual_substeps(dt);
        return write(answer);
    }, py::arg("dt"), "usual_substeps(dt: float) -> int\n\nThe number of substeps in a step of `dt` seconds for "
        "islands that need no more: `WorldDef.substeps`, or, if that is 0, the number for which it stands. Refused "
            "(invalid_value) unless `dt` is finite and > 0.");
    c.def_property("threads", [](PyWorld& w) {
        const auto answer = w.use("World.threads").threads();
        return write(answer);
    }, [](PyWorld& w, py::object o) {
        const auto value = take<int>(o, "World.threads");
        w.use("World.threads").set_threads(value);
        w.update();
    }, "The number of threads that a step may use. Setting: Sets the number of threads that a step may use, 1 to 256: "
        "the caller's, and `count` - 1 that the world keeps. Default: 1. Results do not depend on it, and it is not "
            "part of snapshots. Refused (invalid_value) outside that range, and (unsupported) if the system cannot "
                "create the threads.");
    c.def("add_force_field", [](PyWorld& w, py::object o_field, py::kwargs members) {
        const auto field = take_definition<ForceField>(o_field, members, "ForceField");
        const auto answer = w.use("World.add_force_field").add_force_field(field);
        w.update();
        return write(answer);
    }, py::arg("field") = py::none(), "add_force_field(field: ForceField | None = None, **members: Any) -> "
        "ForceFieldId\n\nAdds a force field, which acts on all dynamic bodies from the next step on.");
    c.def("set_force_field", [](PyWorld& w, py::object o_id, py::object o_field, py::kwargs members) {
        const auto id = take<ForceFieldId>(o_id, "id");
        const auto field = take_definition<ForceField>(o_field, members, "ForceField");
        w.use("World.set_force_field").set_force_field(id, field);
        w.update();
    }, py::arg("id"), py::arg("field") = py::none(), "set_force_field(id: ForceFieldId, field: ForceField | None = "
        "None, **members: Any) -> None\n\nReplaces a force field by another.");
    c.def("remove_force_field", [](PyWorld& w, py::object o_id) {
        const auto id = take<ForceFieldId>(o_id, "id");
        w.use("World.remove_force_field").remove_force_field(id);
        w.update();
    }, py::arg("id"), "remove_force_field(id: ForceFieldId) -> None\n\nRemoves a force field from the world.");
    c.def("force_field", [](PyWorld& w, py::object o_id) {
        const auto id = take<ForceFieldId>(o_id, "id");
        const auto answer = w.use("World.force_field").force_field(id);
        return write(answer);
    }, py::arg("id"), "force_field(id: ForceFieldId) -> ForceField\n\nThe present definition of a force field.");
    c.def_property_readonly("force_fields", [](PyWorld& w) {
        const auto answer = w.use("World.force_fields").force_fields();
        return write(answer);
    },
        "All force fields, in order of slot index.");
    c.def_property_readonly("step_count", [](PyWorld& w) {
        const auto answer = w.use("World.step_count").step_count();
        return write(answer);
    },
        "Number of steps since the world was created.");
    c.def_property_readonly("time", [](PyWorld& w) {
        const auto answer = w.use("World.time").time();
        return write(answer);
    },
        "Simulated time since the world was created, seconds.");
    c.def_property_readonly("kinetic_energy", [](PyWorld& w) {
        const auto answer = w.use("World.kinetic_energy").kinetic_energy();
        return write(answer);
    },
        "Kinetic energy of all dynamic bodies, J.");
    c.def_property_readonly("potential_energy", [](PyWorld& w) {
        const auto answer = w.use("World.potential_energy").potential_energy();
        return write(answer);
    },
        "Potential energy in the world's gravity, relative to the origin, J.");
    c.def_property_readonly("linear_momentum", [](PyWorld& w) {
        const auto answer = w.use("World.linear_momentum").linear_momentum();
        return write(answer);
    },
        "Linear momentum of all dynamic bodies, kg m/s.");
    c.def_property_readonly("angular_momentum", [](PyWorld& w) {
        const auto answer = w.use("World.angular_momentum").angular_momentum();
        return write(answer);
    },
        "Angular momentum of all dynamic bodies about the origin, kg m^2/s.");
    c.def_property_readonly("state_hash", [](PyWorld& w) {
        const auto answer = w.use("World.state_hash").state_hash();
        return write(answer);
    },
        "A hash of the bits of all positions, rotations and velocities.");
    c.def_property_readonly("statistics", [](PyWorld& w) {
        const auto answer = w.use("World.statistics").statistics();
        return write(answer);
    },
        "Counts and times of the last step.");
}

} // namespace cairn::python
