// What a file that is written has for looks: triangles, pictures, and the bones of meshes that bend.
#pragma once

#include "scene/buffer_writer.h"
#include "scene/scene.h"

#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace cairn::scene {

// Members of an array of the file, each line once.
class Table {
  public:
    std::size_t index(const nlohmann::ordered_json& entry);
    const std::vector<std::string>& lines() const { return lines_; }

  private:
    std::unordered_map<std::string, std::size_t> indices_; // looked up, never walked through
    std::vector<std::string> lines_;
};

class LookWriter {
  public:
    explicit LookWriter(BufferWriter& buffer) : buffer_(buffer) {}

    // A glTF primitive with the triangles of a surface, which outlives this, without a material.
    nlohmann::ordered_json primitive(const Surface& surface);
    // What a glTF material says of its texture and its finish, if there are any.
    void add_look(const Texture* texture, const Finish* finish, nlohmann::ordered_json& material);
    // The index of the skin with these bones; `node_of` tells the node of a body, or of what stands still at the
    // origin.
    std::size_t skin(std::span<const Bone> bones, const std::function<std::size_t(BodyId)>& node_of);

    // Arrays of the file by their names.
    std::vector<std::pair<const char*, const std::vector<std::string>*>> arrays() const;

    bool uses_glow_strength() const { return uses_glow_strength_; } // KHR_materials_emissive_strength

  private:
    // The textureInfo; null without a picture.
    nlohmann::ordered_json texture_info(const Texture* texture);
    void add_finish(const Finish& finish, nlohmann::ordered_json& material);

    bool uses_glow_strength_ = false;
    BufferWriter& buffer_;
    Table textures_, samplers_, images_, skins_;
    std::unordered_map<const Surface*, nlohmann::ordered_json> primitives_; // looked up, never walked through
    std::unordered_map<const std::string*, std::size_t> image_of_file_;
    std::map<std::string, std::size_t> skin_of_bones_; // by their bytes
};

} // namespace cairn::scene
