/// \file gl_renderer.h
/// Draws frames with OpenGL 3.3: instanced meshes, a soft shadow map fixed in the world, sky, fading ground, smooth
/// edges. One draw call per mesh and pass.
#pragma once

#include "viewer/render_frame.h"

#include <memory>

namespace cairn::viewer {

/// How edges become smooth.
enum class Smoothing {
    samples, ///< Four samples a pixel: for pictures that are kept.
    edges,   ///< By a pass over the finished picture: less than half the time where a processor draws it.
};

/// A part of a framebuffer (0: the window's), in pixels; width and height > 0.
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

    /// Draws there, and leaves the framebuffer bound. `scale`, at most 1: with that share of the pixels each way,
    /// spread over the place (not with samples).
    void draw(const RenderFrame& frame, const PicturePlace& place, Smoothing smoothing, float scale = 1.0f);

    /// Whether it is the processor that draws, for want of a graphics card or its driver.
    bool is_software() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace cairn::viewer
