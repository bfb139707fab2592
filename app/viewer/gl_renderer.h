/// \file gl_renderer.h
/// Renders frames with OpenGL 3.3: instanced meshes, a soft shadow map fixed in the world, sky, fading ground,
/// anti-aliasing. One draw call per mesh and pass.
#pragma once

#include "viewer/render_frame.h"

#include <memory>

namespace cairn::viewer {

/// The method of anti-aliasing.
enum class Smoothing {
    samples, ///< 4x multisampling: for pictures that are saved.
    edges,   ///< A post-processing pass over the finished picture: less than half the time with software rendering.
};

/// A rectangle of a framebuffer (0: the window's), in pixels; width and height > 0.
struct PicturePlace {
    unsigned framebuffer = 0;
    int left = 0, bottom = 0, width = 0, height = 0;
};

class GlRenderer {
  public:
    /// Needs a current context of OpenGL 3.3 or newer. Throws `Error` (unsupported) otherwise.
    GlRenderer();
    ~GlRenderer();
    GlRenderer(const GlRenderer&) = delete;
    GlRenderer& operator=(const GlRenderer&) = delete;

    /// Draws into that rectangle, and leaves the framebuffer bound. `scale`, at most 1: renders at that fraction of the
    /// resolution in each dimension, and stretches the result (not with multisampling).
    void draw(const RenderFrame& frame, const PicturePlace& place, Smoothing smoothing, float scale = 1.0f);

    /// Whether OpenGL renders in software, for lack of a graphics card or its driver.
    bool is_software() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace cairn::viewer
