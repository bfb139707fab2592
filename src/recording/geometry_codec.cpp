#include "recording/geometry_codec.h"

#include "recording/mcap_format.h"

#include <cairn/error.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace cairn::recording {

namespace {

// Geometry types. In the kinds with materials, the materials precede the mesh or height field.
enum class Kind : std::uint8_t { hull, mesh, height_field, mesh_with_materials, height_field_with_materials };

void append(std::string& to, float x) { RecordWriter(to).number(std::bit_cast<std::uint32_t>(x)); }
void append(std::string& to, std::span<const Vec3> points) {
    append_leb128(to, points.size());
    for (const Vec3& point : points) append(to, point.x), append(to, point.y), append(to, point.z);
}

float read_float(RecordReader& from) { return std::bit_cast<float>(from.number<std::uint32_t>()); }

// Reads the number of elements that take at least `size` bytes each.
std::size_t read_count(RecordReader& from, std::size_t size, const std::string& what) {
    const std::uint64_t count = from.leb128();
    if (count > from.rest().size() / size)
        throw Error(ErrorCode::invalid_file, what, std::to_string(count),
                    "must not have a count greater than the remaining bytes");
    return std::size_t(count);
}

std::vector<Vec3> read_points(RecordReader& from, const std::string& what) {
    std::vector<Vec3> points(read_count(from, 12, what));
    for (Vec3& point : points) {
        point.x = read_float(from);
        point.y = read_float(from);
        point.z = read_float(from);
    }
    return points;
}

void append(std::string& to, const SurfaceMaterials& materials) {
    append_leb128(to, materials.materials.size());
    for (const Material& m : materials.materials) {
        for (const float x :
             {m.static_friction, m.dynamic_friction, m.restitution, m.rolling_friction, m.torsional_friction})
            append(to, x);
        to += char(m.friction_combine);
        to += char(m.restitution_combine);
    }
    append_leb128(to, materials.numbers.size());
    for (const std::uint16_t number : materials.numbers) append_leb128(to, number);
}

SurfaceMaterials read_materials(RecordReader& from, const std::string& what) {
    SurfaceMaterials materials;
    materials.materials.resize(read_count(from, 22, what));
    for (Material& m : materials.materials) {
        for (float* const x :
             {&m.static_friction, &m.dynamic_friction, &m.restitution, &m.rolling_friction, &m.torsional_friction})
            *x = read_float(from);
        m.friction_combine = CombineRule(from.number<std::uint8_t>());
        m.restitution_combine = CombineRule(from.number<std::uint8_t>());
    }
    materials.numbers.resize(read_count(from, 1, what));
    for (std::uint16_t& number : materials.numbers) {
        const std::uint64_t value = from.leb128();
        if (value > materials.materials.size())
            throw Error(ErrorCode::invalid_file, what, std::to_string(value), "must be the index of a material");
        number = std::uint16_t(value);
    }
    return materials;
}

Shape read_mesh(RecordReader& from, const std::string& what, const SurfaceMaterials& materials = {}) {
    const std::vector<Vec3> vertices = read_points(from, what);
    std::vector<std::uint32_t> indices(read_count(from, 1, what));
    for (std::uint32_t& index : indices) {
        const std::uint64_t value = from.leb128();
        if (value >= vertices.size())
            throw Error(ErrorCode::invalid_file, what, std::to_string(value), "must be the index of a vertex");
        index = std::uint32_t(value);
    }
    return Mesh(vertices, indices, materials);
}

Shape read_height_field(RecordReader& from, const std::string& what, const SurfaceMaterials& materials = {}) {
    const std::uint32_t columns = from.number<std::uint32_t>(), rows = from.number<std::uint32_t>();
    glm::vec2 spacing;
    spacing.x = read_float(from);
    spacing.y = read_float(from);
    std::vector<float> heights(read_count(from, 4, what));
    for (float& height : heights) height = read_float(from);
    return HeightField(int(columns), int(rows), spacing, heights, materials);
}

void begin(std::string& to, const SurfaceMaterials& materials, Kind without, Kind with) {
    const bool has_any = !materials.materials.empty() || !materials.numbers.empty();
    to += char(has_any ? with : without);
    if (has_any) append(to, materials);
}

} // namespace

std::string encode_geometry(const Shape& shape) {
    std::string bytes;
    if (const auto* hull = std::get_if<Hull>(&shape)) {
        bytes += char(Kind::hull);
        append(bytes, hull->vertices());
    } else if (const auto* mesh = std::get_if<Mesh>(&shape)) {
        begin(bytes, mesh->materials(), Kind::mesh, Kind::mesh_with_materials);
        append(bytes, mesh->vertices());
        append_leb128(bytes, mesh->indices().size());
        for (const std::uint32_t index : mesh->indices()) append_leb128(bytes, index);
    } else {
        const HeightField& field = std::get<HeightField>(shape);
        begin(bytes, field.materials(), Kind::height_field, Kind::height_field_with_materials);
        RecordWriter(bytes).number(std::uint32_t(field.columns())).number(std::uint32_t(field.rows()));
        append(bytes, field.spacing().x), append(bytes, field.spacing().y);
        append_leb128(bytes, field.heights().size());
        for (const float height : field.heights()) append(bytes, height);
    }
    return bytes;
}

Shape decode_geometry(std::string_view bytes, const std::string& what) {
    RecordReader from(bytes, what);
    const std::uint8_t kind = from.number<std::uint8_t>();
    std::optional<Shape> shape;
    if (kind == std::uint8_t(Kind::hull)) shape = Hull(read_points(from, what));
    if (kind == std::uint8_t(Kind::mesh)) shape = read_mesh(from, what);
    if (kind == std::uint8_t(Kind::height_field)) shape = read_height_field(from, what);
    if (kind == std::uint8_t(Kind::mesh_with_materials)) {
        const SurfaceMaterials materials = read_materials(from, what);
        shape = read_mesh(from, what, materials);
    }
    if (kind == std::uint8_t(Kind::height_field_with_materials)) {
        const SurfaceMaterials materials = read_materials(from, what);
        shape = read_height_field(from, what, materials);
    }
    if (!shape)
        throw Error(ErrorCode::unsupported, what, std::to_string(kind),
                    "must be of kind 0 (hull), 1 (mesh), 2 (height field), or 3 or 4 (those with materials) in this "
                    "version of Cairn");
    if (!from.is_empty()) throw Error(ErrorCode::invalid_file, what, "", "has bytes after its end");
    return *shape;
}

std::shared_ptr<const void> shared_geometry(const Shape& shape) {
    if (const auto* hull = std::get_if<Hull>(&shape)) return hull->data();
    if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->data();
    if (const auto* field = std::get_if<HeightField>(&shape)) return field->data();
    return nullptr;
}

} // namespace cairn::recording
