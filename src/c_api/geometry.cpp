// Hulls, meshes and height fields, whose data a C program holds by a pointer.
#include "c_api/generated/convert.h"
#include "c_api/support.h"

#include <cairn/c/cairn.h>

#include <memory>
#include <vector>

using namespace cairn;
using namespace cairn::c_api;

namespace {

// Copies the caller's points, `stride` bytes apart.
std::vector<Vec3> points_of(const float* points, std::size_t count, std::size_t stride, const char* field) {
    require_list(points, count, field);
    if (stride == 0) stride = sizeof(Vec3);
    if (stride < sizeof(Vec3)) refuse("stride", std::to_string(stride), "must be 0 or at least 12");
    std::vector<Vec3> list(count);
    for (std::size_t i = 0; i < count; ++i)
        std::memcpy(&list[i], reinterpret_cast<const std::byte*>(points) + i * stride, sizeof(Vec3));
    return list;
}

template <class T> void make(cairn_geometry** geometry, T&& shape) {
    *geometry = std::make_unique<cairn_geometry>(cairn_geometry{std::forward<T>(shape)}).release();
}

// The geometry as a T; refuses other kinds.
template <class T> const T& as(const cairn_geometry* geometry, const char* what) {
    const T* shape = std::get_if<T>(&required(geometry, "geometry").shape);
    if (!shape) refuse("geometry", "another kind", std::string("must be a ") + what);
    return *shape;
}

SurfaceMaterials materials_of(const cairn_material* materials, std::size_t material_count, const std::uint16_t* numbers,
                              std::size_t number_count) {
    require_list(materials, material_count, "materials");
    require_list(numbers, number_count, "numbers");
    SurfaceMaterials own;
    for (std::size_t i = 0; i < material_count; ++i) own.materials.push_back(to_cpp(materials[i]));
    own.numbers.assign(numbers, numbers + number_count);
    return own;
}
const SurfaceMaterials& materials_of(const cairn_geometry* geometry) {
    if (const auto* field = std::get_if<HeightField>(&required(geometry, "geometry").shape)) return field->materials();
    return as<Mesh>(geometry, "mesh or height field").materials();
}

template <class List, class T> void write_numbers(const List& list, T* out, std::size_t capacity, std::size_t* count) {
    write_list(list, out, capacity, count, [](T number) { return number; });
}
template <class List> void write_points(const List& list, cairn_vec3* out, std::size_t capacity, std::size_t* count) {
    write_list(list, out, capacity, count, [](const Vec3& point) { return to_c(point); });
}

} // namespace

namespace cairn::c_api {

Hull to_cpp(const cairn_hull& c) {
    Hull hull = as<Hull>(&required(c.geometry, "Hull.geometry"), "hull");
    hull.rounding = c.rounding;
    return hull;
}
Mesh to_cpp(const cairn_mesh& c) { return as<Mesh>(&required(c.geometry, "Mesh.geometry"), "mesh"); }
HeightField to_cpp(const cairn_height_field& c) {
    return as<HeightField>(&required(c.geometry, "HeightField.geometry"), "height field");
}
cairn_hull to_c(const Hull& x) { return {new cairn_geometry{x}, x.rounding}; }
cairn_mesh to_c(const Mesh& x) { return {new cairn_geometry{x}}; }
cairn_height_field to_c(const HeightField& x) { return {new cairn_geometry{x}}; }

} // namespace cairn::c_api

cairn_result cairn_geometry_create_hull(const float* points, size_t count, size_t stride, cairn_geometry** geometry) {
    return guarded([&] {
        required(geometry, "geometry");
        make(geometry, Hull(points_of(points, count, stride, "points")));
    });
}

cairn_result cairn_geometry_create_mesh(const float* vertices, size_t vertex_count, size_t stride,
                                        const uint32_t* indices, size_t index_count, cairn_geometry** geometry) {
    return cairn_geometry_create_mesh_with_materials(vertices, vertex_count, stride, indices, index_count, nullptr, 0,
                                                     nullptr, 0, geometry);
}

cairn_result cairn_geometry_create_height_field(int columns, int rows, cairn_vec2 spacing, const float* heights,
                                                size_t height_count, cairn_geometry** geometry) {
    return cairn_geometry_create_height_field_with_materials(columns, rows, spacing, heights, height_count, nullptr, 0,
                                                             nullptr, 0, geometry);
}

