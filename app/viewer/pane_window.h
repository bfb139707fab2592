/// \file pane_window.h
/// The part of the panel that configures the panes, and the captions that describe their differences.
#pragma once

#include "viewer/controller.h"
#include "viewer/report.h"

namespace cairn::viewer {

class PaneWindow {
  public:
    /// Tells the stage to keep panes while they are shown, and draws their captions.
    void draw(const StageState& state, Controller& controller, const WindowFacts& facts, float scale);
    /// The part of the panel that configures the panes.
    void draw_section(const StageState& state, Controller& controller);

  private:
    void open(const StageState& state, Controller& controller);
    bool draw_varied(Controller& controller);
    bool draw_settings(Controller& controller);
    void draw_captions(const StageState& state, const WindowFacts& facts, float scale) const;

    bool was_open_ = false;
    std::uint64_t scene_serial_ = 0;
    PaneSettings first_;                 // settings of the main run
    std::vector<PaneSettings> settings_; // settings of the other panes
};

} // namespace cairn::viewer
