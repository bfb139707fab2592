/// \file picture_area.h
/// The part of the window beside the panel: one view, or several panes with a common camera.
#pragma once

#include "viewer/controller.h"
#include "viewer/gl_renderer.h"
#include "viewer/pane_layout.h"
#include "viewer/physics_thread.h"

#include <cstddef>
#include <vector>

namespace cairn::viewer {

class PictureArea {
  public:
    /// Arranges the panes: leaves `column` units free at the left, and with several panes `bottom` below them. Width
    /// and height of the frame are in pixels, other lengths in window units.
    void place(int frame_width, int frame_height, int window_width, float column, float bottom, std::size_t panes);
    std::size_t count() const { return panes_.size(); }
    /// In window units.
    const PaneRect& pane(std::size_t index) const { return panes_[index]; }
    float pixels_per_unit() const { return pixels_per_unit_; }
    /// The rectangle of the first pane, in pixels.
    PicturePlace first_place() const { return place_of(panes_.front()); }
    /// The pane under the cursor. While a button is held, it stays the pane in which the button was pressed.
    std::size_t pane_under(float x, float y) const;
    void hold(std::size_t pane) { held_ = pane; }
    void let_go() { held_.reset(); }

    void draw(const LatestState& latest, const Controller& controller, float scale);
    /// Draws the view over the whole window, without the panel.
    void draw_without_panel(const LatestState& latest, const Controller& controller);
    bool is_software() const { return renderer_.is_software(); }

  private:
    PicturePlace place_of(const PaneRect& pane) const;
    void draw_pane(const LatestState& latest, const Controller& controller, std::size_t index,
                   const PicturePlace& place, Smoothing smoothing, float scale);

    GlRenderer renderer_;
    std::vector<PaneRect> panes_{1};
    PaneRect area_;
    float pixels_per_unit_ = 1.0f;
    int frame_width_ = 0, frame_height_ = 0; // pixels
    std::optional<std::size_t> held_;
};

} // namespace cairn::viewer
