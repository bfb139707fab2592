#include "module/convert.h"

#include "module/body.h"

#include <pybind11/numpy.h>

#include <cmath>
#include <unordered_map>

namespace cairn::python {

namespace {

std::string type_name(py::handle o) { return Py_TYPE(o.ptr())->tp_name; }

// A new read-only array of numbers.
template <class T> py::object array_of(const T* numbers, int rows, int columns) {
    const py::object array = rows == 1 ? new_array<T>({columns}) : new_array<T>({rows, columns});
    py::detail::PyArray_Proxy* const proxy = py::detail::array_proxy(array.ptr());
    std::memcpy(proxy->data, numbers, sizeof(T) * std::size_t(rows) * std::size_t(columns));
    proxy->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

double number(py::handle o, const Where& where) {
    const double value = PyFloat_AsDouble(o.ptr());
    if (value == -1 && PyErr_Occurred()) {
        PyErr_Clear();
        refuse_type(where, "a number", o);
    }
    return value;
}

// Reads exactly `count` numbers from any object with a length.
void numbers(py::handle o, double* out, std::size_t count, const Where& where) {
    if (py::isinstance<py::array>(o)) {
        const auto array = py::reinterpret_borrow<py::array>(o);
        if (array.ndim() != 1) {
            const std::string shape = py::str(array.attr("shape"));
            PyErr_SetString(PyExc_ValueError, (where.text() + ": must be " + std::to_string(count) +
                                               " numbers, got an array of shape " + shape)
                                                  .c_str());
            throw py::error_already_set();
        }
        if (std::size_t(array.shape(0)) != count) refuse_length(where, count, std::size_t(array.shape(0)));
        const char* const data = static_cast<const char*>(array.data());
        const auto copy = [&]<class T>(T value) {
            for (std::size_t i = 0; i < count; ++i) {
                std::memcpy(&value, data + py::ssize_t(i) * array.strides(0), sizeof value);
                out[i] = double(value);
            }
        };
        if (py::isinstance<py::array_t<double>>(o)) return copy(double{});
        if (py::isinstance<py::array_t<float>>(o)) return copy(float{});
    }
    if (PyUnicode_Check(o.ptr()) || !PySequence_Check(o.ptr()))
        refuse_type(where, std::to_string(count) + " numbers", o);
    const py::object list = py::reinterpret_steal<py::object>(PySequence_Fast(o.ptr(), ""));
    if (!list) throw py::error_already_set();
    const auto length = std::size_t(PySequence_Fast_GET_SIZE(list.ptr()));
    if (length != count) refuse_length(where, count, length);
    for (std::size_t i = 0; i < count; ++i) out[i] = number(PySequence_Fast_GET_ITEM(list.ptr(), Py_ssize_t(i)), where);
}

template <class T> void read_unsigned(py::handle o, T& x, const Where& where) {
    if (!PyLong_Check(o.ptr())) refuse_type(where, "a whole number", o);
    const unsigned long long value = PyLong_AsUnsignedLongLong(o.ptr());
    if (PyErr_Occurred() || value != T(value)) {
        PyErr_Clear();
        PyErr_SetString(PyExc_ValueError, (where.text() + ": must be 0 to 2**" + std::to_string(8 * sizeof(T)) +
                                           " - 1, got " + std::string(py::str(o)))
                                              .c_str());
        throw py::error_already_set();
    }
    x = T(value);
}

template <class Id> void read_id(py::handle o, Id& x, const char* type, const Where& where) {
    if (!py::isinstance<Id>(o)) refuse_type(where, type, o);
    x = *py::cast<Id*>(o);
}

template <class T> void read_geometry(py::handle o, T& x, const char* type, const Where& where) {
    if (!py::isinstance<T>(o)) refuse_type(where, type, o);
    x = *py::cast<T*>(o);
}

} // namespace

void refuse_type(const Where& where, const std::string& expected, py::handle value) {
    PyErr_SetString(PyExc_TypeError, (where.text() + ": must be " + expected + ", got " + type_name(value)).c_str());
    throw py::error_already_set();
}

void refuse_length(const Where& where, std::size_t expected, std::size_t length) {
    PyErr_SetString(
        PyExc_ValueError,
        (where.text() + ": must be " + std::to_string(expected) + " long, got " + std::to_string(length)).c_str());
    throw py::error_already_set();
}

void read(py::handle o, bool& x, const Where& where) {
    if (!PyBool_Check(o.ptr()) && type_name(o) != "numpy.bool_") refuse_type(where, "True or False", o);
    x = PyObject_IsTrue(o.ptr()) == 1;
}
void read(py::handle o, int& x, const Where& where) {
    const py::object whole = py::reinterpret_steal<py::object>(PyNumber_Index(o.ptr()));
    if (!whole) {
        PyErr_Clear();
        refuse_type(where, "a whole number", o);
    }
    int overflow = 0;
    const long value = PyLong_AsLongAndOverflow(whole.ptr(), &overflow);
    if (overflow || value != int(value)) {
        PyErr_SetString(PyExc_ValueError, (where.text() + ": must fit into 32 bits").c_str());
        throw py::error_already_set();
    }
    x = int(value);
}
void read(py::handle o, float& x, const Where& where) { x = float(number(o, where)); }
void read(py::handle o, double& x, const Where& where) { x = number(o, where); }
void read(py::handle o, std::uint32_t& x, const Where& where) { read_unsigned(o, x, where); }
void read(py::handle o, std::uint64_t& x, const Where& where) { read_unsigned(o, x, where); }
void read(py::handle o, std::string& x, const Where& where) {
    if (!PyUnicode_Check(o.ptr())) refuse_type(where, "a str", o);
    x = py::cast<std::string>(o);
}
void read(py::handle o, glm::vec2& x, const Where& where) {
    double n[2];
    numbers(o, n, 2, where);
    x = {float(n[0]), float(n[1])};
}
void read(py::handle o, Vec3& x, const Where& where) {
    double n[3];
    numbers(o, n, 3, where);
    x = {float(n[0]), float(n[1]), float(n[2])};
}
void read(py::handle o, Position& x, const Where& where) { numbers(o, &x.x, 3, where); }
void read(py::handle o, Quat& x, const Where& where) {
    double n[4];
    numbers(o, n, 4, where);
    x = Quat(float(n[3]), float(n[0]), float(n[1]), float(n[2]));
}
void read(py::handle o, BodyId& x, const Where& where) {
    if (py::isinstance<PyBody>(o))
        x = py::cast<PyBody*>(o)->id;
    else
        read_id(o, x, "a BodyId or Body", where);
}
void read(py::handle o, ShapeId& x, const Where& where) { read_id(o, x, "a ShapeId", where); }
void read(py::handle o, JointId& x, const Where& where) { read_id(o, x, "a JointId", where); }
void read(py::handle o, ForceFieldId& x, const Where& where) { read_id(o, x, "a ForceFieldId", where); }
void read(py::handle o, Hull& x, const Where& where) { read_geometry(o, x, "a Hull", where); }
void read(py::handle o, Mesh& x, const Where& where) { read_geometry(o, x, "a Mesh", where); }
void read(py::handle o, HeightField& x, const Where& where) { read_geometry(o, x, "a HeightField", where); }

py::handle class_of(const char* type) {
    // The references are never released: the classes live as long as the interpreter.
    static std::unordered_map<std::string, py::handle> classes;
    py::handle& found = classes[type];
    if (!found) found = py::object(py::module_::import("cairn._types").attr(type)).release();
    return found;
}

bool is_a(py::handle o, const char* type) { return py::isinstance(o, class_of(type)); }

py::object make(const char* type, py::tuple values) {
    PyObject* const made = PyObject_CallObject(class_of(type).ptr(), values.ptr());
    if (!made) throw py::error_already_set();
    return py::reinterpret_steal<py::object>(made);
}

int read_enum(py::handle o, const char* type, const Where& where) {
    const py::handle members = class_of(type);
    if (py::isinstance(o, members)) return py::cast<int>(o.attr("value"));
    if (PyUnicode_Check(o.ptr()) && members.attr("__members__").contains(o))
        return py::cast<int>(members.attr("__members__")[o].attr("value"));
    std::string names;
    for (const py::handle name : members.attr("__members__"))
        names += (names.empty() ? "" : ", ") + py::cast<std::string>(name);
    if (!PyUnicode_Check(o.ptr())) refuse_type(where, std::string("a ") + type + " (" + names + ")", o);
    PyErr_SetString(PyExc_ValueError,
                    (where.text() + ": must be one of " + names + ", got " + std::string(py::str(o))).c_str());
    throw py::error_already_set();
}

py::object write_enum(const char* type, int value) { return class_of(type)(value); }

py::object write(bool x) { return py::bool_(x); }
py::object write(int x) { return py::int_(x); }
py::object write(float x) { return py::float_(double(x)); }
py::object write(double x) { return py::float_(x); }
py::object write(std::uint64_t x) { return py::int_(x); }
py::object write(const std::string& x) { return py::str(x); }
py::object write(const glm::vec2& x) { return array_of(&x.x, 1, 2); }
py::object write(const Vec3& x) { return array_of(&x.x, 1, 3); }
py::object write(const Position& x) { return array_of(&x.x, 1, 3); }
py::object write(const Quat& x) {
    const float numbers[4] = {x.x, x.y, x.z, x.w};
    return array_of(numbers, 1, 4);
}
py::object write(const Mat3& x) {
    float rows[9];
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) rows[3 * row + column] = x[column][row];
    return array_of(rows, 3, 3);
}
py::object write(BodyId x) { return py::cast(x); }
py::object write(ShapeId x) { return py::cast(x); }
py::object write(JointId x) { return py::cast(x); }
py::object write(ForceFieldId x) { return py::cast(x); }
py::object write(const Hull& x) { return py::cast(x); }
py::object write(const Mesh& x) { return py::cast(x); }
py::object write(const HeightField& x) { return py::cast(x); }

} // namespace cairn::python
