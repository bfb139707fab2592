/// \file gl_textures.h
/// The pictures of a scene on the graphics card.
#pragma once

#include "viewer/gl_objects.h"
#include "viewer/shape_meshes.h"

#include <memory>
#include <unordered_map>

namespace cairn::viewer {

class GlTextures {
  public:
    /// Makes the pictures of a mesh those of the program, which is the current one. The first time, they come to the
    /// graphics card. Unit 0 stays as it is: it has the shadow map.
    void use(const ShapeMesh& mesh, const GlProgram& program);
    /// Counts a picture of the window, and gives up what was not used for `most` of them.
    void give_up_unused(int most);

  private:
    void use(const std::shared_ptr<const TexturePicture>& picture, int unit, const char* sampler,
             const GlProgram& program);
    struct Loaded {
        std::shared_ptr<const TexturePicture> source; // keeps its address its own
        GlObject texture;
        int unused = 0;
    };
    std::unordered_map<const TexturePicture*, Loaded> loaded_;
};

} // namespace cairn::viewer
