/// \file timeline_bar.h
/// The bar at the bottom of the window: buttons for time, and a track of the known run for scrubbing.
#pragma once

#include "viewer/controller.h"

#include <cstdint>

namespace cairn::viewer {

class TimelineBar {
  public:
    /// To be called between ImGui's NewFrame and Render. `column`: left edge of the view, which is `room` wide. Returns
    /// the height of the bar.
    float draw(const StageState& state, Controller& controller, float scale, float column, float room);

    // Position of the track in the last frame, in window units.
    float left() const noexcept { return left_; }
    float right() const noexcept { return right_; }
    float middle() const noexcept { return middle_; }

  private:
    void draw_buttons(const StageState& state, Controller& controller);
    void draw_track(const StageState& state, Controller& controller, float width, float scale);
    void draw_marks(const TimelineState& timeline, bool is_light, float top, float bottom, float scale);
    float place_of(const TimelineState& timeline, std::uint64_t step) const;
    std::uint64_t step_at(const TimelineState& timeline, float x, float scale) const;

    float left_ = 0.0f, right_ = 0.0f, middle_ = 0.0f;
    std::uint64_t asked_ = 0; // last step number that the mouse was dragged to
};

} // namespace cairn::viewer
