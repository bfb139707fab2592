// Docstrings of hand-written functions and classes; they are taken from the stubs (tools/api_python_stubs.pyi).
#pragma once

namespace cairn::python {

// The docstring of a class, function or member such as "World.step". Throws std::logic_error if there is none.
const char* doc_of(const char* name);

} // namespace cairn::python
