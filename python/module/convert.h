// Conversion of values between Python and C++. Each `read` reports the location of an invalid value: it throws
// TypeError for a wrong type, and ValueError for a wrong length. The ranges of numbers are checked by the engine.
#pragma once

#include <cairn/cairn.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cairn::python {

namespace py = pybind11;

// The origin of a value, for messages: "BodyDef.mass", or the argument "position" of a call.
struct Where {
    const char* owner; // may be null
    const char* name;
    std::string text() const { return owner ? std::string(owner) + "." + name : name; }
};

[[noreturn]] void refuse_type(const Where& where, const std::string& expected, py::handle value);
[[noreturn]] void refuse_length(const Where& where, std::size_t expected, std::size_t length);

// A new NumPy array that owns its memory.
template <class T> py::object new_array(std::initializer_list<py::ssize_t> sizes) {
    const auto& numpy = py::detail::npy_api::get();
    py::ssize_t list[3];
    std::copy(sizes.begin(), sizes.end(), list);
    PyObject* const array = numpy.PyArray_NewFromDescr_(numpy.PyArray_Type_, py::dtype::of<T>().release().ptr(),
                                                        int(sizes.size()), list, nullptr, nullptr, 0, nullptr);
    if (!array) throw py::error_already_set();
    return py::reinterpret_steal<py::object>(array);
}

void read(py::handle o, bool& x, const Where& where);
void read(py::handle o, int& x, const Where& where);
void read(py::handle o, float& x, const Where& where);
void read(py::handle o, double& x, const Where& where);
void read(py::handle o, std::uint32_t& x, const Where& where);
void read(py::handle o, std::uint64_t& x, const Where& where);
void read(py::handle o, std::string& x, const Where& where);
void read(py::handle o, glm::vec2& x, const Where& where);
void read(py::handle o, Vec3& x, const Where& where);
void read(py::handle o, Position& x, const Where& where);
void read(py::handle o, Quat& x, const Where& where);   // x, y, z, w
void read(py::handle o, BodyId& x, const Where& where); // a Body is accepted too
void read(py::handle o, ShapeId& x, const Where& where);
void read(py::handle o, JointId& x, const Where& where);
void read(py::handle o, ForceFieldId& x, const Where& where);
void read(py::handle o, Hull& x, const Where& where);
void read(py::handle o, Mesh& x, const Where& where);
void read(py::handle o, HeightField& x, const Where& where);

// The value of a Python enum: one of its members, or the name of one. `type` is the name of the class.
int read_enum(py::handle o, const char* type, const Where& where);
py::object write_enum(const char* type, int value);
// A class of cairn/_types.py.
py::handle class_of(const char* type);
bool is_a(py::handle o, const char* type);
// An instance of that class with these values, in the order of its fields.
py::object make(const char* type, py::tuple values);

py::object write(bool x);
py::object write(int x);
py::object write(float x);
py::object write(double x);
py::object write(std::uint64_t x);
py::object write(const std::string& x);
py::object write(const glm::vec2& x); // arrays are read-only copies: writing into them would have no effect
py::object write(const Vec3& x);
py::object write(const Position& x);
py::object write(const Quat& x);
py::object write(const Mat3& x);
py::object write(BodyId x);
py::object write(ShapeId x);
py::object write(JointId x);
py::object write(ForceFieldId x);
py::object write(const Hull& x);
py::object write(const Mesh& x);
py::object write(const HeightField& x);

} // namespace cairn::python