cairn_result cairn_geometry_create_mesh_with_materials(const float* vertices, size_t vertex_count, size_t stride,
                                                       const uint32_t* indices, size_t index_count,
                                                       const cairn_material* materials, size_t material_count,
                                                       const uint16_t* numbers, size_t number_count,
                                                       cairn_geometry** geometry) {
    return guarded([&] {
        required(geometry, "geometry");
        require_list(indices, index_count, "indices");
        make(geometry, Mesh(points_of(vertices, vertex_count, stride, "vertices"), std::span(indices, index_count),
                            materials_of(materials, material_count, numbers, number_count)));
    });
}

cairn_result cairn_geometry_create_height_field_with_materials(int columns, int rows, cairn_vec2 spacing,
                                                               const float* heights, size_t height_count,
                                                               const cairn_material* materials, size_t material_count,
                                                               const uint16_t* numbers, size_t number_count,
                                                               cairn_geometry** geometry) {
    return guarded([&] {
        required(geometry, "geometry");
        require_list(heights, height_count, "heights");
        make(geometry, HeightField(columns, rows, to_cpp(spacing), std::span(heights, height_count),
                                   materials_of(materials, material_count, numbers, number_count)));
    });
}

cairn_result cairn_geometry_get_materials(const cairn_geometry* geometry, cairn_material* materials, size_t capacity,
                                          size_t* count) {
    return guarded([&] {
        require_room(materials, capacity, count, "materials");
        write_list(materials_of(geometry).materials, materials, capacity, count,
                   [](const Material& material) { return to_c(material); });
    });
}

cairn_result cairn_geometry_get_material_numbers(const cairn_geometry* geometry, uint16_t* numbers, size_t capacity,
                                                 size_t* count) {
    return guarded([&] {
        require_room(numbers, capacity, count, "numbers");
        write_numbers(materials_of(geometry).numbers, numbers, capacity, count);
    });
}

void cairn_geometry_release(cairn_geometry* geometry) { delete geometry; }

cairn_result cairn_geometry_get_vertices(const cairn_geometry* geometry, cairn_vec3* vertices, size_t capacity,
                                         size_t* count) {
    return guarded([&] {
        require_room(vertices, capacity, count, "vertices");
        if (const Hull* hull = std::get_if<Hull>(&required(geometry, "geometry").shape))
            write_points(hull->vertices(), vertices, capacity, count);
        else if (const auto* field = std::get_if<HeightField>(&geometry->shape))
            write_points(field->vertices(), vertices, capacity, count);
        else
            write_points(as<Mesh>(geometry, "hull, mesh or height field").vertices(), vertices, capacity, count);
    });
}

cairn_result cairn_geometry_get_indices(const cairn_geometry* geometry, uint32_t* indices, size_t capacity,
                                        size_t* count) {
    return guarded([&] {
        require_room(indices, capacity, count, "indices");
        if (const auto* field = std::get_if<HeightField>(&required(geometry, "geometry").shape))
            write_numbers(field->indices(), indices, capacity, count);
        else
            write_numbers(as<Mesh>(geometry, "mesh or height field").indices(), indices, capacity, count);
    });
}

cairn_result cairn_geometry_get_dropped_triangles(const cairn_geometry* geometry, size_t* count) {
    return guarded([&] { required(count, "count") = as<Mesh>(geometry, "mesh").dropped_triangles(); });
}

cairn_result cairn_geometry_get_face_count(const cairn_geometry* geometry, size_t* count) {
    return guarded([&] { required(count, "count") = as<Hull>(geometry, "hull").face_count(); });
}

cairn_result cairn_geometry_get_face(const cairn_geometry* geometry, size_t face, uint32_t* corners, size_t capacity,
                                     size_t* count) {
    return guarded([&] {
        require_room(corners, capacity, count, "corners");
        write_numbers(as<Hull>(geometry, "hull").face(face), corners, capacity, count);
    });
}

cairn_result cairn_geometry_get_volume(const cairn_geometry* geometry, double* volume) {
    return guarded([&] { required(volume, "volume") = as<Hull>(geometry, "hull").volume(); });
}

cairn_result cairn_geometry_get_grid(const cairn_geometry* geometry, int* columns, int* rows, cairn_vec2* spacing) {
    return guarded([&] {
        const HeightField& field = as<HeightField>(geometry, "height field");
        required(columns, "columns"), required(rows, "rows"), required(spacing, "spacing");
        *columns = field.columns();
        *rows = field.rows();
        *spacing = to_c(field.spacing());
    });
}

cairn_result cairn_geometry_get_heights(const cairn_geometry* geometry, float* heights, size_t capacity,
                                        size_t* count) {
    return guarded([&] {
        require_room(heights, capacity, count, "heights");
        write_numbers(as<HeightField>(geometry, "height field").heights(), heights, capacity, count);
    });
}
