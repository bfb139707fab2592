/// \file report.h
/// The viewer's state as JSON, for tests and tools.
#pragma once

#include "viewer/controller.h"
#include "viewer/pane_layout.h"

#include <string>
#include <vector>

namespace cairn::viewer {

/// State that only the window knows.
struct WindowFacts {
    int left = 0;                 ///< Width of the panel beside the view, pixels.
    int width = 0, height = 0;    ///< Size of the view (the first of several), pixels.
    std::vector<PaneRect> panes;  ///< In window units; one pane for a single view.
    int scene_lines = 0;          ///< Number of lines that fit in the panel's scene list.
    bool scene_is_listed = false; ///< The entry of the present scene is visible.
    std::uint64_t frames = 0;
    double frames_per_second = 0.0;
    float bar_left = 0.0f, bar_right = 0.0f, bar_middle = 0.0f; ///< Track of the timeline in the window, pixels.
    std::string notice;                                         ///< The message line at the bottom.
};

/// One JSON object: `scene`, `body_count`, `bodies` (index, name, type, position, speed, awake, and `screen`, the pixel
/// of the center, from the top left), `selected`, `dragging`, `joints` (index, name, kind, positions, force, torque,
/// errors, `screen`), `selected_joint`, `paused`, `speed`, `camera`, `frames` ...
std::string report_json(const StageState& state, const Controller& controller, const WindowFacts& facts);

} // namespace cairn::viewer
