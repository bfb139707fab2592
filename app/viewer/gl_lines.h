/// \file gl_lines.h
/// Draws unlit geometry: thin lines and boxes of lines, strokes of constant width in pixels, and veils.
#pragma once

#include "viewer/camera.h"
#include "viewer/gl_objects.h"
#include "viewer/render_frame.h"

#include <vector>

namespace cairn::viewer {

/// Leaves the OpenGL state as `GlRenderer::draw` sets it.
class GlLines {
  public:
    GlLines();
    /// Draws the lines and boxes of a frame, one pixel wide.
    void draw(const RenderFrame& frame, const glm::mat4& clip_from_world);
    /// Draws the veils and strokes of a frame, into a picture of `height` pixels. `camera`: that of the frame.
    void draw_marks(const RenderFrame& frame, const glm::mat4& clip_from_world, const OrbitCamera& camera, int width,
                    int height);

  private:
    void draw_boxes(std::vector<LineBox> boxes, const glm::mat4& clip_from_world);
    void upload(const std::vector<Vec3>& vertices);
    GlProgram program_, box_program_;
    GlObject array_, buffer_, box_array_, box_buffer_;
};

} // namespace cairn::viewer
