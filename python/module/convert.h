// Values between Python and C++. Each `read` says where a value that it refuses stands: TypeError where it is of the
// wrong type, ValueError where it has the wrong length; whether numbers are in range is the engine's to say.
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

// Where a value comes from, for messages: "BodyDef.mass", or "position" of a call.
struct Where {
    const char* owner; // may be null
    const char* name;
    std::string text() const { return owner ? std::string(owner) + "." + name : name; }
};

[[noreturn]] void refuse_type(const Where& where, const std::string& expected, py::handle value);
[[noreturn]] void refuse_length(const Where& where, std::size_t expected, std::size_t length);

// A new array of NumPy, whose memory is its own.
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
void read(py::handle o, BodyId& x, const Where& where); // a Body will do
void read(py::handle o, ShapeId& x, const Where& where);
void read(py::handle o, JointId& x, const Where& where);
void read(py::handle o, ForceFieldId& x, const Where& where);
void read(py::handle o, Hull& x, const Where& where);
void read(py::handle o, Mesh& x, const Where& where);
void read(py::handle o, HeightField& x, const Where& where);

// The value of an enum of Python: its member, or the name of one. `type` is the class's name.
int read_enum(py::handle o, const char* type, const Where& where);
py::object write_enum(const char* type, int value);
// A class of cairn/_types.py.
py::handle class_of(const char* type);
bool is_a(py::handle o, const char* type);
// An instance of it with these values, in the order of its fields.
py::object make(const char* type, py::tuple values);

py::object write(bool x);
py::object write(int x);
py::object write(float x);
py::object write(double x);
py::object write(std::uint64_t x);
py::object write(const std::string& x);
py::object
write(const glm::vec2& x); // arrays are read-only: they are copies, and writing into them would change nothing
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
