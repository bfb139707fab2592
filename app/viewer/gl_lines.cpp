#include "viewer/gl_lines.h"

#include "viewer/joint_drawing.h"
#include "viewer/palette.h"
#include "viewer/shaders.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cairn::viewer {

GlLines::GlLines()
    : program_(shaders::desktop_header, shaders::line_vertex, shaders::line_fragment),
      box_program_(shaders::desktop_header, shaders::line_box_vertex, shaders::line_fragment),
      array_(make_vertex_array()), buffer_(make_buffer()), box_array_(make_vertex_array()), box_buffer_(make_buffer()) {
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(float), nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(float),
                          reinterpret_cast<const void*>(3 * sizeof(float)));
    // The buffer holds one record for each box; the shader generates the edges.
    static_assert(sizeof(LineBox) == 9 * sizeof(float));
    glBindVertexArray(box_array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, box_buffer_.name());
    for (GLuint i = 0; i < 3; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(LineBox),
                              reinterpret_cast<const void*>(3 * i * sizeof(float)));
        glVertexAttribDivisor(i, 1);
    }
    glBindVertexArray(0);
}

// Hidden parts of the edges are drawn faintly, as for strokes.
void GlLines::draw_boxes(std::vector<LineBox> boxes, const glm::mat4& clip_from_world) {
    for (LineBox& box : boxes) box.color = srgb(box.color);
    constexpr float hidden_alpha = 0.25f;
    constexpr GLsizei ends_of_edges = 24;
    box_program_.use();
    box_program_.set("u_clip_from_world", clip_from_world);
    glBindVertexArray(box_array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, box_buffer_.name());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(boxes.size() * sizeof(LineBox)), boxes.data(), GL_STREAM_DRAW);
    const auto draw = [&] { glDrawArraysInstanced(GL_LINES, 0, ends_of_edges, GLsizei(boxes.size())); };
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    glBlendColor(0.0f, 0.0f, 0.0f, hidden_alpha);
    glDepthFunc(GL_GREATER);
    draw();
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    draw();
}

void GlLines::draw(const RenderFrame& frame, const glm::mat4& clip_from_world) {
    if (!frame.line_boxes.empty()) draw_boxes(frame.line_boxes, clip_from_world);
    if (frame.lines.empty()) return;
    std::vector<Vec3> vertices;
    for (const Line& line : frame.lines) vertices.insert(vertices.end(), {line.from, line.color, line.to, line.color});
    program_.use();
    program_.set("u_clip_from_world", clip_from_world);
    upload(vertices);
    glDrawArrays(GL_LINES, 0, GLsizei(2 * frame.lines.size()));
}

void GlLines::upload(const std::vector<Vec3>& vertices) {
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vec3)), vertices.data(), GL_STREAM_DRAW);
}

// Draws fluid surfaces, veils, then strokes with a dark rim that separates them from bodies of the same color: hidden
// parts first, faintly, then the visible ones.
void GlLines::draw_marks(const RenderFrame& frame, const glm::mat4& clip_from_world, const OrbitCamera& camera,
                         int width, int height) {
    if (frame.strokes.empty() && frame.veils.empty() && frame.fluids.empty()) return;
    constexpr float stroke_picture_height = 720.0f, rim = 2.0f;
    constexpr float fluid_alpha = 0.5f, veil_alpha = 0.22f, rim_alpha = 0.3f, hidden_alpha = 0.4f;
    StrokeView view{Vec3(camera.position() - frame.origin),
                    camera.forward(),
                    2.0f * camera.half_height(float(width) / float(height)) / stroke_picture_height,
                    {}};
    if (camera.is_parallel()) view.parallel_distance = camera.distance();
    std::vector<Vec3> vertices, band;
    const auto add_veils = [&](const std::vector<Veil>& veils) {
        for (const Veil& veil : veils)
            for (const Vec3& corner : {veil.a, veil.b, veil.c})
                vertices.insert(vertices.end(), {corner, srgb(veil.color)});
        return GLsizei(vertices.size() / 2);
    };
    const GLsizei fluids_end = add_veils(frame.fluids), veils_end = add_veils(frame.veils);
    const auto add_strokes = [&](float wider, std::optional<Vec3> color) {
        for (const Stroke& stroke : frame.strokes) {
            Stroke drawn = stroke; // at least one pixel wide
            drawn.width = std::max(drawn.width, stroke_picture_height / float(height)) + wider;
            band.clear();
            add_band(band, drawn, view);
            const Vec3 shown = color.value_or(srgb(stroke.color));
            for (const Vec3& corner : band) vertices.insert(vertices.end(), {corner, shown});
        }
        return GLsizei(vertices.size() / 2);
    };
    const GLsizei rims_end = add_strokes(rim, Vec3(0.05f, 0.08f, 0.12f)), strokes_end = add_strokes(0.0f, std::nullopt);
    program_.use();
    program_.set("u_clip_from_world", clip_from_world);
    upload(vertices);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    const auto draw_part = [](GLsizei from, GLsizei to, float alpha) {
        glBlendColor(0.0f, 0.0f, 0.0f, alpha);
        glDrawArrays(GL_TRIANGLES, from, to - from);
    };
    glDepthFunc(GL_LEQUAL);
    draw_part(0, fluids_end, fluid_alpha);
    glDepthFunc(GL_GREATER);
    draw_part(fluids_end, veils_end, veil_alpha * hidden_alpha);
    draw_part(rims_end, strokes_end, hidden_alpha);
    glDepthFunc(GL_LEQUAL);
    draw_part(fluids_end, veils_end, veil_alpha);
    draw_part(veils_end, rims_end, rim_alpha);
    draw_part(rims_end, strokes_end, 1.0f);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glEnable(GL_CULL_FACE);
}

} // namespace cairn::viewer
