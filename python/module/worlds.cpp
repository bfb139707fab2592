// Worlds, bodies, snapshots and scene files: the part that is not generated from the table.
#include "module/definitions.h"
#include "module/docs.h"
#include "module/module.h"

#include <filesystem>

namespace cairn::python {

namespace {

std::string path_of(py::handle path) { return py::cast<std::string>(py::module_::import("os").attr("fsdecode")(path)); }

scene::Scene scene_of(const WorldDef& settings) {
    scene::Scene scene;
    scene.world = World(settings);
    return scene;
}

bool is_valid(PyWorld& w, py::object handle) {
    const World& world = w.use("World.is_valid");
    if (py::isinstance<BodyId>(handle)) return world.is_valid(*py::cast<BodyId*>(handle));
    if (py::isinstance<PyBody>(handle)) return world.is_valid(py::cast<PyBody*>(handle)->id);
    if (py::isinstance<ShapeId>(handle)) return world.is_valid(*py::cast<ShapeId*>(handle));
    if (py::isinstance<JointId>(handle)) return world.is_valid(*py::cast<JointId*>(handle));
    if (py::isinstance<ForceFieldId>(handle)) return world.is_valid(*py::cast<ForceFieldId*>(handle));
    refuse_type({nullptr, "handle"}, "a BodyId, ShapeId, JointId or ForceFieldId", handle);
}

void step(PyWorld& w, py::object dt, py::object n) {
    const auto count = take<std::uint64_t>(n, "n");
    const float seconds = dt.is_none() ? w.scene("World.step").info.time_step : take<float>(dt, "dt");
    w.step(seconds, count);
}

template <Column column> py::object array(PyWorld& w) { return w.column(column); }

using WorldClass = py::class_<PyWorld, std::shared_ptr<PyWorld>>;

void add_world_basics(WorldClass& c) {
    c.def(py::init([](py::object given, py::kwargs members) {
              return std::make_shared<PyWorld>(scene_of(take_definition<WorldDef>(given, members, "WorldDef")));
          }),
          py::arg("definition") = py::none(), doc_of("World.__init__"));
    c.def(
        "body",
        [](PyWorld& w, py::object body) {
            const auto id = take<BodyId>(body, "body");
            w.use("World.body").body(id).type(); // throws if the handle is stale
            return PyBody{w.shared_from_this(), id};
        },
        py::arg("body"), doc_of("World.body"));
    c.def(
        "create_body",
        [](PyWorld& w, py::object given, py::kwargs members) {
            const auto def = take_definition<BodyDef>(given, members, "BodyDef");
            const BodyId id = w.use("World.create_body").create_body(def);
            w.retire("a body was created");
            return id;
        },
        py::arg("definition") = py::none(), doc_of("World.create_body"));
    c.def(
        "destroy_body",
        [](PyWorld& w, py::object body) {
            const auto id = take<BodyId>(body, "body");
            w.use("World.destroy_body").destroy_body(id);
            w.retire("a body was destroyed");
        },
        py::arg("body"), doc_of("World.destroy_body"));
    c.def("is_valid", &is_valid, py::arg("handle"), doc_of("World.is_valid"));
    c.def("step", &step, py::arg("dt") = py::none(), py::arg("n") = 1, doc_of("World.step"));
    c.def("close", &PyWorld::close, doc_of("World.close"));
    c.def_property_readonly("closed", &PyWorld::is_closed);
    c.def("__enter__", [](py::object self) { return self; });
    c.def("__exit__", [](PyWorld& w, py::args) { w.close(); });
    c.def(
        "save", [](PyWorld& w) { return w.use("World.save").save(); }, doc_of("World.save"));
    c.def(
        "restore",
        [](PyWorld& w, const Snapshot& snapshot) {
            w.use("World.restore").restore(snapshot);
            w.retire("another state was restored");
        },
        py::arg("snapshot"), doc_of("World.restore"));
}

void add_world_arrays(WorldClass& c) {
    c.def_property_readonly("positions", &array<Column::positions>, doc_of("World.positions"));
    c.def_property_readonly("rotations", &array<Column::rotations>, doc_of("World.rotations"));
    c.def_property_readonly("velocities", &array<Column::velocities>, doc_of("World.velocities"));
    c.def_property_readonly("angular_velocities", &array<Column::angular_velocities>,
                            doc_of("World.angular_velocities"));
}

void add_scene_members(WorldClass& c) {
    c.def_property(
        "time_step", [](PyWorld& w) { return w.scene("World.time_step").info.time_step; },
        [](PyWorld& w, py::object value) {
            const auto seconds = take<float>(value, "World.time_step");
            if (!(seconds >= 0.0001f && seconds <= 1.0f)) // as in scene files
                throw Error(ErrorCode::invalid_value, "World.time_step", std::string(py::str(value)),
                            "must be 0.0001 to 1 s");
            w.scene("World.time_step").info.time_step = seconds;
        });
    c.def_property(
        "title", [](PyWorld& w) { return w.scene("World.title").info.title; },
        [](PyWorld& w, py::object text) { w.scene("World.title").info.title = take<std::string>(text, "title"); });
    c.def_property(
        "hint", [](PyWorld& w) { return w.scene("World.hint").info.hint; },
        [](PyWorld& w, py::object text) { w.scene("World.hint").info.hint = take<std::string>(text, "hint"); });
    c.def_property_readonly("warnings", [](PyWorld& w) { return write(w.scene("World.warnings").warnings); });
}

void add_files(py::module_& m) {
    m.def(
        "load",
        [](py::object path, bool fixed_base) {
            return std::make_shared<PyWorld>(scene::load(path_of(path), {.fixed_base = fixed_base}));
        },
        py::arg("path"), py::arg("fixed_base") = false, doc_of("load"));
    m.def(
        "save", [](PyWorld& w, py::object path) { scene::save(w.scene("save"), path_of(path)); }, py::arg("world"),
        py::arg("path"), doc_of("save"));
    m.def(
        "find_scene", [](const std::string& name) { return scene::find_scene(name).string(); }, py::arg("name"),
        doc_of("find_scene"));
}

} // namespace

void add_worlds(py::module_& m) {
    py::class_<Snapshot>(m, "Snapshot", doc_of("Snapshot")).def_property_readonly("nbytes", [](const Snapshot& s) {
        return s.bytes.size();
    });
    WorldClass world(m, "World", doc_of("World"));
    py::class_<PyBody> body(m, "Body", doc_of("Body"));
    add_world_basics(world);
    add_world_arrays(world);
    add_scene_members(world);
    add_world_calls(world);
    body.def_property_readonly("id", [](const PyBody& b) { return b.id; });
    body.def_property_readonly("world", [](const PyBody& b) { return b.world; });
    body.def("__repr__", [](py::object self) { return py::str("Body of {!r}").format(self.attr("id")); });
    body.def("__eq__", [](const PyBody& b, py::object other) {
        return py::isinstance<PyBody>(other) && py::cast<PyBody*>(other)->id == b.id &&
               py::cast<PyBody*>(other)->world == b.world;
    });
    body.def("__hash__", [](const PyBody& b) { return std::hash<BodyId>{}(b.id); });
    add_body_calls(body);
    add_files(m);
}

} // namespace cairn::python
