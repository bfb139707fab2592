// Conversion of lists and optional values; include after the declarations for their elements.
#pragma once

#include "module/generated/types.h"

namespace cairn::python {

template <class T> void read(py::handle o, std::optional<T>& x, const Where& where) {
    x.reset();
    if (!o.is_none()) read(o, x.emplace(), where);
}

// The elements of a Python sequence as a tuple, which stays valid while they are read, even if reading runs Python
// code.
inline py::tuple elements(py::handle o, const Where& where) {
    if (PyUnicode_Check(o.ptr()) || !PySequence_Check(o.ptr())) refuse_type(where, "a sequence", o);
    return py::tuple(py::reinterpret_borrow<py::object>(o));
}

template <class T> void read(py::handle o, std::vector<T>& x, const Where& where) {
    x.clear();
    for (const py::handle element : elements(o, where)) read(element, x.emplace_back(), where);
}

template <class T, std::size_t n> void read(py::handle o, std::array<T, n>& x, const Where& where) {
    const py::tuple list = elements(o, where);
    if (list.size() != n) refuse_length(where, n, list.size());
    for (std::size_t i = 0; i < n; ++i) read(list[i], x[i], where);
}

template <class T> py::object write(const std::optional<T>& x) {
    if (x) return write(*x);
    return py::none();
}

template <class List> py::object write_list(const List& list) {
    py::list out(std::size(list));
    std::size_t i = 0;
    for (const auto& element : list) out[i++] = write(element);
    return out;
}
template <class T> py::object write(const std::vector<T>& x) { return write_list(x); }
template <class T, std::size_t n> py::object write(const std::array<T, n>& x) { return write_list(x); }
template <class T, std::size_t n> py::object write(const T (&x)[n]) { return write_list(x); }
// Copies the elements first, as creating Python objects may run code that steps the world and invalidates `x`.
template <class T> py::object write(std::span<const T> x) { return write_list(std::vector<T>(x.begin(), x.end())); }

// Reads the value of a call's argument.
template <class T> T take(py::handle o, const char* name) {
    T x{};
    read(o, x, {nullptr, name});
    return x;
}

} // namespace cairn::python
