/// \file gl_target.h
/// The offscreen render target of a picture, and its anti-aliasing.
#pragma once

#include "viewer/gl_objects.h"
#include "viewer/gl_renderer.h"

#include <optional>

namespace cairn::viewer {

class GlTarget {
  public:
    GlTarget();
    /// Binds the render target, cleared, with that size in pixels. Throws `Error` (unsupported) if the graphics driver
    /// does not support that size.
    void begin(int width, int height, Smoothing smoothing);
    /// Copies the picture to `place`, and leaves its framebuffer bound. A place of another size gets a stretched
    /// picture, which smooths edges enough; multisampled pictures cannot be stretched.
    void finish(const PicturePlace& place);

  private:
    void resize(int width, int height, Smoothing smoothing);

    GlProgram program_;
    GlMesh square_;
    GlObject framebuffer_, color_, depth_;
    int width_ = 0, height_ = 0;
    Smoothing smoothing_ = Smoothing::samples;
};

} // namespace cairn::viewer
