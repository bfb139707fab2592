#include "scene/visuals.h"

#include "scene/definitions.h"
#include "scene/document.h"

namespace cairn::scene {

namespace {

constexpr Range color_range{0.0, 1.0, false};
constexpr float texture_gray = 0.4f; // what a texture is taken for

} // namespace

std::optional<Vec3> Visuals::own_color(const Value& node) const {
    const auto extras = node.find("extras");
    if (!extras || !extras->is_object()) return std::nullopt;
    const auto color = extras->find("cairn_color");
    return color ? std::optional(color->float_vector3(color_range)) : std::nullopt;
}

std::optional<Vec3> Visuals::material_color(const Value& index) const {
    const Value material = element(document_.find("materials"), index, max_definitions, "materials");
    const auto roughness = material.find("pbrMetallicRoughness");
    const auto color = roughness ? roughness->find("baseColorFactor") : std::nullopt;
    const bool is_textured = roughness && roughness->find("baseColorTexture");
    if (!color && !is_textured) return std::nullopt;
    Vec3 plain(1.0f);
    if (color) {
        if (color->size(4, "numbers") != 4) color->fail("must be an array of 4 numbers");
        plain = {(*color)[0].real(color_range), (*color)[1].real(color_range), (*color)[2].real(color_range)};
    }
    return is_textured ? texture_gray * plain : plain;
}

std::optional<Vec3> Visuals::color(const Value& node) const {
    if (const auto own = own_color(node)) return own;
    const auto index = node.find("mesh");
    if (!index) return std::nullopt;
    const Value primitives = element(document_.find("meshes"), *index, max_meshes, "meshes").require("primitives");
    if (primitives.size(max_primitives, "primitives") == 0) primitives.fail("must not be empty");
    const auto material = primitives[0].find("material");
    return material ? material_color(*material) : std::nullopt;
}

void Visuals::add(const Value& node, const std::optional<BodyId>& body, const NodeTransform& transform, Scene& scene,
                  std::vector<std::string>& warnings) {
    const auto index = node.find("mesh");
    const glm::dvec3& scale = transform.scale;
    if (!index || scale.x == 0.0 || scale.y == 0.0 || scale.z == 0.0) return;
    if (transform.is_skewed) {
        warnings.push_back(node.place() + "is skewed: its mesh is not shown");
        return;
    }
    require_usable(transform, node);
    try {
        const std::vector<Triangles>& parts = surfaces_.mesh(*index, warnings);
        const auto own = own_color(node);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            VisualMesh visual;
            if (body) visual.body = *body;
            visual.local = {transform.translation, Quat(transform.rotation)};
            visual.surface = scaled(*index, i, parts[i], scale);
            std::optional<Vec3> color = own;
            if (!color && parts[i].material) color = material_color(*parts[i].material);
            if (color) visual.color = *color;
            if (!own && parts[i].material) warn_of_texture(*parts[i].material, warnings);
            scene.visuals.push_back(std::move(visual));
        }
    } catch (const Error& error) {
        if (error.code() != ErrorCode::unsupported) throw;
        warnings.push_back(std::string(error.what()) + " (its mesh is not shown)");
    }
}

void Visuals::warn_of_texture(const Value& index, std::vector<std::string>& warnings) {
    const Value material = element(document_.find("materials"), index, max_definitions, "materials");
    const auto roughness = material.find("pbrMetallicRoughness");
    if (has_warned_of_textures_ || !roughness || !roughness->find("baseColorTexture")) return;
    has_warned_of_textures_ = true;
    warnings.push_back(roughness->place() +
                       "baseColorTexture is not shown: textures are taken for a plain gray, tinted "
                       "by the base color");
}

std::shared_ptr<const Surface> Visuals::scaled(const Value& mesh, std::size_t part, const Triangles& triangles,
                                               const glm::dvec3& scale) {
    std::shared_ptr<const Surface>& found =
        shared_[{mesh.index(max_meshes, "meshes"), part, scale.x, scale.y, scale.z}];
    if (!found) {
        Triangles made = surfaces_.mapped(triangles, affine(scale), mesh);
        found = std::make_shared<const Surface>(
            Surface{std::move(made.vertices), std::move(made.normals), std::move(made.indices)});
    }
    return found;
}

} // namespace cairn::scene
