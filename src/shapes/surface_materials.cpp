#include "shapes/surface_materials.h"

#include "shapes/refuse.h"

#include <cmath>
#include <limits>

namespace cairn {

void check_material(std::string_view field, const Material& material) {
    const auto refuse_member = [&](const char* member, float value, const char* expected) {
        refuse(std::string(field) + member, number_text(double(value)), expected);
    };
    const auto check_size = [&](const char* member, float value) {
        if (!(std::isfinite(value) && value >= 0)) refuse_member(member, value, "must be finite and >= 0");
    };
    check_size(".static_friction", material.static_friction);
    check_size(".dynamic_friction", material.dynamic_friction);
    if (!(material.restitution >= 0 && material.restitution <= 1))
        refuse_member(".restitution", material.restitution, "must be from 0 to 1");
    check_size(".rolling_friction", material.rolling_friction);
    check_size(".torsional_friction", material.torsional_friction);
    for (const CombineRule rule : {material.friction_combine, material.restitution_combine})
        if (rule > CombineRule::multiply)
            refuse(std::string(field) + ".combine", std::to_string(int(rule)), "must be one of the enumerators");
}

void check_materials(const std::string& type, const SurfaceMaterials& materials, std::size_t parts) {
    constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
    const std::string field = type + " materials";
    if (materials.materials.size() > most)
        refuse(field + ".materials", std::to_string(materials.materials.size()), "must be at most 65535");
    for (std::size_t i = 0; i < materials.materials.size(); ++i)
        check_material(field + ".materials[" + std::to_string(i) + "]", materials.materials[i]);
    if (materials.numbers.empty()) return;
    if (materials.numbers.size() != parts)
        refuse(field + ".numbers", std::to_string(materials.numbers.size()),
               (type == "Mesh" ? "there must be one of each triangle, " : "there must be one of each cell, ") +
                   std::to_string(parts) + ", or none");
    for (std::size_t i = 0; i < materials.numbers.size(); ++i)
        if (materials.numbers[i] > materials.materials.size())
            refuse(field + ".numbers[" + std::to_string(i) + "]", std::to_string(materials.numbers[i]),
                   "must be at most the number of materials, " + std::to_string(materials.materials.size()));
}

} // namespace cairn
