/// \file gl_target.h
/// What a picture is drawn on before it gets to the window or file, and how its edges become smooth.
#pragma once

#include "viewer/gl_objects.h"
#include "viewer/gl_renderer.h"

#include <optional>

namespace cairn::viewer {

class GlTarget {
  public:
    GlTarget();
    /// Makes it the framebuffer to draw on, empty, of that size in pixels. Throws `Error` (unsupported) if this
    /// graphics driver has no picture of that size.
    void begin(int width, int height, Smoothing smoothing);
    /// Brings what was drawn there, and leaves the framebuffer bound. A place of another size gets it stretched, which
    /// smooths edges enough; the samples of a picture have one size.
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
