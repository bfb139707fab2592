/// \file panel.h
/// The panel, the help window and the text lines over the view, made with Dear ImGui.
#pragma once

#include "viewer/command_palette.h"
#include "viewer/controller.h"
#include "viewer/field_panel.h"
#include "viewer/impact_window.h"
#include "viewer/inspector.h"
#include "viewer/integrator_window.h"
#include "viewer/joint_panel.h"
#include "viewer/pane_window.h"
#include "viewer/plot_window.h"
#include "viewer/report.h"
#include "viewer/timeline_bar.h"

#include <string>

namespace cairn::viewer {

class Panel {
  public:
    /// Describes this frame's user interface; to be called between ImGui's NewFrame and Render. `scale`: ImGui units
    /// per unscaled unit.
    void draw(const StageState& state, Controller& controller, const WindowFacts& facts, float scale);

    /// Width of the panel's column beside the view, in window units: 0 where the panel is hidden, or where the window
    /// is too narrow for both and the panel overlays the view.
    static float column_width(const Controller& controller, float scale, float window_width);
    /// Height of the timeline bar, units; 0 where it is hidden.
    float bar_height() const noexcept { return bar_height_; }
    const TimelineBar& timeline() const noexcept { return timeline_; }
    int scene_lines() const noexcept { return scene_lines_; }
    bool scene_is_listed() const noexcept { return scene_is_listed_; }

  private:
    void draw_time(const StageState& state, Controller& controller);
    void draw_scenes(const StageState& state, Controller& controller);
    void draw_settings(const StageState& state, Controller& controller);
    void draw_view(const StageState& state, Controller& controller);
    void draw_spawn_tool(Controller& controller);
    void draw_statistics(const StageState& state, const WindowFacts& facts);

    WorldDef settings_; // as edited; synchronized with the world while no widget is active
    JointPanel joints_;
    FieldPanel fields_;
    TimelineBar timeline_;
    IntegratorWindow integrators_;
    PlotWindow plots_;
    PaneWindow panes_;
    ImpactWindow impacts_;
    float bar_height_ = 0.0f;
    Inspector inspector_;
    CommandPalette palette_;
    float speed_octave_ = 0.0f;
    std::string shown_scene_;   // path of the scene that the list was last scrolled to
    float other_height_ = 0.0f; // height of the rest of the column beside the scene list, in the last frame
    float list_height_ = 0.0f;  // height of the scene list
    int scene_lines_ = 0, shown_lines_ = 0;
    bool scene_is_listed_ = false;
};

/// Interface scale for a window of that size in unscaled units, relative to 1280 x 720: proportional to the tighter
/// side, 0.75 to 3.
float interface_share(float width, float height);

/// Sets colors, rounding and spacing at that scale.
void apply_style(float scale, bool is_light);

} // namespace cairn::viewer
