// Docstrings of what is not made from the table; they are those of the stubs (tools/api_python_stubs.pyi).
#pragma once

namespace cairn::python {

// Of a class, function or member such as "World.step". Throws std::logic_error if it has none.
const char* doc_of(const char* name);

} // namespace cairn::python
