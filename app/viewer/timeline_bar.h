/// \file timeline_bar.h
/// The bar at the bottom of the window: buttons for time, and a track of all that is known, to be scrubbed.
#pragma once

#include "viewer/controller.h"

#include <cstdint>

namespace cairn::viewer {

class TimelineBar {
  public:
    /// To be called between ImGui's NewFrame and Render. `column`: where the picture begins, which is `room` wide.
    /// Returns its height.
    float draw(const StageState& state, Controller& controller, float scale, float column, float room);

    // The track in the last frame, in the window's units.
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
    std::uint64_t asked_ = 0; // the step to which the mouse was dragged last
};

} // namespace cairn::viewer
