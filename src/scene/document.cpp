#include "scene/document.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace cairn::scene {

namespace {

// Prefixes of extensions that affect appearance only, not the simulation.
constexpr std::array<std::string_view, 8> visual_prefixes{
    "KHR_lights_", "KHR_materials_", "KHR_texture_",           "KHR_mesh_quantization", "KHR_draco_mesh_compression",
    "EXT_lights_", "EXT_texture_",   "EXT_meshopt_compression"};

bool is_harmless(std::string_view name) {
    const std::vector<std::string>& understood = understood_extensions();
    if (std::find(understood.begin(), understood.end(), name) != understood.end()) return true;
    return std::any_of(visual_prefixes.begin(), visual_prefixes.end(),
                       [&](std::string_view prefix) { return name.substr(0, prefix.size()) == prefix; });
}

} // namespace

const std::vector<std::string>& understood_extensions() {
    static const std::vector<std::string> names{
        "KHR_physics_rigid_bodies", "KHR_implicit_shapes", "CAIRN_world", "CAIRN_body", "CAIRN_material", "CAIRN_joint",
        "CAIRN_height_field",       "CAIRN_shape",         "CAIRN_mesh"};
    return names;
}

void check_document(const Value& document) {
    document.must_be_object();
    const Value version = document.require("asset").require("version");
    if (const std::string text = version.text(); text.substr(0, 2) != "2.") {
        version.refuse("must be a version 2 of glTF, got \"" + text.substr(0, 20) + "\"");
    }
    const auto required = document.find("extensionsRequired");
    const std::size_t count = required ? required->size(1000, "extensions") : 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Value name = (*required)[i];
        if (const std::string text = name.text(); !is_harmless(text)) {
            name.refuse("the file requires the extension \"" + text.substr(0, 60) + "\", which is not supported");
        }
    }
}

std::optional<Value> default_scene(const Value& document) {
    const auto scenes = document.find("scenes");
    const auto chosen = document.find("scene");
    const std::size_t count = scenes ? scenes->size(10000, "scenes") : 0;
    if (chosen) return (*scenes)[chosen->index(count, "scenes")];
    if (count == 0) return std::nullopt;
    return (*scenes)[0];
}

std::optional<Value> extension(const Value& owner, const char* name) {
    const auto extensions = owner.find("extensions");
    return extensions ? extensions->find(name) : std::nullopt;
}

Value element(const std::optional<Value>& array, const Value& index, std::size_t limit, const char* what) {
    const std::size_t count = array ? array->size(limit, what) : 0;
    if (count == 0) index.fail(std::string("must be left out, as the file has no ") + what);
    return (*array)[index.index(count, what)];
}

} // namespace cairn::scene
