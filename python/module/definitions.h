// Definitions that a call takes as an object or as keyword arguments.
#pragma once

#include "module/containers.h"

namespace cairn::python {

// Reads `world.create_body(mass=3)`: an object of the class `type` with these members.
template <class T> T take_definition(py::handle given, const py::kwargs& members, const char* type) {
    if (given.is_none()) return take<T>(class_of(type)(**members), type);
    if (!members.empty()) {
        PyErr_SetString(PyExc_TypeError, (std::string(type) + ": give it, or its members by name, not both").c_str());
        throw py::error_already_set();
    }
    return take<T>(given, type);
}

} // namespace cairn::python
