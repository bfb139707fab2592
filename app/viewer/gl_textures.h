/// \file gl_textures.h
/// The textures of a scene in GPU memory.
#pragma once

#include "viewer/gl_objects.h"
#include "viewer/shape_meshes.h"

#include <memory>
#include <unordered_map>

namespace cairn::viewer {

class GlTextures {
  public:
    /// Binds the textures of a mesh for the program, which must be current, and uploads them on first use. Unit 0 is
    /// left alone: it holds the shadow map.
    void use(const ShapeMesh& mesh, const GlProgram& program);
    /// Counts one drawn frame of the window, and frees textures that were not used for `most` frames.
    void give_up_unused(int most);

  private:
    void use(const std::shared_ptr<const TexturePicture>& picture, int unit, const char* sampler,
             const GlProgram& program);
    struct Loaded {
        std::shared_ptr<const TexturePicture> source; // kept alive so that its address stays unique
        GlObject texture;
        int unused = 0;
    };
    std::unordered_map<const TexturePicture*, Loaded> loaded_;
};

} // namespace cairn::viewer
