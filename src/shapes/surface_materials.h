// Materials of individual triangles of meshes and cells of height fields.
#pragma once

#include "shapes/mesh.h"

#include <cairn/shape.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace cairn {

// Throws Error(invalid_value) with a field below `field`.
void check_material(std::string_view field, const Material& material);
// `type` is "Mesh" or "HeightField", and `parts` the number of its triangles or cells.
void check_materials(const std::string& type, const SurfaceMaterials& materials, std::size_t parts);

// The index of a triangle's material; 0 is the material of the shape.
inline std::uint32_t material_number(const MeshData& mesh, std::uint32_t triangle) {
    return mesh.materials.numbers.empty() ? 0 : mesh.materials.numbers[triangle];
}
inline std::uint32_t material_number(const HeightFieldData& field, std::uint32_t triangle) {
    return field.materials.numbers.empty() ? 0 : field.materials.numbers[triangle / 2];
}

} // namespace cairn
