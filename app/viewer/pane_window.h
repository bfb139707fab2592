/// \file pane_window.h
/// The part of the panel that sets up the panes, and the lines over them that tell how they differ.
#pragma once

#include "viewer/controller.h"
#include "viewer/report.h"

namespace cairn::viewer {

class PaneWindow {
  public:
    /// Tells the stage to have panes as long as they are wanted, and draws the lines over them.
    void draw(const StageState& state, Controller& controller, const WindowFacts& facts, float scale);
    /// The part of the panel that sets them up.
    void draw_section(const StageState& state, Controller& controller);

  private:
    void open(const StageState& state, Controller& controller);
    bool draw_varied(Controller& controller);
    bool draw_settings(Controller& controller);
    void draw_captions(const StageState& state, const WindowFacts& facts, float scale) const;

    bool was_open_ = false;
    std::uint64_t scene_serial_ = 0;
    PaneSettings first_;                 // as the run itself is
    std::vector<PaneSettings> settings_; // of the others
};

} // namespace cairn::viewer
