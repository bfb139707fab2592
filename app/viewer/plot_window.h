/// \file plot_window.h
/// Plots of the run: energy, momentum, and quantities of the selected body.
#pragma once

#include "viewer/controller.h"
#include "viewer/samples.h"

#include <array>
#include <optional>

namespace cairn::viewer {

class PlotWindow {
  public:
    /// To be called between ImGui's NewFrame and Render. `column`: left edge of the view, which is `room` wide;
    /// `bottom`: height of the bar below it.
    void draw(const StageState& state, Controller& controller, float scale, float column, float room, float bottom);

  private:
    void draw_choice(const StageState& state, Controller& controller);

    bool was_open_ = false;
    int group_ = 0, window_ = 1; // indices of the plot group and of the time span
    std::optional<Quantity> against_;
};

} // namespace cairn::viewer
