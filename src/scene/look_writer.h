// Writes appearances to a glTF file: triangles, pictures, and the bones of skinned meshes.
#pragma once

#include "scene/buffer_writer.h"
#include "scene/scene.h"

#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace cairn::scene {

// The entries of an array of the file; equal entries are written once.
class Table {
  public:
    std::size_t index(const nlohmann::ordered_json& entry);
    const std::vector<std::string>& lines() const { return lines_; }

  private:
    std::unordered_map<std::string, std::size_t> indices_; // looked up, never iterated
    std::vector<std::string> lines_;
};

class LookWriter {
  public:
    explicit LookWriter(BufferWriter& buffer) : buffer_(buffer) {}

    // Returns a glTF primitive with the triangles of a surface, without a material. The surface must outlive the
    // writer.
    nlohmann::ordered_json primitive(const Surface& surface);
    // Adds a texture and a finish, if there are any, to a glTF material.
    void add_look(const Texture* texture, const Finish* finish, nlohmann::ordered_json& material);
    // Returns the index of the skin with these bones. `node_of` returns the node of a body, or for a null body a node
    // that stays at the origin.
    std::size_t skin(std::span<const Bone> bones, const std::function<std::size_t(BodyId)>& node_of);

    // The arrays of the file with their names.
    std::vector<std::pair<const char*, const std::vector<std::string>*>> arrays() const;

    bool uses_glow_strength() const { return uses_glow_strength_; } // KHR_materials_emissive_strength

  private:
    // Returns the textureInfo object; null without a picture.
    nlohmann::ordered_json texture_info(const Texture* texture);
    void add_finish(const Finish& finish, nlohmann::ordered_json& material);

    bool uses_glow_strength_ = false;
    BufferWriter& buffer_;
    Table textures_, samplers_, images_, skins_;
    std::unordered_map<const Surface*, nlohmann::ordered_json> primitives_; // looked up, never iterated
    std::unordered_map<const std::string*, std::size_t> image_of_file_;
    std::map<std::string, std::size_t> skin_of_bones_; // keyed by the bytes of the bones
};

} // namespace cairn::scene
