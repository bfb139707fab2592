#include "scene/look_writer.h"

#include "scene/json_number.h"

namespace cairn::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr int wrap_codes[] = {10497, 33648, 33071}, nearest = 9728, linear = 9729; // glTF 2.0, section 5.26

template <class T> void append_bytes(std::string& text, const T& value) {
    // The bytes serve as a key only: they are compared, never decoded.
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace

std::size_t Table::index(const Json& entry) {
    const auto [found, is_new] = indices_.try_emplace(json_text(entry), lines_.size());
    if (is_new) lines_.push_back(found->first);
    return found->second;
}

Json LookWriter::primitive(const Surface& surface) {
    Json& primitive = primitives_[&surface];
    if (!primitive.is_null()) return primitive;
    Json& attributes = primitive["attributes"];
    attributes["POSITION"] = buffer_.add_vertices(surface.vertices, true);
    if (!surface.normals.empty()) attributes["NORMAL"] = buffer_.add_vertices(surface.normals, false);
    if (!surface.coordinates.empty()) attributes["TEXCOORD_0"] = buffer_.add_coordinates(surface.coordinates);
    if (!surface.weights.empty()) {
        attributes["JOINTS_0"] = buffer_.add_bone_numbers(surface.weights);
        attributes["WEIGHTS_0"] = buffer_.add_bone_shares(surface.weights);
    }
    if (!surface.colors.empty()) attributes["COLOR_0"] = buffer_.add_vertices(surface.colors, false);
    primitive["indices"] = buffer_.add_indices(surface.indices);
    return primitive;
}

Json LookWriter::texture_info(const Texture* texture) {
    if (texture == nullptr || !texture->file || texture->file->empty()) return nullptr;
    const auto [image, is_new] = image_of_file_.try_emplace(texture->file.get());
    if (is_new) {
        const bool is_png = texture->file->front() == '\x89';
        image->second = images_.index(
            {{"bufferView", buffer_.add_file(*texture->file)}, {"mimeType", is_png ? "image/png" : "image/jpeg"}});
    }
    const std::size_t sampler = samplers_.index({{"magFilter", texture->is_smooth ? linear : nearest},
                                                 {"wrapS", wrap_codes[int(texture->wrap_u)]},
                                                 {"wrapT", wrap_codes[int(texture->wrap_v)]}});
    return {{"index", textures_.index({{"sampler", sampler}, {"source", image->second}})}};
}

void LookWriter::add_look(const Texture* texture, const Finish* finish, Json& material) {
    if (Json info = texture_info(texture); !info.is_null()) {
        material["pbrMetallicRoughness"]["baseColorTexture"] = std::move(info);
        if (texture->alpha_cutoff > 0.0f) {
            material["alphaMode"] = "MASK";
            material["alphaCutoff"] = shortest(texture->alpha_cutoff);
        }
    }
    if (finish != nullptr) add_finish(*finish, material);
}

void LookWriter::add_finish(const Finish& finish, Json& material) {
    Json& metal = material["pbrMetallicRoughness"];
    metal["metallicFactor"] = shortest(finish.metalness);
    metal["roughnessFactor"] = shortest(finish.roughness);
    if (Json info = texture_info(finish.rough.get()); !info.is_null())
        metal["metallicRoughnessTexture"] = std::move(info);
    if (Json info = texture_info(finish.normals.get()); !info.is_null()) {
        if (finish.normal_scale != 1.0f) info["scale"] = shortest(finish.normal_scale);
        material["normalTexture"] = std::move(info);
    }
    if (finish.glow == Vec3(0.0f)) return;
    material["emissiveFactor"] = number_array(finish.glow);
    if (finish.glow_strength != 1.0f) {
        material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = shortest(finish.glow_strength);
        uses_glow_strength_ = true;
    }
    if (Json info = texture_info(finish.glows.get()); !info.is_null()) material["emissiveTexture"] = std::move(info);
}

std::size_t LookWriter::skin(std::span<const Bone> bones, const std::function<std::size_t(BodyId)>& node_of) {
    std::string key;
    for (const Bone& bone : bones) {
        append_bytes(key, bone.body.bits);
        append_bytes(key, bone.linear);
        append_bytes(key, bone.translation);
    }
    const auto [found, is_new] = skin_of_bones_.try_emplace(std::move(key));
    if (!is_new) return found->second;
    Json joints = Json::array();
    for (const Bone& bone : bones) joints.push_back(node_of(bone.body));
    return found->second =
               skins_.index({{"joints", std::move(joints)}, {"inverseBindMatrices", buffer_.add_bindings(bones)}});
}

std::vector<std::pair<const char*, const std::vector<std::string>*>> LookWriter::arrays() const {
    return {{"textures", &textures_.lines()},
            {"samplers", &samplers_.lines()},
            {"images", &images_.lines()},
            {"skins", &skins_.lines()}};
}

} // namespace cairn::scene
