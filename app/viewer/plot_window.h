/// \file plot_window.h
/// Plots of the run: energy, momentum, and what the selected body does.
#pragma once

#include "viewer/controller.h"
#include "viewer/samples.h"

#include <array>
#include <optional>

namespace cairn::viewer {

class PlotWindow {
  public:
    /// To be called between ImGui's NewFrame and Render. `column`: where the picture begins, which is `room` wide;
    /// `bottom`: the height of what is below it.
    void draw(const StageState& state, Controller& controller, float scale, float column, float room, float bottom);

  private:
    void draw_choice(const StageState& state, Controller& controller);

    bool was_open_ = false;
    int group_ = 0, window_ = 1; // of the groups and of the lengths of time
    std::optional<Quantity> against_;
};

} // namespace cairn::viewer
