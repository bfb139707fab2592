// Hulls, meshes and height fields from arrays.
#include "module/definitions.h"
#include "module/docs.h"
#include "module/generated/types.h"
#include "module/module.h"

#include <pybind11/numpy.h>

namespace cairn::python {

namespace {

template <class T> using Numbers = py::array_t<T, py::array::c_style | py::array::forcecast>;

// An array with rows of three numbers.
template <class T> std::span<const T> rows(const Numbers<T>& array, const char* name) {
    if (array.ndim() != 2 || array.shape(1) != 3) {
        const std::string shape = py::str(array.attr("shape"));
        PyErr_SetString(PyExc_ValueError, (std::string(name) + ": must be of shape (n, 3), got " + shape).c_str());
        throw py::error_already_set();
    }
    return {array.data(), std::size_t(array.size())};
}

std::vector<Vec3> points(const Numbers<float>& array, const char* name) {
    const std::span<const float> numbers = rows(array, name);
    std::vector<Vec3> list(numbers.size() / 3);
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    return list;
}

py::object array_of(std::span<const Vec3> list) {
    return py::array_t<float>({py::ssize_t(list.size()), py::ssize_t(3)}, list.empty() ? nullptr : &list[0].x);
}

// Negative or too large indices must not wrap around to valid ones.
std::vector<std::uint32_t> indices(const Numbers<std::int64_t>& array) {
    const std::span<const std::int64_t> numbers = rows(array, "indices");
    std::vector<std::uint32_t> list;
    for (const std::int64_t index : numbers) {
        if (index < 0 || index > std::int64_t{0xffffffff})
            throw Error(ErrorCode::invalid_value, "indices", std::to_string(index), "must be those of vertices");
        list.push_back(std::uint32_t(index));
    }
    return list;
}

// Reads material indices of any array shape as a flat list. Negative or too large ones must not wrap around to valid
// ones.
SurfaceMaterials materials_of(const py::iterable& materials, const py::object& numbers) {
    SurfaceMaterials own;
    for (const py::handle& material : materials) {
        own.materials.emplace_back();
        read(material, own.materials.back(), {nullptr, "materials"});
    }
    if (numbers.is_none()) return own;
    const auto list = py::cast<Numbers<std::int64_t>>(numbers);
    for (const std::int64_t number : std::span(list.data(), std::size_t(list.size()))) {
        if (number < 0 || number > std::int64_t(own.materials.size()))
            throw Error(ErrorCode::invalid_value, "material_numbers", std::to_string(number),
                        "must be at most the number of materials, " + std::to_string(own.materials.size()));
        own.numbers.push_back(std::uint16_t(number));
    }
    return own;
}

py::list list_of(const std::vector<Material>& materials) {
    py::list list;
    for (const Material& material : materials) list.append(write(material));
    return list;
}

HeightField height_field(const Numbers<float>& heights, py::object spacing, const py::iterable& materials,
                         const py::object& numbers) {
    if (heights.ndim() != 2) {
        PyErr_SetString(PyExc_ValueError, "heights: must be of shape (rows, columns)");
        throw py::error_already_set();
    }
    const py::ssize_t most = 1 << 28;
    if (heights.shape(0) > most || heights.shape(1) > most)
        throw Error(ErrorCode::invalid_value, "heights", std::to_string(heights.size()), "must be at most 2^28");
    glm::vec2 size;
    read(spacing, size, {nullptr, "spacing"});
    return HeightField(int(heights.shape(1)), int(heights.shape(0)), size,
                       std::span(heights.data(), std::size_t(heights.size())), materials_of(materials, numbers));
}

// Triangles as rows of three indices.
py::array_t<std::uint32_t> triangles(std::span<const std::uint32_t> list) {
    return py::array_t<std::uint32_t>({py::ssize_t(list.size() / 3), py::ssize_t(3)}, list.data());
}

} // namespace

void add_geometry(py::module_& m) {
    py::class_<Hull>(m, "Hull", doc_of("Hull"))
        .def(py::init([](const Numbers<float>& list, float rounding) {
                 Hull hull(points(list, "points"));
                 hull.rounding = rounding;
                 return hull;
             }),
             py::arg("points"), py::arg("rounding") = 0.0f, doc_of("Hull.__init__"))
        .def_readwrite("rounding", &Hull::rounding)
        .def_property_readonly("vertices", [](const Hull& hull) { return array_of(hull.vertices()); })
        .def_property_readonly("faces",
                               [](const Hull& hull) {
                                   py::list faces;
                                   for (std::size_t i = 0; i < hull.face_count(); ++i) {
                                       py::list corners;
                                       for (const std::uint32_t corner : hull.face(i)) corners.append(corner);
                                       faces.append(corners);
                                   }
                                   return faces;
                               })
        .def_property_readonly("volume", &Hull::volume);
    py::class_<Mesh>(m, "Mesh", doc_of("Mesh"))
        .def(py::init([](const Numbers<float>& vertices, const Numbers<std::int64_t>& triangles,
                         const py::iterable& materials, const py::object& numbers) {
                 return Mesh(points(vertices, "vertices"), indices(triangles), materials_of(materials, numbers));
             }),
             py::arg("vertices"), py::arg("indices"), py::arg("materials") = py::tuple(),
             py::arg("material_numbers") = py::none(), doc_of("Mesh.__init__"))
        .def_property_readonly("materials", [](const Mesh& mesh) { return list_of(mesh.materials().materials); })
        .def_property_readonly("material_numbers",
                               [](const Mesh& mesh) {
                                   const auto& numbers = mesh.materials().numbers;
                                   return py::array_t<std::uint16_t>(py::ssize_t(numbers.size()), numbers.data());
                               })
        .def_property_readonly("vertices", [](const Mesh& mesh) { return array_of(mesh.vertices()); })
        .def_property_readonly("indices", [](const Mesh& mesh) { return triangles(mesh.indices()); })
        .def_property_readonly("dropped_triangles", &Mesh::dropped_triangles);
    py::class_<HeightField>(m, "HeightField", doc_of("HeightField"))
        .def(py::init(&height_field), py::arg("heights"), py::arg("spacing"), py::arg("materials") = py::tuple(),
             py::arg("material_numbers") = py::none(), doc_of("HeightField.__init__"))
        .def_property_readonly("materials",
                               [](const HeightField& field) { return list_of(field.materials().materials); })
        .def_property_readonly(
            "material_numbers",
            [](const HeightField& field) {
                const auto& numbers = field.materials().numbers;
                if (numbers.empty()) return py::array_t<std::uint16_t>(py::ssize_t(0));
                return py::array_t<std::uint16_t>({field.rows() - 1, field.columns() - 1}, numbers.data());
            })
        .def_property_readonly("heights",
                               [](const HeightField& field) {
                                   return py::array_t<float>({field.rows(), field.columns()}, field.heights().data());
                               })
        .def_property_readonly("vertices", [](const HeightField& field) { return array_of(field.vertices()); })
        .def_property_readonly("indices", [](const HeightField& field) { return triangles(field.indices()); })
        .def_property_readonly("spacing", [](const HeightField& field) { return write(field.spacing()); });
}

} // namespace cairn::python
