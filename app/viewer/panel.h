/// \file panel.h
/// The panel, the key map and the lines of text over the picture, made with Dear ImGui.
#pragma once

#include "viewer/controller.h"
#include "viewer/joint_panel.h"
#include "viewer/report.h"

#include <string>

namespace cairn::viewer {

class Panel {
  public:
    /// Describes this frame's user interface; to be called between ImGui's NewFrame and Render. `scale`: how many of
    /// ImGui's units one unscaled unit takes.
    void draw(const StageState& state, Controller& controller, const WindowFacts& facts, float scale);

  private:
    void draw_time(const StageState& state, Controller& controller);
    void draw_scenes(const StageState& state, Controller& controller);
    void draw_settings(Controller& controller);
    void draw_view(const StageState& state, Controller& controller);
    void draw_spawn_tool(Controller& controller);
    void draw_statistics(const StageState& state, const WindowFacts& facts);

    WorldDef settings_; // as edited; follows the world while nothing is being edited
    JointPanel joints_;
    float speed_octave_ = 0.0f;
    std::uint64_t shown_scene_ = 0; // the list has been scrolled to the scene of this serial number
};

/// Colors, rounding and spacing, at that scale.
void apply_style(float scale);

} // namespace cairn::viewer
