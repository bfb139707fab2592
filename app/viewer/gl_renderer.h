/// \file gl_renderer.h
/// Draws frames with OpenGL 3.3: instanced meshes, a soft shadow map fixed in the world, sky, fading ground,
/// multisampling. One draw call per mesh and pass.
#pragma once

#include "viewer/render_frame.h"

#include <memory>

namespace cairn::viewer {

/// The place on which the shadow map lies. Only depends on the world and on coarse steps of the camera's distance,
/// so shadows do not swim.
struct ShadowRegion {
    Vec3 center{0.0f, 0.0f, 0.0f}; ///< Relative to the frame's origin, meters.
    float radius = 10.0f;          ///< Meters.
};
ShadowRegion shadow_region(const RenderFrame& frame);

class GlRenderer {
  public:
    /// Needs a current context of OpenGL 3.3 or newer. Throws `Error` (unsupported) otherwise.
    GlRenderer();
    ~GlRenderer();
    GlRenderer(const GlRenderer&) = delete;
    GlRenderer& operator=(const GlRenderer&) = delete;

    /// Draws into a framebuffer (0: the window's) of that size in pixels, both > 0, and leaves it bound.
    void draw(const RenderFrame& frame, int width, int height, unsigned framebuffer = 0);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace cairn::viewer
