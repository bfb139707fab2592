// The pictures that a document's materials refer to (glTF 2.0, sections 3.8 and 3.9).
#pragma once

#include "scene/scene.h"
#include "scene/surfaces.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cairn::scene {

// The texture and finish that a material gives a surface, and the texture coordinates of its vertices.
struct MaterialAppearance {
    std::shared_ptr<const Texture> texture; // none: no texture
    std::shared_ptr<const Finish> finish;   // none: the material does not define a finish
    std::vector<glm::vec2> coordinates;     // empty: no texture
};

class Textures {
  public:
    Textures(const Value& document, Surfaces& surfaces) : document_(document), surfaces_(surfaces) {}

    // Whether the material's base color comes from a texture.
    static bool is_textured(const Value& material);

    // `warn` is called for everything that is left out: pictures that are missing or of an unsupported kind.
    using Warn = std::function<void(const std::string&)>;
    MaterialAppearance covering(const Value& material, const Triangles& triangles, const Warn& warn);

  private:
    std::string read_picture(const Value& image);
    std::shared_ptr<const Texture> read_texture(const Value& info, const Value& material, bool is_data);

    Value document_;
    Surfaces& surfaces_;
    // `known_`: keyed by image, sampler values, cutoff and use; `files_`: by image.
    std::map<std::string, std::shared_ptr<const Texture>> known_;
    std::map<std::size_t, std::shared_ptr<const std::string>> files_;
};

} // namespace cairn::scene
