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

// What a material has for a surface, and where in its textures the corners of that lie.
struct Covering {
    std::shared_ptr<const Texture> texture; // none: not covered
    std::shared_ptr<const Finish> finish;   // none: the material says nothing of it
    std::vector<glm::vec2> coordinates;     // none: no texture
};

class Textures {
  public:
    Textures(const Value& document, Surfaces& surfaces) : document_(document), surfaces_(surfaces) {}

    // Whether the material's base color is that of a picture.
    static bool is_textured(const Value& material);

    // `warn` is told of what is left out: pictures that are not there, or are of a kind that is not read.
    using Warn = std::function<void(const std::string&)>;
    Covering covering(const Value& material, const Triangles& triangles, const Warn& warn);

  private:
    std::string read_picture(const Value& image);
    std::shared_ptr<const Texture> read_texture(const Value& info, const Value& material, bool is_data);

    Value document_;
    Surfaces& surfaces_;
    // By image, sampler's values, cutoff and use; the files by image.
    std::map<std::string, std::shared_ptr<const Texture>> known_;
    std::map<std::size_t, std::shared_ptr<const std::string>> files_;
};

} // namespace cairn::scene
