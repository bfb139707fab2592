// The extension module cairn._cairn.
#include "module/module.h"

#include "module/docs.h"

#include <cctype>
#include <string_view>

namespace cairn::python {

namespace {

template <class Id> void add_handle(py::module_& m, const char* name) {
    py::class_<Id>(m, name, doc_of(name))
        .def(py::init([](py::object bits) {
                 Id id;
                 read(bits, id.bits, {nullptr, "bits"});
                 return id;
             }),
             py::arg("bits") = 0)
        .def_readonly("bits", &Id::bits)
        .def_property_readonly("index", &Id::index)
        .def_property_readonly("generation", &Id::generation)
        .def_property_readonly("world", &Id::world)
        .def("__bool__", [](Id id) { return bool(id); })
        .def("__hash__", [](Id id) { return std::hash<Id>{}(id); })
        .def("__eq__", [](Id id, py::object other) { return py::isinstance<Id>(other) && *py::cast<Id*>(other) == id; })
        .def("__lt__", [](Id id, Id other) { return id < other; })
        .def("__reduce__",
             [](py::object self) { return py::make_tuple(self.attr("__class__"), py::make_tuple(self.attr("bits"))); })
        .def("__repr__", [name](Id id) {
            if (!id) return std::string(name) + "()";
            return std::string(name) + "(index " + std::to_string(id.index()) + ", generation " +
                   std::to_string(id.generation()) + ", world " + std::to_string(id.world()) + ")";
        });
}

bool is_in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Translates C++ names in a message to Python: `Body::set_position` is the property `Body.position`, and `World::step`
// is `World.step`.
std::string in_python(std::string text) {
    constexpr std::string_view setter = "set_";
    for (std::size_t at = text.find("::"); at != std::string::npos; at = text.find("::", at)) {
        std::size_t begin = at, end = at + 2;
        while (begin > 0 && is_in_name(text[begin - 1])) --begin;
        while (end < text.size() && is_in_name(text[end])) ++end;
        const std::string owner = text.substr(begin, at - begin);
        std::string member = text.substr(at + 2, end - at - 2);
        const py::module_ package = py::module_::import("cairn");
        if (member.starts_with(setter) && py::hasattr(package, owner.c_str()) &&
            py::hasattr(package.attr(owner.c_str()), member.c_str() + setter.size()))
            member.erase(0, setter.size());
        text.replace(begin, end - begin, owner + "." + member);
        at = begin;
    }
    return text;
}

// Converts C++ exceptions to those of cairn/_errors.py.
void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
        const py::object type = py::module_::import("cairn._errors").attr("BY_CODE")[py::int_(int(error.code()))];
        const py::object made = type(in_python(error.what()), in_python(error.field()), error.value());
        PyErr_SetObject(type.ptr(), made.ptr());
    }
}

} // namespace

void add_handles(py::module_& m) {
    add_handle<BodyId>(m, "BodyId");
    add_handle<ShapeId>(m, "ShapeId");
    add_handle<JointId>(m, "JointId");
    add_handle<ForceFieldId>(m, "ForceFieldId");
}

} // namespace cairn::python

PYBIND11_MODULE(_cairn, m) {
    using namespace cairn::python;
    py::options options;
    options.disable_function_signatures(); // the hand-written docstrings contain better signatures
    m.doc() = "The part of the package cairn that is written in C++.";
    m.attr("__version__") = cairn::version_string;
    m.def(
        "instruction_set", [] { return std::string(cairn::instruction_set()); }, doc_of("instruction_set"));
    m.def("hardware_threads", &cairn::hardware_threads, doc_of("hardware_threads"));
    m.def("_spring_from_frequency", [](float hertz, float damping_ratio) { // in float, as in C++
        const cairn::JointSpring spring = cairn::JointSpring::from_frequency(hertz, damping_ratio);
        return py::make_tuple(spring.stiffness, spring.damping);
    });
    py::register_exception_translator(&translate);
    add_handles(m);
    add_geometry(m);
    add_worlds(m);
    add_rollout(m);
}
