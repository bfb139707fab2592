// Textures of base colors: the pictures that a document's materials refer to (glTF 2.0, sections 3.8 and 3.9).
#pragma once

#include "scene/scene.h"
#include "scene/surfaces.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cairn::scene {

// A texture, and where in it the corners of a surface lie.
struct Covering {
    std::shared_ptr<const Texture> texture; // none: not covered
    std::vector<glm::vec2> coordinates;
};

class Textures {
  public:
    Textures(const Value& document, Surfaces& surfaces) : document_(document), surfaces_(surfaces) {}

    // Whether the material's base color is that of a picture.
    static bool is_textured(const Value& material);

    // Throws Error if the picture is not there, or is of a kind that is not read.
    Covering covering(const Value& material, const Triangles& triangles);

  private:
    std::string read_picture(const Value& image);
    std::shared_ptr<const Texture> read_texture(const Value& texture, const Value& material);

    Value document_;
    Surfaces& surfaces_;
    // By image, sampler's values and cutoff; the files by image.
    std::map<std::string, std::shared_ptr<const Texture>> known_;
    std::map<std::size_t, std::shared_ptr<const std::string>> files_;
};

} // namespace cairn::scene
