// Functions that define the parts of the module.
#pragma once

#include "module/body.h"

namespace cairn::python {

void add_handles(py::module_& m);
void add_geometry(py::module_& m);
void add_worlds(py::module_& m);
void add_rollout(py::module_& m);
void add_world_calls(py::class_<PyWorld, std::shared_ptr<PyWorld>>& c);
void add_body_calls(py::class_<PyBody>& c);

} // namespace cairn::python
