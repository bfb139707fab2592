// cairn._cairn._rollout: converts Python arrays to the parameters and records of a rollout.
#include "module/module.h"
#include "module/rollout.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>

namespace cairn::python {

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::string shape_of(py::handle array) { return py::str(array.attr("shape")); }

Parameter parameter_of(py::handle target, const std::string& name, const Numbers& values, std::size_t worlds,
                       std::size_t steps) {
    Parameter p;
    p.name = name;
    p.values = values.data();
    BodyId body;
    if (py::isinstance<ShapeId>(target))
        p.target = *py::cast<ShapeId*>(target);
    else if (py::isinstance<JointId>(target))
        p.target = *py::cast<JointId*>(target);
    else if (!target.is_none())
        read(target, body, {"parameter", "target"}), p.target = body;
    p.numbers = numbers_of(p.target, name);
    std::vector<py::ssize_t> expected{py::ssize_t(worlds)};
    if (p.numbers > 1) expected.push_back(py::ssize_t(p.numbers));
    std::vector<py::ssize_t> of_steps = expected;
    of_steps.insert(of_steps.begin() + 1, py::ssize_t(steps));
    const std::vector<py::ssize_t> shape(values.shape(), values.shape() + values.ndim());
    p.of_steps = shape == of_steps;
    if (p.of_steps || shape == expected) return p;
    const auto text = [](const std::vector<py::ssize_t>& list) {
        return std::string(py::str(py::tuple(py::cast(list))));
    };
    PyErr_SetString(PyExc_ValueError, ("parameter " + name + ": must be of shape " + text(expected) + ", or " +
                                       text(of_steps) + " for a value in each step, got " + shape_of(values))
                                          .c_str());
    throw py::error_already_set();
}

struct Recorded {
    const char* name;
    Record what;
    py::ssize_t numbers; // per body; 0: one value per world
    const char* type;
};
constexpr Recorded recorded[] = {
    {"positions", Record::positions, 3, "f8"},           {"rotations", Record::rotations, 4, "f4"},
    {"velocities", Record::velocities, 3, "f4"},         {"angular_velocities", Record::angular_velocities, 3, "f4"},
    {"kinetic_energy", Record::kinetic_energy, 0, "f8"}, {"potential_energy", Record::potential_energy, 0, "f8"},
    {"state_hash", Record::state_hash, 0, "u8"},
};

const Recorded& find(const std::string& name) {
    std::string names;
    for (const Recorded& row : recorded) {
        if (name == row.name) return row;
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    throw Error(ErrorCode::invalid_value, "record", name, "must be of " + names);
}

py::dict rollout(PyWorld& w, py::list parameters, std::size_t worlds, std::size_t steps, float dt, py::list record,
                 std::size_t every, int threads) {
    const World& world = w.use("rollout");
    const auto require = [](bool holds, const char* field, const std::string& value, const char* expected) {
        if (!holds) throw Error(ErrorCode::invalid_value, field, value, expected);
    };
    require(every >= 1, "every", std::to_string(every), "must be at least 1");
    require(threads >= 1 && threads <= 256, "threads", std::to_string(threads), "must be 1 to 256");
    const Snapshot start = world.save();
    RolloutPlan plan;
    plan.start = &start;
    plan.bodies = world.bodies();
    plan.worlds = worlds, plan.steps = steps, plan.every = every, plan.dt = dt;
    plan.threads = int(std::max<std::size_t>(1, std::min(worlds, std::size_t(threads))));
    std::vector<Numbers> kept; // owns the memory to which the parameters point
    for (const py::handle entry : parameters) {
        const auto tuple = py::cast<py::tuple>(entry);
        kept.push_back(py::cast<Numbers>(tuple[2]));
        plan.parameters.push_back(parameter_of(tuple[0], py::cast<std::string>(tuple[1]), kept.back(), worlds, steps));
    }
    py::dict results;
    for (const py::handle name : record) {
        const Recorded& row = find(py::cast<std::string>(name));
        std::vector<py::ssize_t> shape{py::ssize_t(worlds), py::ssize_t(steps / every)};
        if (row.numbers) shape.insert(shape.end(), {py::ssize_t(plan.bodies.size()), row.numbers});
        py::array array(py::dtype(row.type), shape);
        plan.outputs.push_back({row.what, array.mutable_data()});
        results[name] = array;
    }
    bool interrupted = false;
    plan.goes_on = [&] {
        const py::gil_scoped_acquire acquire;
        interrupted = interrupted || PyErr_CheckSignals() != 0;
        return !interrupted;
    };
    {
        const py::gil_scoped_release release;
        run(plan);
    }
    if (interrupted) throw py::error_already_set();
    return results;
}

} // namespace

void add_rollout(py::module_& m) {
    m.def("_rollout", &rollout, py::arg("world"), py::arg("parameters"), py::arg("worlds"), py::arg("steps"),
          py::arg("dt"), py::arg("record"), py::arg("every"), py::arg("threads"));
}

} // namespace cairn::python
