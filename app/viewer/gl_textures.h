/// \file gl_textures.h
/// The pictures of a scene on the graphics card.
#pragma once

#include "viewer/gl_objects.h"
#include "viewer/textures.h"

#include <memory>
#include <unordered_map>

namespace cairn::viewer {

class GlTextures {
  public:
    /// Makes it the texture of the active unit. The first time, it comes to the graphics card.
    void use(const std::shared_ptr<const TexturePicture>& picture);
    /// Counts a picture of the window, and gives up what was not used for `most` of them.
    void give_up_unused(int most);

  private:
    struct Loaded {
        std::shared_ptr<const TexturePicture> source; // keeps its address its own
        GlObject texture;
        int unused = 0;
    };
    std::unordered_map<const TexturePicture*, Loaded> loaded_;
};

} // namespace cairn::viewer
