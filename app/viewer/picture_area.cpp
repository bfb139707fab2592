#include "viewer/picture_area.h"

#include "viewer/render_frame.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace cairn::viewer {

void PictureArea::place(int frame_width, int frame_height, int window_width, float column, float bottom,
                        std::size_t panes) {
    frame_width_ = frame_width;
    frame_height_ = frame_height;
    pixels_per_unit_ = float(frame_width) / float(std::max(window_width, 1));
    const float height = float(frame_height) / pixels_per_unit_;
    area_ = {column, 0.0f, float(window_width) - column, panes > 1 ? height - bottom : height};
    panes_.resize(panes);
    for (std::size_t i = 0; i < panes; ++i) panes_[i] = pane_rect(area_, panes, i);
    if (held_ && *held_ >= panes) held_.reset();
}

PicturePlace PictureArea::place_of(const PaneRect& pane) const {
    const auto pixels = [this](float units) { return int(std::round(units * pixels_per_unit_)); };
    const int left = pixels(pane.left), top = pixels(pane.top);
    const int width = pixels(pane.left + pane.width) - left, height = pixels(pane.top + pane.height) - top;
    return {0, left, frame_height_ - top - height, width, height};
}

std::size_t PictureArea::pane_under(float x, float y) const {
    return held_.value_or(pane_at(area_, panes_.size(), x, y));
}

void PictureArea::draw_pane(const LatestState& latest, const Controller& controller, std::size_t index,
                            const PicturePlace& place, Smoothing smoothing, float scale) {
    if (place.width <= 0 || place.height <= 0) return;
    const StageState& state = latest.stage;
    FrameOptions options = controller.frame_options(state);
    const CameraPose camera = controller.camera.pose();
    if (index == 0) {
        RenderFrame frame =
            make_frame(*state.layout, *state.previous, *state.current, latest.fraction, camera, options);
        if (state.other)
            add_ghosts(frame, *state.layout, *state.current, state.other->picture, latest.fraction, options);
        controller.add_gizmo(frame, state);
        renderer_.draw(frame, place, smoothing, scale);
        return;
    }
    options.drag.reset(); // only the body in the main run is dragged
    const RunPicture& picture = state.panes[index - 1].picture;
    renderer_.draw(make_frame(*picture.layout, *picture.previous, *picture.current, latest.fraction, camera, options),
                   place, smoothing, scale);
}

void PictureArea::draw(const LatestState& latest, const Controller& controller, float scale) {
    if (panes_.size() > 1) { // fills the gaps between panes
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glClearColor(0.05f, 0.06f, 0.07f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    for (std::size_t i = 0; i < panes_.size(); ++i)
        draw_pane(latest, controller, i, place_of(panes_[i]), Smoothing::edges, scale);
}

void PictureArea::draw_without_panel(const LatestState& latest, const Controller& controller) {
    const PaneRect whole{0.0f, 0.0f, float(frame_width_) / pixels_per_unit_, float(frame_height_) / pixels_per_unit_};
    for (std::size_t i = 0; i < panes_.size(); ++i)
        draw_pane(latest, controller, i, place_of(pane_rect(whole, panes_.size(), i)), Smoothing::samples, 1.0f);
}

} // namespace cairn::viewer
